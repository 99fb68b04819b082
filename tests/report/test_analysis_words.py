"""Sentences that count what was found."""

import math
from dataclasses import replace

from similitude.report.analysis_words import (
    account,
    counted,
    headline,
    moved,
    residual_words,
    rewrite_words,
    rows_are_empty,
    seen_words,
)

from .analysis_case import analysed, decay


def test_numbers_go_with_their_nouns():
    assert [counted(n, "state") for n in (0, 1, 2, 40)] == [
        "no states",
        "one state",
        "two states",
        "40 states",
    ]


def test_the_headline_counts_the_model():
    assert headline(analysed("bicycle")) == "two states, one input, one output, eight parameters"


def test_the_account_says_who_removes_what():
    rows = {what: (number, words) for what, number, words in account(analysed("bicycle"))}

    assert rows["units remove"][0] == "3"
    assert rows["structure removes"] == ("1", "states and inputs scale together: the model is linear")
    assert rows["output r cannot see"] == ("1", "of six unknown parameters")


def test_what_outputs_tell_in_one_sentence():
    found = analysed("bicycle")

    assert seen_words(found.seen) == "Output r with U known tells five numbers about six unknown parameters."
    assert seen_words(found.steady, ("U",)) == (
        "Output r while U is held tells four numbers about six unknown parameters, "
        "two of them not a product of powers."
    )
    assert seen_words(analysed("michaelis_menten").seen) == "Output p tells all four parameters."
    assert seen_words(replace(found.seen, parameters=("k",), unseen=())) == (
        "Output r with U known tells the one parameter."
    )
    assert seen_words(replace(found.seen, outputs=())).startswith("No output with U known")


def test_powers_are_said_where_they_are_not_one():
    assert moved({"v": 1, "q": -2}) == "v, q^-2"


def test_rows_are_empty_only_after_a_rewrite():
    assert rows_are_empty(analysed("bicycle"))
    assert not rows_are_empty(decay())
    assert residual_words(analysed("bicycle").invariances[0]) == "0, proven"
    assert residual_words(replace(analysed("bicycle").invariances[0], residual=2e-50)) == "2.0e-50"
    assert residual_words(replace(analysed("bicycle").invariances[0], residual=math.inf)) == "does not hold"


def test_a_rewritten_model_is_said_to_be_the_same_and_what_it_leaves_out():
    same, left = rewrite_words(analysed("bicycle"))

    assert same == (
        "It is the same model: compared in exact arithmetic at three random points, then in symbols."
    )
    assert left.startswith("U taken as constant; left out: ")
    assert rewrite_words(analysed("rlc_circuit"))[1:] == ()
    wrong = replace(analysed("bicycle").equivalence, wrong={"rate of v": 1})
    assert "not the same" in rewrite_words(replace(analysed("bicycle"), equivalence=wrong))[0]
