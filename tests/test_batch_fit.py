"""The batch fit against truth, against an independent fit, and on drives that a car may have."""

import dataclasses

import numpy as np
import pytest
from scipy.optimize import least_squares

from similitude import batch_fit
from similitude.batch_fit import bounded_step, climb_roughly, fit_batch
from similitude.speed_unit_doubt import ROUGH
from similitude.units import Uncertain

from .filter_rig import CAR as PRIOR
from .simulated_drive import CAR, FINE, NOISE, drive, log_of, spoilt
from .test_batch_pass import CALM, at_truth, frozen
from .test_prediction import truth_as_prior

SMALL = np.log([1.0, 0.02])
NO_LAG = Uncertain(0.0, None, "s")


def fitted(log, *, start=None, scales=SMALL, **more):
    one = frozen(log, **{"lag": NO_LAG, **more})
    return fit_batch(one, one.middle if start is None else start(one), scales)


def with_known(prior, *names, sd=1e-5):
    """The prior with some unknowns certain."""
    for name in names:
        prior = prior.known(name, CAR[name], sd, "told")
    return prior


def test_without_noise_the_car_is_found_to_a_thousandth(monkeypatch):
    """On every row of the plant's own steps, between which its steer is straight: nothing is approximate."""
    monkeypatch.setattr(batch_fit, "RATE", FINE)
    found = fitted(
        drive(seconds=20, noise=0.0, rate=FINE, lag=0.001),
        prior=with_known(PRIOR, "pi1"),
        lag=Uncertain(0.001, None, "s"),
        noise_std=1e-6,
        scales=CALM,
        steer_scale_sd=1e-5,
    )
    for name in ("K", "eta", "rho"):
        assert found.values[name] == pytest.approx(CAR[name], rel=1e-3), name
    assert found.settled


def test_it_is_what_least_squares_on_another_simulator_finds():
    """Only K unknown, white noise: the posterior of a nonlinear least squares in physical units."""
    log = drive(seconds=30, rms=0.004, K=150.0)
    prior = with_known(PRIOR, "pi1", "eta", "rho")
    log_K, sd = _output_error(log)
    found = fitted(log, prior=prior, steer_scale_sd=1e-5)
    # the filter also allows for gusts and offsets, so it knows less; it may differ by what they take
    assert sd < found.std[0] < 4 * sd
    assert found.x[0] == pytest.approx(log_K, abs=2 * found.std[0])


def _output_error(log):
    from similitude.simulate import bicycle_response

    known = {name: CAR[name] for name in ("L", "pi1", "eta", "rho")}
    steps = 5  # of the simulation in a row
    fine = np.linspace(log.t[0], log.t[-1], steps * (log.samples - 1) + 1)
    steer = np.interp(fine, log.t, log.delta)

    def residual(p):
        r, _ = bicycle_response(fine, steer, log.U[0], K=np.exp(p[0]), **known)
        prior = (p[0] - np.log(PRIOR.mean[0])) / PRIOR.std[0]
        return np.append((log.r - r[::steps]) / NOISE, prior)

    found = least_squares(residual, [np.log(PRIOR.mean[0])], diff_step=1e-5)
    return found.x[0], 1 / np.sqrt((found.jac.T @ found.jac)[0, 0])


@pytest.mark.parametrize("K", [60.0, 250.0])
def test_it_does_not_matter_where_it_starts(K):
    log = drive(seconds=40, K=K)
    ends = [
        fitted(log, start=lambda one, f=f: one.middle + np.array([f, 0, 0, 0, 0, 0]))
        for f in (-0.7, 0.0, 0.7)
    ]
    for end in ends:
        assert end.settled
        assert end.x == pytest.approx(ends[1].x, abs=0.35 * np.max(ends[1].std[:3]))
        assert end.x[0] == pytest.approx(np.log(K), abs=3 * end.std[0])


def test_steer_scale_lag_offset_and_bias_are_found_or_counted():
    log = drive(seconds=120, rms=0.01, lag=0.03)
    worn = log_of(log.t, log.delta / 1.03 - 0.01, log.r + 0.004, log.U)
    found = fitted(worn, lag=Uncertain(0.010, 0.008, "s"))
    assert found.values["steer_lag"] == pytest.approx(0.03, abs=0.01)
    assert found.zero == pytest.approx((0.0103, 0.004), abs=4 * max(found.zero_std))
    assert found.x[0] == pytest.approx(np.log(CAR["K"]), abs=3 * found.std[0])
    # the slope is the change of K when the scale is told
    told = fitted(worn, lag=Uncertain(0.010, 0.008, "s"), steer_scale_sd=1e-4)
    moved = found.x[0] + found.slope("steer_scale") * (told.x[4] - found.x[4])
    assert told.x[0] == pytest.approx(moved, abs=0.5 * found.std[0])


@pytest.mark.parametrize(
    ("speeds", "rms", "told"), [((25.0, 25.0), 0.004, False), ((4.0, 30.0), 0.012, True)]
)
def test_what_a_wrong_steer_scale_does_to_k_is_what_it_is_said_to_do(speeds, rms, told):
    """The same drive logged with 5 % less steer; where the car also crawls, the log tells the scale."""
    slow, fast = speeds
    log = drive(
        seconds=60, rms=rms, band=(0.05, 1.0), rate=50,
        U=lambda t: slow + (fast - slow) * 0.5 * (1 - np.cos(2 * np.pi * t / 20)),
    )  # fmt: skip
    less = log_of(log.t, log.delta / 1.05, log.r, log.U)
    here, there = fitted(log), fitted(less)
    assert (here.told("steer_scale") > 0.75) == told
    change = here.leans("steer_scale") * np.log(1.05)
    assert there.x[0] - here.x[0] == pytest.approx(-change, abs=0.3 * here.std[0])


@pytest.mark.parametrize("what", ["blind", "standstill", "straight"])
def test_where_nothing_was_learnt_the_prior_comes_back(what):
    log = drive(seconds=30, rms=1e-6 if what == "straight" else 0.006)
    if what == "standstill":
        log.U[:] = 0.0
    if what == "blind":
        log = spoilt(log, r=slice(None))
    found = fitted(log)
    assert found.std[0] == pytest.approx(PRIOR.std[0], rel=0.05)
    assert np.abs(found.x[:4] - PRIOR.coordinates(PRIOR.mean)) == pytest.approx(0, abs=0.3 * PRIOR.std[0])
    assert found.halves.apart < 3


def test_holes_pauses_and_standstills_cost_information_and_nothing_else():
    log = drive(seconds=60, U=lambda t: np.where((t > 20) & (t < 25), 1.0, 25.0))
    rng = np.random.default_rng(5)
    holed = spoilt(log, r=rng.random(log.samples) < 0.1, delta=slice(4000, 4300), U=slice(1000, 1050))
    t = holed.t.copy()
    t[5000:] += 4.0
    found = fitted(dataclasses.replace(holed, t=t))
    assert found.settled
    assert found.x[0] == pytest.approx(np.log(CAR["K"]), abs=3 * found.std[0])
    assert found.std[0] < 0.2


def test_an_unstable_car_is_fitted():
    """Critical speed 21 m/s, driven at 24 by a driver who catches it."""
    log = _caught(K=60.0, eta=0.85, U=24.0)
    prior = truth_as_prior().known("eta", 0.9, 0.15, "told").known("K", 90.0, 0.5, "told")
    found = fitted(log, prior=prior)
    assert np.isfinite(found.x).all() and np.isfinite(found.covariance).all()
    assert found.x[0] == pytest.approx(np.log(60.0), abs=3 * found.std[0])


def _caught(*, K, eta, U, seconds=40.0, dt=0.01):
    """A yaw-rate feedback steers against every deviation."""
    from .test_prediction import simulate

    p = {"L": CAR["L"], "K": K, "pi1": CAR["pi1"], "eta": eta, "rho": CAR["rho"]}
    rng = np.random.default_rng(3)
    n = int(seconds / dt)
    wish = np.repeat(rng.normal(0, 0.05, n // 100 + 1), 100)[:n]
    x, steer, rows = np.zeros(2), 0.0, []
    for i in range(n):
        rows.append((i * dt, steer, x[1] + NOISE * rng.standard_normal(), U))
        then = steer + 0.1 * (0.25 * (wish[i] - x[1]) - 0.3 * x[0] / U - steer)
        x = simulate(x, p, U, np.array([steer, then]), dt)
        steer = then
    return log_of(*np.array(rows).T)


def test_a_stiffness_that_changed_on_the_way_shows_in_the_halves():
    first, second = (
        drive(seconds=40, seed=1, rms=0.008),
        drive(seconds=40, seed=2, rms=0.008, K=0.5 * CAR["K"]),
    )
    log = log_of(*(np.concatenate([getattr(first, c), getattr(second, c) + (40.0 if c == "t" else 0.0)])
                   for c in ("t", "delta", "r", "U")))  # fmt: skip
    halves = fitted(log).halves
    assert halves.apart > 3
    assert np.exp(halves.first) > 1.3 * np.exp(halves.second)
    assert fitted(drive(seconds=80, seed=1, rms=0.008)).halves.apart < 3


def test_a_long_log_loses_next_to_nothing_by_its_means():
    log = drive(seconds=300)
    short = fitted(log)
    assert short.frozen.setup.log.rate == pytest.approx(25)
    whole = frozen(log, lag=NO_LAG)
    at = batch_fit._Point.of(whole, short.x, short.scales, None)
    step, _ = at.newton(whole)
    full = np.sqrt(np.diag(np.linalg.inv(at.information(1.0) + np.linalg.inv(whole.prior.covariance))))
    assert abs(step[0]) < 0.3 * full[0]
    assert short.std[0] == pytest.approx(full[0], rel=0.15)


@pytest.mark.parametrize("seed", range(3))
def test_a_rough_climb_ends_near_the_fit_and_no_other_car_costs_less(seed):
    found = fitted(drive(seconds=60, seed=seed))
    middle = found.frozen.middle

    x, cost = climb_roughly(found.frozen, middle, found.scales)
    again, lowest = climb_roughly(found.frozen, found.x, found.scales)

    away = x - found.x
    assert (
        away @ np.linalg.solve(found.covariance, away) < 6
    )  # 6 coordinates: as far as chance puts the truth
    # wherever it starts; two such costs are compared, and the climb forgets how variances move with the car
    assert cost == pytest.approx(lowest, abs=ROUGH / 2)
    assert again == pytest.approx(x, abs=found.std.max())


def test_steps_stop_at_limits_and_the_rest_follows():
    curve, pull = np.array([[2.0, 1.0], [1.0, 2.0]]), np.array([-3.0, 0.0])
    free = bounded_step(curve / 10, pull / 10, np.array([-9.0, -9.0]), np.array([9.0, 9.0]))
    assert free == pytest.approx(np.array([1.0, -0.5]))  # cut to the longest step, 2 to 1
    held = bounded_step(curve, pull, np.array([-9.0, -9.0]), np.array([0.5, 9.0]))
    assert held == pytest.approx([0.5, -0.25])


def test_the_true_car_is_where_a_known_car_stays():
    found = fitted(drive(seconds=20), prior=with_known(PRIOR, "K", "pi1", "eta", "rho"), start=at_truth)
    assert found.values["K"] == pytest.approx(CAR["K"], rel=1e-3)
