"""A run: the same numbers whatever the processes, failures kept as results, own entrants among ours."""

import pytest

from similitude.benchmark import running
from similitude.benchmark.cells import Cell
from similitude.benchmark.entrant import Answer, Entrant

from .linear_drive import linear_drive

SMALL = [Cell("slalom", "linear", "none", 1), Cell("highway", "linear", "bias", 1)]
TIMES = ("call_ns", "step_ns", "seconds", "processes")
BROKEN = '"""Fails."""\ndef estimate(drive):\n    raise ValueError("no idea")\n'


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    """Two cells of one drive each, made without the simulator, with an entrant that always fails."""
    path = tmp_path_factory.mktemp("entrant") / "broken.py"
    path.write_text(BROKEN)
    told = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(running, "cells", lambda **_: SMALL)
        patch.setattr(running, "drives", lambda cell, seed: [linear_drive(seed=seed)])
        found = running.run_benchmark(quick=True, seed=3, files=[path], processes=1, tell=told.append)
    assert len(told) == len(SMALL)
    return found


def without_times(rows):
    return [{k: v for k, v in row.items() if k not in TIMES} for row in rows]


@pytest.mark.slow
def test_the_number_of_processes_changes_nothing_but_the_times(monkeypatch):
    monkeypatch.setattr(running, "cells", lambda **_: SMALL)
    one, two = (running.run_benchmark(quick=True, seed=3, processes=n).record for n in (1, 2))

    assert without_times(one["rows"]) == without_times(two["rows"])


def test_cells_drives_and_seed_are_on_record(result):
    record = result.record

    assert (record["cells"], record["drives"], record["seed"]) == (2, 2, 3)
    assert {row["fault"] for row in record["rows"]} == {"none", "bias"}


def test_an_entrant_that_fails_is_a_divergence_with_its_reason(result):
    total = next(one for one in result.record["totals"] if one["estimator"] == "broken")

    assert total["diverged"] == total["drives"] == 2
    assert total["faults"] == ["ValueError: no idea"]


def test_the_bound_stands_in_linear_cells_without_a_fault_alone(result):
    assert [row["fault"] for row in result.rows(estimator=running.BOUND)] == ["none"]


def test_one_k_for_a_whole_log_is_asked_before_the_change():
    drive, truth = linear_drive()
    seen = []

    def estimate(given):
        seen.append(given.t[-1])
        return Answer(150.0, 0.1)

    running.answer_scored(Entrant("whole", "", estimate, whole_log=True), drive, truth)
    running.answer_scored(Entrant("rows", "", estimate), drive, truth)

    assert seen[0] < 50.0 < seen[1]
