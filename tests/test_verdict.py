"""Each verdict, its boundary, and a sentence that holds the numbers it was decided on."""

import dataclasses
import re
from types import SimpleNamespace

import numpy as np
import pytest

from similitude.status import STATUS
from similitude.verdict import VERDICTS, Evidence, evidence, linear_doubts, verdict

from .filter_rig import CAR as PRIOR
from .simulated_drive import log_of

ROWS = 100
GOOD = Evidence(
    ln_K_std=0.10,
    prior_std=0.5,
    ln_K_away=0.2,
    information=np.linspace(0, 100, ROWS),
    outside=np.zeros(ROWS, bool),
    status=np.zeros(ROWS, np.int32),
    rejected=0.0,
    noise_scale=1.0,
)


def judged(**changes):
    return verdict(dataclasses.replace(GOOD, **changes))


def code(**changes):
    return judged(**changes)[0]


def beyond(share):
    """Rows outside the linear range that hold this share of equal rows' information."""
    return np.arange(ROWS) >= ROWS - round(share * ROWS)


def learnt_evenly():
    return np.arange(1.0, ROWS + 1)


CASES = {
    "identified": ({}, ["10"]),
    "weak": ({"ln_K_std": 0.2}, ["20", "15"]),
    "not_excited": ({"ln_K_std": 0.39}, ["39", "50"]),
    "outside_model": ({"outside": beyond(0.8), "information": learnt_evenly()}, ["80", "0.3"]),
    "outside_population": ({"ln_K_away": np.log(4.2)}, ["4.2"]),
    "bad_data": ({"rejected": 0.31}, ["31", "20"]),
    "diverged": ({"finite": False}, []),
}


@pytest.mark.parametrize(("share", "said"), [(0.05, False), (0.2, True), (0.45, True), (0.8, False)])
def test_much_learnt_beyond_the_linear_range_is_said_and_most_is_a_verdict(share, said):
    some = dataclasses.replace(GOOD, outside=beyond(share), information=learnt_evenly())
    assert bool(linear_doubts(some)) == said
    assert not said or f"{100 * share:.2g} %" in linear_doubts(some)[0]


def test_every_verdict_has_a_case():
    assert set(CASES) == set(VERDICTS)


@pytest.mark.parametrize("name", CASES)
def test_a_case_of_each_with_its_numbers_in_one_sentence(name):
    changes, numbers = CASES[name]
    found, reason = judged(**changes)
    assert found == name
    for number in numbers:
        assert re.search(rf"(?<![\d.]){re.escape(number)}(?![\d.]*\d)", reason), (number, reason)
    assert not reason[0].islower() and reason.endswith(".") and "\n" not in reason


def test_sd_at_the_boundary_of_identified_and_weak():
    assert code(ln_K_std=0.15) == "identified"
    assert code(ln_K_std=np.nextafter(0.15, 1)) == "weak"


def test_half_the_prior_is_enough_and_a_hair_more_is_not():
    assert code(ln_K_std=0.25) == "weak"
    assert code(ln_K_std=np.nextafter(0.25, 1)) == "not_excited"
    assert code(ln_K_std=0.12, prior_std=0.24) == "identified"
    assert code(ln_K_std=0.12, prior_std=np.nextafter(0.24, 0)) == "not_excited"


def test_a_fifth_of_bad_rows_is_allowed():
    assert code(rejected=0.20) == "identified"
    assert code(rejected=np.nextafter(0.20, 1)) == "bad_data"


def test_half_of_the_information_may_come_from_outside():
    even = learnt_evenly()
    assert code(outside=beyond(0.50), information=even) == "identified"
    assert code(outside=beyond(0.51), information=even) == "outside_model"
    # what counts is information, not time
    late = np.where(np.arange(ROWS) < 90, 0.0, learnt_evenly())
    assert code(outside=beyond(0.10), information=late) == "outside_model"
    early = np.full(ROWS, 5.0)
    assert code(outside=beyond(0.99), information=early) == "identified"
    assert code(outside=beyond(1.0), information=np.zeros(ROWS)) == "identified"


def test_innovations_five_times_the_sensor_contradict_the_model():
    assert code(noise_scale=25.0) == "identified"
    found, reason = judged(noise_scale=49.0)
    assert found == "outside_model"
    assert "7 times" in reason


def test_the_edges_of_the_population():
    assert code(ln_K_away=1.25 - 1e-12) == "identified"
    assert code(ln_K_away=1.25) == "outside_population"
    low = -1.25 - np.log(4)
    assert code(ln_K_away=low + 1e-12) == "identified"
    assert code(ln_K_away=low) == "outside_population"


def test_a_group_at_its_limit_is_named():
    found, reason = judged(at_limit=("eta", "rho"))
    assert found == "outside_population"
    assert "(eta) and the yaw inertia (rho)" in reason


def test_an_estimate_outside_the_population_was_driven_there_however_wide_it_is():
    assert code(ln_K_std=0.4, ln_K_away=0.1) == "not_excited"
    assert code(ln_K_std=0.4, ln_K_away=1.4) == "outside_population"
    assert code(ln_K_std=0.4, at_limit=("eta",)) == "outside_population"


def test_a_slow_drive_is_told_from_a_straight_one():
    slow = np.where(np.arange(ROWS) < 80, STATUS["too_slow"], 0).astype(np.int32)
    _, crawled = judged(ln_K_std=0.48, status=slow)
    _, straight = judged(ln_K_std=0.48)
    assert "too slow" in crawled and "80 %" in crawled
    assert "steering" in straight


def test_the_graver_fault_is_the_one_that_is_named():
    everything = {
        "rejected": 0.9, "finite": False, "ln_K_std": 0.4, "ln_K_away": 3.0,
        "noise_scale": 99.0, "outside": beyond(1.0), "information": learnt_evenly(),
    }  # fmt: skip
    faults_and_cures = (
        ("bad_data", {"rejected": 0.0}),
        ("diverged", {"finite": True}),
        ("outside_model", {"outside": beyond(0)}),
        ("outside_model", {"noise_scale": 1.0}),
        ("outside_population", {"ln_K_away": 0.0}),
        ("not_excited", {"ln_K_std": 0.1}),
    )
    for fault, cure in faults_and_cures:
        assert code(**everything) == fault
        everything |= cure
    assert code(**everything) == "identified"


def test_a_number_that_decided_is_not_rounded_across_its_bound():
    assert "20.3 %" in judged(rejected=0.203)[1]
    assert "15.2 %" in judged(ln_K_std=0.152)[1]


def _trace(rows, **columns):
    fields = ("t", "K", "ln_K_std", "information", "ay_kinematic", "status")
    made = {name: np.ones(rows) for name in fields} | {"status": np.zeros(rows, np.int32)} | columns
    return SimpleNamespace(**made)


def test_evidence_is_read_off_the_last_row_and_counts_each_bad_row_once():
    rows = np.full((4, 10), 0.1)
    rows[0] = np.arange(10)
    rows[1, 2] = rows[2, 2] = rows[2, 5] = rows[3, 6] = np.nan
    status = np.zeros(10, np.int32)
    status[[5, 8]] = STATUS["bad_sample"]
    K = np.linspace(100, 2 * PRIOR.mean[0], 10)
    sideways = np.where(np.arange(10) < 3, -2.95, 2.93)
    trace = _trace(10, K=K, ln_K_std=np.linspace(0.5, 0.2, 10), ay_kinematic=sideways, status=status)

    found = evidence(log_of(*rows), trace, PRIOR, noise_scale=3.0, at_limit=("eta",))

    assert found.rejected == pytest.approx(0.4)  # rows 2, 5, 6 and 8
    assert found.ln_K_std == pytest.approx(0.2)
    assert found.ln_K_away == pytest.approx(np.log(2))
    assert found.prior_std == pytest.approx(0.5)
    assert found.outside.tolist() == [True] * 3 + [False] * 7  # 0.3 g is 2.942 m/s^2
    assert (found.noise_scale, found.at_limit, found.finite) == (3.0, ("eta",), True)


@pytest.mark.parametrize("column", ["K", "ln_K_std"])
def test_a_single_row_that_is_not_finite_is_a_divergence(column):
    values = np.ones(10)
    values[4] = np.inf
    log = log_of(*np.ones((4, 10)))
    assert not evidence(log, _trace(10, **{column: values}), PRIOR).finite
