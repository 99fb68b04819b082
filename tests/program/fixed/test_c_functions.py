"""Every function of the C gives the words of the twin's, at all edges and at random."""

import ctypes
import random

import pytest
from tests.program.fixed.test_integer import HELPERS

from similitude.program.compile import load_library
from similitude.program.fixed.c_functions import FUNCTIONS

EDGES = [0, 1, -1, 2**31 - 1, -(2**31), 2**31, 2**32 - 1, 2**32, -(2**32), 2**47, 2**62 - 1, 2**62, -(2**62)]


@pytest.fixture(scope="module")
def helpers(tmp_path_factory):
    text = (
        "\n".join(FUNCTIONS.values())
        .format(name="h")
        .replace("static ", "")
        .replace("SIMILITUDE_INLINE ", "")
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
