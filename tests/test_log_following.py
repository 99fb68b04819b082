"""A steer that is held or cut off is told from one that a driver holds by what the car does."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.log_following import cut_off, cut_short, unanswered

from .simulated_drive import drive

STEP = 1e-4  # rad, of the readings


def values(*, seconds=50.0, seed=0, rms=0.006, **more):
    log = drive(seconds=seconds, seed=seed, rms=rms, **more)
    return {"t": log.t, "delta": np.round(log.delta / STEP) * STEP, "r": log.r, "U": log.U}


def with_steer(log, change):
    steer = log["delta"].copy()
    change(steer)
    return {**log, "delta": steer}


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 99), start=st.integers(200, 3500), length=st.integers(150, 1000))
def test_a_steer_that_stands_while_the_car_turns_is_found_and_only_there(seed, start, length):
    log = values(seed=seed)
    rows = slice(start, start + length)
    stuck = with_steer(log, lambda steer: steer.__setitem__(rows, steer[start]))
    found = np.flatnonzero(unanswered(stuck, "delta", [(start, start + length)]))
    assert found.tolist() == list(range(start, start + length))


def test_a_driver_who_holds_the_wheel_is_not_accused():
    """The car turns at a steady rate while the wheel is held: the log is that of the held steer."""
    rng = np.random.default_rng(0)
    t = np.arange(0, 60, 0.01)
    steer = np.repeat(rng.normal(0, 0.01, 30), 200)
    steer = np.round(np.convolve(steer, np.ones(40) / 40, "same") / STEP) * STEP
    answer = np.convolve(steer, np.exp(-np.arange(100) / 12) / 12)[: t.size]
    log = {"t": t, "delta": steer, "r": 8 * answer + rng.normal(0, 2e-3, t.size), "U": np.full(t.size, 25.0)}
    same = np.r_[np.diff(steer) == 0, False]
    edges = np.flatnonzero(np.diff(np.r_[False, same, False].astype(int)))
    held = [(a, b) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a > 50]
    assert len(held) > 15
    assert not unanswered(log, "delta", held).any()
    assert not cut_off(log, "delta").any()


@pytest.mark.parametrize("share", [0.4, 0.6])
@pytest.mark.parametrize("seed", range(3))
def test_a_coarse_steer_that_is_cut_off_is_found_and_the_whole_one_is_not(share, seed):
    log = values(seed=seed)
    most = round(share * np.abs(log["delta"]).max() / STEP) * STEP
    cut = {**log, "delta": np.clip(log["delta"], -most, most)}
    assert not cut_off(log, "delta").any()
    assert np.array_equal(cut_off(cut, "delta"), np.abs(cut["delta"]) == most)


def test_a_step_steer_is_held_at_its_end_and_not_cut_off():
    t = np.arange(0, 60, 0.01)
    steer = 0.02 * np.clip(5 * np.sin(2 * np.pi * t / 8), -1, 1)
    yaw = np.convolve(8 * steer, np.exp(-np.arange(100) / 12) / 12)[: t.size]
    yaw += np.random.default_rng(1).normal(0, 2e-3, t.size)
    assert not cut_off({"t": t, "delta": steer, "r": yaw, "U": np.full(t.size, 25.0)}, "delta").any()


@pytest.mark.parametrize("missing", ["r", "U"])
def test_without_yaw_rate_or_speed_nothing_is_said(missing):
    log = values(seconds=20)
    del log[missing]
    assert not unanswered(log, "delta", [(500, 900)]).any()
    assert not cut_off(log, "delta").any()


def test_a_steer_that_explains_nothing_accuses_nothing():
    log = values(seconds=40)
    log["r"] = np.random.default_rng(0).normal(0, 0.1, log["r"].size)
    assert not unanswered(log, "delta", [(500, 900)]).any()


def test_a_yaw_rate_without_a_number_stands_at_no_end():
    t = np.arange(400) * 0.05
    values = {"t": t, "delta": np.sin(t), "U": np.full(t.size, 20.0), "r": np.full(t.size, np.nan)}

    assert not cut_short(values, "delta").any()


def test_a_yaw_rate_that_is_at_an_end_in_every_row_leaves_nothing_to_learn_from():
    t = np.arange(1200) * 0.05
    steer = 0.02 * np.sin(t)
    rate = np.where(steer >= 0, 0.1, -0.1)
    values = {"t": t, "delta": steer, "U": np.full(t.size, 20.0), "r": rate}

    with np.errstate(all="raise"):
        assert not cut_short(values, "delta").any()


@pytest.mark.parametrize("most", [0.5, 2.0])
def test_a_yaw_rate_that_is_cut_off_asks_for_less_than_its_steer(most):
    """A rounded rate on the rails of its steer: cut at half its size it is found, whole it is not."""
    t = np.arange(3000) * 0.02
    steer = 0.02 * (np.sin(0.9 * t) + 0.5 * np.sin(2.3 * t))
    rate = np.round(np.clip(4 * steer, -most * 0.1, most * 0.1) / 0.002) * 0.002
    values = {"t": t, "delta": steer, "U": np.full(t.size, 20.0), "r": rate}

    assert cut_short(values, "delta").any() == (most < 1)


def test_the_top_of_a_coarse_sine_is_no_end_of_its_range():
    """Steer and yaw rate in step, so that noise hides nothing; the sine's top is rounded to its last step."""
    t = np.arange(0, 60, 0.02)
    for most in np.arange(1.05, 6, 0.3):
        turning = most * np.sin(1.3 * t)
        log = {"t": t, "delta": 0.01 * turning, "r": 0.004 * np.round(turning), "U": np.full(t.size, 20.0)}
        assert not cut_short(log, "delta").any()


@pytest.mark.parametrize(("size", "most"), [(0.5, 2), (0.3, 3), (0.3, 4)])
def test_a_yaw_rate_of_a_few_steps_that_is_cut_is_found(size, most):
    """At one step to either side, nothing of its height is left to compare; that is not found."""
    log = values(seconds=60)
    step = size * log["r"].std()
    cut = {**log, "r": step * np.clip(np.round(log["r"] / step), -most, most)}
    whole = {**log, "r": step * np.round(log["r"] / step)}
    assert cut_short(cut, "delta").any() and not cut_short(whole, "delta").any()
