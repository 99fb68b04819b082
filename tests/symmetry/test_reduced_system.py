"""What is left when scalings are taken out, and the way back."""

from fractions import Fraction

import pytest
import sympy as sp

from similitude.symmetry.equations import equations_of
from similitude.symmetry.scalings import scaling_symmetries, scalings_of
from similitude.systems.bicycle import BICYCLE, bicycle_groups
from similitude.systems.shipped import shipped_system

x, y, t, pi1 = sp.symbols("x y t pi1", real=True)


def test_a_logistic_curve_has_nothing_left_to_know():
    reduced = scaling_symmetries({"x": "r*x*(1 - x/K)"}, ["r", "K"]).reduced

    assert sp.expand(reduced.rates["x"] - x * (1 - x)) == 0
    assert reduced.definitions == {
        "t": {"t": Fraction(1), "r": Fraction(1)},
        "x": {"x": Fraction(1), "K": Fraction(-1)},
    }


def test_fractional_scales_where_no_whole_ones_exist():
    reduced = scaling_symmetries({"x": "a - b*x**2"}, ["a", "b"]).reduced

    assert reduced.rates["x"] == 1 - x**2
    assert reduced.definitions["x"] == {"x": 1, "a": Fraction(-1, 2), "b": Fraction(1, 2)}


def test_a_state_as_a_scale_leaves_by_its_own_integral():
    # x' = -x^2 y, y' = x y - x y^2: time scales with 1/x and y with nothing
    reduced = scaling_symmetries({"x": "-x**2*y", "y": "x*y - x*y**2"}, []).reduced

    assert reduced.base == ("x",)
    assert sp.expand(reduced.rates["y"] - (y - y**2)) == 0
    assert reduced.drifts == {"x": -y}


def test_time_that_is_measured_in_a_state_runs_by_itself():
    reduced = scaling_symmetries({"x": "-x**2*(1 + sin(t*x))"}, []).reduced

    # d(t x)/dsigma with x' = -(1 + sin t x) x^2 and dt = dsigma/x
    assert sp.expand(reduced.rates["t"] - (1 - t - t * sp.sin(t))) == 0


def test_signals_in_a_base_bring_their_drift():
    reduced = scaling_symmetries({"x": "u*x"}, [], signals=["u"]).reduce(["x", "u"])

    assert reduced.drifts == {"x": 1, "u": sp.Symbol("drift_u", real=True)}


def test_units_give_the_groups_of_the_paper():
    found = scalings_of(equations_of(BICYCLE))
    ours = found.reduce(["m", "L", "U", "delta"])
    groups = bicycle_groups()

    named = {new: ours.definitions[new] for new in ours.definitions if new.startswith("pi")}
    assert named == {g.name: g.exponents for g in groups.groups}
    drift = sp.Symbol("drift_delta", real=True)
    for state in ("v", "r"):  # with one radian as the unit of the steer, and a steer that is held
        symbol = sp.Symbol(state, real=True)
        paper = groups.rates[state].subs(sp.Symbol("delta", real=True), 1)
        assert sp.expand(ours.rates[state] + symbol * drift - paper) == 0


def test_names_of_groups_avoid_names_that_are_taken():
    reduced = scaling_symmetries({"x": "a*x - pi1*x**2 - b*x"}, ["pi1", "a", "b"]).reduced

    assert set(reduced.rates["x"].free_symbols) == {x, sp.Symbol("pi2", real=True)}
    assert "pi1" in reduced.base


@pytest.mark.parametrize(
    "rates",
    [{"S": "-k*S*E + b*C", "C": "k*S*E - (b + c)*C"}, {"S": "-k*S**2 + b/(c + S)", "C": "exp(-c/S)*b"}],
)
def test_restoring_is_the_inverse_of_reducing(rates):
    found = scaling_symmetries(rates, ["k", "b", "c", "E"])

    for state in found.reduced.rates:
        assert sp.simplify(found.reduced.restore(state) - found.equations.rates[state]) == 0


def test_a_preferred_base_is_taken_even_with_fractional_powers():
    crane = shipped_system("overhead_crane").model

    assert scalings_of(equations_of(crane), prefer=("M", "L", "g")).base == ("M", "L", "g")
