"""The instrumental regression: no bias from the sensor, gaps survived, never a NaN."""

import numpy as np
import pytest

from similitude.status import STATUS

from ..any_model.gallery import made


def run(rows):
    estimator = made("rlc_circuit")
    state = estimator.library.start(estimator.config)
    outputs, status = estimator.library.run(estimator.config, state, rows)
    return outputs, status, state


def rows_of(seed, samples=2000, noise=1.0, R=200.0):
    estimator = made("rlc_circuit")
    log = estimator.simulate(seed=seed, truth={"R": R})
    clean = estimator.simulate(seed=seed + 1000, truth={"R": R})
    y = log["vc"] if noise == 1 else clean["vc"] + noise * (log["vc"] - clean["vc"])
    return np.column_stack([np.full(len(y), estimator.step), log["u"], y])[:samples]


def test_the_sensors_noise_is_no_bias():
    """Mean of 20 runs with twenty times the noise: as one quiet run reads, within three standard errors."""
    quiet = run(rows_of(1, noise=0.01))[0][-1, 0]
    found = np.array([np.log(run(rows_of(k, noise=20.0))[0][-1, 0]) for k in range(20)])

    assert abs(found.mean() - np.log(quiet)) < 3 * found.std() / np.sqrt(20) + 1e-4


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e30, 0.0])
def test_no_value_breaks_the_state(bad):
    rows = rows_of(3)
    for column in range(3):
        rows[200 + 10 * column, column] = bad
    outputs, _, state = run(rows)

    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert abs(np.log(outputs[-1, 0] / run(rows_of(3))[0][-1, 0])) < 3 * np.sqrt(outputs[-1, 1])


def test_after_a_gap_it_settles_before_it_learns():
    rows = rows_of(4)
    rows[1000, 0] = 1.0
    outputs, status, _ = run(rows)

    assert status[1000] == STATUS["restarted"]
    assert outputs[1001, 0] == outputs[1000, 0]
    assert abs(np.log(outputs[-1, 0] / run(rows_of(4))[0][-1, 0])) < 3 * np.sqrt(outputs[-1, 1])


def test_time_that_stands_still_is_a_bad_sample():
    rows = rows_of(5)
    rows[50, 0] = 0.0

    assert run(rows)[1][50] == STATUS["bad_sample"]
