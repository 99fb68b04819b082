"""A 64-bit state is two plain signed words."""

from hypothesis import given
from hypothesis import strategies as st
from tests.program.fixed.lowered import tiny_fixed

from similitude.program.fixed.layout import halves, resolution, split, words


@given(st.integers(-(2**62), 2**62))
def test_the_two_words_are_signed_and_make_the_value(value):
    high, low = split(value)

    assert (high << 32) + low == value
    assert -(2**31) <= low < 2**31 and -(2**31) <= high < 2**31


def test_a_field_tells_format_range_and_step():
    fixed = tiny_fixed()

    assert list(words(fixed)) == [f.name for f in halves(fixed.state)]
    assert resolution(fixed.output[0]).startswith("Q24: -10 to 10 in steps of 6e-08")
