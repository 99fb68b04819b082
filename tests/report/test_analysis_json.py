"""The record of an analysis keeps its keys, and its formulas are read back to what they were."""

import json
import math
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from similitude.model_text import parse_expression
from similitude.report.analysis_json import analysis_line, analysis_record

from .analysis_case import analysed, decay


def test_the_record_has_the_keys_others_rely_on():
    record = json.loads(analysis_line(analysed("bicycle")))

    assert record["system"] == "bicycle"
    assert {"name", "exponents"} <= set(record["groups"][0])
    assert {"dimension", "coefficients", "rhs", "residual"} <= set(record["invariances"][0])
    assert {"count", "invariants"} <= set(record["symmetries"])
    assert {"dimension_matrix", "rewritten", "identifiable"} <= set(record)
    assert record["symmetries"]["count"] == 4


def test_exponents_are_exact_and_cancel():
    record = json.loads(analysis_line(analysed("rlc_circuit")))
    matrix = record["dimension_matrix"]

    assert record["groups"][0]["exponents"] == {"R": 1, "L": "-1/2", "C": "1/2"}
    for row in matrix["exponents"]:
        of = dict(zip(matrix["variables"], row, strict=True))
        for group in record["groups"]:
            assert sum(Fraction(of[n]) * Fraction(p) for n, p in group["exponents"].items()) == 0


def test_rewritten_rates_are_read_back():
    found = analysed("bicycle")
    rewritten = analysis_record(found)["rewritten"]
    names = [*(g.name for g in found.groups), "v", "r", "delta"]

    for name, text in rewritten["rates"].items():
        assert sp.expand(parse_expression(text, names) - found.rewritten.groups.rates[name]) == 0


def test_a_row_that_does_not_hold_has_no_number():
    found = analysed("bicycle")
    broken = replace(found, invariances=(replace(found.invariances[0], residual=math.inf),))

    assert json.loads(analysis_line(broken))["invariances"][0]["residual"] is None


def test_what_cannot_be_rewritten_says_why():
    record = analysis_record(decay())

    assert "x [m]" in record["rewritten"]["why_not"]
    assert record["identifiable"]["unseen_sums"] == [{"a": 1, "b": -1}]
