"""The processors an estimator is exported for: compiler, flags, and what its table of cost is measured on.

Invariant: every target is built at the one optimisation level below, so that costs can be compared.
"""

from __future__ import annotations

import difflib
import shutil
from dataclasses import dataclass

from similitude.errors import UsageError

LEVEL = "-Os"
IN_ORDER = "-fno-tree-ter"  # gcc: values are worked out where they stand, not held back until they are used
CONTRACT_OFF = "SIMILITUDE_CONTRACT_OFF"  # the build says that it forbids fused multiply-add
LANGUAGE = ("-std=c99", LEVEL, "-ffp-contract=off", f"-D{CONTRACT_OFF}")
SECTIONS = ("-ffreestanding", "-ffunction-sections", "-fdata-sections")
STRICT = (
    "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wcast-qual "
    "-Wcast-align -Wstrict-prototypes -Wmissing-prototypes -Wundef -Wvla -Werror"
).split()
REALS = ("float", "double", "fixed")
BYTES = {"float": 4, "double": 8, "fixed": 4}
READ = 'docs/embedded.md, "Targets"'


@dataclass(frozen=True)
class Target:
    """A processor: ``compiler`` the command, ``flags`` its own, ``machine`` what emulates it."""

    name: str
    words: str
    compiler: str
    flags: tuple[str, ...]
    reals: tuple[str, ...]
    machine: tuple[str, ...] = ()  # the emulator's command line
    clock: float = 0.0  # Hz of the counter that the emulator advances
    unit: str = "instructions"
    packages: str = ""  # Debian's, for a message

    @property
    def missing(self) -> tuple[str, ...]:
        """Commands that measuring on this target needs and this machine lacks."""
        wanted = (self.compiler, *self.machine[:1])
        return tuple(tool for tool in wanted if shutil.which(tool) is None)


_ARM = "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm"
TARGETS: dict[str, Target] = {
    target.name: target
    for target in (
        Target(
            "cortex-m4f",
            "Arm Cortex-M4 with single-precision floating point",
            "arm-none-eabi-gcc",
            ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", IN_ORDER),
            REALS,
            ("qemu-system-arm", "-machine", "mps2-an386"),
            25e6,
            packages=_ARM,
        ),
        Target(
            "cortex-m3",
            "Arm Cortex-M3, floating point in software",
            "arm-none-eabi-gcc",
            ("-mcpu=cortex-m3", "-mthumb", IN_ORDER),
            REALS,
            ("qemu-system-arm", "-machine", "mps2-an385"),
            25e6,
            packages=_ARM,
        ),
        Target(
            "cortex-m0",
            "Arm Cortex-M0, floating point in software",
            "arm-none-eabi-gcc",
            ("-mcpu=cortex-m0", "-mthumb", IN_ORDER),
            REALS,
            ("qemu-system-arm", "-machine", "microbit"),
            16e6,
            packages=_ARM,
        ),
        Target(
            "rv32",
            "RISC-V RV32IMAC, floating point in software",
            "riscv64-unknown-elf-gcc",
            ("-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany", IN_ORDER),
            REALS,
            ("qemu-system-riscv32", "-machine", "virt"),
            packages="gcc-riscv64-unknown-elf qemu-system-misc",
        ),
        Target(
            "avr",
            "ATmega328P, floating point in software",
            "avr-gcc",
            ("-mmcu=atmega328p", IN_ORDER),
            ("float", "fixed"),
            unit="cycles",
            packages="gcc-avr avr-libc libsimavr-dev libelf-dev",
        ),
        Target("host", "the machine that exports", "cc", (), REALS),
    )
}


def target_named(name: str, *, real: str) -> Target:
    """The target of that name, able to hold the real.

    Parameters
    ----------
    name : as ``--target`` has it.
    real : ``float``, ``double`` or ``fixed``.

    Raises
    ------
    UsageError    there is no such target, or it has no such real.
    """
    if name not in TARGETS:
        near = difflib.get_close_matches(name, TARGETS, n=1, cutoff=0.3)
        raise UsageError(
            f"--target '{name}' is not known; there are {', '.join(TARGETS)}",
            usually="the core is meant, not the part: an STM32F4 is a cortex-m4f.",
            paste=f"--target {near[0] if near else 'cortex-m4f'}",
            read=READ,
        )
    if real not in REALS:
        raise UsageError(
            f"--real '{real}' is not exported; there are {', '.join(REALS)}",
            usually="the C type was written: 'fixed' is the profile in whole numbers.",
            paste="--real fixed",
            read='docs/embedded.md, "Reals"',
        )
    target = TARGETS[name]
    if real not in target.reals:
        raise UsageError(
            f"--real {real} does not exist on --target {name}: its compiler's double has four bytes",
            usually="the words of the host were carried over; on this part single precision is all there is.",
            paste=f"--real {target.reals[0]}",
            read=READ,
        )
    return target


def flags_of(target: Target) -> list[str]:
    """Flags that compile an exported file for a target, without the warnings."""
    return [*LANGUAGE, *SECTIONS, *target.flags]
