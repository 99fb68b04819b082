"""Random homogeneous models, for laws that hold for any: polynomial, rational and transcendental rates."""

from fractions import Fraction

import sympy as sp
from hypothesis import strategies as st

from similitude.model import Model, Quantity
from similitude.units import TIME, Dimension

MEASURES = (Quantity("M", "kg"), Quantity("D", "m"), Quantity("T", "s"))
BASE = ("M", "D", "T")
NAMES = {"mass": "kg", "length": "m", "time": "s"}
SHAPES = (
    lambda q: sp.Integer(1),
    sp.sin,
    lambda q: sp.exp(-q),
    lambda q: 1 / (1 + q**2),
    lambda q: sp.sqrt(1 + q**2),
    sp.tanh,
)


def unit_of(dimension: Dimension) -> str:
    """The dimension as a unit in SI."""
    return " ".join(f"{NAMES[n]}^{e}" if e.denominator == 1 else f"{NAMES[n]}^({e})"
                    for n, e in dimension.exponents.items()) or "1"  # fmt: skip


@st.composite
def models(draw, *, linear: bool = False, most_states: int = 2) -> Model:
    """One or two states, an input, and coefficients whose units make every term fit."""
    power = st.integers(-1, 2)
    unit = st.builds(lambda a, b, c: unit_of(Dimension(mass=a, length=b, time=c)), power, power, power)
    count = draw(st.integers(1, most_states))
    states = [Quantity(f"x{i}", draw(unit)) for i in range(count)]
    driven = Quantity("u", draw(unit))
    parameters, rates = list(MEASURES), {}
    for state in states:
        terms = []
        for _ in range(draw(st.integers(1, 3))):
            factor, dimension = _term(draw, states, driven, linear)
            name = f"c{len(parameters) - len(MEASURES)}"
            parameters.append(Quantity(name, unit_of(state.dimension / TIME / dimension)))
            terms.append(draw(st.sampled_from([1, -1])) * parameters[-1].symbol * factor)
        rates[state.name] = sp.Add(*terms) - state.symbol / sp.Symbol("T", real=True)
        if state is states[0]:
            rates[state.name] += driven.symbol * _ratio(state.dimension / TIME / driven.dimension)
    return Model("random", states, [driven], [states[0]], parameters, rates)


def _term(draw, states, driven, linear: bool) -> tuple[sp.Expr, Dimension]:
    """A state, or a product of powers times a function of a ratio without dimension."""
    first = draw(st.sampled_from(states))
    if linear:
        return first.symbol, first.dimension
    powers = {q: draw(st.integers(0, 2)) for q in (first, driven)}
    product = sp.Mul(*(q.symbol**p for q, p in powers.items()))
    dimension = Dimension.none
    for q, p in powers.items():
        dimension = dimension * q.dimension**p
    shape = draw(st.sampled_from(SHAPES))
    return product * shape(first.symbol / _ratio(first.dimension)), dimension


def _ratio(dimension: Dimension) -> sp.Expr:
    """A product of powers of the base with that dimension."""
    symbols = {"mass": "M", "length": "D", "time": "T"}
    return sp.Mul(
        *(sp.Symbol(symbols[n], real=True) ** sp.Rational(e.numerator, e.denominator)
          for n, e in dimension.exponents.items())
    )  # fmt: skip


positive = st.fractions(Fraction(3, 4), Fraction(4, 3), max_denominator=20)


@st.composite
def values_of(draw, model: Model) -> dict[str, float]:
    """Positive parameters and input of the size of one."""
    return {q.name: float(draw(positive)) for q in (*model.parameters, *model.inputs)}
