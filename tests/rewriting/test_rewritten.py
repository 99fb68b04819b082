"""A model rewritten is a model: the paper's, with the way back, and with what the chain rule adds."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.rewriting.rewritten import rewrite
from similitude.systems.bicycle import BICYCLE

v, r, delta, rate = sp.symbols("v r delta U_rate", real=True)
pi1, pi2, pi3, pi4, pi5 = sp.symbols("pi1:6", real=True)
BASE = ("m", "L", "U")


def test_the_bicycle_of_the_paper_without_dimensions():
    """Science of eqs 17-20: k = pi4/pi3, p2 = pi2."""
    model = rewrite(BICYCLE, base=BASE).model
    k = pi4 / pi3
    first = pi3 * (-(1 + k) * v + (pi2 * k - pi1) * r + delta) - r
    second = pi3 / pi5 * ((pi2 * k - pi1) * v - (pi1**2 + pi2**2 * k) * r + pi1 * delta)

    assert sp.expand(model.rates["v"] - first) == 0 and sp.expand(model.rates["r"] - second) == 0
    assert {q.unit for q in model.quantities} == {"1"} and model.time_unit == "1"
    assert model.signals == ("pi3", "pi4") and model.constraints == {"pi2": 1 - pi1}
    assert model.validity[0] == r


def test_the_way_back_is_the_model():
    back = rewrite(BICYCLE, base=BASE).back()

    assert all(sp.expand(back.rates[n] - e) == 0 for n, e in BICYCLE.rates.items())


def test_a_model_without_dimensions_is_rewritten_into_itself():
    model = rewrite(BICYCLE, base=BASE).model

    assert rewrite(model, base=()).model.rates.keys() == model.rates.keys()


def test_a_moving_scale_adds_its_terms_or_is_stated():
    still, moving = rewrite(BICYCLE, base=BASE), rewrite(BICYCLE, base=BASE, moving=["U"])

    assert moving.model.rates["v"] - still.model.rates["v"] == -rate * v
    assert moving.left_out == {} and moving.statement == ""
    assert still.left_out == {"v": -rate * v, "r": -rate * r}
    assert "U taken as constant; left out: -U_rate*v in the rate of v" in still.statement
    assert still.statement in str(still)


def test_only_what_is_in_the_base_moves_the_scales():
    with pytest.raises(ModelError, match="'Caf' is said to move, but is not in the base"):
        rewrite(BICYCLE, base=BASE, moving=["Caf"])


def test_sums_under_roots_and_in_functions_are_rewritten():
    tank = Model(
        "tank",
        [Quantity("h", "m")],
        [Quantity("q", "m^3/s")],
        [Quantity("h", "m")],
        [Quantity(n, "m^2") for n in "Aa"] + [Quantity("g", "m/s^2"), Quantity("z", "m")],
        {"h": "(q - a*sqrt(2*g*(h + z)))/A"},
    )
    h, q, z = (sp.Symbol(n, real=True) for n in ("h", "q", "pi2"))

    found = rewrite(tank, base=("A", "g")).model.rates["h"]
    assert sp.expand(found - (q - pi1 * sp.sqrt(2) * sp.sqrt(h + z))) == 0
