"""The choice follows the numbers and can be overridden."""

import pytest

from similitude import make_estimator, shipped_system
from similitude.errors import UsageError

from .gallery import CASES, made


def test_one_unknown_of_a_linear_model_is_regressed():
    choice = made("rlc_circuit").choice

    assert choice.kind == "regression" and "straight" in choice.reason and 0 < choice.bend < 0.1


def test_two_unknowns_are_filtered_and_the_second_is_named():
    choice = made("dc_motor").choice

    assert choice.kind == "population" and "time_ratio" in choice.reason


def test_coarse_samples_bend_the_coefficients_until_the_filter_is_chosen():
    case = {**CASES["rlc_circuit"], "step": "200 us"}
    choice = make_estimator(shipped_system("rlc_circuit"), **case).choice

    assert choice.kind == "population" and "straight line" in choice.reason


def test_the_users_choice_stands_where_it_is_possible():
    mine = make_estimator(shipped_system("rlc_circuit"), **CASES["rlc_circuit"], kind="population")

    assert mine.choice.kind == "population" and mine.choice.reason == "yours"
    with pytest.raises(UsageError, match="no regression of 'aircraft_short_period'"):
        make_estimator(
            shipped_system("aircraft_short_period"), **CASES["aircraft_short_period"], kind="regression"
        )
    with pytest.raises(UsageError, match="there are population, regression"):
        make_estimator(shipped_system("rlc_circuit"), **CASES["rlc_circuit"], kind="band")
