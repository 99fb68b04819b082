"""Doubts: each is raised where it was planted, and not beside it."""

from types import SimpleNamespace

import numpy as np
import pytest

from similitude.inspection.channels import channel
from similitude.inspection.doubts import (
    find_coarse_steer,
    find_cut_steer,
    find_late_steer,
    find_other_axis,
    find_strange_car,
    find_wrong_scale,
)
from similitude.inspection.follow import Follow
from similitude.inspection.signals import Signals
from similitude.inspection.slow_relation import SlowRelation


def plan(*, lag=0.0, std=0.002, origin="scanned", K=150.0, commanded=False, early=0.0, at_limit=()):
    scan = SimpleNamespace(total=lag, std=std, origin=origin, early=early)
    K_away = float(np.log(K / 145.68))
    return SimpleNamespace(
        scan=scan, commanded=commanded, K=K, K_away=K_away, K_prior_std=0.5, at_limit=at_limit
    )


def faults(findings):
    return [one.fault for one in findings]


def test_a_cut_steer_names_where_it_is_held():
    t = np.arange(5000) * 0.02
    steer = np.clip(0.5 * np.sin(t), -0.34, 0.34)

    (found,) = find_cut_steer(channel(steer, header="delta [rad]", unit="rad"))

    assert "-0.34 and 0.34 rad" in found.what and not found.certain
    assert find_cut_steer(channel(0.3 * np.sin(t), header="delta [rad]")) == []


@pytest.mark.parametrize("step, found", [(0.02, ["steer_coarse"]), (0.01, [])])
def test_a_steer_in_large_steps_is_coarse(step, found):
    steer = 0.2 * np.sin(np.arange(5000) * 0.02)
    described = channel(np.round(steer / step) * step, header="delta [rad]", unit="rad")

    assert faults(find_coarse_steer(described, float(steer.std()))) == found


def test_a_scale_of_one_over_three_point_six_is_that_of_kilometres_an_hour():
    (kmh,) = find_wrong_scale(SlowRelation(20, length=9.72, length_std=0.06), 2.7, "delta", at_wheel=False)
    (other,) = find_wrong_scale(SlowRelation(20, length=4.0, length_std=0.06), 2.7, "delta", at_wheel=False)

    assert kmh.fix == "speed_is_kmh" and other.fix is None


@pytest.mark.parametrize("lag, found", [(0.06, ["late_steer"]), (0.003, []), (0.0, [])])
def test_a_late_steer_must_be_later_than_its_uncertainty(lag, found):
    assert faults(find_late_steer(plan(lag=lag), "delta")) == found


def test_a_lag_that_was_assumed_is_no_finding():
    assert find_late_steer(plan(lag=0.06, origin="vehicle file"), "delta") == []


@pytest.mark.parametrize(
    "length, found", [(2.7, []), (2.5, []), (2.0, ["steer_scale"]), (4.0, ["steer_scale"])]
)
def test_a_scale_must_be_off_by_more_than_its_interval(length, found):
    slow = SlowRelation(20, length=length, length_std=0.06)

    assert faults(find_wrong_scale(slow, 2.7, "delta", at_wheel=False)) == found
    assert find_wrong_scale(slow, 2.7, "steering_wheel", at_wheel=True) == []
    assert find_wrong_scale(SlowRelation(3), 2.7, "delta", at_wheel=False) == []


def test_a_stiffness_no_car_has_doubts_the_steer():
    assert faults(find_strange_car(plan(K=970.0), "delta")) == ["steer_scale"]
    assert find_strange_car(plan(K=40.0), "delta") == []  # ice is a road too
    (edge,) = find_strange_car(plan(at_limit=("rho",)), "delta")
    assert edge.fault == "outside_population"
    assert "the yaw inertia (rho)" in edge.what


def signals(ay_of):
    """A drive that speeds up, slows down and corners, unrelated to one another."""
    t = np.arange(6000) * 0.02
    U = 15 + 4 * np.sin(0.5 * t)
    r = 0.1 * np.sin(1.7 * t)
    noise = 0.1 * np.random.default_rng(0).standard_normal(t.size)
    return Signals(0.02, t, None, r, U, ay_of(U, r, np.gradient(U, t)) + noise)


def test_an_acceleration_along_the_car_is_not_the_lateral_one():
    turned = signals(lambda U, r, along: -along)

    (found,) = find_other_axis(turned, Follow(0, 0.0), "ay [g]")

    assert found.fault == "ay_axis" and found.value < -0.6
    assert find_other_axis(signals(lambda U, r, along: r * U), Follow(1, 0.9), "ay") == []
    assert find_other_axis(signals(lambda U, r, along: 0 * U), Follow(0, 0.0), "ay") == []
    assert find_other_axis(turned, None, "ay") == []


def test_every_doubt_has_its_four_parts_and_refuses_nothing():
    met = [
        *find_late_steer(plan(lag=0.06, commanded=True), "delta"),
        *find_strange_car(plan(K=970.0), "delta"),
        *find_wrong_scale(SlowRelation(20, length=4.0, length_std=0.05), 2.7, "delta", at_wheel=False),
    ]

    for one in met:
        assert one.what and one.usually and one.paste and one.read and not one.certain


def test_a_yaw_rate_before_its_steer_is_two_clocks():
    (found,) = find_late_steer(plan(origin="assumed", early=0.1), "delta [rad]")
    assert found.fault == "clocks_apart" and not found.certain
    assert "100 ms before" in found.what
