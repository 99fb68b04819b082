"""Rerun the self-test of an exported folder with this machine's compiler, bit for bit.

Invariant: nothing is written into the folder.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from similitude.embedded.targets import CONTRACT_OFF, STRICT
from similitude.errors import CompileError, SimilitudeError, UsageError
from similitude.program.compile import cache_directories
from similitude.program.compiler import find_compiler, run_compiler

LEVELS = ("-O0", "-O2", "-O3")
TIME_LIMIT = 60.0  # s; a self-test takes milliseconds
MANIFEST = "evidence.json"
READ = 'docs/embedded.md, "Verify"'
_MAIN = """\
#include <stdio.h>
#include "{name}_self_test.h"
int main(void)
{{
    unsigned long first = 0ul;
    unsigned long wrong = {name}_self_test(&first);
    printf("%lu %lu\\n", wrong, first);
    return 0;
}}
"""


class SelfTestError(SimilitudeError):
    """An exported estimator that does not give the bits it must."""


@dataclass(frozen=True)
class Verified:
    """A folder whose self-test passed: ``words`` compared at each of ``levels``, none differing."""

    name: str
    real: str
    samples: int
    words: int
    compiler: str
    levels: tuple[str, ...] = LEVELS


def verify_folder(folder: Path) -> Verified:
    """Compile an exported folder with this machine's compiler and run its self-test.

    Parameters
    ----------
    folder : what ``similitude export --out`` wrote.

    Raises
    ------
    UsageError       it is no exported folder.
    CompileError     there is no compiler, or it refuses the files.
    SelfTestError    words differ.
    """
    told = read_manifest(folder)
    name = told["name"]
    compiler = find_compiler(cache_directories())
    with tempfile.TemporaryDirectory(prefix="similitude-") as scratch:
        main = Path(scratch, "main.c")
        main.write_text(_MAIN.format(name=name), encoding="utf-8")
        files = [str(folder / f"{name}.c"), str(folder / f"{name}_self_test.c"), str(main)]
        for level in LEVELS:
            program = Path(scratch, f"test{level}")
            flags = ["-std=c99", level, "-ffp-contract=off", f"-D{CONTRACT_OFF}", *STRICT, f"-I{folder}"]
            run_compiler(
                compiler.command,
                [*flags, *files, "-o", str(program)],
                subject=f"{name} {level}",
                scratch=Path(scratch),
            )
            _compare(program, told, level, folder)
    version = compiler.version.splitlines()[0]
    return Verified(name, told["real"], told["self_test"]["samples"], told["self_test"]["words"], version)


def read_manifest(folder: Path) -> dict:
    """What an export wrote down about its folder.

    Raises
    ------
    UsageError    it is no exported folder, or the file is damaged.
    """
    try:
        told = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
        told["name"], told["real"], told["self_test"]["samples"], told["self_test"]["words"]
    except (OSError, ValueError, KeyError, TypeError) as fault:
        raise UsageError(
            f"'{folder}' is no folder that `similitude export` wrote: its {MANIFEST} is missing or damaged",
            usually="the folder above or below it was meant.",
            paste=f"ls {folder}",
            read=READ,
        ) from fault
    return told


def _compare(program: Path, told: dict, level: str, folder: Path) -> None:
    try:
        done = subprocess.run([str(program)], capture_output=True, text=True, timeout=TIME_LIMIT, check=True)
        wrong, first = (int(word) for word in done.stdout.split())
    except (OSError, subprocess.SubprocessError, ValueError) as fault:
        raise CompileError(
            f"the self-test of {told['name']} built with {level} does not run: {fault}",
            usually="the compiler makes programs for another machine than this one.",
            paste=f"SIMILITUDE_CC=gcc similitude export --verify {folder}",
            read=READ,
        ) from fault
    if wrong:
        where = f"sample {first}" if first < told["self_test"]["samples"] else "the last state"
        raise SelfTestError(
            f"{wrong} of {told['self_test']['words']} words of {told['name']} differ with {level}, "
            f"first in {where}",
            usually=f"a number in {told['name']}_config.h was changed after the export (the vectors hold for "
            "the old ones), or a file of the folder was edited.",
            paste="similitude export ... --out NEW   # the same command again, with the new numbers",
            read=READ,
        )
