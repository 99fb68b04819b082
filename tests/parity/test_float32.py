"""The single-precision build against the double one: same estimate, variances that stay variances."""

import numpy as np
import pytest

from similitude.simulate import bicycle_response

from ..filter_rig import NOISE, Float32, car, car_config, covariance, scaled_eigenvalues
from ..rough_drive import rough_drive

RATE = 100.0  # Hz
ROUND = 2.0**-24  # of float32


def long_drive(samples: int, *, seed: int) -> np.ndarray:
    """Rows of a car whose stiffness halves half-way, steered at 3 mrad rms, speed varying."""
    rng = np.random.default_rng(seed)
    t = np.arange(samples) / RATE
    waves = rng.uniform(0.15, 1.0, (6, 1)), rng.uniform(0, 6, (6, 1))
    steer = 3e-3 * np.sqrt(2 / 6) * np.sin(2 * np.pi * waves[0] * t + waves[1]).sum(axis=0)
    speed = np.repeat(rng.uniform(15, 35, samples // 2000 + 1), 2000)[:samples]
    K = np.where(np.arange(samples) < samples // 2, 150.0, 75.0)
    yaw, _ = bicycle_response(t, steer, speed, L=2.7, K=K, pi1=0.45, eta=1.5, rho=1.05)
    yaw += NOISE * rng.standard_normal(samples)
    return np.column_stack([np.full(samples, 1 / RATE), steer, speed, yaw])


def assert_close_to_double(rows: np.ndarray) -> None:
    """Every diagonal positive all along; ln K within 0.1 of its sd."""
    library = car()
    config = car_config(library)
    rows = rows.astype(np.float32).astype(np.float64)  # both read the same numbers
    state = library.start(config)
    exact, _ = library.run(config, state, rows)

    single, _, last = Float32(library).run(config, rows)

    assert np.isfinite(single).all() and (single[:, 1] > 0).all() and (single[:, 4] > 0).all()
    apart = np.abs(np.log(single[:, 0].astype(float) / exact[:, 0])) / np.sqrt(exact[:, 1])
    assert apart.max() < 0.1
    assert_is_covariance(covariance(library, last.astype(float)))
    assert_is_covariance(covariance(library, state), rounding=2.0**-53)


def assert_is_covariance(P: np.ndarray, *, rounding: float = ROUND) -> None:
    """Positive diagonal; no eigenvalue of the correlations below what rounding explains.

    An entry of P is a sum that went through about 100 roundings within the correlation time of the
    filter (1000 samples, random walk: sqrt(1000) ~ 30; times the ~ n = 10 terms of each).
    """
    assert (np.diag(P) > 0).all()
    assert scaled_eigenvalues(P).min() > -300 * rounding


def test_float32_follows_double_over_100_000_samples():
    assert_close_to_double(long_drive(100_000, seed=1))


@pytest.mark.slow
def test_float32_follows_double_over_a_million_samples():
    assert_close_to_double(long_drive(1_000_000, seed=2))


@pytest.mark.parametrize("seed", range(3))
def test_float32_survives_a_rough_drive(seed):
    library = car()

    outputs, _, state = Float32(library).run(car_config(library), rough_drive(100_000, seed))

    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert (np.diag(covariance(library, state.astype(float))) > 0).all()
