"""Laws of scaling symmetries over random systems: counts by exponents, names, order, and units."""

from fractions import Fraction

import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude import scaling_symmetries

STATES, PARAMETERS = ("x", "y"), ("a", "b", "c")
NAMES = ("t", *STATES, *PARAMETERS)
few = settings(max_examples=25, deadline=None)

exponents = st.fixed_dictionaries({name: st.integers(-2, 2) for name in NAMES})
rates = st.fixed_dictionaries({name: st.lists(exponents, min_size=1, max_size=3) for name in STATES})


def text(terms) -> str:
    """A sum of products of powers, one a term, with coefficients that cannot cancel."""
    products = ("*".join(f"{name}**({power})" for name, power in term.items()) for term in terms)
    return " + ".join(f"{k + 1}*{product}" for k, product in enumerate(products))


def rows(system) -> list[list[int]]:
    """What a sum of monomials asks: every term of t f_i/x_i has no weight."""
    asked = []
    for state, terms in system.items():
        for term in terms:
            asked.append([term[n] + (n == "t") - (n == state) for n in NAMES])
    return asked


def span(groups) -> sp.Matrix:
    return sp.Matrix([[sp.Rational(str(g.get(n, 0))) for n in NAMES] for g in groups] or [[0] * len(NAMES)])


@few
@given(rates)
def test_sums_of_monomials_are_left_alone_by_what_leaves_each_term_alone(system):
    found = scaling_symmetries({name: text(terms) for name, terms in system.items()}, PARAMETERS)
    asked = sp.Matrix(rows(system))

    assert found.count == len(NAMES) - asked.rank()
    assert sp.Matrix([*asked.tolist(), *span(found.invariants).tolist()]).rank() == asked.rank()
    assert found.verify()


@few
@given(rates, st.permutations(PARAMETERS))
def test_the_order_of_names_changes_no_span(system, order):
    text_of = {name: text(terms) for name, terms in system.items()}
    one = scaling_symmetries(text_of, PARAMETERS)
    other = scaling_symmetries(dict(reversed(text_of.items())), order)

    assert one.count == other.count
    both = sp.Matrix([*span(one.invariants).tolist(), *span(other.invariants).tolist()])
    assert both.rank() == span(one.invariants).rank() == span(other.invariants).rank()


@few
@given(rates, st.sampled_from(PARAMETERS), st.integers(2, 9))
def test_a_parameter_in_other_units_changes_no_scaling(system, name, factor):
    text_of = {state: text(terms) for state, terms in system.items()}
    other_units = {
        state: rate.replace(name + "**", f"({factor}*{name})**") for state, rate in text_of.items()
    }

    assert scaling_symmetries(text_of, PARAMETERS).invariants == (
        scaling_symmetries(other_units, PARAMETERS).invariants
    )


@few
@given(rates)
def test_reducing_and_restoring_is_the_identity(system):
    found = scaling_symmetries({name: text(terms) for name, terms in system.items()}, PARAMETERS)
    point = {sp.Symbol(n, real=True): sp.Rational(k + 2) ** 12 for k, n in enumerate(NAMES)}

    for state in found.reduced.rates.keys() & set(STATES):
        again = found.reduced.restore(state).xreplace(point)
        assert sp.simplify(again - found.equations.rates[state].xreplace(point)) == 0


def test_invariants_are_whole_numbers_as_fractions():
    group = scaling_symmetries({"x": "a*x"}, ["a"]).invariants[0]

    assert all(isinstance(power, Fraction) and power.denominator == 1 for power in group.values())
