"""The default filter beyond the linear range: K is the slope at small slip, before, during and after.

The plants saturate by laws of their own (Fiala's brush and the tangent formula), not by the filter's.
"""

from itertools import pairwise
from math import atan, atan2, sin, tan

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from similitude.filter_config import filter_config
from similitude.program.library import shipped

from ..filter_rig import CAR, NOISE, covariance

LIBRARY = shipped("saturating_bicycle_population")
LINEAR = shipped("bicycle_population")
L, SPEED, GRAVITY = 2.7, 25.0, 9.80665
TRUTH = {"K": 160.0, "pi1": 0.46, "eta": 1.5, "rho": 1.05}
T = np.arange(0, 75, 0.01)


def brush(C, slip, most):
    """Fiala's brush [m/s^2]: C [m/s^2/rad], greatest force per mass ``most``."""
    x = C * tan(slip)
    if abs(x) >= 3 * most:
        return most if x > 0 else -most
    return x - x * abs(x) / (3 * most) + x**3 / (27 * most**2)


def tangent(C, slip, most, shape=1.35, curvature=-0.5):
    """The magic formula with its stiffness C and its peak."""
    x = C / (shape * most) * slip
    return most * sin(shape * atan(x - curvature * (x - atan(x))))


def response(steer, tyre, mu=0.95, parts=2):
    """Yaw rate of the car, by the classical Runge-Kutta scheme."""
    p1, p2 = TRUTH["pi1"], 1 - TRUTH["pi1"]
    a, b, front = p1 * L, p2 * L, TRUTH["K"] / L
    rear, gyration = front * TRUTH["eta"] * p1 / p2, TRUTH["rho"] * p1 * p2 * L * L

    def rates(v, r, d):
        F = tyre(front, d - atan2(v + a * r, SPEED), mu * GRAVITY * p2)
        R = tyre(rear, -atan2(v - b * r, SPEED), mu * GRAVITY * p1)
        return F + R - SPEED * r, (a * F - b * R) / gyration

    v = r = 0.0
    out, h = [0.0], (T[1] - T[0]) / parts
    for now, then in pairwise(steer):
        for part in range(parts):
            d = [now + (then - now) * (part + k) / parts for k in (0, 0.5, 1)]
            k1 = rates(v, r, d[0])
            k2 = rates(v + h / 2 * k1[0], r + h / 2 * k1[1], d[1])
            k3 = rates(v + h / 2 * k2[0], r + h / 2 * k2[1], d[1])
            k4 = rates(v + h * k3[0], r + h * k3[1], d[2])
            v += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
            r += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
        out.append(r)
    return np.array(out)


def manoeuvres():
    noise = np.random.default_rng(3).standard_normal(len(T) + 2000)
    gentle = sosfilt(butter(2, [0.15, 1.0], "bandpass", fs=100, output="sos"), noise)[2000:]
    gentle *= 5e-3 / gentle.std()
    at = (T > 30) & (T < 50)
    sweep = np.sin(2 * np.pi * np.cumsum(np.where(at, 0.2 + (T - 30) / 20, 0)) * 0.01)
    return {
        "sine sweep": np.where(at, (0.01 + 0.06 * (T - 30) / 20) * sweep, gentle),
        "limit step": np.where((T > 30) & (T < 33), 0.05, gentle),
        "limit slalom": np.where(at, 0.05 * np.sin(np.pi * T), gentle),
    }


MANOEUVRES = manoeuvres()


def rows_of(steer, r):
    """The log of a drive, its yaw rate with noise."""
    measured = r + NOISE * np.random.default_rng(1).standard_normal(len(r))
    return np.column_stack([np.full(len(T), 0.01), steer, np.full(len(T), SPEED), measured])


def estimate(library, steer, tyre):
    """Error of ln K and its sd over the drive, and the greatest lateral acceleration [m/s^2]."""
    r = response(steer, tyre)
    rows = rows_of(steer, r)
    config = filter_config(library, CAR, L=L, noise_std=NOISE, input_scale_sd=0.02)
    outputs, _ = library.run(config, library.start(config), rows)
    return np.log(outputs[:, 0] / TRUTH["K"]), np.sqrt(outputs[:, 1]), np.abs(r * SPEED).max()


def mean_at(error, second):
    return float(np.mean(error[int(100 * (second - 1)) : int(100 * second)]))


@pytest.mark.parametrize("tyre", [brush, tangent])
@pytest.mark.parametrize("manoeuvre", MANOEUVRES)
def test_after_the_limit_K_is_what_it_was_before(manoeuvre, tyre):
    error, sd, peak = estimate(LIBRARY, MANOEUVRES[manoeuvre], tyre)

    assert peak > 0.5 * GRAVITY  # well beyond the linear range
    assert abs(mean_at(error, 29)) < 2 * sd[2900]
    # ten seconds after the release: within the interval, and no further than it from before
    assert abs(mean_at(error, 60)) < 2 * sd[6000]
    assert abs(mean_at(error, 60) - mean_at(error, 29)) < 2 * sd[2900]


@pytest.mark.parametrize("manoeuvre", MANOEUVRES)
def test_a_linear_tyre_would_read_the_limit_as_softness(manoeuvre):
    steer = MANOEUVRES[manoeuvre]
    linear, ours = (np.abs(estimate(one, steer, brush)[0][3000:5000]).max() for one in (LINEAR, LIBRARY))
    assert ours < linear


def test_beyond_the_linear_range_one_sample_in_a_while_teaches_and_grip_learns_from_each():
    """The state's variances tell what a sample taught: K's falls once in 0.2 s there, grip's with each."""
    steer = MANOEUVRES["limit slalom"]
    rows = rows_of(steer, response(steer, brush))
    config = filter_config(LIBRARY, CAR, L=L, noise_std=NOISE, input_scale_sd=0.02)
    state, names = LIBRARY.start(config), list(LIBRARY.layout.COORDINATES)
    LIBRARY.run(config, state, rows[:3300])
    variances, beyond, teaches = [np.diag(covariance(LIBRARY, state))], [], []
    for row in rows[3300:4800]:
        _, status = LIBRARY.run(config, state, row[None])
        variances.append(np.diag(covariance(LIBRARY, state)))
        beyond.append(status[0] == LIBRARY.layout.STATUS["outside_linear"])
        teaches.append(state[LIBRARY.index("state", "untaught")] == 0)
    fell, beyond, teaches = np.diff(variances, axis=0) < 0, np.array(beyond), np.array(teaches)

    assert 0.5 < beyond.mean() < 1.0 and teaches[~beyond].all()
    assert 1 / 35 < teaches[beyond].mean() < 1 / 19  # one in 0.2 s; each visit begins with a wait
    for name in ("K", "eta"):
        learnt = fell[:, names.index(name)]
        assert learnt[teaches].mean() > 0.5 and not learnt[beyond & ~teaches].any()
    assert fell[beyond, names.index("grip")].mean() > 0.9
