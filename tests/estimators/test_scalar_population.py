"""The one-unknown filter: it finds K, says how sure it is, and survives anything."""

import numpy as np
import pytest
from tests.estimators.fixed_case import NOISE, STEP, L, rows_of_a_drive

from similitude.embedded.configuration import reference_car
from similitude.estimators.scalar_design import scalar_config
from similitude.program.library import shipped
from similitude.status import STATUS
from similitude.vehicle_prior import vehicle_prior

LIBRARY = shipped("bicycle_scalar_population")


def config(**changes):
    prior = vehicle_prior(reference_car())
    average = {"pi1": 0.4431, "eta": 1.0977 * (1 - 0.4431) / 0.4431, "rho": 0.251 / (0.4431 * (1 - 0.4431))}
    return scalar_config(LIBRARY, prior, sample_time=STEP, L=L, noise_std=NOISE, **(average | changes))


def ran(rows, **changes):
    told = config(**changes)
    state = LIBRARY.start(told)
    return *LIBRARY.run(told, state, rows), state


def test_with_the_groups_known_it_finds_k_within_its_own_interval():
    outputs, status, _ = ran(rows_of_a_drive(6000, noise=NOISE), frozen_variance=0.0, K_start=300.0)
    error, sd = np.log(outputs[-1, 0] / 146.0), np.sqrt(outputs[-1, 1])

    assert abs(error) < 3 * sd
    assert sd < 0.1
    assert (status == STATUS["ok"]).mean() > 0.5


def test_the_step_is_that_of_the_model_without_noise():
    rows = rows_of_a_drive(3000)
    outputs, _, _ = ran(rows, K_start=146.0, start_variance=1e-12, frozen_variance=0.0)
    rest = rows[1000:, 3] - outputs[1000:, 2]

    half_sample = (
        np.sqrt(np.mean(np.diff(rows[1000:, 3]) ** 2)) / 2
    )  # the plant holds its input, the filter not
    assert np.sqrt(np.mean(rest**2)) < half_sample + 0.01 * np.sqrt(np.mean(rows[1000:, 3] ** 2))


def test_what_freezing_costs_is_in_the_variance_from_the_start():
    outputs, _, _ = ran(rows_of_a_drive(6000, noise=NOISE))
    told = config()

    assert outputs[:, 1].min() >= told[LIBRARY.index("config", "frozen_variance")]


@pytest.mark.parametrize("seed", range(5))
def test_after_garbage_it_learns_again(seed):
    rng = np.random.default_rng(seed)
    garbage = rng.choice([np.nan, np.inf, -np.inf, 1e30, -1e30, 0.0, 0.01, 20.0], (500, 4))
    outputs, status, state = ran(np.vstack([garbage, rows_of_a_drive(1500, noise=NOISE)]))

    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert status[-1] in (STATUS["ok"], STATUS["outside_linear"], STATUS["not_excited"])
    assert (status[-500:] == STATUS["ok"]).any()
