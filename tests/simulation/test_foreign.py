"""Foreign cars behind our interface: signs, small-slip stiffness, friction; needs the extra `plants`."""

import numpy as np
import pytest

from similitude.errors import UsageError
from similitude.simulation import foreign
from similitude.simulation.foreign import MODELS, ForeignPlant, foreign_car
from similitude.simulation.plant import Push

U, STEP = 20.0, 2e-3
PUSH = Push(0.0, U, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0)


@pytest.fixture
def installed():
    pytest.importorskip("vehiclemodels")


def settle(model, angle, seconds=3.0, vehicle="bmw_320i", **road):
    """What is seen at the end of a steady turn that was entered over half a second."""
    plant = ForeignPlant(model, vehicle)
    state, n = plant.start(PUSH, 0.0), round(seconds / STEP)
    angles = angle * np.minimum(np.arange(n + 1) * STEP / 0.5, 1.0)
    for before, after in zip(angles.tolist(), angles[1:].tolist(), strict=False):
        push = PUSH._replace(delta=before, **road)
        state, seen = plant.advance(state, push, push._replace(delta=after), STEP)
    return seen


def slip(seen, car):
    """Slip angles of the axles and the force over stiffness that a steady turn asks of them [rad]."""
    front = seen.delta - (seen.v + car.a * seen.r) / seen.U
    rear = -(seen.v - car.b * seen.r) / seen.U
    asked = car.m * seen.ay / car.L
    return np.array([front, rear]), asked * np.array([car.b / car.Caf, car.a / car.Car])


def test_without_the_package_it_is_said_how_to_get_it(monkeypatch):
    monkeypatch.setattr(foreign.importlib, "import_module", _absent)
    with pytest.raises(UsageError) as refused:
        ForeignPlant("st", "bmw_320i")
    assert refused.value.paste == "pip install 'similitude[plants]'"


def _absent(name):
    raise ModuleNotFoundError(name)


@pytest.mark.parametrize("model", MODELS)
def test_a_positive_steer_turns_and_accelerates_positively_at_the_speed_asked_for(installed, model):
    seen = settle(model, 0.01)
    assert seen.r > 0 and seen.ay > 0 and seen.y * seen.psi > 0
    assert seen.delta == pytest.approx(0.01) and seen.U == pytest.approx(U, rel=0.01)
    assert seen.ay == pytest.approx(seen.U * seen.r, rel=0.02)


def test_the_stiffness_of_the_linear_model_is_the_one_derived_from_its_parameters(installed):
    car = foreign_car("st", "bmw_320i")
    angles, asked = slip(settle("st", 0.005), car)
    np.testing.assert_allclose(angles, asked, rtol=2e-3)
    assert car.K == pytest.approx(21.92 * 9.81 * car.b) and car.groups["eta"] == pytest.approx(1)


def test_the_slope_of_the_drifting_model_too(installed):
    """Between two small turns, so that the side force of the driven wheels cancels."""
    car = foreign_car("std", "bmw_320i")
    (a1, f1), (a2, f2) = (slip(settle("std", angle), car) for angle in (0.002, 0.004))
    # drive and curvature of the tyre cost under two per cent at this slip of 0.1 to 0.2 deg
    np.testing.assert_allclose((f2 - f1) / (a2 - a1), 1.0, atol=0.02)


def test_the_multi_body_car_jumps_with_the_sign_of_its_camber(installed):
    """Its tyre shifts by p_hy1 + p_vy1/p_ky1 = 0.97 mrad of slip to the side it leans to.

    So force over stiffness is slip angle plus that shift, plus what camber adds with roll: at 0.3
    m/s^2 the axles look four times as stiff as their slope, at 3 m/s^2 a sixth stiffer.
    """
    car = foreign_car("mb", "bmw_320i")
    tire = foreign.parameters("bmw_320i").tire
    jump = tire.p_hy1 + tire.p_vy1 / tire.p_ky1
    angles, asked = slip(settle("mb", 5e-4), car)
    assert jump == pytest.approx(0.97e-3, rel=0.01)
    np.testing.assert_allclose(asked - angles, jump, rtol=0.1)


def test_friction_and_stiffness_are_two_things(installed):
    small, large = 0.004, 0.12
    for model in ("std",):
        normal, peak, slope = (settle(model, small, **road) for road in (
            {}, {"friction": 0.5}, {"stiffness": 0.5}))  # fmt: skip
        car = foreign_car(model, "bmw_320i")
        soft = slip(slope, car)[0] / slip(normal, car)[0] * normal.ay / slope.ay
        np.testing.assert_allclose(soft, 2.0, rtol=0.05)
        assert peak.r == pytest.approx(normal.r, rel=0.01)
        grip, ice = settle(model, large), settle(model, large, friction=0.3)
        assert ice.ay < 0.4 * 9.81 < grip.ay


def test_a_scenario_with_a_foreign_car_runs(installed):
    from similitude.simulation.recording import run_scenario
    from similitude.simulation.scenario import read_scenario

    drive, again = (
        run_scenario(read_scenario("drift", changes={"run.duration": "4 s"}), [seed])[0] for seed in (1, 1)
    )
    assert drive.truth["K [m^2/s^2]"][0] == pytest.approx(foreign_car("std", "bmw_320i").K)
    np.testing.assert_array_equal(drive.log["r [rad/s]"], again.log["r [rad/s]"])
    assert 'L = "2.578' in drive.vehicle_file and "Caf" not in drive.vehicle_file
