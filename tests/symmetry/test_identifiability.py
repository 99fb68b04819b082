"""What outputs tell, held against transfer functions and solutions that are known in closed form."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.equations import read_equations
from similitude.symmetry.identifiability import identifiability, identifiable
from similitude.systems.bicycle import BICYCLE
from similitude.systems.saturating_bicycle import SATURATING_BICYCLE


def seen_by(rates, parameters, outputs, *, signals="", **known):
    equations = read_equations(rates, parameters.split(), signals=signals.split(), time="t")
    symbols = {name: sp.Symbol(name, real=True) for name in equations.names}
    expressions = {name: sp.sympify(name, locals=symbols) for name in outputs}
    return identifiability(equations, expressions, **known)


def span(rows, names):
    return sp.Matrix([[sp.Rational(str(row.get(n, 0))) for n in names] for row in rows])


def test_a_decay_tells_its_rate_and_not_its_scale():
    found = seen_by({"x": "-k*x"}, "k c", ["c*x"])

    assert found.unseen == ({"c": 1, "x(0)": -1},)
    assert found.seen == ({"k": 1},)


def test_a_product_is_seen_and_its_factors_are_not():
    found = seen_by({"x": "-a*b*x + c*u"}, "a b c", ["x"], signals="u")

    assert found.unseen == ({"a": 1, "b": -1},)
    assert found.seen == ({"a": 1, "b": 1}, {"c": 1})
    assert not found.is_complete


def test_a_sum_is_seen_and_its_terms_are_not():
    found = seen_by({"x": "-(a + b)*x"}, "a b", ["x"])

    assert (found.unseen, found.curved, found.involved) == ((), 1, ("a", "b"))
    assert found.shifts == ({"a": 1, "b": -1},)
    assert found.seen == ()


def test_a_saturating_rate_tells_both_parameters():
    assert seen_by({"S": "-V*S/(K + S)"}, "V K", ["S"]).is_complete


def test_a_state_nobody_measures_is_named():
    found = seen_by({"x": "-k*x", "y": "x - y"}, "k", ["x"])

    assert found.is_complete
    assert found.hidden_states == ("y",)


def test_known_parameters_make_others_visible():
    assert seen_by({"x": "-a*b*x"}, "a b", ["x"], known=["b"]).is_complete


@pytest.mark.parametrize("rate", ["-g/l*sin(x) - c*v", "-g/l*sqrt(x) - c*v", "-g/l*x - c*v"])
def test_a_pendulum_tells_gravity_over_length_whatever_its_arithmetic(rate):
    found = seen_by({"x": "v", "v": rate}, "g l c", ["x"])

    assert found.unseen == ({"g": 1, "l": 1},)
    assert found.seen == ({"g": 1, "l": -1}, {"c": 1})


def test_a_bicycle_at_constant_speed_tells_the_numerator_of_its_transfer_function():
    # yaw rate over steer: a Caf/Iz s + Caf Car L/(m Iz U); the two of the denominator are sums
    found = identifiable(BICYCLE, held=["U"])

    names = ("m", "L", "a", "Caf", "Car", "Iz")
    meant = [
        {"a": 1, "Caf": 1, "Iz": -1},
        {"Caf": 1, "Car": 1, "L": 1, "m": -1, "Iz": -1},
    ]
    assert found.parameters == names  # b is L - a
    assert found.unseen == ({"m": 1, "Caf": 1, "Car": 1, "Iz": 1},)
    assert found.curved == 1
    assert found.determined == 4  # the coefficients of the transfer function
    assert span([*found.seen, *meant], names).rank() == span(found.seen, names).rank() == 2


def test_a_change_of_speed_shows_a_bicycle_all_but_its_mass():
    # coefficients with 1/U and without are told apart: five numbers for six parameters
    found = identifiable(BICYCLE)

    assert found.unseen == ({"m": 1, "Caf": 1, "Car": 1, "Iz": 1},)
    assert found.curved == 0
    assert len(found.seen) == 5


def test_the_limit_of_grip_shows_what_a_linear_tyre_hides():
    found = identifiable(SATURATING_BICYCLE, held=["U"])

    assert found.curved == 0
    assert {"grip": 1} in found.seen


def test_michaelis_and_menten_from_the_complex_alone():
    # C'' in C, C' has the sums km + k2 and k1; E enters with k1 only: k1 E and the like
    found = seen_by({"S": "-k1*E*S + km*C", "C": "k1*E*S - (km + k2)*C"}, "k1 km k2 E", ["C"])

    assert {"k1": 1, "E": -1} in found.unseen
    assert found.curved == 1  # three rates, two roots: k1 E + km + k2 and k1 E k2
    assert found.seen == ({"k1": 1, "k2": 1, "E": 1},)


def test_no_parameters_and_no_outputs_are_answered():
    assert seen_by({"x": "-x"}, "", ["x"]).is_complete
    assert seen_by({"x": "-k*x"}, "k", []).unseen == ({"k": 1},)


def test_a_name_that_is_no_parameter_is_refused():
    with pytest.raises(ModelError, match="'x', which is no parameter"):
        seen_by({"x": "-k*x"}, "k", ["x"], known=["x"])


def test_other_outputs_and_more_that_is_known():
    assert identifiable(BICYCLE, ["v"], known=["m"]).outputs == ("v",)
    assert identifiable(BICYCLE, known=["m"]).is_complete


@pytest.mark.parametrize("asked", [{"outputs": ["ay"]}, {"held": ["m"]}, {"known": ["delta"]}])
def test_names_that_are_not_the_models_are_refused(asked):
    with pytest.raises(ModelError) as caught:
        identifiable(BICYCLE, **asked)
    assert all((caught.value.usually, caught.value.paste, caught.value.read))
