"""An exported estimator built for a target and streamed through its emulator.

Invariant: the firmware is the exported files unchanged, behind a harness that feeds rows and reads words.
"""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.targets import STRICT, Target, flags_of
from similitude.embedded.vectors import WORDS, Vectors
from similitude.errors import CompileError
from similitude.program.library import Library

SHIFT = 10  # of QEMU's icount: an instruction takes 2^10 ns, so that the counter resolves one
TIME_LIMIT = 120.0  # s a stream
FIRMWARE = Path(__file__).parent / "firmware"
EMULATED = "emulated"
READ = 'docs/embedded.md, "Measuring"'


@dataclass(frozen=True, eq=False)
class Streamed:
    """What came out of a target: words as `Vectors` has them, and what each step cost."""

    status: NDArray[np.int32]
    outputs: NDArray
    state: NDArray
    counts: NDArray[np.int64]  # instructions or cycles of each step, (n,)
    stack: int  # bytes, the most of any step
    report: int  # instructions or cycles, the most of any report; 0 where the step hands out everything

    def differing(self, wanted: Vectors) -> int:
        """Words that are not those expected."""
        pairs = ((self.status, wanted.status), (self.outputs, wanted.outputs), (self.state, wanted.state))
        return int(sum(np.count_nonzero(ours != theirs) for ours, theirs in pairs))


def run(command: list[str], cwd: Path) -> str:
    """Run a tool and return what it printed.

    Raises
    ------
    CompileError    it cannot be started, takes too long, or ends with an error.
    """
    try:
        done = subprocess.run(
            command, cwd=cwd, capture_output=True, text=True, timeout=TIME_LIMIT, check=True
        )
    except subprocess.CalledProcessError as fault:
        lines = (fault.stderr or fault.stdout or "it said nothing").strip().splitlines()[:8]
        raise _failed(command, f"ended with {fault.returncode}: " + "\n".join(lines)) from fault
    except (OSError, subprocess.TimeoutExpired) as fault:
        raise _failed(command, str(fault)) from fault
    return done.stdout


def _failed(command: list[str], why: str) -> CompileError:
    return CompileError(
        f"{Path(command[0]).name} {why}",
        usually="the tool is of a version that was not tried, or the part is too small for the estimator.",
        paste=" ".join(command[:1]) + " --version",
        read=READ,
    )


def harness(target: Target) -> dict[str, bytes]:
    """The files of ``emulated/`` that a board needs beside the estimator."""
    if target.name == "avr":
        names = ["stream_avr.c", "simulate_avr.c"]
    else:
        names = ["stream.c", "board.h", f"board_{board(target)}.c", f"link_{board(target)}.ld"]
    return {name: (FIRMWARE / name).read_bytes() for name in names}


def row_bytes(real: str, samples: NDArray) -> bytes:
    """Words of rows as the harness reads them, little-endian."""
    return samples.astype(np.dtype(WORDS[real]).newbyteorder("<")).tobytes()


def board(target: Target) -> str:
    """Which of the harness's boards a target is."""
    return "rv32" if target.name == "rv32" else "cortex_m"


def compile_line(name: str, target: Target) -> list[str]:
    """The command that builds the firmware from inside ``emulated/``."""
    loose = [flag for flag in flags_of(target) if flag != "-std=c99"]
    own = ["stream_avr.c"] if target.name == "avr" else ["stream.c", f"board_{board(target)}.c"]
    link = ["-Wl,--gc-sections"]
    if target.name != "avr":
        link += ["-nostdlib", f"-Tlink_{board(target)}.ld"]
    last = ["-lgcc", *(["-lm"] if target.name == "avr" else []), "-o", "firmware.elf"]
    files = [f"../{name}.c", f"../{name}_self_test.c"]
    return [target.compiler, *loose, "-std=gnu99", f"-DNAME={name}", "-I..", *own, *files, *link, *last]


def build(folder: Path, library: Library, target: Target, scratch: Path) -> Path:
    """The firmware of a folder for a target; the exported files with warnings as errors."""
    name = library.name
    flags = flags_of(target)
    for stem in (name, f"{name}_self_test"):
        made = ["-c", str(folder / f"{stem}.c"), "-o", str(scratch / f"{stem}.o")]
        run([target.compiler, *flags, *STRICT, f"-I{folder}", *made], scratch)
    emulated = scratch / EMULATED
    emulated.mkdir(exist_ok=True)
    for file, raw in harness(target).items():
        (emulated / file).write_bytes(raw)
    line = [
        word.replace("../", f"{folder}/") if word != "-I.." else f"-I{folder}"
        for word in compile_line(name, target)
    ]
    run(line, emulated)
    return emulated / "firmware.elf"


def stream(
    elf: Path, library: Library, target: Target, real: str, samples: NDArray, scratch: Path
) -> Streamed:
    """Feed rows (words, (n, fields)) through the firmware.

    Raises
    ------
    CompileError    the emulator fails or takes too long.
    """
    word = WORDS[real]
    place = elf.parent
    (place / "rows.bin").write_bytes(row_bytes(real, samples))
    (place / "words.bin").unlink(missing_ok=True)
    width = np.dtype(word).itemsize
    outputs, states = len(library.layout.OUTPUT), len(library.names("state"))
    if target.name == "avr":
        runner = _simulator(scratch)
        sizes = [samples.shape[1] * width, outputs * width, states * width]
        run([str(runner), str(elf), *map(str, sizes)], place)
    else:
        run([*emulator(target), str(elf)], place)
    return _records((place / "words.bin").read_bytes(), len(samples), outputs, states, word, target)


def emulator(target: Target) -> list[str]:
    """The command of QEMU: one instruction a fixed time, files by semihosting, the firmware last."""
    quiet = ["-display", "none", "-monitor", "none", "-serial", "none"]
    counted = ["-icount", f"shift={SHIFT if target.clock else 0}"]
    semihosting = ["-semihosting-config", "enable=on,target=native"]
    return [*target.machine, *quiet, *counted, *semihosting, "-bios" if target.name == "rv32" else "-kernel"]


def _simulator(scratch: Path) -> Path:
    program = scratch / "simulate_avr"
    if not program.exists():
        run(["cc", "-O2", str(FIRMWARE / "simulate_avr.c"), "-o", str(program), "-lsimavr", "-lelf"], scratch)
    return program


def _records(raw: bytes, n: int, outputs: int, states: int, word: type, target: Target) -> Streamed:
    width = np.dtype(word).itemsize
    reals = np.dtype(word).newbyteorder("<")
    record = np.dtype([("head", "<u4", 4), ("output", reals, outputs)])
    wanted = (n + 1) * record.itemsize + states * width
    if len(raw) != wanted:
        raise CompileError(
            f"{target.name} handed back {len(raw)} bytes where {wanted} were due",
            usually="the firmware stopped early: its stack ran into its data, or a fault was taken.",
            paste="--target cortex-m4f",
            read=READ,
        )
    rows = np.frombuffer(raw[: (n + 1) * record.itemsize], record)
    state = np.frombuffer(raw[(n + 1) * record.itemsize :], reals).astype(word)
    ticks = rows["head"][1:, [1, 3]].astype(np.int64) - int(rows["head"][0, 1])
    each = target.clock * 2**SHIFT * 1e-9 if target.clock else 1.0
    counts, reports = np.rint(ticks / each).astype(np.int64).T
    stack = int(rows["head"][1:, 2].max()) - int(rows["head"][0, 2])
    return Streamed(
        rows["head"][1:, 0].astype(np.int32),
        rows["output"][1:].astype(word),
        state,
        counts,
        stack,
        max(0, int(reports.max())),
    )


def arithmetic_size(folder: Path, name: str, target: Target) -> int:
    """Bytes of the compiler's own floating point that a step needs: linked alone, it needs nothing else.

    Parameters
    ----------
    folder : where ``NAME.o`` lies.

    Raises
    ------
    CompileError    the step calls something that is no arithmetic.
    """
    tool = target.compiler.removesuffix("gcc")
    link = ["-nostdlib", "-Wl,--gc-sections", f"-Wl,-e,{name}_step", f"{name}.o", "-lgcc"]
    if target.name == "avr":
        link += ["-lm", "-lgcc"]
    run([target.compiler, *target.flags, *link, "-o", "alone.elf"], folder)
    found = [line.split() for line in run([f"{tool}nm", "-S", "alone.elf"], folder).splitlines()]
    own = sum(int(words[1], 16) for words in found if len(words) == 4 and words[3].startswith(f"{name}_"))
    sections = [line.split() for line in run([f"{tool}size", "-A", "alone.elf"], folder).splitlines()]
    code = sum(int(words[1]) for words in sections if len(words) == 3 and words[0] in (".text", ".rodata"))
    return code - own
