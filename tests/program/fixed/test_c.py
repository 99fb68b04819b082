"""The C of a fixed-point step gives the twin's words, for any words that come in."""

import ctypes
import random
import subprocess

import numpy as np
import pytest
from tests.program.fixed.lowered import run_c, run_twin, tiny_fixed
from tests.program.fixed.test_integer import HELPERS

from similitude.embedded.targets import STRICT
from similitude.program.compile import load_library
from similitude.program.fixed.c import _HELPERS, print_fixed_c


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


EDGES = [0, 1, -1, 2**31 - 1, -(2**31), 2**31, 2**32 - 1, 2**32, -(2**32), 2**47, 2**62 - 1, 2**62, -(2**62)]


@pytest.fixture(scope="module")
def helpers(tmp_path_factory):
    text = (
        "\n".join(_HELPERS.values()).format(name="h").replace("static ", "").replace("SIMILITUDE_INLINE ", "")
    )
    source = "#include <stdint.h>\n#pragma GCC visibility push(default)\n" + text
    return load_library(source, name="helpers")


def called(helpers, name, kinds, result):
    function = getattr(helpers, f"h_{name}")
    function.argtypes, function.restype = kinds, result
    return function


def test_every_helper_is_that_of_the_twin_at_all_edges(helpers):
    wide, word, plain = ctypes.c_int64, ctypes.c_int32, ctypes.c_int
    mulq = called(helpers, "mulq", [word, word], word)
    mulw, mulh = called(helpers, "mulw", [wide, word], wide), called(helpers, "mulh", [wide, wide], wide)
    quotient = called(helpers, "quotient", [wide, wide, plain, word, word], word)
    choose = random.Random(5)
    wides = EDGES + [choose.randint(-(2**62), 2**62) >> choose.randrange(62) for _ in range(120)]
    for a in wides:
        for b in wides:
            if abs(a) < 2**31 > abs(b):
                assert mulq(a, b) == HELPERS["_mulq"](a, b)
            if abs(b) < 2**31:
                assert mulw(a, b) == HELPERS["_mulw"](a, b)
            assert mulh(a, b) == HELPERS["_mulh"](a, b)
            up = choose.randint(-70, 70)
            assert quotient(a, b, up, -12345678, 87654321) == HELPERS["_quotient"](
                a, b, up, -12345678, 87654321
            )
