"""Names with one role each, symbols that are a model's, and faults that are said."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.symmetry.equations import equations_of, read_equations
from similitude.symmetry.scalings import scalings_of
from similitude.systems.bicycle import BICYCLE


def read(rates, parameters=("k",), signals=(), time="t"):
    return read_equations(rates, parameters, signals=signals, time=time)


def test_text_expressions_and_numbers_make_the_same_equations():
    x, k = sp.symbols("x k")  # without assumptions, as people make them
    moving = sp.Function("x")(sp.Symbol("t"))

    meant = read({"x": "-k*x"})

    assert read({"x": -k * x}) == meant
    assert read({x: -k * x}, [k]) == meant
    assert read({"x": -k * moving}) == meant
    assert read({"x": 0.5}).rates["x"] == sp.Rational(1, 2)
    assert meant.names == ("t", "x", "k")


def test_a_model_brings_its_outputs_and_constraints():
    of_car = equations_of(BICYCLE)

    assert of_car.signals == ("delta",)
    assert of_car.results == ()  # its output is a state
    assert set(of_car.relations) == {"b"}


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"rates": {}}, "gives no state a rate"),
        ({"rates": "x' = k*x"}, "gives no state a rate"),
        ({"rates": {"x": "-q*x"}}, "'q', which is not declared"),
        ({"rates": {"x": -sp.Symbol("q")}}, "'q', which is not declared"),
        ({"rates": {"x": None}}, "and no text"),
        ({"rates": {"x": ""}}, "is empty"),
        ({"rates": {"x": float("nan")}}, "and no text"),
        ({"rates": {"x": sp.Symbol("x") > 0}}, "and no text"),
        ({"rates": {"x": "k*x"}, "parameters": None}, "not a list of names"),
        ({"rates": {"x": "k*x"}, "parameters": "k"}, "not a list of names"),
        ({"rates": {"x": "k*x"}, "signals": "u, v"}, "not a list of names"),
        ({"rates": {"x": "k*x"}, "parameters": ("k", "k")}, "given twice"),
        ({"rates": {"x": "k*x"}, "parameters": ("k", "x")}, "is a state and a parameter"),
        ({"rates": {"x": "k*x"}, "parameters": ("k", "t")}, "is a time and a parameter"),
        ({"rates": {"x": "k*x"}, "parameters": ("k 1",)}, "is no name"),
        ({"rates": {"x": "k*x"}, "parameters": (3,)}, "is no name"),
    ],
)
def test_faults_have_four_parts(given, says):
    with pytest.raises(ModelError) as caught:
        read(**given)

    assert says in caught.value.what
    assert all((caught.value.usually, caught.value.paste, caught.value.read))


def test_time_has_no_part_in_a_formula_without_states():
    drag = Model(
        name="drag",
        states=(),
        inputs=(),
        outputs=(Quantity("F", "N"),),
        parameters=(Quantity("rho", "kg/m^3"), Quantity("V", "m/s"), Quantity("A", "m^2")),
        rates={},
        output_map={"F": "rho*V**2*A/2"},
    )
    found = scalings_of(equations_of(drag))

    assert found.equations.names == ("rho", "V", "A", "F")
    assert found.count == 3
    assert found.verify()
