"""Frequency, sampled, poles, zeros and gain against other routes: scipy, differences, the paper's formula."""

import numpy as np
import pytest
import sympy as sp
from scipy.signal import cont2discrete, ss2tf

from similitude.errors import ModelError
from similitude.invariance.invariances import invariances
from similitude.model import Model, Quantity
from similitude.systems.bicycle import BICYCLE
from similitude.systems.saturating_bicycle import SATURATING_BICYCLE

CAR = {"m": 5.451, "Iz": 0.1615, "U": 4.0, "a": 0.1461, "b": 0.2191, "Caf": 65.0, "Car": 110.0}
POINTS = {"frequency": {"s": 2j}, "z": {"z": 0.9 + 0.2j, "Ts": 0.01}, "poles": {}, "zeros": {}, "dc_gain": {}}
SINGULAR = {"L": 0.3652, "grip": 4.0, "v": 0.1, "r": 0.2, "delta": 0.03}  # an operating point


def matrices(c):
    """Of the yaw rate, from section 2 of the paper."""
    m, Iz, U, a, b, front, rear = (c[n] for n in ("m", "Iz", "U", "a", "b", "Caf", "Car"))
    A = [
        [-(front + rear) / (m * U), (b * rear - a * front) / (m * U) - U],
        [(b * rear - a * front) / (Iz * U), -(a * a * front + b * b * rear) / (Iz * U)],
    ]
    return np.array(A), np.array([[front / m], [a * front / Iz]]), np.array([[0.0, 1.0]]), np.zeros((1, 1))


def test_values_are_those_of_the_papers_matrices():
    A, B, C, D = matrices(CAR)
    Ad, Bd, Cd, Dd, _ = cont2discrete((A, B, C, D), 0.01)
    z = POINTS["z"]["z"]
    found = {k: invariances(BICYCLE, response=k).value(CAR | at) for k, at in POINTS.items()}

    assert found["frequency"] == pytest.approx((C @ np.linalg.solve(2j * np.eye(2) - A, B))[0, 0], rel=1e-12)
    assert found["z"] == pytest.approx((Cd @ np.linalg.solve(z * np.eye(2) - Ad, Bd) + Dd)[0, 0], rel=1e-12)
    assert np.sort_complex(found["poles"]) == pytest.approx(np.sort_complex(np.linalg.eigvals(A)))
    assert found["zeros"] == pytest.approx(np.roots(np.trim_zeros(ss2tf(A, B, C, D)[0][0], "f")))
    assert found["dc_gain"] == pytest.approx(-(C @ np.linalg.solve(A, B))[0, 0])


@pytest.mark.parametrize("kind", POINTS)
@pytest.mark.parametrize("model", [BICYCLE, SATURATING_BICYCLE], ids=lambda m: m.name)
def test_slopes_are_those_of_differences_and_rows_hold(kind, model):
    rows = invariances(model, response=kind)
    known = {**CAR, **POINTS[kind], **(SINGULAR if model is SATURATING_BICYCLE else {})}
    given = {n: known[n] for n in rows.arguments}
    S, step = rows.sensitivities(given), 1e-5

    assert all(residual == 0 for residual in rows.verify().values())
    assert max(rows.verify(given).values()) < 1e-12
    some = rows.arguments if model is BICYCLE else ("grip", "delta", "s", "Ts")  # what only it has
    for name in set(some) & set(rows.arguments):
        up, down = (rows.value({**given, name: given[name] * np.exp(way * step)}) for way in (1, -1))
        assert S[name] == pytest.approx((up - down) / (2 * step) / rows.value(given), abs=1e-7), name


def test_the_frequency_row_carries_s_and_the_sampled_one_Ts():
    assert invariances(BICYCLE, response="frequency").rows[2].coefficients["s"] == -1
    assert invariances(BICYCLE, response="z").rows[2].coefficients["Ts"] == 1
    assert "z" not in invariances(BICYCLE, response="z").rows[2].coefficients


def test_symbolic_sensitivities_are_exact_and_sum_as_the_rows_say():
    rows = invariances(BICYCLE, response="frequency")
    S = rows.sensitivities()

    at = {x: sp.Rational(k + 3, 7) for k, x in enumerate(sorted(S["m"].free_symbols, key=str))}
    exact = {name: e.xreplace(at) for name, e in S.items()}
    assert exact["m"].is_Rational
    for row in rows.rows:
        assert row.left_side(exact) == row.rhs


def test_what_cancels_from_the_gain_is_no_argument():
    assert "Iz" not in invariances(BICYCLE, response="dc_gain").arguments


def integrator() -> Model:
    return Model(
        "integrator", [Quantity("x", "m")], [Quantity("u", "m/s")], [Quantity("x", "m")], [], {"x": "u"}
    )


def test_a_system_without_a_gain_or_with_too_many_states_is_refused():
    with pytest.raises(ModelError, match="no gain at rest"):
        invariances(integrator(), response="dc_gain")
    names = [f"x{i}" for i in range(7)]
    states = [Quantity(name, "1") for name in names]
    chain = Model(
        "chain", states, [Quantity("u", "1")], states[-1:], [Quantity("k", "1/s")],
        {name: f"k*({before} - {name})" for before, name in zip(["u", *names], names, strict=False)},
    )  # fmt: skip
    assert invariances(chain, response="poles").verify() == {"time": 0}
    assert invariances(chain, response="frequency").verify({"k": 2.0, "s": 1j})["time"] < 1e-12
    with pytest.raises(ModelError, match="zeros are found for 6 at most"):
        invariances(chain, response="zeros")


def test_without_zeros_there_is_nothing_to_be_wrong():
    assert invariances(integrator(), response="zeros").verify({}) == {"time": 0.0}
