"""Rates as text, expressions, numbers and functions end in the same symbols, or are refused by name."""

import math

import numpy as np
import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.model_formulas import Symbols, read_formula, read_formulas

x, u, k = sp.symbols("x u k", real=True)
NAMES = {"owners": ["x"], "states": ["x"], "inputs": ["u"], "parameters": ["k"]}


def read(given):
    return read_formulas(given, what="rate", **NAMES)


@pytest.mark.parametrize(
    "given",
    [
        {"x": "u - k*x"},
        {"x": u - k * x},
        {"x": sp.Symbol("u") - sp.Symbol("k", positive=True) * x},
        lambda s, i, p: {"x": i.u - p.k * s.x},
        lambda s, i, p: [i["u"] - p["k"] * s["x"]],
        lambda s, i, p: i[0] - p[0] * s[0],
        lambda s, i, p: "u - k*x",
    ],
)
def test_all_ways_of_writing_a_rate_give_one_expression(given):
    assert read(given) == {"x": u - k * x}


def test_people_s_names_are_not_sympys():
    names = ["N", "S", "E", "I", "beta", "gamma", "lambda"]
    expression = read_formula("beta*S*I/N - gamma*E", names, what="the rate of 'E'")

    assert {s.name for s in expression.free_symbols} == {"beta", "S", "I", "N", "gamma", "E"}


def test_symbols_unpack_in_their_order_and_show_their_names():
    symbols = Symbols("parameters", ["b", "a"])

    assert tuple(symbols) == tuple(sp.symbols("b a", real=True))
    assert symbols.keys() == ("b", "a") and len(symbols) == 2


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (lambda s, i, p: math.sqrt(s.x), "cannot be followed with symbols: TypeError"),
        (lambda s, i, p: np.sqrt(s.x), "cannot be followed with symbols"),
        (lambda s, i, p: i.u if s.x > 0 else 0, "cannot be followed with symbols: TypeError"),
        (lambda s: s.x, "cannot be followed with symbols: TypeError"),
        (lambda s, i, p: p.q, "asks the parameters for 'q'"),
        (lambda s, i, p: None, "returned a NoneType where 1 formulas"),
        (lambda s, i, p: [s.x, s.x], "returned 2 where 1 formulas"),
        ([u - k * x], "the rates are a list, not a mapping"),
        ({"x": [u]}, "the rate of 'x' is a list"),
        ({"x": None}, "the rate of 'x' is a NoneType"),
        ({"x": "u - q*x"}, "the rate of 'x'"),
    ],
)
def test_what_is_no_formula_is_refused_with_its_owner(given, said):
    with pytest.raises(ModelError, match=said):
        read(given)
