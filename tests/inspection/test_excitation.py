"""Windows of a drive: planted standstill, reverse, straights and hard corners are told apart."""

import numpy as np
import pytest

from similitude.inspection.excitation import KINDS, WINDOW, excitation, seconds_by_kind
from similitude.inspection.signals import Signals


def planted():
    """Twelve seconds of each: standing, reverse, straight, steered, hard, not measured."""
    t = np.arange(6 * 1200) * 0.01
    part = np.arange(t.size) // 1200
    U = np.select([part == 0, part == 1], [0.0, -3.0], 20.0)
    size = np.select([part == 3, part == 4], [0.005, 0.08], 1e-5)
    steer = size * np.sin(2 * np.pi * t)
    r = np.where(part == 5, np.nan, steer * U / 2.7)
    return Signals(0.01, t, steer, r, U, None)


def test_each_part_of_a_drive_is_of_its_kind():
    windows = excitation(planted())
    kinds = [one.kind for one in windows]

    expected = ["standing", "reverse", "straight", "steered", "beyond_linear", "missing"]
    assert kinds == [kind for kind in expected for _ in range(6)]
    assert seconds_by_kind(windows) == {kind: 12.0 for kind in KINDS}


def test_the_steer_of_a_window_is_its_rms_about_its_own_line():
    windows = excitation(planted())

    assert windows[20].steer_rms == pytest.approx(0.005 / np.sqrt(2), rel=0.15)
    assert windows[20].sideways == pytest.approx(0.005 * 20**2 / 2.7, rel=0.01)
    assert windows[20].speed == 20.0
    assert windows[-1].sideways is None


def test_a_slow_bend_is_hardly_steered():
    t = np.arange(2000) * 0.01
    steer = 1e-4 * t  # a clothoid
    windows = excitation(Signals(0.01, t, steer, steer * 20 / 2.7, np.full(t.size, 20.0), None))

    assert {one.kind for one in windows} == {"straight"}


def test_windows_follow_one_another():
    windows = excitation(planted())

    assert np.diff([one.at for one in windows]) == pytest.approx(WINDOW)


def test_nothing_to_cut_gives_nothing():
    short = Signals(0.01, np.arange(10.0), np.ones(10), np.ones(10), np.ones(10), None)

    assert excitation(short) == ()
    assert excitation(Signals(0.01, np.arange(1000.0), None, None, None, None)) == ()
