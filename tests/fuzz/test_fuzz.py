"""The fuzzer runs, tries many files, and fails when a reader does."""

import subprocess
import sys
from pathlib import Path

import pytest
from fuzz.__main__ import seeds

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
