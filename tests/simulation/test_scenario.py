"""Scenario files: the shipped ones, changes, and how parts that do not fit are refused."""

import pathlib

import numpy as np
import pytest

from similitude.errors import ScenarioError, UsageError
from similitude.simulation.lqr import Lqr
from similitude.simulation.manoeuvres import FromLog, Slalom
from similitude.simulation.scenario import find_scenario, read_scenario, shipped

from .quiet_drive import TWO_TRACK, quiet

DATA = pathlib.Path(__file__).parents[2] / "data"
NEEDS_PACKAGE = {"multi_body", "drift"}


@pytest.mark.parametrize("name", sorted(shipped().keys() - NEEDS_PACKAGE))
def test_a_shipped_scenario_is_read_and_says_what_it_is(name):
    scenario = read_scenario(name)
    assert scenario.name == name and scenario.title and len(scenario.about) > 80


def test_the_scenarios_that_were_promised_are_there():
    promised = {"slalom", "highway", "double_lane_change", "friction_step", "peak_only", "split_mu",
                "straight_road", "square_closed_loop", "treadmill"}  # fmt: skip
    assert promised <= shipped().keys() and find_scenario("slalom") == shipped()["slalom"]


def test_the_paper_s_loop_is_as_printed():
    """Brennan & Alleyne (2004), section 6."""
    scenario = read_scenario("square_closed_loop")
    assert scenario.timing.step == 0.001 and scenario.timing.rows_every == 1
    assert (scenario.actuator.servo, scenario.actuator.damping) == (5, 0.707)
    assert scenario.driver.path.square == 0.06 and scenario.driver.design_speed == 3
    car = scenario.vehicle.nominal()
    pi3 = car.K / 4**2
    assert pi3 == pytest.approx(0.27217, abs=5e-6)
    assert isinstance(scenario.driver, Lqr)


def test_a_file_is_read_by_its_path(tmp_path):
    mine = tmp_path / "mine.toml"
    mine.write_text(find_scenario("slalom").read_text())
    scenario = read_scenario(mine, changes={"driver.amplitude": "5 mrad", "run.duration": '"3 s"'})
    assert scenario.name == "mine" and scenario.driver == Slalom(amplitude=0.005, frequency=0.5, begin=2.0)
    assert scenario.timing.duration == 3 and scenario.timing.ticks == 601


def test_changes_may_be_numbers_lists_and_tables_of_toml():
    scenario = read_scenario("square_closed_loop", changes={
        "driver.weights": "[1, 2, 3, 4, 5]", "driver.effort": "2", "road": "{ friction = 0.7 }",
    })  # fmt: skip
    assert scenario.driver.weights == (1, 2, 3, 4, 5) and scenario.driver.effort == 2
    assert scenario.road.friction == 0.7 and scenario.road.surface == ()


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"run.log_rate": "300 Hz"}, "no whole number of steps"),
        ({"plant": "{ kind = 'bicycle' }"}, "'bicycle' is not known"),
        ({"driver.amplitud": "1 mrad"}, "did you mean 'amplitude'"),
        ({"rode.friction": "1"}, "'rode' is not known"),
        ({"road.surface": "[{ side = 'left', friction = 0.3 }]"}, "no left and right"),
        ({"sensors.steer_as": "steering_wheel"}, "needs a ratio"),
        ({"speed": "{ kind = 'log', at_least = '3 m/s' }"}, "needs driver.kind = 'log'"),
        ({"vehicle.Caf": "0.1 kN/rad"}, "times the weight"),
        ({"title": "3"}, "'title' is not known, or is not what it should be"),
    ],
)  # fmt: skip
def test_parts_that_do_not_fit_are_refused(changes, says):
    with pytest.raises((ScenarioError, Exception)) as refused:
        read_scenario("slalom", changes=changes)
    assert says in refused.value.what and refused.value.paste


def test_a_change_through_a_list_and_a_missing_scenario_are_usage():
    with pytest.raises(UsageError, match="no single table"):
        read_scenario("friction_step", changes={"road.surface.friction": "0.3"})
    with pytest.raises(UsageError, match="slalon") as refused:
        read_scenario("slalon")
    assert refused.value.paste == "similitude simulate slalom"


def test_files_that_are_no_scenario_are_refused(tmp_path):
    for name, content, says in (
        ("a.toml", b"[run\n", "is not TOML"), ("b.toml", b"\xff\xfe\xfa", "cannot be read"),
        ("c.toml", b"", "section [run] is missing"),
        ("d.toml", b"run = 3\nplant = 3\nspeed=3\ndriver=3", "kind"),
    ):  # fmt: skip
        (tmp_path / name).write_bytes(content)
        with pytest.raises(ScenarioError) as refused:
            read_scenario(tmp_path / name)
        assert says in refused.value.what


def test_the_steer_and_the_speed_of_a_log_drive_the_plant(tmp_path):
    scenario = quiet(
        driver={"kind": "log", "file": str(DATA / "bmw_m8_double_lane_change.csv")},
        speed={"kind": "log", "at_least": "3 m/s"},
    )
    assert isinstance(scenario.driver, FromLog)
    t = np.arange(0, 5, 0.01)
    assert (
        np.abs(scenario.driver.steer(t, 0)).max() > 1e-3
        and scenario.speed.at(t).min() == 3 < scenario.speed.at(t).max()
    )


def test_the_foreign_plant_knows_no_places_and_needs_short_steps():
    pytest.importorskip("vehiclemodels")
    for changes, says in (
        ({"run.step": "5 ms"}, "too long"),
        ({"road.gusts": "{force='1 N', correlation='1 s'}"}, "knows no gusts"),
        ({"road.surface": "[{ y_to = '0 m', friction = 0.3 }]"}, "at a place"),
        ({"vehicle.m": "1500 kg"}, "has no effect"),
    ):  # fmt: skip
        with pytest.raises(ScenarioError) as refused:
            read_scenario("drift", changes=changes)
        assert says in refused.value.what


def test_two_track_may_have_sides():
    road = {"surface": [{"side": "left", "friction": 0.3}]}
    assert quiet(TWO_TRACK, road=road).road.surface[0].side == "left"
