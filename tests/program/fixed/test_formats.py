"""A format holds its range with the finest step that does."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from similitude.program.fixed.formats import SLIM, format_of, sample_format
from similitude.program.fixed.integer import NARROW

SIZES = st.floats(1e-9, 1e9)


@given(SIZES, st.booleans())
def test_both_ends_fit_and_twice_the_step_would_be_too_coarse(size, wide):
    kept = format_of(-size, size, wide=wide)
    most = 2**60 if wide else SLIM

    assert max(-kept.lo, kept.hi) <= most
    assert 2 * size * 2.0**kept.fraction > most * (1 - 2**-20)
    assert abs(kept.integer(Fraction(size)) * kept.step - size) <= kept.step


@given(SIZES)
def test_what_a_gate_refuses_can_still_be_told_from_what_it_lets_in(size):
    kept = sample_format(-size, size)

    assert (kept.lo, kept.hi) == NARROW
    assert kept.hi * kept.step > size


def test_every_bit_is_used_where_it_is_asked_for():
    assert format_of(-1.5, 1.5, full=True).fraction == format_of(-1.5, 1.5).fraction + 3


def test_counts_are_whole():
    assert format_of(0.0, 13.0, whole=True).fraction == 0
