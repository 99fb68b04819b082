"""Bad samples: each gets its status, none stops an estimator of the ladder, nothing is ever not finite."""

import numpy as np
import pytest

from similitude.status import STATUS

from .ladder_case import CAR, LADDER, QUIET, U, drive, run

ROWS = drive(30.0)
AT = slice(1500, 1510)


def learnt(outputs):
    # band leaves out 4 % at this rate, see test_band; the others nothing
    return abs(outputs["estimate"][-1] / CAR["K"] - 1) < 0.06


@pytest.mark.parametrize("name", LADDER)
@pytest.mark.parametrize("column", [1, 2, 3])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300, -1e5])
def test_an_impossible_value_is_held_and_teaches_nothing(name, column, value):
    rows = ROWS.copy()
    rows[AT, column] = value
    outputs, status, _ = run(name, rows, noise=QUIET)

    assert (status[AT] == STATUS["no_measurement"]).all()
    assert (outputs["estimate"][AT] == outputs["estimate"][AT.start]).all()
    assert (outputs["innovation"][AT] == 0).all()
    assert (outputs["unknowns"][AT] == 0).all()
    assert learnt(outputs)


@pytest.mark.parametrize("name", LADDER)
@pytest.mark.parametrize("dt", [0.0, -1.0, np.nan, np.inf, -np.inf])
def test_a_sample_whose_time_does_not_advance_changes_nothing(name, dt):
    rows = np.insert(ROWS, 1500, [dt, 1.0, 30.0, 5.0], axis=0)
    with_it, status, state = run(name, rows, noise=QUIET)
    without, _, reference = run(name, ROWS, noise=QUIET)

    assert status[1500] == STATUS["bad_sample"]
    assert (state == reference).all()
    assert (np.delete(with_it["estimate"], 1500) == without["estimate"]).all()


@pytest.mark.parametrize("name", LADDER)
def test_a_gap_restarts_the_count_and_the_estimate_stays(name):
    rows = np.delete(ROWS, np.arange(1500, 1750), axis=0)
    rows[1500, 0] = 2.51
    outputs, status, _ = run(name, rows, noise=QUIET)

    assert status[1500] == STATUS["restarted"]
    assert (status[1501:1510] == STATUS["not_excited"]).all()
    assert (outputs["estimate"][1500:1510] == outputs["estimate"][1499]).all()
    assert learnt(outputs)


@pytest.mark.parametrize("name", LADDER)
def test_too_slow_holds_the_estimate_and_the_interval_grows(name):
    speed = np.full(len(ROWS), U)
    speed[1500:2000] = np.linspace(1.0, -2.0, 500)
    rows = ROWS.copy()
    rows[:, 2] = speed
    outputs, status, _ = run(name, rows, noise=QUIET)

    assert (status[1500:2000] == STATUS["too_slow"]).all()
    held = slice(1500, 2000)
    assert (outputs["estimate"][held] == outputs["estimate"][1499]).all()
    assert (np.diff(outputs["variance"][held]) > 0).all()


@pytest.mark.parametrize("name", LADDER)
@pytest.mark.parametrize("value", [np.nan, 0.0])
def test_a_log_of_nothing_learns_nothing(name, value):
    rows = ROWS.copy()
    rows[:, 1:] = value
    outputs, status, _ = run(name, rows)

    assert not np.isin(status, [STATUS["ok"]]).any()
    assert (outputs["variance"] == 1.0).all() and (outputs["unknowns"] == 0).all()
    assert (outputs["estimate"] == outputs["estimate"][0]).all()


@pytest.mark.parametrize("name", LADDER)
def test_a_spike_is_missing_and_a_step_that_stays_is_believed(name):
    rows = ROWS.copy()
    rows[1500, 3] += 3.0
    _, status, _ = run(name, rows)
    assert status[1500] == STATUS["no_measurement"]

    rows[1500:, 3] += 3.0
    _, status, _ = run(name, rows)
    assert (status[1502:] != STATUS["no_measurement"]).all()


@pytest.mark.parametrize("name", LADDER)
def test_random_bits_never_break_it(name):
    rng = np.random.default_rng(4)
    rows = rng.integers(0, 2**64, (20_000, 4), dtype=np.uint64).view(np.float64)
    rows[::2, 0] = 0.01
    rows[::3, 1:] = rng.normal(0, 1, rows[::3, 1:].shape) * [1.0, 100.0, 10.0]

    run(name, rows)
    run(name, rows, settle_samples=3.0, excitation_least=0.0)


@pytest.mark.parametrize("name", LADDER)
def test_a_turn_without_end_does_not_wind_up(name):
    turning = np.tile([0.01, 0.02, U, 0.15], (200_000, 1))
    outputs, _, _ = run(name, np.vstack([turning, ROWS, ROWS, ROWS]), noise=QUIET)

    assert learnt(outputs)
