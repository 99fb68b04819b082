"""Manoeuvres: amplitudes, frequencies, quiet starts, and seeds."""

import numpy as np
import pytest

from similitude.simulation.manoeuvres import (
    MANOEUVRES,
    DoubleLaneChange,
    FromLog,
    Highway,
    Slalom,
    Square,
    Straight,
    Sweep,
    Turns,
)

T = np.arange(0, 60, 0.005)
ALL = [
    Straight(), Slalom(amplitude=0.02, frequency=0.5, begin=2.0),
    Sweep(amplitude=0.01, slowest=0.2, fastest=4.0, duration=20.0, begin=2.0),
    DoubleLaneChange(amplitude=0.03, period=2.0, pause=1.0, every=10.0, begin=2.0),
    Turns(amplitude=0.03, rise=0.3, hold=4.0, rest=3.0, begin=2.0), Highway(rms=0.003),
    Square(amplitude=0.01, period=4.0, begin=2.0),
]  # fmt: skip


@pytest.mark.parametrize("one", ALL, ids=lambda one: type(one).__name__)
def test_steer_keeps_to_its_amplitude_and_repeats_with_its_seed(one):
    steer = one.steer(T, 1)
    assert steer.shape == T.shape and np.isfinite(steer).all()
    assert np.abs(steer).max() <= getattr(one, "amplitude", 1.0) * (1 + 1e-9)
    np.testing.assert_array_equal(steer, one.steer(T, 1))


@pytest.mark.parametrize("one", [x for x in ALL if hasattr(x, "begin")], ids=lambda x: type(x).__name__)
def test_straight_ahead_until_it_begins_and_then_all_of_it(one):
    steer = one.steer(T, 1)
    assert not steer[T < 2].any() and np.abs(steer).max() > 0.99 * one.amplitude


def test_a_sweep_has_its_frequencies():
    steer = ALL[2].steer(T, 1)
    rises = T[1:][(steer[1:] > 0) & (steer[:-1] <= 0)]
    periods = np.diff(rises[rises < 22])
    # the first whole turn is a little faster than the start, the last a little slower than the end
    assert 1 / periods[0] == pytest.approx(0.2, rel=0.6) and 1 / periods[-1] == pytest.approx(4, rel=0.05)


def test_a_double_lane_change_ends_where_it_began():
    steer = ALL[3].steer(T, 1)[(T >= 2) & (T < 12)]
    heading = np.cumsum(steer)
    assert (
        abs(heading[-1]) < 1e-3 * np.abs(heading).max()
        and np.abs(np.cumsum(heading)[-1]) < 0.01 * np.abs(np.cumsum(heading)).max()
    )


def test_turns_alternate():
    steer = ALL[4].steer(T, 1)
    assert steer[T == 4.0] > 0 and steer[np.argmin(abs(T - 11.6))] < 0


def test_highway_noise_has_its_rms_and_band_and_depends_on_the_seed():
    steer, other = Highway(rms=0.003).steer(T, 1), Highway(rms=0.003).steer(T, 2)
    assert np.sqrt(np.mean(steer**2)) == pytest.approx(0.003) and abs(np.corrcoef(steer, other)[0, 1]) < 0.3
    power = np.abs(np.fft.rfft(steer)) ** 2
    inside = (np.fft.rfftfreq(T.size, 0.005) > 0.07) & (np.fft.rfftfreq(T.size, 0.005) < 2)
    assert power[inside].sum() > 0.95 * power.sum()


def test_the_steer_of_a_log_is_straight_between_rows():
    log = FromLog(file="x.csv", times=np.array([0.0, 1.0]), angles=np.array([0.0, 0.02]))
    assert log.steer(np.array([0.5, 5.0]), 1).tolist() == [0.01, 0.02]
    assert set(MANOEUVRES) >= {"slalom", "sweep", "log"}
