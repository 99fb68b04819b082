"""Sensors: every fault has the size that was asked for, and none disturbs another."""

import numpy as np
import pytest

from similitude.simulation.car import generator
from similitude.simulation.keys import Place, keys_of, read_table
from similitude.simulation.sensors import Sensor, Sensors, YawRateSensor, errors_of, reading, written

N = 40000
T = np.arange(N) * 0.01
ZERO = np.zeros(N)


def error(seed=1, **faults):
    return errors_of(Sensor(**faults), T, generator(seed, "sensor r"))


def column(truth=ZERO, added=ZERO, **faults):
    return written(Sensor(**faults), T, truth, added, generator(1, "lost r"))


def test_noise_is_white_and_of_its_size():
    noise = error(noise=0.02)
    assert noise.std() == pytest.approx(0.02, rel=4 / np.sqrt(2 * N))
    assert abs(np.corrcoef(noise[1:], noise[:-1])[0, 1]) < 4 / np.sqrt(N)


def test_a_bias_walks_as_the_root_of_time():
    ends = [error(seed, walk=0.01)[[100, 400]] for seed in range(300)]
    after_1, after_4 = np.std(ends, axis=0)
    assert after_1 == pytest.approx(0.01, rel=4 / np.sqrt(600))
    assert after_4 == pytest.approx(0.02, rel=4 / np.sqrt(600))
    assert error(walk=0.01, bias=0.3)[0] == 0.3


def test_spikes_come_at_their_rate():
    spikes = error(spike=5.0, spikes_every=2.0)
    hits = np.count_nonzero(spikes)
    assert hits == pytest.approx(200, abs=4 * np.sqrt(200))
    assert spikes[spikes != 0].std() == pytest.approx(5, rel=4 / np.sqrt(2 * hits))


def test_one_fault_does_not_change_another():
    np.testing.assert_array_equal(error(noise=0.02), error(noise=0.02, spike=0.0, walk=0.0))
    np.testing.assert_allclose(error(noise=0.02, bias=0.1), error(noise=0.02) + 0.1)


def test_scale_and_rounding():
    sensor = Sensor(scale=1.1, quantum=0.05)
    assert reading(sensor, 1.0, 0.02) == pytest.approx(1.1)
    steps = column(np.linspace(-1, 1, N), quantum=0.05) / 0.05
    np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)
    # rounding is uniform over a step: a twelfth of its square
    spread = column(np.linspace(-1, 1, N), quantum=0.05) - np.linspace(-1, 1, N)
    assert spread.std() == pytest.approx(0.05 / np.sqrt(12), rel=0.02)


def test_a_slower_sensor_holds_or_leaves_cells_empty():
    truth = np.arange(N, dtype=float)
    held, empty = column(truth, rate=20.0), column(truth, rate=20.0, between="empty")
    fresh = np.arange(N) % 5 == 0
    np.testing.assert_array_equal(held, truth // 5 * 5)
    np.testing.assert_array_equal(np.isfinite(empty), fresh)
    np.testing.assert_array_equal(empty[fresh], truth[fresh])
    uneven = column(truth, rate=30.0, between="empty")  # no whole number of rows: 30 a second all the same
    assert np.count_nonzero(np.isfinite(uneven)) == pytest.approx(N * 0.3, abs=2)


@pytest.mark.parametrize("lost_for", [0.0, 0.2])
def test_lost_samples_have_their_share_and_length(lost_for):
    gone = np.isnan(column(lost=0.05, lost_for=lost_for))
    starts = np.count_nonzero(gone[1:] & ~gone[:-1])
    length = max(lost_for / 0.01, 1 / 0.95)
    # a share of gaps: its standard error is that of the number of gaps, lengths being geometric
    assert gone.mean() == pytest.approx(0.05, rel=4 * np.sqrt(2 / starts))
    assert gone.sum() / starts == pytest.approx(length, rel=4 / np.sqrt(starts))


def test_keys_carry_the_unit_of_their_channel():
    read = read_table(Sensors, {"r": {"noise": "0.1 deg/s", "lost": 0.02}}, Place("a.toml", ""))
    assert read.r.noise == pytest.approx(np.deg2rad(0.1)) and read.r.lost == 0.02 and read.U == Sensors().U
    assert isinstance(read.r, YawRateSensor) and {"bias", "walk", "delay"} <= keys_of(YawRateSensor).keys()
