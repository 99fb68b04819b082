"""What an exported estimator costs on its target: time, flash, memory, stack, and words that differ.

Invariant: every figure was measured on the folder it stands in, by the target's compiler and emulator.
"""

from __future__ import annotations

import shutil
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from similitude.embedded.machine import Streamed, arithmetic_size, build, run, stream
from similitude.embedded.system import Source
from similitude.embedded.targets import BYTES, LEVEL, Target
from similitude.embedded.vectors import Vectors

SAVING = ("save", "restore", "label", "put", "checksum")  # functions that no step needs


@dataclass(frozen=True)
class Cost:
    """Cost of one estimator on one target; bytes unless ``unit`` says otherwise."""

    target: str
    real: str
    level: str
    compiler: str
    unit: str  # of mean and most: instructions or cycles a sample
    mean: float
    most: int
    report: int  # the most, when it is asked for; 0 where the step hands out everything
    step: int  # code of it, and of the report
    init: int
    saving: int  # save and restore
    numbers: int  # the configuration
    arithmetic: int  # the compiler's floating point, shared by all code that uses any
    state: int
    stack: int
    samples: int
    differing: int

    @property
    def flash(self) -> int:
        """Code that estimates and its configuration, without saving and shared arithmetic."""
        return self.step + self.init + self.numbers

    @property
    def record(self) -> dict:
        """As JSON has it."""
        return {**asdict(self), "flash": self.flash}


def measure(
    folder: Path, source: Source, real: str, target: Target, vectors: Vectors, scratch: Path
) -> tuple[Cost, Streamed]:
    """Build a folder for a target and stream vectors through it.

    Raises
    ------
    CompileError    a tool fails.
    """
    library = source.library()
    elf = build(folder, library, target, scratch)
    out = stream(elf, library, target, real, vectors.samples, scratch)
    plain = _plain_sizes(scratch / f"{source.name}.o", source.name, target)
    version = run([target.compiler, "--version"], scratch).splitlines()[0]
    states = len(library.names("state"))
    cost = Cost(
        target=target.name,
        real=real,
        level=LEVEL,
        compiler=version,
        unit=target.unit,
        mean=round(float(np.mean(out.counts)), 1),
        most=int(out.counts.max()),
        report=out.report,
        step=sum(size for name, size in plain.items() if name not in (*SAVING, "init")),
        init=plain["init"],
        saving=sum(plain.get(name, 0) for name in SAVING),
        numbers=len(library.names("config")) * BYTES[real],
        arithmetic=arithmetic_size(scratch, source.name, target),
        state=states * BYTES[real],
        stack=out.stack,
        samples=len(vectors.samples),
        differing=out.differing(vectors),
    )
    return cost, out


def costs_of(folder: Path, source: Source, real: str, target: Target, vectors: Vectors) -> Cost | None:
    """What a folder costs on its target over its own self-test; None where a tool is missing.

    Raises
    ------
    CompileError    a tool is there and fails.
    """
    if target.name == "host" or missing_tools(target):
        return None
    with tempfile.TemporaryDirectory(prefix="similitude-") as scratch:
        return measure(folder, source, real, target, vectors, Path(scratch))[0]


def missing_tools(target: Target) -> tuple[str, ...]:
    """What this machine lacks to measure on a target."""
    if target.name == "host":
        return ()
    lacking = list(target.missing)
    if target.name == "avr":
        headers = ("/usr/include/simavr/sim_avr.h", "/usr/local/include/simavr/sim_avr.h")
        lacking += [] if any(Path(header).exists() for header in headers) else ["simavr"]
        lacking += [] if shutil.which("cc") else ["cc"]
    return tuple(lacking)


def _plain_sizes(obj: Path, name: str, target: Target) -> dict[str, int]:
    """Bytes of every section of code and constants of the estimator's object file, by function."""
    size = target.compiler.removesuffix("gcc") + "size"
    sizes: dict[str, int] = {}
    for line in run([size, "-A", str(obj)], obj.parent).splitlines():
        words = line.split()
        if len(words) == 3 and words[0].startswith((".text", ".rodata", ".progmem")) and int(words[1]):
            sizes[words[0].rpartition(f"{name}_")[2]] = int(words[1])
    return sizes
