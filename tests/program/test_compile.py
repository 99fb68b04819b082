"""The cache survives races, kills and strangers: what it hands out is always a whole library."""

import ctypes
import hashlib
import os
import pathlib
import shlex
import shutil
import signal
import subprocess
import sys
import time

import pytest

from similitude.errors import CompileError
from similitude.program import compile as compiling
from similitude.program.compile import compile_source, load_library

SOURCE = """
#ifndef SIMILITUDE_REAL
#define SIMILITUDE_REAL double
#endif
#define SIMILITUDE_API __attribute__((visibility("default")))
SIMILITUDE_API int similitude_test_size(void) { return (int)sizeof(SIMILITUDE_REAL); }
SIMILITUDE_API int similitude_test_answer(void) { return 42; }
int similitude_test_hidden(void) { return 1; }
"""
LOAD = f"""
import ctypes
from similitude.program.compile import load_library
print(load_library({SOURCE!r}, name="probe").similitude_test_answer())
"""


def answer(library: ctypes.CDLL) -> int:
    return library.similitude_test_answer()


def script(path: pathlib.Path, *lines: str) -> pathlib.Path:
    """An executable shell script that ends by becoming the real compiler."""
    real = shlex.quote(shutil.which("cc"))
    path.write_text("\n".join(("#!/bin/sh", *lines, f'exec {real} "$@"', "")))
    path.chmod(0o755)
    return path


def test_the_library_of_a_source_is_compiled_once_and_found_again(cache):
    first = compile_source(SOURCE, name="probe")
    written = first.stat().st_mtime_ns

    assert first.parent == cache and first.name.startswith("probe-") and first.suffix == ".so"
    assert len(first.stem.removeprefix("probe-")) == 16
    assert compile_source(SOURCE, name="probe") == first
    assert first.stat().st_mtime_ns == written
    assert answer(load_library(SOURCE, name="probe")) == 42


def test_a_change_of_one_character_is_another_library(cache):
    changed = SOURCE.replace("42", "43")

    assert compile_source(SOURCE, name="probe") != compile_source(changed, name="probe")
    assert answer(load_library(changed, name="probe")) == 43
    assert answer(load_library(SOURCE, name="probe")) == 42


def test_float_and_double_live_side_by_side(cache):
    sizes = {
        real: load_library(SOURCE, name="probe", real=real).similitude_test_size()
        for real in ("double", "float", "double")
    }

    assert sizes == {"double": ctypes.sizeof(ctypes.c_double), "float": 4}
    assert len(list(cache.glob("probe-*.so"))) == 2


def test_only_marked_symbols_are_exported(cache):
    library = load_library(SOURCE, name="probe")

    assert library.similitude_test_answer
    with pytest.raises(AttributeError):
        _ = library.similitude_test_hidden


@pytest.mark.parametrize("wrong", [{"name": "../probe"}, {"name": ""}, {"name": "a b"}, {"real": "half"}])
def test_names_that_cannot_be_files_or_types_are_refused(cache, wrong):
    with pytest.raises(ValueError, match=repr(next(iter(wrong.values())))):
        compile_source(SOURCE, **{"name": "probe", **wrong})


def test_a_path_with_spaces_is_fine(cache, tmp_path, monkeypatch):
    roomy = tmp_path / "a folder with spaces"
    roomy.mkdir()
    compiler = script(roomy / "my cc")
    monkeypatch.setenv("SIMILITUDE_CACHE", str(roomy / "the cache"))
    monkeypatch.setenv("SIMILITUDE_CC", f"{shlex.quote(str(compiler))} -DUNUSED='a b'")

    assert answer(load_library(SOURCE, name="probe")) == 42


def test_arguments_in_the_environment_reach_the_compiler_and_the_key(cache, monkeypatch):
    source = SOURCE.replace("42", "ANSWER")
    for value in (7, 8):
        monkeypatch.setenv("SIMILITUDE_CC", f"cc -DANSWER={value}")
        assert answer(load_library(source, name="probe")) == value


def test_four_processes_compiling_at_once_all_end_well(cache, tmp_path, monkeypatch):
    # The wait makes every process find an empty cache and compile.
    monkeypatch.setenv("SIMILITUDE_CC", shlex.quote(str(script(tmp_path / "cc", "sleep 0.3"))))
    command = [sys.executable, "-c", LOAD]
    racers = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for _ in range(4)]

    assert [racer.communicate()[0].strip() for racer in racers] == ["42"] * 4
    assert [racer.returncode for racer in racers] == [0] * 4
    assert len(list(cache.glob("probe-*.so"))) == 1
    assert not list(cache.glob(".build-*"))


def test_a_killed_compile_leaves_nothing_that_is_believed(cache, tmp_path, monkeypatch):
    begun, slow = tmp_path / "begun", tmp_path / "slow"
    half_written = f'if [ -e "{slow}" ] && [ "$1" != --version ]; then'
    compiler = script(
        tmp_path / "cc",
        half_written,
        '  while [ "$1" != -o ]; do shift; done',
        f'  printf half > "$2"; touch "{begun}"; sleep 60',
        "fi",
    )
    slow.touch()
    monkeypatch.setenv("SIMILITUDE_CC", shlex.quote(str(compiler)))
    victim = subprocess.Popen([sys.executable, "-c", LOAD], start_new_session=True)
    deadline = time.monotonic() + 30
    while not begun.exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    os.killpg(victim.pid, signal.SIGKILL)
    victim.wait()

    assert begun.exists(), "the compiler was never started"
    assert not list(cache.glob("probe-*"))
    (abandoned,) = cache.glob(".build-*")
    slow.unlink()
    assert answer(load_library(SOURCE, name="probe")) == 42
    assert abandoned.exists()  # too young to be told from a build that is running

    two_days_ago = time.time() - 2 * 86400
    os.utime(abandoned, (two_days_ago, two_days_ago))
    compile_source(SOURCE + "\n", name="probe")
    assert not abandoned.exists()


@pytest.mark.parametrize("kept", [0, 20, 4096, 0.5, 0.99])
def test_a_truncated_library_is_built_again(cache, kept):
    library = compile_source(SOURCE, name="probe")
    size = library.stat().st_size
    os.truncate(library, int(kept * size) if isinstance(kept, float) else kept)

    assert answer(load_library(SOURCE, name="probe")) == 42
    assert library.stat().st_size == size


def test_a_library_without_its_digest_is_built_again(cache):
    library = compile_source(SOURCE, name="probe")
    library.with_suffix(".sha256").unlink()
    library.write_bytes(b"not yet")

    assert answer(load_library(SOURCE, name="probe")) == 42


def test_a_whole_file_that_is_no_library_is_built_again(cache):
    library = compile_source(SOURCE, name="probe")
    library.write_bytes(b"something else")
    digest = hashlib.sha256(b"something else").hexdigest()
    library.with_suffix(".sha256").write_text(digest)

    assert answer(load_library(SOURCE, name="probe")) == 42


def test_a_compiler_that_makes_no_library_is_an_error_not_a_loop(cache, tmp_path, monkeypatch):
    compiler = script(
        tmp_path / "cc",
        '[ "$1" = --version ] && exec echo "fake 1"',
        'while [ "$1" != -o ]; do shift; done',
        'echo rubbish > "$2"; exit 0',
    )
    monkeypatch.setenv("SIMILITUDE_CC", shlex.quote(str(compiler)))

    with pytest.raises(CompileError, match="cannot be loaded"):
        load_library(SOURCE, name="probe")


def test_a_program_that_is_no_compiler_is_an_error_in_four_parts(cache, monkeypatch):
    """`true` ends well whatever it is asked, and writes nothing."""
    monkeypatch.setenv("SIMILITUDE_CC", "true")

    with pytest.raises(CompileError, match=r"true' ended well on probe-.* but wrote no library"):
        load_library(SOURCE, name="probe")
    assert not list(cache.glob(".build-*"))


@pytest.mark.parametrize("home", ["read-only", "a file", "missing"])
def test_a_home_that_cannot_be_written_gives_way_to_a_private_directory(cache, tmp_path, monkeypatch, home):
    if home == "read-only" and os.access("/", os.W_OK):
        pytest.skip("this user may write anywhere")
    where = tmp_path / "home"
    if home == "read-only":
        where.mkdir(mode=0o500)
    elif home == "a file":
        where.write_text("")
    for variable in ("SIMILITUDE_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setenv("HOME", "/dev/null/nowhere" if home == "missing" else str(where))
    monkeypatch.setattr(compiling.tempfile, "tempdir", str(tmp_path))

    library = compile_source(SOURCE, name="probe")

    assert library.parent == tmp_path / f"similitude-{os.getuid()}"
    assert library.parent.stat().st_mode & 0o077 == 0
    assert compile_source(SOURCE, name="probe") == library


def test_a_cache_that_was_filled_and_then_closed_is_still_read(cache, tmp_path, monkeypatch):
    library = compile_source(SOURCE, name="probe")
    monkeypatch.setattr(compiling, "_can_write", lambda directory: False)
    monkeypatch.setattr(compiling.tempfile, "tempdir", str(tmp_path))

    assert compile_source(SOURCE, name="probe") == library
    assert compile_source(SOURCE + "\n", name="probe").parent != cache


def test_a_temporary_directory_open_to_others_is_not_trusted(cache, tmp_path, monkeypatch):
    monkeypatch.setenv("SIMILITUDE_CACHE", "/dev/null/nowhere")
    monkeypatch.setattr(compiling.tempfile, "tempdir", str(tmp_path))
    stranger = tmp_path / f"similitude-{os.getuid()}"
    stranger.mkdir()
    stranger.chmod(0o777)

    library = compile_source(SOURCE, name="probe")

    assert library.parent != stranger and library.parent.parent == tmp_path


def test_a_warm_load_starts_no_process(cache):
    compile_source(SOURCE, name="probe")
    watched = f"""
import sys
def watch(event, arguments):
    if event in ("subprocess.Popen", "os.fork", "os.exec", "os.posix_spawn", "os.system"):
        raise SystemExit(f"a process was started: {{event}} {{arguments}}")
sys.addaudithook(watch)
{LOAD}
"""
    done = subprocess.run([sys.executable, "-c", watched], capture_output=True, text=True)

    assert (done.stdout.strip(), done.stderr, done.returncode) == ("42", "", 0)
