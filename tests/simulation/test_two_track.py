"""Four wheels: the single track where the sides are alike, and what load and split friction do."""

import numpy as np
import pytest

from similitude.simulation.arithmetic import FLOATS
from similitude.simulation.car import GRAVITY, Car
from similitude.simulation.loop import drive
from similitude.simulation.plant import Push
from similitude.simulation.two_track import Body, TwoTrack

from .quiet_drive import SATURATING, TWO_TRACK, quiet

CAR = Car(m=1500.0, Iz=2600.0, a=1.2, b=1.5, Caf=82e3, Car=98e3)
NARROW = TWO_TRACK | {"height": "0 m", "track": "1 mm"}
TURN = {"kind": "turns", "amplitude": "40 mrad", "rise": "0.5 s", "hold": "30 s", "rest": "1 s"}
LIVELY = {"driver__amplitude": "45 mrad"}


@pytest.mark.parametrize("tyre", ["cubic", "brush"])
def test_without_height_and_width_it_is_the_single_track(tyre):
    two = drive(quiet(NARROW | {"tyre": tyre}, **LIVELY), CAR, [0]).seen
    one = drive(quiet(SATURATING | {"tyre": tyre}, **LIVELY), CAR, [0]).seen

    # half a millimetre of track changes the speed of a wheel by r/2U mm: 2e-5 at 1 rad/s
    np.testing.assert_allclose(two.r, one.r, atol=1e-5 * np.abs(one.r).max())
    np.testing.assert_allclose(two.v, one.v, atol=1e-5 * np.abs(one.v).max())


def test_load_transfer_costs_grip_where_the_stiffness_falls_with_load():
    def yaw_rate(**more):
        return drive(quiet(TWO_TRACK | more, driver=TURN), CAR, [0]).seen.r[-1]

    assert yaw_rate(load_sensitivity=0.4) < yaw_rate(load_sensitivity=0.0)
    front, rear = (yaw_rate(load_sensitivity=0.4, front_roll_share=s) for s in (0.9, 0.1))
    assert front < rear  # more transfer at the front understeers


def test_the_wheels_carry_the_car():
    """Loads of the four wheels add up to the weight, and their moment to m h ay."""
    body = Body(height=0.5, track=1.5, front_roll_share=0.6, roll_time=0.1, load_sensitivity=0.0)
    plant = TwoTrack(CAR, tyre="brush", body=body, on=FLOATS)
    seen = []
    plant_axle = plant._axle

    def spy(state, push, way, at, C, rest, moved, delta):
        seen.append((rest, moved))
        return plant_axle(state, push, way, at, C, rest, moved, delta)

    plant._axle = spy
    q = 4.0
    plant.rates([0, 0, 0, 0, 0, q], Push(0.0, 20.0, 0, 0, 0, -3.0, 1.0, 1.0))
    assert 2 * sum(rest for rest, _ in seen) == pytest.approx(CAR.m * GRAVITY)
    # moved from the left to the right wheel: twice that times half the track
    assert sum(moved for _, moved in seen) * body.track == pytest.approx(CAR.m * body.height * q)
    assert 2 * (seen[0][0] * CAR.a - seen[1][0] * CAR.b) == pytest.approx(CAR.m * 0.5 * 3.0)


def test_the_body_rolls_to_what_the_tyres_carry():
    scenario = quiet(TWO_TRACK, driver=TURN, run__duration="8 s")
    plant_state = drive(scenario, CAR, [0])
    assert plant_state.seen.ay[-1] == pytest.approx(plant_state.seen.r[-1] * 80 / 3.6, rel=1e-3)


def test_braking_on_split_friction_pulls_to_the_side_that_holds():
    road = {"surface": [{"side": "right", "friction": 0.2}]}
    brake = {"kind": "ramp", "first": "25 m/s", "last": "15 m/s", "begin": "1 s", "duration": "2 s"}
    straight = {"kind": "straight"}

    def heading(**more):
        return drive(quiet(TWO_TRACK, driver=straight, speed=brake, run__duration="2 s", **more),
                     CAR, [0]).seen.psi[-1]  # fmt: skip

    assert heading(road=road) > 0.01  # to the left, where the grip is
    assert heading() == 0.0


def test_split_friction_turns_no_car_that_rolls_straight():
    road = {"surface": [{"side": "left", "friction": 0.2, "stiffness": 0.3}]}
    seen = drive(quiet(TWO_TRACK, driver={"kind": "straight"}, road=road), CAR, [0]).seen
    assert not seen.r.any()


def test_mirrored_motion_has_mirrored_rates():
    body = Body(height=0.5, track=1.5, front_roll_share=0.6, roll_time=0.1, load_sensitivity=0.2)
    plant = TwoTrack(CAR, tyre="brush", body=body, on=FLOATS)
    state, push = [0.0, 0.3, 0.2, -0.5, 0.4, 3.0], Push(0.05, 20.0, 200.0, 90.0, 0.3, -3.0, 1.0, 0.7)

    rates = plant.rates(state, push)
    mirrored = [-x if i else x for i, x in enumerate(state)]
    pushed = push._replace(delta=-0.05, force=-200.0, moment=-90.0, pull=-0.3)

    np.testing.assert_allclose(plant.rates(mirrored, pushed)[1:], [-x for x in rates[1:]], rtol=1e-12)


def test_many_cars_are_each_the_one_on_a_road_with_places():
    road = {"surface": [{"y_from": "0.2 m", "friction": 0.3, "stiffness": 0.5}]}
    scenario = quiet(TWO_TRACK, vehicle__Caf="82 ± 8 kN/rad", road=road, **LIVELY)
    together = drive(scenario, scenario.vehicle.draw([1, 2]), [1, 2]).seen
    for i, seed in enumerate([1, 2]):
        alone = drive(scenario, scenario.vehicle.draw([seed]), [seed]).seen
        np.testing.assert_allclose(together.y[:, i], alone.y, rtol=1e-9, atol=1e-12)


def test_wheels_of_an_axle_brake_alike_until_one_has_no_more_grip():
    """No moment of the brakes in a turn, but where the inner wheels are too light for their half."""
    body = Body(height=0.5, track=1.5, front_roll_share=0.6, roll_time=0.1, load_sensitivity=0.0)
    plant = TwoTrack(CAR, tyre="linear", body=body, on=FLOATS)

    def turned(q, ax):
        return plant.rates([0, 0, 0, 0, 0, q], Push(0.0, 20.0, 0, 0, 0, ax, 1.0, 1.0))[4]

    assert turned(4.0, -3.0) == pytest.approx(0.0, abs=1e-12)
    assert turned(4.0, 3.0) == pytest.approx(0.0, abs=1e-12)
    # turning left the right wheels carry more, and hold the car back there
    assert turned(8.0, -8.0) < -0.05
