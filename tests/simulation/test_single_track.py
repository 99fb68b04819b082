"""One wheel an axle: against the exact linear response, statics, signs and the books of energy."""

import numpy as np
import pytest

from similitude.simulate import bicycle_response
from similitude.simulation.arithmetic import FLOATS
from similitude.simulation.car import GRAVITY, Car
from similitude.simulation.loop import drive
from similitude.simulation.plant import Push
from similitude.simulation.single_track import SingleTrack, axle_limit

from .quiet_drive import LINEAR, SATURATING, quiet

CAR = Car(m=1500.0, Iz=2600.0, a=1.2, b=1.5, Caf=82e3, Car=98e3)


def exact(motion, U):
    groups = {"L": CAR.L, "K": CAR.K * motion.felt.stiffness, **CAR.groups}
    return bicycle_response(motion.t, motion.seen.delta, U, **groups)


@pytest.mark.parametrize("step", ["5 ms", "10 ms"])
def test_the_linear_plant_is_the_exact_response(step):
    motion = drive(quiet(run__step=step), CAR, [0])
    r, beta = exact(motion, 80 / 3.6)

    h, rate = motion.t[1], CAR.fastest_rate(80 / 3.6)
    # local error (λ h)^5/120 a step, forgotten at the rate λ: (λ h)^4/120
    bound = (rate * h) ** 4 / 120
    assert np.abs(motion.seen.r - r).max() <= bound * np.abs(r).max()
    assert np.abs(motion.seen.v / (80 / 3.6) - beta).max() <= bound * np.abs(beta).max()


def test_a_change_of_stiffness_too():
    surface = [{"begin": "4 s", "stiffness": 0.5}]
    motion = drive(quiet(road={"surface": surface}), CAR, [0])
    r, _ = exact(motion, 80 / 3.6)
    assert np.abs(motion.seen.r - r).max() <= 1e-4 * np.abs(r).max()


@pytest.mark.parametrize("tyre", ["cubic", "brush"])
def test_at_small_slip_the_saturating_car_is_the_linear_one(tyre):
    def difference(amplitude):
        small = {"driver__amplitude": f"{amplitude} mrad"}
        linear = drive(quiet(LINEAR, **small), CAR, [0]).seen.r
        other = drive(quiet(SATURATING | {"tyre": tyre}, **small), CAR, [0]).seen.r
        return np.abs(other - linear).max() / np.abs(linear).max()

    # the onset loses a share of the grip used (brush) or its square (cubic): smaller with the steer
    large, small = difference(1.0), difference(0.1)
    assert large < 0.03 and small < (0.15 if tyre == "brush" else 0.02) * large


@pytest.mark.parametrize("tyre", ["cubic", "brush"])
def test_on_a_skid_pad_it_settles_at_the_static_solution(tyre):
    """Statics: m U r b/L at the front, m U r a/L at the rear; slip by inverting each tyre's curve."""
    from scipy.optimize import brentq

    from similitude.simulation.tyres import lateral_force

    U, friction = 20.0, 0.8
    scenario = quiet(
        SATURATING | {"tyre": tyre}, run__duration="20 s", speed={"kind": "constant", "value": "20 m/s"},
        driver={"kind": "turns", "amplitude": "45 mrad", "rise": "2 s", "hold": "30 s", "rest": "1 s"},
        road={"friction": friction},
    )  # fmt: skip
    seen = drive(scenario, CAR, [0]).seen
    r, v = seen.r[-1], seen.v[-1]

    most_f, most_r = (friction * CAR.m * GRAVITY * x / CAR.L for x in (CAR.b, CAR.a))

    def slip(C, force, most):
        return brentq(lambda x: lateral_force(tyre, C, x, most, FLOATS) - force, 0, 0.5)

    ay = U * r
    front = slip(CAR.Caf, CAR.m * ay * CAR.b / CAR.L / np.cos(0.045), most_f)
    rear = slip(CAR.Car, CAR.m * ay * CAR.a / CAR.L, most_r)
    assert ay > 0.5 * friction * GRAVITY, "not near the limit"
    assert seen.ay[-1] == pytest.approx(ay, rel=1e-6)
    assert 0.045 - np.arctan((v + CAR.a * r) / U) == pytest.approx(front, rel=1e-4)
    assert -np.arctan((v - CAR.b * r) / U) == pytest.approx(rear, rel=1e-4)


def test_signs_steer_to_the_left_turns_and_accelerates_to_the_left():
    driver = {"kind": "turns", "amplitude": "20 mrad", "rise": "0.2 s", "hold": "3 s", "rest": "1 s"}
    seen = drive(quiet(SATURATING, driver=driver, run__duration="3 s"), CAR, [0]).seen

    assert seen.r[-1] > 0 and seen.ay[-1] > 0 and seen.y[-1] > 0 and seen.psi[-1] > 0
    assert seen.v[-1] < 0  # nose in, above the speed at which the rear runs inside the front


def test_a_push_to_the_left_moves_to_the_left_and_a_lean_does_too():
    for road in ({"bank": [{"at": "0 s", "angle": "2 deg"}]},):
        seen = drive(quiet(SATURATING, driver={"kind": "straight"}, road=road), CAR, [0]).seen
        assert seen.y[-1] > 0 and seen.v[10] > 0


def test_without_steer_lateral_motion_only_loses_energy():
    """The tyres of a straight rolling car take energy out: m v²/2 + Iz r²/2 − m U v ... at low speed.

    At low speed U r is small beside the tyres, and the sum of both energies must fall all the time.
    """
    plant = SingleTrack(CAR, tyre="brush", height=0.0, on=FLOATS)
    push = Push(0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0)
    state, energy = [0.0, 0.0, 0.0, 1.0, 0.5], []
    for _ in range(300):
        energy.append(CAR.m * state[3] ** 2 / 2 + CAR.Iz * state[4] ** 2 / 2)
        state, _ = plant.advance(state, push, push, 1e-3)
    assert (np.diff(energy) < 0).all() and energy[-1] < 1e-2 * energy[0]


def test_braking_moves_load_and_takes_grip():
    assert axle_limit(5000.0, 0.9, 0.0, FLOATS) == 4500.0
    # half of the grip used forward leaves √(3)/2 of it sideways
    assert axle_limit(5000.0, 1.0, -GRAVITY / 2, FLOATS) == pytest.approx(5000 * np.sqrt(3) / 2)
    plant = SingleTrack(CAR, tyre="brush", height=0.5, on=FLOATS)
    gripping = [
        plant._axle_forces([0, 0, 0, 0, 0], Push(1.0, 20.0, 0, 0, 0, ax, 1.0, 1.0))[0] for ax in (0.0, -2.0)
    ]
    load = CAR.m * (GRAVITY * CAR.b + 0.5 * 2) / CAR.L
    assert gripping[1] == pytest.approx(load * np.sqrt(1 - (2 / GRAVITY) ** 2))


def test_many_cars_are_each_the_one():
    scenario = quiet(SATURATING, vehicle__m="1500 ± 200 kg", driver__amplitude="40 mrad")
    cars = scenario.vehicle.draw([1, 2, 3])
    together = drive(scenario, cars, [1, 2, 3]).seen
    for i, seed in enumerate([1, 2, 3]):
        alone = drive(scenario, scenario.vehicle.draw([seed]), [seed]).seen
        np.testing.assert_allclose(together.r[:, i], alone.r, rtol=1e-9, atol=1e-12)
