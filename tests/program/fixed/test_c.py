"""The C of a fixed-point step gives the twin's words, for any words that come in."""

import subprocess

import numpy as np
from tests.program.fixed.lowered import run_c, run_twin, tiny_fixed

from similitude.embedded.targets import STRICT
from similitude.program.fixed.c import print_fixed_c


def test_the_c_and_the_twin_agree_on_random_and_extreme_words(cache):
    fixed = tiny_fixed()
    rng = np.random.default_rng(1)
    rows = rng.integers(-(2**31), 2**31, (4000, 2))
    rows[::3] >>= rng.integers(0, 32, rows[::3].shape)
    rows[::7] = rng.choice([-(2**31), 2**31 - 1, 0, -1, 1], rows[::7].shape)
    for ours, theirs in zip(run_c(fixed, rows), run_twin(fixed, rows), strict=True):
        assert np.array_equal(ours, theirs)


def test_it_compiles_without_a_warning(tmp_path):
    (tmp_path / "a.c").write_text(print_fixed_c(tiny_fixed()))
    kept = [flag for flag in STRICT if flag != "-Wmissing-prototypes"]
    done = subprocess.run(
        ["gcc", "-std=c99", "-O2", *kept, "-c", "a.c", "-o", "a.o"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )

    assert done.returncode == 0, done.stderr
