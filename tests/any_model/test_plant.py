"""The plant against closed forms, and its two routes against each other."""

from dataclasses import replace

import numpy as np
import pytest

from similitude import Model, Quantity, shipped_system
from similitude.any_model.plant import _stepped, is_linear, respond
from similitude.errors import UsageError

RLC = shipped_system("rlc_circuit")
T = 2e-5 * np.arange(150)


def test_a_step_gives_the_closed_form():
    v = RLC.numbers()
    found = respond(RLC.model, v, np.full(150, 48.0), 2e-5).output[0]
    alpha, w0 = v["R"] / 2 / v["L"], (v["L"] * v["C"]) ** -0.5
    w = np.sqrt(w0**2 - alpha**2)
    truth = 48 * (1 - np.exp(-alpha * T) * (np.cos(w * T) + alpha / w * np.sin(w * T)))

    np.testing.assert_allclose(found, truth, atol=1e-9)


def test_both_routes_agree_on_a_linear_model():
    v, u = RLC.numbers(), 10 * np.sin(3000 * T)
    fixed = {n: np.array([x]) for n, x in v.items()}
    exact = respond(RLC.model, v, u, 2e-5).output
    stepped = _stepped(RLC.model, fixed, {}, u, 2e-5, np.zeros((1, 2))).output

    assert np.abs(stepped - exact).max() < 1e-5 * np.abs(exact).max()


def test_systems_side_by_side_are_the_same_as_one_by_one():
    crane = shipped_system("overhead_crane")
    v, u = crane.numbers(), 0.3 * np.sin(np.arange(60) * 0.1)
    both = respond(crane.model, {**v, "m": np.array([0.1, 0.3])}, u, 0.02).output

    for row, m in zip(both, (0.1, 0.3), strict=True):
        np.testing.assert_allclose(row, respond(crane.model, {**v, "m": m}, u, 0.02).output[0], atol=1e-12)


def test_linear_means_nothing_added_and_no_product():
    x = Quantity("x", "1")
    model = Model(name="lag", states=(x,), inputs=(Quantity("u", "1"),), outputs=(x,),
                  parameters=(Quantity("a", "1/s"),), rates={"x": "a*(u - x)"})  # fmt: skip

    assert is_linear(model)
    assert not is_linear(replace(model, rates={"x": "a*(u - x*x)"}))
    assert not is_linear(replace(model, rates={"x": "a*(u - x + 1)"}))


def test_a_sample_far_too_long_says_so():
    x = Quantity("x", "1")
    model = Model(name="lag", states=(x,), inputs=(Quantity("u", "1"),), outputs=(x,),
                  parameters=(Quantity("a", "1/s"),), rates={"x": "a*(u - x - x**3)"})  # fmt: skip
    with pytest.raises(UsageError, match="fastest time constant"):
        respond(model, {"a": 1e6}, np.ones(60), 1.0)
