"""Runs are computed once, here or in another process, and are the same."""

import multiprocessing

from similitude.paper import ahead
from similitude.paper.claims_figure_5 import CHANGES
from similitude.paper.claims_noise import full_size_errors


def test_a_kept_function_is_called_once():
    calls = []

    @ahead.kept
    def number():
        calls.append(1)
        return 7

    assert (number(), number(), len(calls)) == (7, 7, 1)


def test_another_process_finds_the_same():
    here = full_size_errors()
    name = f"{full_size_errors.__module__}.{full_size_errors.__name__}"
    del ahead._KEPT[name]
    ahead.compute_ahead([full_size_errors], workers=1)

    assert ahead._KEPT[name] == here and len(CHANGES) == 5


def test_without_processes_it_is_computed_here(monkeypatch):
    def refused(*_):
        raise OSError("no processes")

    monkeypatch.setattr(multiprocessing, "get_context", refused)

    @ahead.kept
    def another():
        return 1

    try:
        ahead.compute_ahead([another])
    except OSError:
        raise AssertionError("an environment without processes must not stop it") from None
    assert another() == 1
