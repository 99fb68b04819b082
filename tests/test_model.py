"""A Model that contradicts itself cannot be made, and says where."""

import pytest
import sympy as sp

from similitude.errors import ModelError, UnitError
from similitude.model import Model, Quantity, mismatches_of
from similitude.systems.bicycle import BICYCLE
from similitude.units import Dimension

x, u, k, m = sp.symbols("x u k m", real=True)
DRAG = Quantity("m", "N s/m", "drag")


def model(**changes) -> Model:
    """A lag: x' = (u - k x)/m."""
    parts = {
        "name": "lag",
        "states": (Quantity("x", "m"),),
        "inputs": (Quantity("u", "N"),),
        "outputs": (Quantity("x", "m"),),
        "parameters": (Quantity("k", "N/m"), DRAG),
        "rates": {"x": (u - k * x) / m},
        "output_map": {"x": x},
    }
    return Model(**(parts | changes))


def test_quantities_keep_their_order_and_an_output_that_is_a_state_counts_once():
    assert [q.name for q in model().quantities] == ["x", "u", "k", "m"]
    own = model(outputs=(Quantity("force", "N"),), output_map={"force": k * x})
    assert [q.name for q in own.quantities] == ["x", "u", "force", "k", "m"]


def test_a_quantity_knows_its_dimension_and_symbol():
    stiffness = model().quantity("k")

    assert stiffness.symbol == k
    assert stiffness.dimension.exponents == {"mass": 1, "time": -2}
    assert Quantity("angle", "rad").dimension == Dimension.none


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"parameters": (Quantity("k", "N/m"), Quantity("x", "m"))}, "x is declared more than once"),
        ({"inputs": (Quantity("u", "N"), Quantity("u", "N"))}, "u is declared more than once"),
        ({"rates": {}}, "rates and declarations differ in x"),
        ({"rates": {"x": u, "y": u}}, "differ in y"),
        ({"output_map": {}}, "output expressions and declarations differ in x"),
        ({"parameters": (Quantity("k", "N/m"),)}, "uses m, which is not declared"),
        ({"constraints": {"k": sp.Symbol("z", real=True)}}, "uses z, which is not declared"),
    ],
)
def test_a_contradiction_is_refused_by_name(changes, said):
    with pytest.raises(ModelError, match=said) as caught:
        model(**changes)

    assert "lag" in str(caught.value) and "Paste" in str(caught.value)


def test_an_unknown_name_lists_the_known_ones():
    with pytest.raises(ModelError, match=r"no quantity 'q' \(there are x, u, k, m\)"):
        model().quantity("q")


def test_formulas_may_be_text_expressions_or_numbers_and_mean_the_same():
    given = [{"x": "(u - k*x)/m"}, {"x": (u - k * x) / m}, {"x": (sp.Symbol("u") - k * x) / m}]

    assert [model(rates=rates).rates for rates in given] == [model().rates] * 3
    assert model(rates={"x": 0}).rates == {"x": 0}


def test_a_function_is_followed_with_symbols():
    def rates(states, inputs, parameters):
        (x,) = states
        return {"x": (inputs.u - parameters["k"] * x) / parameters.m}

    assert model(rates=rates, output_map=lambda s, i, p: s.x) == model()


def test_an_output_that_is_a_state_needs_no_formula():
    assert model(output_map=None) == model()


@pytest.mark.parametrize(
    ("rates", "said"),
    [
        ({"x": "u - m*x"}, r"-m\*x is in kg m/s, but u in N \(N against kg m/s\)"),
        ({"x": "(u - m*x)/m"}, r"N against kg m/s"),
        ({"x": "u"}, r"u is in N, the rate of 'x' in m/s"),
        ({"x": "u/m - 3"}, r"-3 is in -, but u/m in m/s"),
        ({"x": "u/m*sin(k*x)"}, r"k\*x is in kg m/s\^2, and sin takes a pure number"),
    ],
)
def test_the_term_that_does_not_fit_is_named_with_both_dimensions(rates, said):
    """``u - m*x``: m is a drag and x a length, so the product is a momentum in disguise."""
    momentum = {"parameters": (Quantity("k", "N/m"), Quantity("m", "kg/s", "drag"))}
    with pytest.raises(ModelError, match=said) as caught:
        model(rates=rates, **momentum)

    assert "the rate of 'x' is not homogeneous" in str(caught.value)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"outputs": (Quantity("f", "N"),), "output_map": {"f": "k*x + u*x"}}, "the output 'f'"),
        ({"constraints": {"k": "m"}}, "the constraint on 'k'"),
        ({"validity": ("k*x", Quantity("limit", "m"))}, "the validity"),
        ({"signals": ("x",)}, "'x' is listed as signal, but is no parameter"),
        ({"constraints": {"u": "u"}}, "'u' is listed as constrained, but is no parameter"),
    ],
)
def test_outputs_constraints_and_validity_are_checked_too(changes, said):
    with pytest.raises(ModelError, match=said):
        model(**changes)


def test_the_bicycle_is_homogeneous_unless_angles_count():
    """Slip is a ratio of speeds taken for an angle, and that is what is said."""
    assert mismatches_of(BICYCLE) == {}
    said = [str(one) for one in mismatches_of(BICYCLE, angle=True)["the rate of 'r'"]]
    assert "-(a*r + v)/U is in -, but delta in rad (rad against -)" in said


def test_a_known_value_has_a_unit_of_its_own():
    assert Quantity("g", "m/s^2", known="981 cm/s^2").value == pytest.approx(9.81)
    assert Quantity("g", "m/s^2").value is None


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        (("k 1", "N/m"), ModelError, "'k 1' is no name"),
        (("k", "N/blurb"), UnitError, "quantity 'k'"),
        (("k", 3), UnitError, "quantity 'k': the unit is 3"),
        (("g", "m/s^2", "", "9.81 m/s"), UnitError, "quantity 'g'"),
        (("g", "m/s^2", "", "9.81"), UnitError, "has no unit"),
    ],
)
def test_a_quantity_that_cannot_be_is_refused(arguments, error, said):
    with pytest.raises(error, match=said):
        Quantity(*arguments)
