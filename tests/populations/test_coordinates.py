"""Coordinates: every real z is a possible car, and every car is one z."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.errors import ModelError
from similitude.groups import reparameterize
from similitude.model import Model, Quantity
from similitude.populations.building import PRODUCTS
from similitude.populations.coordinates import coordinates_of
from similitude.systems.bicycle import BICYCLE, bicycle_groups

SPACE = coordinates_of(bicycle_groups(), products=PRODUCTS)
finite = st.lists(st.floats(-3, 3), min_size=6, max_size=6)


@settings(deadline=None)
@given(finite)
def test_the_constraint_holds_for_every_z(z):
    value = dict(zip(SPACE.parameters, np.exp(SPACE.logs(np.array(z))), strict=True))

    assert value["a"] + value["b"] == pytest.approx(value["L"], rel=1e-12)


@settings(deadline=None)
@given(finite)
def test_coordinates_are_what_their_names_say(z):
    value = dict(zip(SPACE.parameters, np.exp(SPACE.logs(np.array(z))), strict=True))
    m, L, a, b, Caf, Car, Iz = (value[n] for n in ("m", "L", "a", "b", "Caf", "Car", "Iz"))
    said = dict(zip(SPACE.names, z, strict=True))
    meant = {
        "ln m": np.log(m), "ln L": np.log(L), "ln K": np.log(Caf * L / m), "logit a/L": np.log(a / b),
        "ln eta": np.log(Car * b / (Caf * a)), "ln rho": np.log(Iz / (m * a * b)),
    }  # fmt: skip

    assert said == pytest.approx(meant, abs=1e-9)


def test_slopes_are_the_derivatives():
    z, h = np.random.default_rng(0).normal(size=(5, 6)), 1e-6
    slopes = SPACE.slopes(z)
    for k in range(6):
        step = h * np.eye(6)[k]
        np.testing.assert_allclose(
            slopes[..., k], (SPACE.logs(z + step) - SPACE.logs(z - step)) / (2 * h), atol=1e-8
        )


def test_a_signal_stands_at_its_stated_value():
    groups = bicycle_groups()
    space = coordinates_of(groups, at={"U": 20.0})
    _, fixed = space.exponents([g.exponents for g in groups.groups])

    assert fixed == pytest.approx([0, 0, -2 * np.log(20), -2 * np.log(20), 0])


def _model(constraint):
    x, u, p, q, s = sp.symbols("x u p q s", real=True)
    return Model(
        name="one", states=(Quantity("x", "m"),), inputs=(Quantity("u", "m/s"),),
        outputs=(Quantity("x", "m"),),
        parameters=(Quantity("p", "s"), Quantity("q", "s"), Quantity("s", "s"), Quantity("w", "m")),
        rates={"x": u - x / s}, output_map={"x": x}, constraints={"s": constraint(p, q)},
    )  # fmt: skip


def test_a_whole_that_is_the_sum_of_its_parts_is_a_share_too():
    groups = reparameterize(_model(lambda p, q: p + q), base=("p", "w"))
    space = coordinates_of(groups)
    value = dict(zip(space.parameters, np.exp(space.logs(np.array([0.2, 0.1, -0.7]))), strict=True))

    assert value["p"] + value["q"] == pytest.approx(value["s"])


def test_a_product_that_is_a_parameter_is_kept():
    groups = reparameterize(_model(lambda p, q: p**2 / q), base=("p", "w"))
    space = coordinates_of(groups)
    value = dict(zip(space.parameters, np.exp(space.logs(np.array([0.2, 0.1, -0.7]))), strict=True))

    assert value["p"] ** 2 / value["q"] == pytest.approx(value["s"])


def test_other_constraints_are_refused():
    groups = reparameterize(_model(lambda p, q: sp.sqrt(p * p + q * q)), base=("p", "w"))
    with pytest.raises(ModelError, match="cannot keep the constraint"):
        coordinates_of(groups)


def test_the_bicycle_needs_no_more_than_its_independent_parameters():
    assert len(SPACE.names) == len(BICYCLE.parameters) - len(BICYCLE.signals) - len(BICYCLE.constraints)
