"""A trial car: the frozen filter is the Kalman filter of what is linear given it."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.batch_pass import COMMANDED_LAG, FrozenFilter, batch_prior
from similitude.filter_config import DESIGN
from similitude.filter_run import LINEAR
from similitude.program.library import shipped
from similitude.steer_lag import EARLIEST, MEASURED_LAG
from similitude.units import Uncertain

from .filter_rig import CAR as PRIOR
from .simulated_drive import CAR, NOISE, drive
from .test_filter_run import setup_of
from .test_prediction import simulate

NOMINAL = np.zeros(2)
CALM = np.log([1e-4, 2e-3])  # hardly any disturbance, and noise that lines between rows do not stand out of


def frozen(log, *, lag=MEASURED_LAG, noise_std=NOISE, prior=PRIOR, steer_scale_sd=0.02):
    joint = batch_prior(prior, steer_scale_sd=steer_scale_sd, lag=lag)
    setup = setup_of(log, prior, noise_std=noise_std)
    return FrozenFilter(replace(setup, library=shipped(LINEAR)), joint)


def at_truth(filter_, *, scale=1.0, lag=0.0):
    return filter_.coordinates(np.array([*(CAR[name] for name in PRIOR.names), scale, lag]))


def test_coordinates_and_values_undo_each_other():
    filter_ = frozen(drive(seconds=3))
    x = at_truth(filter_, scale=1.1, lag=0.03)
    values = filter_.values(x)
    assert list(values) == ["K", "pi1", "eta", "rho", "steer_scale", "steer_lag"]
    assert filter_.coordinates(np.array(list(values.values()))) == pytest.approx(x, abs=1e-14)


def test_the_prior_holds_the_population_and_beside_it_scale_and_lag():
    prior = batch_prior(PRIOR, steer_scale_sd=0.2, lag=COMMANDED_LAG)
    assert np.array_equal(prior.covariance[:4, :4], PRIOR.covariance)
    assert prior.mean[4:] == pytest.approx([1.0, 0.1 + EARLIEST])
    assert prior.std[4:] == pytest.approx([0.2, 0.08 / 0.11])
    stated = batch_prior(PRIOR, steer_scale_sd=0.02, lag=Uncertain(0.0, None, "s"))
    assert stated.mean[5] == EARLIEST and stated.std[5] * EARLIEST < 1e-3


def test_a_steer_in_step_with_the_gyro_is_usual():
    """A lag of nothing is at most two sd from a measured angle's, one of 50 ms no more than as far again."""
    filter_ = frozen(drive(seconds=3))
    away = [(at_truth(filter_, lag=lag) - filter_.middle)[5] / filter_.prior.std[5] for lag in (0.0, 0.05)]
    assert -2 < away[0] < -1 and 1.5 < away[1] < 3


def test_the_unknowns_stay_and_offset_and_bias_are_followed():
    filter_ = frozen(drive(seconds=20))
    x = at_truth(filter_)
    done = filter_.run(x, NOMINAL)
    assert [done.value(name) for name in PRIOR.names] == list(filter_.values(x).values())[:4]
    assert done.value("output_bias") != 0 and done.value("input_offset") != 0
    held = filter_.run(x, NOMINAL, zero=(0.01, -0.002), held=True)
    assert held.value("input_offset") == pytest.approx(0.01, abs=1e-6)
    assert held.value("output_bias") == pytest.approx(-0.002, abs=1e-4)  # it may drift 1e-5 rad/s a second
    assert done.value("noise_scale") == 1.0 and done.value("disturbance_scale") == 1.0


def test_the_steer_is_scaled_and_shifted():
    log = drive(seconds=10)
    filter_ = frozen(log)
    rows = filter_.rows(at_truth(filter_, scale=1.05, lag=0.03))
    assert rows[3:, 1] == pytest.approx(1.05 * log.delta[:-3], abs=1e-12)
    assert np.array_equal(rows[:, 3], log.r)


def test_the_true_car_leaves_no_innovation():
    """Steer of 3 Hz is straight between rows but for (19/s 10 ms)^2/12 = 0.3 % of the response."""
    log = drive(seconds=20, noise=0.0)
    filter_ = frozen(log)
    done = filter_.run(at_truth(filter_), CALM)
    assert np.max(np.abs(done.output("innovation")[1:])) < 3e-3 * np.ptp(log.r)


def test_innovations_are_those_of_a_filter_written_in_physical_units():
    """A Kalman filter of v, r, w, offset, bias in SI units, its dynamics by Runge-Kutta."""
    log = drive(seconds=3)
    filter_ = frozen(log)
    mine = filter_.run(at_truth(filter_), NOMINAL)
    e, S = _physical_filter(log)
    # the step's error, 0.2 % of the response, and the disturbance held over a step, 1 % of it
    assert mine.output("innovation")[1:] == pytest.approx(e[1:], abs=0.01 * np.std(log.r))
    assert mine.output("innovation_variance")[50:] == pytest.approx(S[50:], rel=0.05)


def _physical_filter(log):
    n, L, U, dt = log.samples, CAR["L"], log.U[0], 0.01
    A, B = _transition(U, dt)
    rate, keep = DESIGN["disturbance_rate"], 1 - DESIGN["disturbance_rate"] * dt
    assert rate > 0
    x = np.zeros(5)  # v, r, w, offset, bias
    names = ("disturbance_floor", "input_offset_sd", "output_bias_sd")
    P = np.diag(
        np.square([DESIGN["v_star_sd"] * U, DESIGN["r_star_sd"] * U / L, *(DESIGN[name] for name in names)])
    )
    F = np.eye(5)
    F[:2, :2], F[:2, 2], F[:2, 3], F[2, 2] = A, B, B, keep
    h = np.array([0.0, 1.0, 0.0, 0.0, 1.0])
    activity, e, S = 0.0, np.zeros(n), np.zeros(n)
    for i in range(n):
        steer = 0.5 * (log.delta[max(i - 1, 0)] + log.delta[i])
        before = x[1]
        floor = DESIGN["disturbance_floor"] ** 2 + activity * (DESIGN["disturbance_share"] * L / U) ** 2
        x = F @ x
        x[:2] += B * steer
        P = F @ P @ F.T
        P[2, 2] += floor * (1 - keep**2)
        P[4, 4] += DESIGN["bias_drift"] * dt
        activity += (x[1] ** 2 - activity) * DESIGN["activity_rate"] * dt
        R = (
            NOISE**2
            + ((x[1] - before) / dt * DESIGN["timing_error"]) ** 2
            + activity * DESIGN["structure_share"] ** 2 * 2 * DESIGN["structure_time"] / dt
        )
        e[i], S[i] = log.r[i] - h @ x, h @ P @ h + R
        spread = 1 / S[i] * min(1.0, DESIGN["outlier_ratio"] * S[i] / max(e[i] ** 2, 1e-300))
        gain = P @ h * spread
        x, P = x + gain * e[i], P - np.outer(gain, h @ P)
    return e, S


def _transition(U, dt):
    """Response to each initial state and to steer, by a simulation that knows no Pi groups."""
    p = {name: CAR[name] for name in ("L", "K", "pi1", "eta", "rho")}
    quiet, steered = np.zeros(2), np.ones(2)
    A = np.column_stack([simulate(unit, p, U, quiet, dt) for unit in np.eye(2)])
    return A, simulate(np.zeros(2), p, U, steered, dt)
