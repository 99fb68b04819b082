"""Find the C compiler, know its version, run it: nothing here knows what is compiled.

Invariant: a compiler seen before is known without starting a process. Its version text is kept in
the cache under the path, time and size of every file its command names.
"""

import contextlib
import dataclasses
import hashlib
import importlib.util
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence

from similitude.errors import CompileError

CANDIDATES = ("cc", "gcc", "clang")
SHOWN_LINES = 8  # of the compiler's own message
READ = 'docs/architecture.md, "Compile, cache and load"'


@dataclasses.dataclass(frozen=True)
class Compiler:
    """A C compiler: the command that starts it and the text of its version."""

    command: tuple[str, ...]
    version: str


def find_compiler(directories: Sequence[pathlib.Path]) -> Compiler:
    """Find the compiler: ``SIMILITUDE_CC``, else cc, gcc, clang, else the ``ziglang`` wheel.

    Parameters
    ----------
    directories : sequence of pathlib.Path
        Where version texts are kept; the last one can be written.

    Raises
    ------
    CompileError
        None is installed, or what ``SIMILITUDE_CC`` names does not exist or does not run.
    """
    command = _command()
    filename = f"compiler-{_identity(command)}.txt"
    for directory in directories:
        with contextlib.suppress(OSError):
            version = (directory / filename).read_text(encoding="utf-8", errors="replace")
            if version:
                return Compiler(command, version)
    version = run_compiler(command, ["--version"], subject="its version", scratch=directories[-1]).strip()
    _keep(directories[-1] / filename, version)
    return Compiler(command, version)


def run_compiler(
    command: Sequence[str], arguments: Sequence[str], *, subject: str, scratch: pathlib.Path
) -> str:
    """Run the compiler and return what it printed.

    Parameters
    ----------
    command, arguments : sequence of str
        What to run.
    subject : str
        What the run is about, for the message.
    scratch : pathlib.Path
        A writable directory for compilers that keep a cache of their own.

    Raises
    ------
    CompileError
        It cannot be started or ends with an error; the first lines it wrote are in the message.
    """
    environment = dict(os.environ, LC_ALL="C")
    for variable in ("ZIG_GLOBAL_CACHE_DIR", "ZIG_LOCAL_CACHE_DIR"):
        environment.setdefault(variable, str(scratch / "zig"))
    try:
        done = subprocess.run(
            [*command, *arguments],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            errors="replace",
        )
    except OSError as error:
        raise _refused(command, f"cannot be started ({error})", subject) from error
    if done.returncode != 0:
        lines = (done.stderr or done.stdout).strip().splitlines() or ["(it wrote nothing)"]
        shown = "".join(f"\n    {line}" for line in lines[:SHOWN_LINES])
        more = f"\n    … {len(lines) - SHOWN_LINES} lines more" if len(lines) > SHOWN_LINES else ""
        raise _refused(command, f"ended with status {done.returncode}", subject, shown + more)
    return done.stdout


def _refused(command: Sequence[str], how: str, subject: str, shown: str = "") -> CompileError:
    return CompileError(
        f"the C compiler '{shlex.join(command)}' {how} on {subject}{shown}",
        usually="the compiler is incomplete (no linker, no C headers), does not know C99, or the "
        "disk is full; for a model of your own the lines above name the faulty source",
        paste="SIMILITUDE_CC=gcc similitude …",
        read=READ,
    )


def _command() -> tuple[str, ...]:
    """The command that starts the compiler, its first word an absolute path."""
    asked = os.environ.get("SIMILITUDE_CC", "").strip()
    if asked:
        return _asked_command(asked)
    for candidate in CANDIDATES:
        path = shutil.which(candidate)
        if path is not None:
            return (os.path.abspath(path),)
    if importlib.util.find_spec("ziglang") is not None:
        # Zig compiles for the very processor by default; a shared home may be read by another.
        return (sys.executable, "-m", "ziglang", "cc", "-mcpu=baseline")
    raise CompileError(
        "no C compiler was found: neither SIMILITUDE_CC, nor "
        f"{', '.join(CANDIDATES)} on PATH, nor the ziglang package",
        usually="the machine has none yet; the estimator is C and is compiled on first use",
        paste="pip install 'similitude[cc]'     (or on Debian and Ubuntu: apt install gcc)",
        read=READ,
    )


def _asked_command(asked: str) -> tuple[str, ...]:
    try:
        words = shlex.split(asked)
        path = shutil.which(words[0])
    except ValueError:  # an opening quote without its partner
        path = None
    if path is None:
        raise CompileError(
            f'SIMILITUDE_CC is "{asked}", whose first word is no program on this machine',
            usually="the name is mistyped, or a path with spaces needs quotes of its own",
            paste="export SIMILITUDE_CC=gcc",
            read=READ,
        )
    return (os.path.abspath(path), *words[1:])


def _identity(command: Sequence[str]) -> str:
    """16 hex digits that change when a file named by the command is replaced."""
    parts = list(command)
    files = [shutil.which(word) for word in command]
    if "ziglang" in command:
        files.append(importlib.util.find_spec("ziglang").origin)
    for file in filter(None, files):
        with contextlib.suppress(OSError):
            found = os.stat(file)
            parts.append(f"{file} {found.st_mtime_ns} {found.st_size}")
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def _keep(path: pathlib.Path, text: str) -> None:
    """Write a small file whole or not at all; failing to is no reason to stop."""
    with contextlib.suppress(OSError):
        handle, temporary = tempfile.mkstemp(prefix=".version-", dir=path.parent)
        with open(handle, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(temporary, path)
