"""The fuzzer runs, tries many files, and fails when a reader does."""

import subprocess
import sys
from pathlib import Path

import pytest
from fuzz.__main__ import seeds

from fuzz import __main__ as fuzzing

ROOT = Path(__file__).parents[2]


def test_the_seeds_are_short_and_whole_lines():
    for name in ("text", "vehicle"):
        found = seeds(name)
        assert found and all(seed.endswith(b"\n") and len(seed) < 8192 for seed in found)


def test_a_few_seconds_of_every_target():
    pytest.importorskip("atheris")
    done = subprocess.run(
        [sys.executable, "-m", "fuzz.target", "vehicle", "-max_total_time=2", "-print_final_stats=1"],
        cwd=ROOT, capture_output=True, text=True, errors="replace",
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
    tried = [line for line in done.stderr.splitlines() if "executed_units" in line]
    assert int(tried[0].split()[-1]) > 100


def test_a_long_run_goes_on_in_shifts_and_ends_with_the_first_that_fails(monkeypatch, capsys):
    """The instrumentation of a process grows; a new one goes on with what the last one found."""
    begun = []

    def shift(command, **_):
        begun.append(next(part for part in command if part.startswith("-max_total_time")))
        failed = int(len(begun) == 3)
        return subprocess.CompletedProcess(command, failed, "", "stat::number_of_executed_units: 7\n")

    monkeypatch.setattr(fuzzing.subprocess, "run", shift)

    assert fuzzing.run("vehicle", 700) == 1
    assert begun == ["-max_total_time=300", "-max_total_time=300", "-max_total_time=100"]
    assert "21 files tried" in capsys.readouterr().out
