"""similitude bench: arguments, files and what is printed; the work itself is tested under tests/benchmark."""

import importlib
import json
import subprocess
import sys

import pytest

from similitude import cli

from .benchmark.small_result import small_result


@pytest.fixture
def asked(monkeypatch):
    """The command with the work taken out; what it was asked for."""
    running = importlib.import_module("similitude.benchmark.running")
    calls = []
    monkeypatch.setattr(running, "run_benchmark", lambda **how: calls.append(how) or small_result())
    return calls


def left(*words):
    with pytest.raises(SystemExit) as code:
        cli.main(["bench", *words])
    return code.value.code


def test_files_are_written_and_named(asked, tmp_path, capsys):
    assert left("--quick", "--seed", "7", "--out", str(tmp_path / "out")) == 0
    printed = capsys.readouterr().out

    assert asked[0]["quick"] and asked[0]["seed"] == 7 and not asked[0]["files"]
    assert printed.strip().endswith("benchmark.html") and (tmp_path / "out" / "benchmark.json").exists()


def test_json_is_one_line(asked, tmp_path, capsys):
    assert left("--quick", "--json", "--out", str(tmp_path)) == 0
    lines = capsys.readouterr().out.splitlines()

    assert len(lines) == 1 and json.loads(lines[0])["cells"] == 2


def test_an_output_that_is_a_file_is_refused_before_the_work(asked, tmp_path, capsys):
    (tmp_path / "page.html").write_text("")

    assert left("--out", str(tmp_path / "page.html")) == 2
    assert not asked and "Paste:" in capsys.readouterr().err


def test_a_part_that_is_none_is_refused(asked, tmp_path, capsys):
    assert left("--part", "fault", "--out", str(tmp_path)) == 2
    assert not asked and "--part faults" in capsys.readouterr().err


def test_an_entrant_that_is_not_there_is_a_usage_error(tmp_path, capsys):
    assert left("--quick", "--entrant", str(tmp_path / "none.py"), "--out", str(tmp_path)) == 2
    assert "none.py" in capsys.readouterr().err


def test_help_needs_no_heavy_package():
    code = (
        "import sys, similitude.cli as c\n"
        "try: c.main(['bench', '--help'])\n"
        "except SystemExit: pass\n"
        "assert not {'numpy', 'sympy', 'pint', 'matplotlib', 'scipy'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, timeout=60)
