"""The sentences: what stands in them is what was found."""

import dataclasses

import numpy as np
import pytest

from similitude.inspection.advice import outlook, percent, relations
from similitude.inspection.inspection import inspect_log
from similitude.inspection.prospects import Prospect, Prospects
from similitude.steer_lag import LagScan

from ..log_text import csv_text, write
from ..simulated_drive import drive


def plan(**more):
    """Prospects of a good drive, with some of them replaced."""
    none = np.empty(0)
    values = dict(
        unknowns={"K": Prospect(0.5, 0.12)}, verdict="identified", goal=0.06, steer_times=2.0,
        long_times=4.0, longest=16.0, is_linear=True, steer_limit=False, known_scale=0.12, too_slow=0.0,
        scan=LagScan(none, none, 0.0, "assumed"), commanded=False, K=150.0, K_prior=145.68,
        K_prior_std=0.5, information=none,
    )  # fmt: skip
    return Prospects(**{**values, **more})


def test_a_good_log_says_how_good_and_what_would_halve_it():
    assert outlook(plan()) == (
        "This log can show K to about ± 12 %, against ± 50 % before it.",
        "For ± 6 %, steer 2 times as much or drive 4 times as long.",
    )


@pytest.mark.parametrize(
    "more, said",
    [
        ({"verdict": "not_excited"}, "cannot show K"),
        ({"verdict": "weak"}, "no better than"),
        ({"steer_times": None, "long_times": None}, "Not even a drive 16 times as long"),
        ({"is_linear": False}, "steer less"),
        ({"steer_limit": True}, "Twice the steer"),
        ({"known_scale": 0.05}, "calibrated road-wheel angle would give ± 5 %"),
        ({"too_slow": 0.3}, "In 30 % of the rows"),
    ],
)
def test_what_stands_in_the_way_is_said(more, said):
    assert said in " ".join(outlook(plan(**more)))
    assert said not in " ".join(outlook(plan()))


def test_percent_has_two_digits_and_no_powers():
    assert [percent(x) for x in (0.0123, 0.123, 0.999, 2.5)] == ["± 1.2 %", "± 12 %", "± 100 %", "± 250 %"]


@pytest.fixture(scope="module")
def seen(tmp_path_factory):
    log = drive(seconds=40, rate=50, band=(0.05, 1.5))
    table = np.column_stack([log.t, log.delta, log.r, log.U])
    return inspect_log(write(tmp_path_factory.mktemp("log"), csv_text(table)))


def test_relations_are_named_valued_and_explained(seen):
    rows = {name: value for name, value, _ in relations(seen)}

    assert rows["yaw rate, steer"] == "same side"
    assert rows["lag in all"].endswith("ms") and "±" in rows["steer offset"]
    assert all(len(row) == 3 and all(row) for row in relations(seen))


def test_a_log_of_which_nothing_is_known_has_no_relations(seen):
    bare = dataclasses.replace(seen, behind_steer=None, behind_yaw=None, slow=None, prospects=None)

    assert relations(bare) == ()
