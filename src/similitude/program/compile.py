"""C source to a loaded shared library: found in the cache, or compiled into it once.

Invariant: a library under its final name is whole. It is compiled in a directory of its own and
moved in one step, and the digest written beside it must match before it is ever mapped (mapping a
truncated library would kill the process, not raise). What does not match is built again.

Environment: ``SIMILITUDE_CC`` (a compiler, may hold arguments), ``SIMILITUDE_CACHE`` (a directory).
A cache that cannot be written is replaced by a private directory under the system's temporary one.
"""

import ctypes
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import sysconfig
import tempfile
import time

from similitude.errors import CompileError
from similitude.program.compiler import Compiler, find_compiler, run_compiler

FLAGS = (
    "-std=c99",
    "-O2",
    "-ffp-contract=off",  # no fused multiply-add: host and target agree bit for bit
    "-fvisibility=hidden",
    "-fPIC",
    "-shared",
)
REALS = ("double", "float")
ABANDONED_AFTER = 86400.0  # s; a build directory this old belongs to a process that was killed
READ = 'docs/architecture.md, "Compile, cache and load"'


def compile_source(source: str, *, name: str, real: str = "double") -> pathlib.Path:
    """Compile C99 source into a shared library, or find the one compiled earlier.

    Parameters
    ----------
    source : str
        One C translation unit; exported functions carry
        ``__attribute__((visibility("default")))``, every other symbol stays hidden.
    name : str
        A C identifier; the file is ``<name>-<16 hex digits>.so``.
    real : str
        ``"double"``, or ``"float"`` which passes ``-DSIMILITUDE_REAL=float``.

    Returns
    -------
    pathlib.Path
        The library; a whole file that matches its digest.

    Raises
    ------
    CompileError
        No compiler was found, or the compiler refused the source.
    ValueError
        ``name`` is no C identifier, or ``real`` is neither of the two types.
    """
    if not re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII):
        raise ValueError(f"name = {name!r} must be a C identifier, it becomes a file name")
    if real not in REALS:
        raise ValueError(f"real = {real!r} must be one of {', '.join(REALS)}")
    flags = (*FLAGS, "-DSIMILITUDE_REAL=float") if real == "float" else FLAGS
    directories = cache_directories()
    compiler = find_compiler(directories)
    filename = f"{name}-{_key(source, flags, compiler)}.so"
    for directory in directories:
        if is_whole(directory / filename):
            return directory / filename
    return _build(source, flags, compiler, directories[-1] / filename)


def load_library(source: str, *, name: str, real: str = "double") -> ctypes.CDLL:
    """Compile C99 source if needed and load the library; calls into it release the GIL.

    Parameters are those of `compile_source`. A library that the system refuses to load is
    built once more before giving up.

    Raises
    ------
    CompileError
        As `compile_source`, or the fresh library cannot be loaded either.
    """
    path = compile_source(source, name=name, real=real)
    try:
        return ctypes.CDLL(str(path))
    except OSError:
        path.unlink(missing_ok=True)
    path = compile_source(source, name=name, real=real)
    try:
        return ctypes.CDLL(str(path))
    except OSError as error:
        raise CompileError(
            f"the freshly compiled library {path} cannot be loaded: {error}",
            usually="the compiler builds for another machine, or the folder forbids execution",
            paste=f"SIMILITUDE_CC=gcc SIMILITUDE_CACHE={pathlib.Path.cwd() / 'cache'} similitude …",
            read=READ,
        ) from error


def cache_directories() -> list[pathlib.Path]:
    """Where libraries are looked for, in order; the last one can be written.

    Returns
    -------
    list of pathlib.Path
        The configured cache alone, or, where it cannot be written, the configured cache (a
        read-only one may have been filled earlier) and a private temporary directory.
    """
    configured = os.environ.get("SIMILITUDE_CACHE")
    if not configured:
        base = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
        configured = os.path.join(base, "similitude")
    directory = pathlib.Path(configured).absolute()
    return [directory] if _can_write(directory) else [directory, _temporary_directory()]


def is_whole(library: pathlib.Path) -> bool:
    """Tell whether a library exists and matches the digest written beside it."""
    try:
        expected = _digest_file(library).read_text(encoding="ascii", errors="replace")
        return hashlib.sha256(library.read_bytes()).hexdigest() == expected
    except OSError:
        return False


def _key(source: str, flags: tuple[str, ...], compiler: Compiler) -> str:
    """16 hex digits that change with anything that could change the compiled code."""
    abi = f"{sysconfig.get_platform()} {ctypes.sizeof(ctypes.c_void_p)}"
    parts = ("1", source, *flags, *compiler.command, compiler.version, abi)
    # Lengths first, so that no two lists of parts run together into one text.
    text = "".join(f"{len(part)}:{part}" for part in parts)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _build(source: str, flags: tuple[str, ...], compiler: Compiler, library: pathlib.Path) -> pathlib.Path:
    """Compile in a directory of our own, then move library and digest into place."""
    _sweep(library.parent)
    workshop = pathlib.Path(tempfile.mkdtemp(prefix=".build-", dir=library.parent))
    try:
        written = workshop / "source.c"
        written.write_text(source, encoding="utf-8")
        made = workshop / "library.so"
        arguments = [*flags, "-o", str(made), str(written)]
        run_compiler(compiler.command, arguments, subject=library.name, scratch=library.parent)
        if not made.is_file():
            raise _nothing_written(compiler.command, library.name)
        digest = workshop / "digest"
        digest.write_text(hashlib.sha256(made.read_bytes()).hexdigest(), encoding="ascii")
        # Another process may have been faster; its library is as good as ours.
        if not is_whole(library):
            os.replace(made, library)
            os.replace(digest, _digest_file(library))
    finally:
        shutil.rmtree(workshop, ignore_errors=True)
    return library


def _nothing_written(command: tuple[str, ...], subject: str) -> CompileError:
    return CompileError(
        f"the C compiler '{shlex.join(command)}' ended well on {subject}, but wrote no library",
        usually="SIMILITUDE_CC names a program that is no compiler",
        paste="SIMILITUDE_CC=gcc similitude …",
        read=READ,
    )


def _digest_file(library: pathlib.Path) -> pathlib.Path:
    return library.with_suffix(".sha256")


def _sweep(directory: pathlib.Path) -> None:
    """Remove the build directories that killed processes left behind."""
    for workshop in directory.glob(".build-*"):
        try:
            abandoned = time.time() - workshop.stat().st_mtime > ABANDONED_AFTER
        except OSError:
            continue  # its owner has just removed it
        if abandoned:
            shutil.rmtree(workshop, ignore_errors=True)


def _can_write(directory: pathlib.Path) -> bool:
    try:
        directory.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(directory, os.W_OK | os.X_OK)


def _temporary_directory() -> pathlib.Path:
    """The user's own directory under the temporary one; a stranger's is never trusted."""
    if hasattr(os, "getuid"):
        directory = pathlib.Path(tempfile.gettempdir()) / f"similitude-{os.getuid()}"
        try:
            directory.mkdir(mode=0o700, exist_ok=True)
            found = directory.lstat()
            is_ours = found.st_uid == os.getuid() and not found.st_mode & 0o022
            if directory.is_dir() and not directory.is_symlink() and is_ours:
                return directory
        except OSError:
            pass
    return pathlib.Path(tempfile.mkdtemp(prefix="similitude-"))
