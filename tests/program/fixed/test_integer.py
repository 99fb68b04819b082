"""An expression's range holds every value it can take, and one that could wrap cannot be made."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.errors import ProgramError
from similitude.program.fixed import integer as it
from similitude.program.fixed.python import _TAIL, _text

WORDS = st.integers(-(2**31), 2**31 - 1)
HELPERS: dict = {}
exec(_TAIL.format(start=[]), HELPERS)


def value(node, **names):
    return eval(_text(node), {**HELPERS, **names})


@st.composite
def known(draw, bits=31):
    lo, hi = sorted(draw(st.tuples(*[st.integers(-(2**bits), 2**bits - 1)] * 2)))
    return lo, hi, draw(st.integers(lo, hi))


@given(known(), known(), st.integers(0, 30))
def test_a_range_holds_what_narrow_operations_give(a, b, n):
    x, y = it.name("x", *a[:2]), it.name("y", *b[:2])
    made = [it.add(x, y), it.sub(x, y), it.neg(x), it.mul(x, y), it.shl(x, n), it.shr(it.mul(x, y), n)]
    made += [it.clamp(x, -1000, 5000), it.quotient(x, y, n, -(2**20), 2**20)]
    for node in made:
        assert node.lo <= value(node, x=a[2], y=b[2]) <= node.hi


@given(known(60), known(31), known(60))
def test_a_range_holds_what_wide_products_give(a, b, c):
    x, y, z = it.name("x", *a[:2], wide=True), it.name("y", *b[:2]), it.name("z", *c[:2], wide=True)
    for node in (it.mulw(x, y), it.mulh(x, z)):
        assert node.lo <= value(node, x=a[2], y=b[2], z=c[2]) <= node.hi
    exact = c[2] * a[2] / 2**64
    assert abs(value(it.mulh(x, z), x=a[2], z=c[2]) - exact) <= 7  # six units, and the rounding of /


@given(st.integers(-(2**62), 2**62), st.integers(0, 2**62), st.integers(-62, 62))
def test_a_quotient_is_the_nearest_one_and_saturates(n, d, up):
    node = it.quotient(
        it.name("n", -(2**62), 2**62, wide=True), it.name("d", 0, 2**62, wide=True), up, -5000, 5000
    )
    found, exact = value(node, n=n, d=d), n * 2.0**up / max(d, 1)

    assert -5000 <= found <= 5000
    assert abs(found - min(max(exact, -5000), 5000)) <= 0.5 + 5000 * 2.0**-27  # 28 bits


def test_what_could_leave_62_bits_cannot_be_made():
    x = it.name("x", -(2**61), 2**61, wide=True)
    with pytest.raises(ProgramError, match="more than 62 bits"):
        it.shl(x, 2)


def test_conditions_that_ranges_decide_are_decided():
    low, high = it.name("low", 0, 5), it.name("high", 6, 9)

    assert it.less(low, high, equal=False) == it.TRUE
    assert it.less(high, low, equal=True) == it.FALSE
    assert it.every([it.TRUE, it.TRUE]) == it.TRUE
    assert it.some([it.FALSE, it.opposite(it.TRUE)]) == it.FALSE
    assert it.choose(it.TRUE, low, high) is low
