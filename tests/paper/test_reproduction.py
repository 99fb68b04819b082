"""All at once."""

import json
from dataclasses import replace

import pytest

from similitude.errors import CompileError
from similitude.filter_run import POPULATION
from similitude.paper import reproduction
from similitude.paper.claim import VERDICTS
from similitude.paper.reproduction import SUBJECTS, reproduce
from similitude.program.library import shipped

from .pinned import FILE
from .reproduced import small


def test_there_are_enough_claims_and_enough_that_do_not_simply_hold():
    pinned = json.loads(FILE.read_text(encoding="utf-8"))
    every = [record for records in pinned.values() for record in records]

    assert list(pinned) == list(SUBJECTS)
    assert len(every) >= 25 and sum(record["verdict"] != VERDICTS[0] for record in every) >= 8
    assert len({record["id"] for record in every}) == len(every)


def test_verdicts_are_counted():
    done = small()
    assert sum(done.count().values()) == len(done.claims) == len(done.records)


def test_without_a_compiler_it_says_so_at_once(monkeypatch):
    twin = replace(shipped(POPULATION), c=None, why_slow="no compiler")
    monkeypatch.setattr(reproduction, "shipped", lambda name: twin)

    with pytest.raises(CompileError, match="no compiler"):
        reproduce()


def test_parts_are_announced_and_equations_checked(monkeypatch):
    """The whole way with two cheap subjects and no drive."""
    monkeypatch.setattr(reproduction, "LONG", ())
    cheap = {name: SUBJECTS[name] for name in ("The controller", "Cost")}
    monkeypatch.setattr(reproduction, "SUBJECTS", cheap)
    announced = []
    done = reproduce(announced.append, drawn=False)

    assert announced == ["drives", "The controller", "Cost", "equations"]
    assert all(residual <= equation.tolerance for equation, residual in done.residuals)
