"""The exact plant against an adaptive integrator that knows only the dimensional equations."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.signal import lsim

from similitude.simulate import TOGETHER, _exponential, _matrices, bicycle_response

CAR = {"L": 2.7, "K": 150.0, "pi1": 0.44, "eta": 1.4, "rho": 1.02}


def dimensional(t, steer, speed, *, L, K, pi1, eta, rho):
    """Yaw rate and sideslip by Runge-Kutta between samples, from the axle forces."""
    a, b = pi1 * L, (1 - pi1) * L
    m = 1500.0
    Iz = rho * m * a * b
    x, r, beta = np.zeros(2), [0.0], [0.0]
    for k in range(len(t) - 1):
        U, Caf = speed[k], K[k] * m / L
        Car = eta * Caf * a / b

        def rates(time, state, U=U, Caf=Caf, Car=Car):
            v, yaw = state
            front = Caf * (np.interp(time, t, steer) - (v + a * yaw) / U)
            rear = Car * (b * yaw - v) / U
            return [(front + rear) / m - U * yaw, (a * front - b * rear) / Iz]

        x = solve_ivp(rates, t[k : k + 2], x, rtol=1e-9, atol=1e-12).y[:, -1]
        r.append(x[1])
        beta.append(x[0] / speed[k + 1])
    return np.array(r), np.array(beta)


def assert_equal_to_integration(t, speed, K, **changes):
    steer = 0.02 * np.sin(3 * t) + 0.01 * np.sign(np.sin(7 * t))
    car = CAR | changes | {"K": K}

    found = bicycle_response(t, steer, speed, **car)

    for ours, theirs in zip(found, dimensional(t, steer, speed, **car), strict=True):
        assert ours.shape == t.shape
        # the integrator's own tolerance, 1e-9 a step over sixty steps
        assert np.abs(ours - theirs).max() <= 1e-7 * max(1e-3, np.abs(theirs).max()) * 10


def test_constant_speed_and_rate():
    t = np.arange(60) * 0.02
    assert_equal_to_integration(t, np.full(60, 25.0), np.full(60, 150.0))


def test_uneven_sampling():
    t = np.cumsum(np.where(np.arange(60) % 2, 0.01, 0.05))
    assert_equal_to_integration(t, np.full(60, 25.0), np.full(60, 150.0))


def test_speed_and_stiffness_that_change_on_the_way():
    t = np.arange(60) * 0.02
    speed, K = np.linspace(15, 30, 60), np.where(t < 0.6, 150.0, 75.0)
    assert_equal_to_integration(t, speed, K)


def test_an_oversteering_car_above_its_critical_speed_is_unstable():
    t = np.arange(60) * 0.02
    assert_equal_to_integration(t, np.full(60, 45.0), np.full(60, 120.0), eta=0.6)
    long, _ = bicycle_response(np.arange(500) * 0.02, np.full(500, 1e-3), 45.0, **CAR | {"eta": 0.6})
    assert abs(long[-1]) > 100 * abs(long[50])


def test_a_long_drive_at_one_speed_is_that_of_a_linear_system():
    """More samples than are taken together; lsim takes them one by one."""
    t = np.arange(3 * TOGETHER + 5) * 0.01
    steer = 0.01 * np.random.default_rng(0).standard_normal(t.size)
    A, B = _matrices(
        *(np.full((1, 1), x) for x in (25.0, CAR["K"])), *(CAR[n] for n in ("L", "pi1", "eta", "rho"))
    )

    r, beta = bicycle_response(t, steer, 25.0, **CAR)

    _, wanted, _ = lsim((A[0, 0], B[0, 0][:, None], np.eye(2), np.zeros((2, 1))), steer, t)
    np.testing.assert_allclose(np.column_stack([25 * beta, r]), wanted, rtol=0, atol=1e-12)


@pytest.mark.parametrize("size", [1e-8, 0.4, 30.0])
def test_the_exponential_is_the_librarys(size):
    M = size * np.random.default_rng(0).standard_normal((3, 2, 4, 4))
    wanted = expm(M)
    # either rounds a few dozen times, and exp multiplies what its matrix is wrong by with its norm
    room = 64 * np.finfo(float).eps * np.maximum(1, np.linalg.norm(M, axis=(-2, -1), keepdims=True))
    assert (np.abs(_exponential(M) - wanted) <= room * np.abs(wanted).max((-2, -1), keepdims=True)).all()


def test_many_cars_at_once_are_each_the_one():
    t, rng = np.arange(200) * 0.01, np.random.default_rng(0)
    steer = 0.01 * rng.standard_normal((3, 200))
    speed, K = rng.uniform(15, 35, (3, 1)), rng.uniform(80, 250, (3, 1))
    column = {"L": rng.uniform(2.3, 3.2, (3, 1)), "pi1": 0.44, "eta": 1.4, "rho": 1.0}

    together, _ = bicycle_response(t, steer, speed, K=K, **column)

    for i in range(3):
        alone, _ = bicycle_response(t, steer[i], speed[i, 0], K=K[i, 0], **column | {"L": column["L"][i, 0]})
        np.testing.assert_allclose(together[i], alone, rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("speed", [15.0, 25.0, 35.0])
def test_the_static_yaw_rate_is_the_textbook_one(speed):
    """r/delta = U / (L (1 + Kus U^2)), Kus = (eta - 1) pi1/(K eta) ... from the axle balance.

    At rest: front force b/L, rear a/L of m U r; slip angles differ by delta - L r/U.
    """
    L, K, pi1, eta = (CAR[n] for n in ("L", "K", "pi1", "eta"))
    front, rear = K / L, K / L * eta * pi1 / (1 - pi1)  # stiffness per mass
    slip = speed * ((1 - pi1) / front - pi1 / rear)  # per yaw rate
    gain = 1 / (L / speed + slip)

    r, _ = bicycle_response(np.arange(2000) * 0.01, np.full(2000, 0.01), speed, **CAR)

    assert r[-1] == pytest.approx(0.01 * gain, rel=1e-9)


def test_no_steer_no_motion_and_one_sample_is_enough():
    r, beta = bicycle_response(np.arange(5) * 0.1, np.zeros(5), 20.0, **CAR)
    assert not r.any() and not beta.any()
    r, _ = bicycle_response([0.0], [0.01], 20.0, **CAR)
    assert r.tolist() == [0.0]
