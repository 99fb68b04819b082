"""The line through an axle's force and slip is the car's own stiffness where the axle is a line."""

import numpy as np
import pytest

from similitude.benchmark.acting_stiffness import acting_stiffness
from similitude.simulation.recording import run_scenario
from similitude.simulation.scenario import read_scenario

ROAD = [{"begin": "10 s", "friction": 0.5, "stiffness": 0.5}]


def driven(plant, amplitude="10 mrad"):
    changes = {
        "run": {"duration": "20 s", "step": "5 ms", "log_rate": "200 Hz"},
        "plant": plant,
        "road": {"surface": ROAD},
        "driver.amplitude": amplitude,
    }
    scenario = read_scenario("slalom", changes=changes)
    car = scenario.vehicle.draw([0])
    return run_scenario(scenario, [0], car=car)[0].truth, car


def test_a_linear_axle_is_its_own_line_before_and_after_a_change():
    truth, car = driven({"kind": "linear"})
    K = acting_stiffness(truth, car)
    # r' by central differences over 10 ms of a signal of half a hertz: (pi 0.5 0.01)^2/6
    assert np.abs(K / truth["K [m^2/s^2]"] - 1).max() < 1e-3
    assert K[-1] == pytest.approx(K[0] / 2, rel=1e-3)


def test_an_axle_that_saturates_acts_softer_the_more_it_slips():
    soft = []
    for amplitude in ("5 mrad", "40 mrad"):
        truth, car = driven({"kind": "saturating", "tyre": "cubic"}, amplitude)
        soft.append(acting_stiffness(truth, car)[0] / car.K)
    assert soft[1] < 0.95 < soft[0] < 1.001


def test_a_car_that_does_not_turn_keeps_what_is_stated():
    truth, car = driven({"kind": "linear"}, "0 mrad")
    assert acting_stiffness(truth, car) == pytest.approx(car.K * truth["stiffness [-]"])


def test_an_axle_whose_force_is_not_its_slips_keeps_what_is_stated():
    """Noise on the force ten times as large as what slip makes of it."""
    truth, car = driven({"kind": "linear"}, "2 mrad")
    whole = acting_stiffness(truth, car)
    noise = np.random.default_rng(0).standard_normal(truth["t [s]"].size)
    shifted = truth | {"ay [m/s^2]": truth["ay [m/s^2]"] + 10 * truth["ay [m/s^2]"].std() * noise}

    assert not np.array_equal(whole, car.K * truth["stiffness [-]"])
    assert acting_stiffness(shifted, car) == pytest.approx(car.K * truth["stiffness [-]"])
