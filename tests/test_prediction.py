"""Yaw rate a second ahead, against a simulation that shares no code with the estimator."""

import numpy as np
import pytest

from similitude.filter_config import DESIGN
from similitude.prediction import FROZEN, HORIZON, predict_ahead

from .filter_rig import CAR as PRIOR
from .simulated_drive import CAR, drive, spoilt
from .test_filter_run import setup_of

STEPS = 20  # of the simulation below in a row


def truth_as_prior():
    """A population whose average is this very car."""
    prior = PRIOR
    for name, sd in (("K", 0.5), ("pi1", 0.02), ("eta", 0.1), ("rho", 0.1)):
        prior = prior.known(name, CAR[name], sd, "truth")
    return prior


def simulate(x, p, U, steer, dt):
    """Runge-Kutta on the bicycle in SI units: m = 1 kg; x = [v, r]; steer is straight in a row."""
    L, a = p["L"], p["pi1"] * p["L"]
    b = L - a
    Cf = p["K"] / L
    Cr, Iz = Cf * p["eta"] * a / b, p["rho"] * a * b

    def rate(x, d):
        front = d - (x[0] + a * x[1]) / U
        rear = -(x[0] - b * x[1]) / U
        return np.array([Cf * front + Cr * rear - U * x[1], (a * Cf * front - b * Cr * rear) / Iz])

    h = dt / STEPS
    for k in range(len(steer) - 1):
        for i in range(STEPS):
            d = [steer[k] + (i + s) / STEPS * (steer[k + 1] - steer[k]) for s in (0, 0.5, 1)]
            k1 = rate(x, d[0])
            k2 = rate(x + h / 2 * k1, d[1])
            k3 = rate(x + h / 2 * k2, d[1])
            k4 = rate(x + h * k3, d[2])
            x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return x


def test_a_prediction_is_the_bicycle_run_on_from_the_estimate():
    """From the filter's own state, by Runge-Kutta in SI units and in physical time."""
    log = drive(seconds=8, noise=0.0)
    setup = setup_of(log, truth_as_prior())
    library, rows, config = setup.library, setup.samples(), setup.config()
    state = library.start(config)
    per_second, U, errors, sizes = 100, log.U[0], [], []
    at = 0
    for start in (200, 350, 500, 650):
        library.run(config, state, rows[at : start + 1])
        at = start + 1
        value = dict(zip(library.names("state"), state.tolist(), strict=True))
        p = {"L": CAR["L"], **{name: value[name] for name in ("K", "pi1", "eta", "rho")}}
        later = np.arange(per_second + 1) * 0.01
        gust = value["disturbance"] * np.exp(-DESIGN["disturbance_rate"] * later)
        steer = log.delta[start : start + per_second + 1] + value["input_offset"] + gust
        x = np.array([value["v_star"] * U, value["r_star"] * U / CAR["L"]])
        expected = simulate(x, p, U, steer, 0.01)[1] + value["output_bias"]
        ahead, blind = state.copy(), rows[at : start + per_second + 1].copy()
        blind[:, 3] = np.nan
        outputs, _ = library.run(config, ahead, blind)
        errors.append(outputs[-1, library.index("output", "predicted")] - expected)
        sizes.append(np.ptp(log.r))
    # second order: (lambda dt)^2/12 of the response, lambda about 8/s at this speed; the gust's
    # factor 1 - dt/T instead of exp(-dt/T) is dt/(2 T) = 1 % of what it does
    assert np.max(np.abs(errors)) < (2 * 0.08**2 / 12) * np.max(sizes)


def test_a_known_car_without_noise_is_predicted_to_the_error_of_the_step():
    log = drive(seconds=20, noise=0.0)
    found = predict_ahead(setup_of(log, truth_as_prior()))
    size = np.sqrt(np.mean(log.r**2))
    assert found["rms"]["frozen_averages"] < 0.01 * size  # nothing to learn; second-order step
    assert found["rms"]["estimate"] < 0.03 * size
    assert found["rms"]["kinematic"] > 0.3 * size
    assert found["horizon_s"] == HORIZON == 1.0
    assert found["predictions"] == len(range(0, 2000 - 100, 50))


def test_learning_pays_where_the_car_is_not_the_average():
    found = predict_ahead(setup_of(drive(seconds=60, K=250.0)))
    assert found["ratio_to_frozen"] < 0.8
    assert found["ratio_to_frozen"] == pytest.approx(
        found["rms"]["estimate"] / found["rms"]["frozen_averages"]
    )
    assert found["rms"]["estimate"] < found["rms"]["kinematic"]


def test_frozen_means_frozen():
    log = drive(seconds=20, K=250.0)
    done = setup_of(log).run(**FROZEN)
    assert np.all(done.output("estimate") == PRIOR.mean[0])
    assert [done.value(name) for name in PRIOR.names] == PRIOR.mean.tolist()
    assert done.value("output_bias") != 0  # offset and bias are followed


def test_the_kinematic_rate_is_U_delta_over_L():
    """At a crawl with a quick, stiff car the kinematic rate is right but for lags of 10 ms."""
    log = drive(seconds=20, U=6.0, K=300.0, noise=0.0, rms=0.01, band=(0.1, 0.5))
    found = predict_ahead(setup_of(log))
    assert found["rms"]["kinematic"] < 0.1 * np.sqrt(np.mean(log.r**2))


@pytest.mark.parametrize("what", ["standstill", "blind", "short", "holes"])
def test_nothing_is_judged_where_there_is_nothing_to_judge(what):
    log = drive(seconds=6)
    if what == "standstill":
        log.U[:] = 0.0
    if what == "blind":
        log = spoilt(log, r=slice(None))
    if what == "short":
        log = drive(seconds=0.9)
    if what == "holes":
        log.t[300:] += 5.0  # a gap inside every horizon that crosses it
    found = predict_ahead(setup_of(log))
    if what == "holes":
        assert all(np.isfinite(rms) for rms in found["rms"].values())
        assert 0 < found["predictions"] < predict_ahead(setup_of(drive(seconds=6)))["predictions"]
    else:
        assert found["predictions"] == 0
        assert found["rms"]["estimate"] is None and found["ratio_to_frozen"] is None


def test_another_estimator_s_K_is_judged_in_the_average_vehicle():
    """The population's mean as that K is the frozen average itself; the truth is better."""
    setup = setup_of(drive(seconds=40, rms=0.01))
    rows = np.ones(setup.log.samples)
    average = predict_ahead(setup, K=PRIOR.mean[0] * rows)
    true = predict_ahead(setup, K=CAR["K"] * rows)

    assert average["ratio_to_frozen"] == pytest.approx(1.0, rel=1e-12)
    assert true["ratio_to_frozen"] < 0.8
