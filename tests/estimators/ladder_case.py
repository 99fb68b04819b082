"""Cars and drives for the tests of the ladder's regressions, simulated exactly."""

import numpy as np
from scipy.signal import butter, sosfilt

from similitude.estimators.ladder_design import ladder_config
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.simulate import bicycle_response

L, U = 2.7, 22.0
CAR = {"K": 120.0, "pi1": 0.45, "eta": 1.5, "rho": 1.05}
PRIOR = Prior(
    ("K", "pi1", "eta", "rho"),
    ("log", "linear", "log", "log"),
    np.array([150.0, CAR["pi1"], CAR["eta"], CAR["rho"]]),  # all but K are the car's own
    np.diag(np.array([0.5, 0.03, 0.13, 0.09]) ** 2),
)
NOISE = np.deg2rad(0.15)
QUIET = 1e-6  # rad/s: noise assumed where there is none
LADDER = ("band", "output_error", "robust")


def library(name: str) -> Library:
    """A shipped estimator of the ladder."""
    return shipped(f"bicycle_{name}")


def steer(seconds, rate, *, rms=0.01, band=(0.15, 3.0), seed=0):
    """Band-limited random steer (n,) [rad]."""
    rng = np.random.default_rng(seed)
    sos = butter(2, band, "bandpass", fs=rate, output="sos")
    raw = sosfilt(sos, rng.standard_normal(int((seconds + 20) * rate)))[int(20 * rate) :]
    return raw * rms / raw.std()


def drive(seconds=40.0, rate=100, *, speed=U, K=None, noise=0.0, seed=0, rms=0.01, band=(0.15, 3.0), **car):
    """Rows dt, input, U, measured (n, 4) of the car; ``speed`` and ``K`` a number or (n,)."""
    delta = steer(seconds, rate, rms=rms, band=band, seed=seed)
    t = np.arange(delta.size) / rate
    groups = {**CAR, **car}
    stiffness = groups.pop("K") if K is None else K
    groups.pop("K", None)
    r, _ = bicycle_response(t, delta, speed, L=L, K=stiffness, **groups)
    r = r + noise * np.random.default_rng(seed + 99).standard_normal(r.size)
    return np.column_stack([np.full(r.size, 1 / rate), delta, np.broadcast_to(speed, r.shape), r])


def config(name, rate=100, *, noise=NOISE, prior=PRIOR, **changes):
    """Configuration of an estimator for the car."""
    return ladder_config(library(name), prior, sample_time=1 / rate, L=L, noise_std=noise, **changes)


def run(name, rows, rate=100, *, library_of=library, **changes):
    """Outputs by name, status and last state of a pass."""
    used = library_of(name)
    made = config(name, rate, **changes)
    state = used.start(made)
    outputs, status = used.run(made, state, rows)
    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert (outputs[:, :2] > 0).all()
    return {n: outputs[:, i] for i, n in enumerate(used.names("output"))}, status, state
