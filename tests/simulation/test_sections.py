"""Timing, and plants and drivers by name."""

from similitude.simulation.keys import keys_of
from similitude.simulation.sections import DRIVERS, PLANTS, Timing


def test_rows_and_ticks():
    timing = Timing(duration=60.0, step=0.002, log_rate=100.0)
    assert (timing.rows_every, timing.ticks) == (5, 30001)


def test_plants_and_drivers_have_their_names():
    assert set(PLANTS) == {"linear", "saturating", "two_track", "commonroad"}
    assert {
        "slalom",
        "sweep",
        "double_lane_change",
        "turns",
        "highway",
        "straight",
        "square",
        "log",
        "lqr",
    } == set(DRIVERS)
    assert not keys_of(PLANTS["linear"]) and "track" in keys_of(PLANTS["two_track"])
