"""What the filter for small parts does otherwise than the population filter."""

import math

import numpy as np
import pytest

from similitude.estimators.filter_lean import TURNS, bounded_once
from similitude.estimators.small_population import small_population_filter
from similitude.filter_config import longest
from similitude.program.ir import Assign, walk
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction

from ..filter_rig import car_config
from .test_small_population import drive

LIBRARY = shipped("bicycle_small_population")
CONFIG = car_config(LIBRARY)


def test_no_average_takes_more_than_its_newest_sample():
    config = dict(zip(LIBRARY.names("config"), CONFIG, strict=True))

    assert config["longest"] == pytest.approx(longest(config))
    slow = {"disturbance_adapt", "noise_adapt", "excitation_rate"}
    rates = {n: v * (TURNS if n in slow else 1) for n, v in config.items() if n.endswith(("_rate", "_adapt"))}
    assert max(v * config["longest"] for v in rates.values()) <= 1 + 1e-12
    assert 2 * config["structure_time"] >= config["longest"]


def test_averages_are_bounded_by_the_time_alone():
    step = small_population_filter(bicycle_reduction()).step
    texts = [str(s.expression) for s in walk(step) if isinstance(s, Assign)]

    assert not any("dt*activity_rate" in t or "dt*validity_rate" in t for t in texts)
    assert any("activity_rate*held" in t for t in texts)
    program = small_population_filter(bicycle_reduction())
    assert bounded_once(program) == program  # nothing is left to bound


def test_a_sample_pulls_or_learns_and_a_start_anew_propagates_nothing():
    state = LIBRARY.start(CONFIG)
    rows = drive(20)
    place = {n: LIBRARY.index("state", n) for n in ("excited", "information", "unlearnt")}
    seen = set()
    for row in rows:
        before = state.copy()
        LIBRARY.run(CONFIG, state, row[None])
        learnt = state[place["information"]] > before[place["information"]]
        assert learnt == (before[place["excited"]] > 0)
        seen.add(bool(learnt))
    assert seen == {False, True}

    known = state.copy()
    LIBRARY.run(CONFIG, state, np.array([[1.5, 0.0, 25.0, math.nan]]))  # a gap, and nothing measured
    P = LIBRARY.index("state", "P")
    cross = [P + j for j in range(2, 8)]  # of the sideslip with all that is slow
    assert np.count_nonzero(known[cross]) and not np.count_nonzero(state[cross])


def test_the_slow_sizes_take_turns():
    state, turns = LIBRARY.start(CONFIG), []
    at = LIBRARY.index("state", "turn")
    for row in drive(1):
        LIBRARY.run(CONFIG, state, row[None])
        turns.append(int(state[at]))

    assert turns[:7] == [1, 2, 0, 1, 2, 0, 1]
