"""A Model that contradicts itself cannot be made, and says where."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.units import Dimension

x, u, k, m = sp.symbols("x u k m", real=True)


def model(**changes) -> Model:
    """A lag: x' = (u - k x)/m."""
    parts = {
        "name": "lag",
        "states": (Quantity("x", "m"),),
        "inputs": (Quantity("u", "N"),),
        "outputs": (Quantity("x", "m"),),
        "parameters": (Quantity("k", "N/m"), Quantity("m", "N s/m", "drag")),
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
        ({"output_map": {"x": sp.Symbol("x")}}, "uses x, which is not declared"),  # not real=True
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
