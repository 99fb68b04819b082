"""The loop: closed loops follow, feedback feels the gyro, schedules believe whom they should."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.errors import ScenarioError
from similitude.simulation.loop import drive
from similitude.simulation.recording import run_scenario
from similitude.simulation.scenario import read_scenario

from .quiet_drive import SATURATING, quiet

SHORT = {"run.duration": "10 s"}


def loop(seeds=(0,), estimate=None, **changes):
    changes = {k.replace("__", "."): v for k, v in changes.items()}
    scenario = read_scenario("square_closed_loop", changes=SHORT | changes)
    return drive(scenario, scenario.vehicle.draw(list(seeds)), list(seeds), estimate)


def test_the_closed_loop_follows_its_path():
    motion = loop()
    before_a_jump = np.isclose(np.mod(motion.t, 2.5), 2.4)
    off = np.abs(motion.seen.y - motion.wanted)[before_a_jump]
    # 2.4 s after each jump of 12 cm
    assert off.size == 4 and off.max() < 0.004


def test_the_closed_loop_is_the_linear_system_with_servo():
    """Against the matrices: A of the paper, the servo's two states, the integral; one exponential."""
    from scipy.linalg import expm

    from similitude.simulation.lqr import lqr_gain, path_matrices

    scenario = read_scenario("square_closed_loop", changes={
        "run.duration": "2 s", "driver.path.square": "1 mm"})  # fmt: skip
    car = scenario.vehicle.nominal()
    A, B = path_matrices(car, 4.0)
    k, w, z = lqr_gain(car, scenario.driver), 2 * np.pi * 5, 0.707
    M = np.zeros((8, 8))  # integral, y, y', psi, psi', delta, delta', reference
    M[0, 1], M[0, 7] = 1, -1
    M[1:5, 1:5], M[1:5, 5] = A, B
    M[5, 6] = 1
    M[6, :5], M[6, 5], M[6, 6], M[6, 7] = -w * w * k, -w * w, -2 * z * w, w * w * k[1]
    start = np.zeros(8)
    start[7] = 1e-3

    motion = drive(scenario, car, [0])
    for t in (0.2, 0.5, 1.0, 2.0):
        exact = expm(M * t) @ start
        # commands are held for a millisecond and act straight between ticks: a delay of about 1.5 ms
        at = np.searchsorted(motion.t, t - 1e-9)
        assert motion.seen.y[at] == pytest.approx(exact[1], abs=0.02e-3)
        assert motion.seen.r[at] == pytest.approx(exact[4], abs=0.02 * np.abs(motion.seen.r).max())


def test_feedback_through_the_gyro_turns_noise_into_steer():
    noise = {"sensors__r__noise": "1 deg/s", "driver__path__square": "0 m"}
    assert not loop(**noise).rack.any()
    felt = loop(driver__feedback="sensors", **noise)
    assert felt.rack.std() > 1e-5
    biased = loop(driver__feedback="sensors", sensors__r__bias="5 deg/s", driver__path__square="0 m",
                  run__duration="30 s", run__step="2 ms",
                  run__log_rate="500 Hz", road="{}")  # fmt: skip
    # the integral takes a bias out: the car ends on its path, steering straight
    assert abs(biased.seen.y[-1]) < 2e-3 < np.abs(biased.seen.y).max()


def test_a_schedule_that_believes_the_truth_and_one_that_is_told_it_agree():
    changes = {
        "road": '{ surface = [{ begin = "1 s", stiffness = 0.5 }] }',
        "run__duration": "3 s",
        "run__step": "2 ms",
        "run__log_rate": "500 Hz",
        "driver__path__square": "2 cm",
    }

    def true_pi3(t, steer, r, U):
        return 0.27217 * (0.5 if t >= 1 - 1e-9 else 1.0)

    told = loop(estimate=true_pi3, driver__schedule="estimate", **changes)
    truth, fixed = loop(driver__schedule="truth", **changes), loop(**changes)
    assert np.abs(told.seen.y - truth.seen.y).max() < 1e-5
    assert np.abs(fixed.seen.y - truth.seen.y).max() > 1e-4
    with pytest.raises(ScenarioError, match="needs an estimate"):
        loop(driver__schedule="estimate")


def test_the_truth_that_is_believed_lies_under_the_car():
    """Everywhere it is one without a place; where it begins on the way it is what the truth says."""
    short = {
        "run__duration": "3 s",
        "run__step": "2 ms",
        "run__log_rate": "500 Hz",
        "driver__schedule": "truth",
    }
    everywhere = loop(road="{ surface = [{ stiffness = 0.3 }] }", **short)
    placed = loop(road='{ surface = [{ x_from = "-1 m", stiffness = 0.3 }] }', **short)
    assert np.array_equal(placed.seen.y, everywhere.seen.y)

    beyond = '{ surface = [{ x_from = "5 m", stiffness = 0.3 }] }'
    scenario = read_scenario("square_closed_loop", changes={
        "run.duration": "3 s", "driver.schedule": "truth", "road": beyond})  # fmt: skip
    (truth,) = run_scenario(scenario, [0])
    pi3 = dict(zip(np.round(truth.truth["t [s]"], 6), truth.truth["pi3 [-]"], strict=True))
    told = replace(scenario, driver=replace(scenario.driver, schedule="estimate"))
    (other,) = run_scenario(told, [0], estimate=lambda t, steer, r, U: pi3[round(t, 6)])
    assert np.abs(other.truth["y [m]"] - truth.truth["y [m]"]).max() < 1e-12
    fixed = run_scenario(replace(scenario, driver=replace(scenario.driver, schedule="none")), [0])[0]
    assert np.abs(fixed.truth["y [m]"] - truth.truth["y [m]"]).max() > 1e-4


def test_one_gain_may_be_that_of_another_stiffness():
    halved = {"road__surface": "[{ stiffness = 0.5 }]", "run__duration": "1 s"}
    one, other = loop(driver__design_stiffness="0.5", **halved), loop(driver__schedule="truth", **halved)
    # the schedule is interpolated over steps of 12 %
    assert np.abs(one.seen.y - other.seen.y).max() < 1e-3 * np.abs(other.seen.y).max()
    assert np.abs(one.seen.y - loop(**halved).seen.y).max() > 1e-3


def test_many_cars_in_a_closed_loop_are_each_the_one():
    uncertain = {
        "vehicle__Caf": "65 ± 6 N/rad",
        "driver__feedback": "sensors",
        "driver__schedule": "truth",
        "sensors__r__noise": "0.5 deg/s",
        "run__duration": "1 s",
    }
    together = loop([1, 2], **uncertain)
    for i, seed in enumerate((1, 2)):
        alone = loop([seed], **uncertain)
        np.testing.assert_allclose(together.seen.y[:, i], alone.seen.y, rtol=1e-9, atol=1e-12)


def test_a_step_too_long_for_the_speed_is_refused_with_one_that_is_not():
    with pytest.raises(ScenarioError, match="too fast for steps") as refused:
        slow = quiet(speed={"kind": "constant", "value": "0.5 m/s"})
        drive(slow, slow.vehicle.draw([0]), [0])
    step = refused.value.paste.split('"')[1]
    fine = quiet(speed={"kind": "constant", "value": "0.5 m/s"}, run__duration="1 s",
                 run__step=step)  # fmt: skip
    drive(fine, fine.vehicle.draw([0]), [0])
    stops = quiet(speed={"kind": "sinusoid", "mean": "5 m/s", "amplitude": "6 m/s", "period": "10 s"})
    with pytest.raises(ScenarioError, match="too fast for steps"):
        drive(stops, stops.vehicle.draw([0]), [0])


def test_motion_that_leaves_all_bounds_is_refused():
    wild = quiet(
        vehicle__Car="40 kN/rad", run__duration="200 s", speed={"kind": "constant", "value": "60 m/s"}
    )
    with pytest.raises(ScenarioError, match="left all bounds before"), np.errstate(all="ignore"):
        drive(wild, wild.vehicle.draw([0]), [0])


def test_actuator_and_compliance_come_between():
    scenario = quiet(SATURATING, actuator={"delay": "100 ms", "scale": 1.1, "offset": "2 mrad"})
    motion = drive(scenario, scenario.vehicle.draw([0]), [0])
    np.testing.assert_allclose(motion.rack[20:], motion.command[:-20], atol=1e-12)
    np.testing.assert_allclose(motion.seen.delta, 1.1 * motion.rack + 0.002, atol=1e-12)
