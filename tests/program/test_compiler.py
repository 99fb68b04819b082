"""The compiler is found where the page says it is looked for, and its refusals are readable."""

import os
import shlex
import shutil
import sys

import pytest

from similitude.errors import CompileError
from similitude.program import compiler as finding
from similitude.program.compile import compile_source, load_library
from similitude.program.compiler import find_compiler

SOURCE = """
__attribute__((visibility("default"))) int similitude_test_answer(void) { return 42; }
"""


@pytest.fixture
def bare_path(tmp_path, monkeypatch):
    """A PATH with nothing on it and no ziglang package; returns its only directory."""
    directory = tmp_path / "bin"
    directory.mkdir()
    monkeypatch.setenv("PATH", str(directory))
    monkeypatch.setattr(finding.importlib.util, "find_spec", lambda name: None)
    return directory


def fake(path, *lines):
    path.write_text("\n".join(("#!/bin/sh", *lines, "")))
    path.chmod(0o755)
    return path


def assert_has_four_parts(error: CompileError) -> None:
    assert all((error.what, error.usually, error.paste, error.read))
    assert "\n" not in error.paste
    for part in (error.what, error.usually, error.paste, error.read):
        assert part in str(error)


def test_no_compiler_at_all_is_an_error_that_says_what_to_install(cache, bare_path):
    with pytest.raises(CompileError) as caught:
        compile_source(SOURCE, name="probe")

    assert_has_four_parts(caught.value)
    assert "SIMILITUDE_CC" in caught.value.what
    assert "similitude[cc]" in caught.value.paste


@pytest.mark.parametrize("asked", ["no-such-compiler -O2", "'unclosed"])
def test_a_compiler_named_wrongly_is_quoted_back(cache, monkeypatch, asked):
    monkeypatch.setenv("SIMILITUDE_CC", asked)
    with pytest.raises(CompileError) as caught:
        compile_source(SOURCE, name="probe")

    assert_has_four_parts(caught.value)
    assert asked in caught.value.what


def test_the_first_lines_of_a_refusal_are_shown(cache):
    source = "\n".join(f"int broken_{i} = no_such_thing_{i};" for i in range(30))
    with pytest.raises(CompileError) as caught:
        compile_source(source, name="probe")

    assert_has_four_parts(caught.value)
    assert "no_such_thing_0" in caught.value.what
    assert "no_such_thing_29" not in caught.value.what
    assert "lines more" in caught.value.what
    assert not list(cache.glob("probe-*")) and not list(cache.glob(".build-*"))


def test_a_compiler_that_cannot_be_started_is_named(cache, tmp_path, monkeypatch):
    broken = tmp_path / "cc"
    broken.write_text("#!/no/such/interpreter\n")
    broken.chmod(0o755)
    monkeypatch.setenv("SIMILITUDE_CC", str(broken))
    with pytest.raises(CompileError, match="cannot be started") as caught:
        compile_source(SOURCE, name="probe")

    assert str(broken) in caught.value.what


def test_the_search_order_is_environment_then_cc_gcc_clang(cache, bare_path, monkeypatch):
    cache.mkdir()
    found = []
    for name in ("clang", "gcc", "cc"):  # each one hides those before it
        fake(bare_path / name, f"echo {name} 1.0")
        found.append(find_compiler([cache]).version)
    fake(bare_path / "mine", 'echo mine "$1"')
    monkeypatch.setenv("SIMILITUDE_CC", "mine")
    found.append(find_compiler([cache]).version)

    assert found == ["clang 1.0", "gcc 1.0", "cc 1.0", "mine --version"]


def test_a_compiler_replaced_on_disk_is_asked_again(cache, bare_path):
    cache.mkdir()
    fake(bare_path / "cc", "echo version one")
    assert find_compiler([cache]).version == "version one"
    fake(bare_path / "cc", "echo version two, longer")

    assert find_compiler([cache]).version == "version two, longer"


def test_another_version_is_another_library(cache, tmp_path, monkeypatch):
    real = shlex.quote(shutil.which("cc"))
    compiler = tmp_path / "cc"
    monkeypatch.setenv("SIMILITUDE_CC", shlex.quote(str(compiler)))
    libraries = set()
    for version in ("1", "22"):
        lines = f'[ "$1" = --version ] && exec echo {version}', f'exec {real} "$@"'
        fake(compiler, *lines)
        libraries.add(compile_source(SOURCE, name="probe"))

    assert len(libraries) == 2


def test_the_ziglang_package_is_used_when_there_is_no_compiler(cache, tmp_path, monkeypatch):
    # A stand-in package: the calls it gets are those of `python -m ziglang cc ...`.
    path = os.environ["PATH"]
    package = tmp_path / "site" / "ziglang"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("")
    (package / "__main__.py").write_text(
        "import os, sys\n"
        f"os.environ['PATH'] = {path!r}\n"
        "assert sys.argv[1:3] == ['cc', '-mcpu=baseline'], sys.argv\n"
        f"os.execv({shutil.which('cc')!r}, ['cc', *sys.argv[3:]])\n"
    )
    monkeypatch.setenv("PYTHONPATH", str(package.parent))
    monkeypatch.syspath_prepend(str(package.parent))
    monkeypatch.setenv("PATH", str(tmp_path))

    assert load_library(SOURCE, name="probe").similitude_test_answer() == 42
    assert find_compiler([cache]).command[:3] == (sys.executable, "-m", "ziglang")
