"""Handling numbers against the state-space model built from m, Iz, a, b, Caf, Car."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.handling import GRAVITY, handling, understeer_gradient

SMALL = np.diag(np.square([0.03, 0.004, 0.02, 0.02]))  # of ln K, pi1, ln eta, ln rho
PER_G = GRAVITY * 180 / np.pi

cars = st.fixed_dictionaries(
    {
        "m": st.floats(3, 3000),
        "a": st.floats(0.9, 1.6),
        "b": st.floats(0.9, 1.6),
        "front": st.floats(40, 400),  # Caf/m [m/s^2]
        "k": st.floats(0.6, 2.5),  # Car/Caf
        "gyration": st.floats(0.8, 1.3),  # Iz/(m a b)
    }
)


def physical(m, a, b, front, k, gyration):
    return {"m": m, "a": a, "b": b, "Caf": front * m, "Car": k * front * m, "Iz": gyration * m * a * b}


def groups(p):
    L = p["a"] + p["b"]
    return {
        "K": p["Caf"] * L / p["m"],
        "pi1": p["a"] / L,
        "eta": p["Car"] * p["b"] / (p["Caf"] * p["a"]),
        "rho": p["Iz"] / (p["m"] * p["a"] * p["b"]),
    }


def state_space(p, U):
    """x = [lateral velocity, yaw rate], SI (Brennan & Alleyne 2004, eqs 1-4)."""
    m, Iz, a, b, Caf, Car = (p[key] for key in ("m", "Iz", "a", "b", "Caf", "Car"))
    A = np.array(
        [
            [-(Caf + Car) / (m * U), (b * Car - a * Caf) / (m * U) - U],
            [(b * Car - a * Caf) / (Iz * U), -(a * a * Caf + b * b * Car) / (Iz * U)],
        ]
    )
    return A, np.array([Caf / m, a * Caf / Iz])


def numbers(p, U, covariance=SMALL):
    return handling(groups(p), covariance, L=p["a"] + p["b"], U=U)


@settings(max_examples=60, deadline=None)
@given(cars, st.floats(3, 60))
def test_gains_are_the_steady_state_of_the_model_and_the_mode_its_eigenvalues(drawn, U):
    p = physical(**drawn)
    A, B = state_space(p, U)
    eigenvalues = np.linalg.eigvals(A)
    found = numbers(p, U)
    lost = 1e-13 * np.linalg.cond(A) + 1e-11
    if eigenvalues.real.max() > -1e-6 * np.abs(eigenvalues).max():
        if np.linalg.det(A) < 0:  # unstable: there is no steady state and no oscillation
            assert not found.keys() & {"yaw_rate_gain", "sideslip_gain", "yaw_frequency"}
        return
    v, r = -np.linalg.solve(A, B)
    assert found["yaw_rate_gain"]["value"] == pytest.approx(r, rel=lost)
    assert found["sideslip_gain"]["value"] == pytest.approx(v / U, rel=lost, abs=lost)
    natural = np.sqrt(np.prod(eigenvalues).real)
    assert found["yaw_frequency"]["value"] * 2 * np.pi == pytest.approx(natural, rel=lost)
    damping = -eigenvalues.sum().real / (2 * natural)
    assert found["yaw_damping"]["value"] == pytest.approx(damping, rel=lost)


@settings(max_examples=60, deadline=None)
@given(cars, st.floats(3, 12))
def test_understeer_gradient_from_two_steady_states(drawn, U):
    """Steer at two speeds on one circle: d(delta)/d(ay) is the gradient."""
    p = physical(**drawn)
    curvature, steer, ay = 0.01, [], []
    for speed in (U, 1.5 * U):
        A, B = state_space(p, speed)
        _, gain = -np.linalg.solve(A, B)
        steer.append(curvature * speed / gain)
        ay.append(curvature * speed**2)
    slope = np.diff(steer)[0] / np.diff(ay)[0]
    direct = p["m"] / (p["a"] + p["b"]) * (p["b"] / p["Caf"] - p["a"] / p["Car"])

    assert understeer_gradient(p["a"] + p["b"], **groups(p)) == pytest.approx(slope, rel=1e-7, abs=1e-9)
    assert understeer_gradient(p["a"] + p["b"], **groups(p)) == pytest.approx(direct, rel=1e-10, abs=1e-14)
    assert numbers(p, U)["understeer_gradient"]["value"] == pytest.approx(slope * PER_G, rel=1e-7, abs=1e-6)


@settings(max_examples=60, deadline=None)
@given(cars)
def test_critical_speed_is_where_an_eigenvalue_crosses_zero(drawn):
    p = physical(**drawn)
    found = numbers(p, 10.0)
    if "critical_speed" not in found:
        assert understeer_gradient(p["a"] + p["b"], **groups(p)) >= 0
        for U in (20.0, 80.0, 300.0):
            assert np.linalg.eigvals(state_space(p, U)[0]).real.max() < 0
        return
    U = found["critical_speed"]["value"]
    largest = [np.linalg.eigvals(state_space(p, U * f)[0]).real.max() for f in (0.999, 1.001)]
    assert largest[0] < 0 < largest[1]
    assert "characteristic_speed" not in found


@settings(max_examples=60, deadline=None)
@given(cars)
def test_characteristic_speed_is_where_the_yaw_gain_is_greatest(drawn):
    p = physical(**drawn)
    U = numbers(p, 10.0).get("characteristic_speed", {}).get("value")
    if U is None:
        assert understeer_gradient(p["a"] + p["b"], **groups(p)) <= 0
        return
    gains = [-np.linalg.solve(*state_space(p, U * f))[1] for f in (0.98, 1.0, 1.02)]
    assert gains[1] > max(gains[0], gains[2])


def test_sd_is_that_of_a_thousand_drawn_cars():
    mean = {"K": 110.0, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}
    rng = np.random.default_rng(3)
    root = rng.normal(size=(4, 4)) * np.sqrt(np.diag(SMALL))[:, None]
    covariance = 0.3 * (SMALL + 0.5 * root @ root.T)  # correlated, a few per cent each
    draws = rng.multivariate_normal(np.zeros(4), covariance, 4000)
    found = handling(mean, covariance, L=2.65, U=22.0)
    columns = {name: [] for name in found}
    for d in draws:
        moved = {n: mean[n] + d[i] if n == "pi1" else mean[n] * np.exp(d[i]) for i, n in enumerate(mean)}
        for name, number in handling(moved, covariance, L=2.65, U=22.0).items():
            columns[name].append(number["value"])
    assert len(found) == 6
    for name, number in found.items():
        # 4000 draws know an sd to 1/sqrt(8000) = 1.1 %; the second order adds about sd/value
        room = 0.035 + 0.5 * np.sqrt(covariance.max())
        assert number["std"] == pytest.approx(np.std(columns[name]), rel=room)
        assert number["hi"] - number["lo"] == pytest.approx(2 * 1.96 * number["std"])
        assert number["lo"] < number["value"] < number["hi"]


def test_no_uncertainty_gives_no_interval_and_every_number_says_what_it_is():
    found = handling({"K": 110.0, "pi1": 0.44, "eta": 1.4, "rho": 1.0}, np.zeros((4, 4)), L=2.65, U=20.0)
    for number in found.values():
        assert number["std"] == 0 and number["lo"] == number["value"] == number["hi"]
        assert number["unit"] and number["meaning"]
    assert "20.0 m/s" in found["yaw_rate_gain"]["meaning"]


def test_the_papers_scale_car():
    """m 5.451, Iz 0.1615, a 0.1461, b 0.2191, Caf 65, Car 110 at 4 m/s: understeering."""
    p = {"m": 5.451, "Iz": 0.1615, "a": 0.1461, "b": 0.2191, "Caf": 65.0, "Car": 110.0}
    A, _ = state_space(p, 4.0)
    found = numbers(p, 4.0)
    assert found["understeer_gradient"]["value"] > 0
    assert found["yaw_frequency"]["value"] * 2 * np.pi == pytest.approx(np.sqrt(np.linalg.det(A)))


@pytest.mark.parametrize("U", [0.0, -3.0])
def test_a_car_that_never_drove_forward_has_no_gains_and_no_yaw_mode(U):
    found = handling({"K": 110.0, "pi1": 0.44, "eta": 1.4, "rho": 1.0}, SMALL, L=2.65, U=U)
    assert found.keys() == {"understeer_gradient", "characteristic_speed"}


def test_a_neutral_car_has_neither_special_speed():
    found = handling({"K": 110.0, "pi1": 0.44, "eta": 1.0, "rho": 1.0}, SMALL, L=2.65, U=20.0)
    assert not found.keys() & {"critical_speed", "characteristic_speed"}
    assert found["yaw_rate_gain"]["value"] == pytest.approx(20.0 / 2.65)
