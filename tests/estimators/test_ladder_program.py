"""The frame of the ladder's programs: what is committed, what it calls, what it costs."""

import re

import numpy as np
import pytest

from similitude.estimators.band import band_regression
from similitude.estimators.output_error import output_error_method
from similitude.estimators.robust import robust_regression
from similitude.program.c import print_c
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction

from .ladder_case import LADDER, library, run

MAKERS = {"band": band_regression, "output_error": output_error_method, "robust": robust_regression}


@pytest.mark.parametrize("name", LADDER)
def test_the_c_is_that_of_a_fresh_derivation_and_calls_nothing(name):
    program = MAKERS[name](bicycle_reduction())
    text = print_c(program)
    with open(library(name).layout.__file__.removesuffix("py") + "c", encoding="utf-8") as file:
        assert file.read() == text
    called = set(re.findall(r"(\w+)\(", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)))

    functions = {f"bicycle_{name}_{f}" for f in ("init", "step", "batch", "advance")}
    assert called - functions <= {"R", "if", "for", "defined", "visibility", "__attribute__", "__declspec"}
    assert "Brennan & Alleyne 2004" in text
    assert "Operations: step" in text


def test_each_rung_costs_less_than_the_population_filter():
    """Counted along the longest way, which takes guards that exclude one another both."""
    population = shipped("bicycle_population").layout.OPERATIONS
    costs = {name: library(name).layout.OPERATIONS for name in LADDER}

    assert costs["band"] < costs["output_error"] < population / 2
    assert costs["robust"] < 0.7 * population


@pytest.mark.parametrize("name", LADDER)
def test_a_bad_sample_hands_out_what_stood_before(name):
    rows = np.array([[np.nan, 0.0, 20.0, 0.1]] * 3)
    outputs, status, state = run(name, rows)

    assert (status == 7).all() and (outputs["innovation"] == 0).all()
    assert (outputs["innovation_variance"] > 0).all() and np.isfinite(state).all()
