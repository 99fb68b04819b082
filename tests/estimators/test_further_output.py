"""A second measurement: nothing without it, a textbook Kalman update with it, the same bits in C and twin."""

import numpy as np
import pytest

from similitude.accelerometer import Accelerometer
from similitude.filter_config import filter_config
from similitude.program.library import shipped
from similitude.status import STATUS

from ..banked_drive import BEHIND, banked_drive
from ..filter_rig import CAR, NOISE, covariance, twin_of
from ..rough_drive import rough_drive

WITH = shipped("bicycle_with_accelerometer_population")
WITHOUT = shipped("saturating_bicycle_population")
NAMES = WITH.layout.COORDINATES
LOGS = ("K", "eta", "rho", "grip", "input_scale")


def config_of(library, **changes):
    meter = Accelerometer(BEHIND, 0.05, 0.1)
    return filter_config(
        library, CAR, L=2.65, noise_std=NOISE, input_scale_sd=0.02, accelerometer=meter, **changes
    )


def drive(**more):
    log, _ = banked_drive(**more)
    return np.column_stack([np.full(log.samples, 0.01), log.delta, log.U, log.r, log.ay])


def get(library, state, name):
    return state[library.index("state", name)]


def test_without_the_measurement_it_is_the_filter_without():
    """NaN and a reading beyond belief alike; the covariance of what is not there is zero."""
    rows = drive(seconds=20)
    n = len(CAR.names) + 2
    P = np.zeros((n, n))
    P[:5, :5] = _prior_with_grip()
    still = config_of(WITH, P_prior=P[np.triu_indices(n)])
    plain = config_of(WITHOUT)
    state = WITHOUT.start(plain)
    expected, codes = WITHOUT.run(plain, state, rows[:, :4])
    for nothing in (np.nan, 1e9):
        rows[:, 4] = nothing
        begun = WITH.start(still)
        found, status = WITH.run(still, begun, rows)
        own = [WITH.index("output", name) for name in WITHOUT.names("output")]
        assert np.allclose(found[:, own], expected, rtol=1e-9, atol=1e-12)
        assert (status == codes).all()


def _prior_with_grip():
    config = config_of(WITHOUT)
    start = WITHOUT.index("config", "P_prior")
    P = np.zeros((5, 5))
    P[np.triu_indices(5)] = config[start : start + 15]
    return P + np.triu(P, 1).T


def settled():
    """State of a filter in the middle of a drive, without effects that take no part in its derivatives."""
    rows = drive(seconds=12, bank=0.2)
    config = config_of(WITH)
    state = WITH.start(config)
    WITH.run(config, state, rows[:1100])
    for name in ("disturbance", "input_offset", "input_offset_plain"):
        state[WITH.index("state", name)] = 0.0
    for name in ("v_star", "r_star"):  # sensitivities are taken along the companion: let it be the state
        state[WITH.index("state", f"{name}_plain")] = get(WITH, state, name)
    state[WITH.index("state", "unlearnt")] = 1.0
    return config, state, rows[1100:1101].copy()


def one(config, state, row):
    after = state.copy()
    out, _ = WITH.run(config, after, row)
    return out[0], after


def predicted_ay(config, state, row):
    """The model's ay at the end of a step that corrects nothing, by physics written out here."""
    at = {name: get(WITH, state, name) for name in (*NAMES,)}
    U, L = row[0, 2], config[WITH.index("config", "L")]
    a, b = at["pi1"] * L, (1 - at["pi1"]) * L
    front, rear = at["K"] / L, at["K"] / L * at["eta"] * at["pi1"] / (1 - at["pi1"])
    steer = at["input_scale"] * row[0, 1] + at["input_offset"] + at["disturbance"]
    v, r = at["v_star"] * U, at["r_star"] * U / L
    loads = at["grip"] * (1 - at["pi1"]), at["grip"] * at["pi1"]
    Ff, Fr = (
        most * float(_saturated(force / most))
        for most, force in zip(
            loads, (front * (steer - (v + a * r) / U), rear * (b * r - v) / U), strict=True
        )
    )
    inertia = at["rho"] * a * b
    ahead = (at["pi1"] - at["place"]) * L
    return Ff + Fr + ahead * (a * Ff - b * Fr) / inertia + at["ay_bias"]


def _saturated(x):
    from similitude.saturation import Saturation

    return Saturation(x).doit()


def test_the_update_is_kalmans():
    """Gains, states and covariance against dense algebra, slopes by differences."""
    config, state, row = settled()
    row[0, 4] = np.nan
    out, _ = one(config, state, row)
    row[0, 3] = out[WITH.index("output", "predicted")]  # nothing to correct by the yaw rate
    before = one(config, state, row)[1]
    P = covariance(WITH, before)
    x = np.array([get(WITH, before, name) for name in NAMES])
    base = predicted_ay(config, before, row)
    H = np.zeros(len(NAMES))
    for i, name in enumerate(NAMES):
        moved = before.copy()
        scale = x[i] if name in LOGS else 1.0
        moved[WITH.index("state", name)] += 1e-6 * scale
        H[i] = (predicted_ay(config, moved, row) - base) / 1e-6
    nu = 0.05
    row[0, 4] = base + nu
    after = one(config, state, row)[1]
    share = config[WITH.index("config", "ay_share")]
    size = config[WITH.index("config", "ay_variance")] + share**2 * get(WITH, after, "ay_activity")
    alike = 2 * config[WITH.index("config", "ay_time")] / 0.01
    spread = H @ P @ H + get(WITH, before, "ay_noise_scale") * size * alike
    gain = P @ H / spread
    assert get(WITH, state, "excited") == 1.0
    for i, name in enumerate(NAMES):
        y = get(WITH, after, name)
        moved = np.log(y / x[i]) if name in LOGS else y - x[i]
        assert moved == pytest.approx(gain[i] * nu, rel=2e-4, abs=1e-9), name
    assert np.allclose(covariance(WITH, after), P - np.outer(gain, gain) * spread, rtol=1e-4, atol=1e-10)


def rough_with_ay(samples, seed):
    rows = rough_drive(samples, seed)
    rng = np.random.default_rng(seed + 77)
    with np.errstate(invalid="ignore", over="ignore"):
        ay = np.clip(rows[:, 2] * rows[:, 3], -50, 50) + rng.normal(0, 0.3, samples)
    wild = rng.random(samples) < 0.02
    ay[wild] = rng.choice([np.nan, np.inf, -np.inf, 1e308, -1e308, 59.9, 0.0], wild.sum())
    return np.column_stack([rows, ay])


@pytest.mark.parametrize("seed", range(2))
def test_the_same_bits_in_c_and_twin_and_nothing_but_numbers_out(seed):
    config, rows = config_of(WITH), rough_with_ay(6_000, seed)
    mine, theirs = WITH.start(config), twin_of(WITH).start(config)
    out, status = WITH.run(config, mine, rows)
    again, codes = twin_of(WITH).run(config, theirs, rows)
    assert np.array_equal(out.view(np.uint64), again.view(np.uint64)) and (status == codes).all()
    assert np.array_equal(mine.view(np.uint64), theirs.view(np.uint64))
    assert np.isfinite(out).all() and np.isfinite(mine).all()
    assert len(np.unique(status)) > len(STATUS) // 2
    assert np.linalg.eigvalsh(covariance(WITH, mine)).min() > -1e-9
