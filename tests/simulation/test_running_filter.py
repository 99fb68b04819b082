"""The filter beside a drive: it hears what the log says, and nothing else."""

import numpy as np
import pytest

from similitude.errors import ScenarioError
from similitude.simulation.recording import run_scenario
from similitude.simulation.running_filter import RunningFilter, filter_of, gyro_noise, told_prior
from similitude.simulation.scenario import read_scenario

NOISY = {"sensors.r.noise": "0.1 deg/s", "driver.schedule": "estimate", "run.duration": "4 s"}


def scenario(**changes):
    changes = {name.replace("__", "."): value for name, value in changes.items()}
    return read_scenario("square_closed_loop", changes=NOISY | changes)


@pytest.mark.parametrize("rate", ["1000 Hz", "200 Hz"])
def test_it_says_in_the_loop_what_the_filter_says_of_the_log(rate):
    """Whatever the logger's rate: the same K at every row, to the last digit."""
    made = scenario(run__log_rate=rate)
    beside = RunningFilter(made)
    (drive,) = run_scenario(made, [0], estimate=beside)
    log = drive.log
    rows = [log[name] for name in ("delta [rad]", "U [m/s]", "r [rad/s]")]
    library, config = filter_of(made, np.deg2rad(0.1))
    dt = np.full(rows[0].size, 1 / float(rate.split()[0]))
    outputs, _ = library.run(config, library.start(config), np.column_stack([dt, *rows]))

    assert beside.heard == pytest.approx(outputs[:, 0], rel=1e-12) and len(beside.heard) == dt.size


def test_without_a_function_it_runs_by_itself_and_each_drive_has_its_own():
    made = scenario(run__duration="2 s")
    alone = [run_scenario(made, [seed], estimate=RunningFilter(made))[0] for seed in (1, 2)]
    together = run_scenario(made, [1, 2])

    for one, other in zip(alone, together, strict=True):
        assert one.seed == other.seed and np.array_equal(one.truth["y [m]"], other.truth["y [m]"])
    assert not np.array_equal(together[0].truth["y [m]"], together[1].truth["y [m]"])


def test_the_noise_is_as_told_or_that_of_the_gyro_with_its_rounding():
    assert gyro_noise(scenario()) == pytest.approx(np.deg2rad(0.1))
    rounded = scenario(sensors__r__quantum="0.3 deg/s", sensors__r__noise="0 deg/s")
    assert gyro_noise(rounded) == pytest.approx(np.deg2rad(0.3) / np.sqrt(12))
    assert gyro_noise(scenario(told__yaw_rate_noise="0.2 deg/s")) == pytest.approx(np.deg2rad(0.2))


def test_a_perfect_gyro_is_refused_with_the_line_to_write():
    with pytest.raises(ScenarioError, match="neither noise nor rounding") as refused:
        run_scenario(scenario(sensors__r__noise="0 deg/s"), [0])
    assert "sensors.r.noise" in refused.value.paste


def test_it_is_told_the_vehicle_file_and_not_the_truth():
    stiff = scenario(vehicle__Caf="130 N/rad")
    assert np.array_equal(told_prior(stiff).mean, told_prior(scenario()).mean)
