"""A formula means what its author declared, and nothing but formulas can be written."""

import time

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.errors import ModelError
from similitude.model import Quantity
from similitude.model_text import DEEPEST, FUNCTIONS, parse_expression

NAMES = ("S", "I", "N", "E", "beta", "gamma", "lambda", "x", "y")
SYMBOLS = {name: sp.Symbol(name, real=True) for name in NAMES}
S, I, N, E, beta, gamma, lam, x, y = SYMBOLS.values()  # noqa: E741


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("beta*S*I/N - gamma*I", beta * S * I / N - gamma * I),
        ("lambda*E**2", lam * E**2),
        ("-x**2", -(x**2)),
        ("x**-2", x**-2),
        ("2^3^2", sp.Integer(512)),
        ("x - y - 1", x - y - 1),
        ("x/y/2", x / (2 * y)),
        ("- - x + +y", x + y),
        ("0.1*x + .5e-3", x / 10 + sp.Rational(1, 2000)),
        ("exp(-E/(8.314*x))", sp.exp(-E * 500 / (4157 * x))),
        ("max(x, 0)*sqrt(y)", sp.Max(x, 0) * sp.sqrt(y)),
        ("atan2(y, x) + ln(x)", sp.atan2(y, x) + sp.log(x)),
        ("pi*x**2/4", sp.pi * x**2 / 4),
        ("x·y − 1", x * y - 1),
    ],
)
def test_text_means_what_a_reader_takes_it_for(text, meant):
    assert parse_expression(text, NAMES) == meant


def test_symbols_are_those_of_a_model():
    assert parse_expression("beta", NAMES) == Quantity("beta", "1/s").symbol


def test_a_declared_name_wins_over_constants_and_functions():
    assert parse_expression("pi*x", ("pi", "x")) == sp.Symbol("pi", real=True) * x
    assert parse_expression("exp + x", ("exp", "x")) == sp.Symbol("exp", real=True) + x


def test_the_micro_sign_is_the_greek_letter():
    assert parse_expression("µ*x", ("μ", "x")) == sp.Symbol("μ", real=True) * x


expressions = st.recursive(
    st.sampled_from([S, E, lam, x, sp.Rational(2, 3), sp.Integer(-4)]),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda p: p[0] + p[1]),
        st.tuples(inner, inner).map(lambda p: p[0] * p[1]),
        st.tuples(inner, st.integers(-3, 3)).map(lambda p: (p[0] + y) ** p[1]),
        inner.map(sp.tanh),
    ),
    max_leaves=8,
)


@settings(deadline=None, max_examples=50)
@given(expressions)
def test_what_sympy_prints_is_read_back(expression):
    if expression.has(sp.zoo, sp.nan):
        return
    read = parse_expression(sp.sstr(expression), NAMES)
    point = {symbol: sp.Rational(7 + i, 5 + 2 * i) for i, symbol in enumerate(SYMBOLS.values())}
    ours, theirs = (e.xreplace(point).evalf(30) for e in (read, expression))
    assert abs(ours - theirs) <= 1e-20 * abs(theirs)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("__import__('os').system('true')", "has ''' at character 12"),
        ("eval(x)", "no function here"),
        ("x.__class__", "has '.'"),
        ("x[0]", "has '['"),
        ("[x for x in y]", "has '['"),
        ("x if y else S", "cannot go on"),
        ("x := 1", "has ':'"),
        ("x = y", "has '='"),
        ("", "is empty"),
        ("x +", "ends where something must follow"),
        ("(x", "never closes the bracket of character 1"),
        ("x)", "cannot go on"),
        ("2 x", "cannot go on"),
        ("x(3)", "calls 'x', which is a declared quantity"),
        ("gama*x", "'gama', which is not declared"),
        ("sin", "'sin', which is not declared"),
        ("sin(x, y)", "gives sin 2 arguments"),
        ("1/0", "divides by zero"),
        ("1/(x - x)", "divides by zero"),
        ("sqrt(-1)", "no real number"),
        ("(-8)**(1/3)", "no real number"),
        ("9**9**9", "more than 3000 digits"),
        ("((9**900)**900)**900", "more than 3000 digits"),
        ("1e999999999", "more than 3000 digits"),
        ("exp(exp(exp(exp(1000))))", "beyond 1.8e308"),
        ("2*exp(800)*x", "beyond 1.8e308"),
        ("x^1000000", "power 1000000; 100 is the highest"),
        ("1/(x + y)^5000", "power -5000"),
        ("x^60*x^60", "power 120"),
        ("(" * 300 + "x" + ")" * 300, f"more than {DEEPEST} brackets"),
        ("-" * 300 + "x", f"more than {DEEPEST} brackets"),
    ],
)
def test_anything_else_is_refused_with_four_parts_and_at_once(text, says):
    start = time.perf_counter()
    with pytest.raises(ModelError) as caught:
        parse_expression(text, NAMES, what="the rate of 'S'")

    assert time.perf_counter() - start < 1  # [s]; 9**9**9 would take hours
    assert says in caught.value.what
    assert caught.value.what.startswith("the rate of 'S'")
    assert all((caught.value.usually, caught.value.paste, caught.value.read))


def test_a_misspelt_name_is_answered_with_the_nearest():
    with pytest.raises(ModelError) as caught:
        parse_expression("gama*x", NAMES)

    assert caught.value.paste.startswith("gamma ")


@pytest.mark.parametrize("given", [3, None, x])
def test_what_is_no_text_is_refused(given):
    with pytest.raises(ModelError, match="and no text"):
        parse_expression(given, NAMES)


@settings(deadline=None, max_examples=60)
@given(st.text(alphabet="xS+-*/^(), .0123456789elambdsinqrt\n", max_size=40))
def test_any_text_is_an_expression_or_a_model_error(text):
    try:
        result = parse_expression(text, NAMES)
    except ModelError:
        return
    assert isinstance(result, sp.Expr)
    assert result.free_symbols <= set(SYMBOLS.values())


def test_every_function_takes_its_arguments():
    for name in FUNCTIONS:
        for text in (f"{name}(x)", f"{name}(x, y)"):
            try:
                assert parse_expression(text, NAMES).free_symbols
            except ModelError as error:
                assert "arguments" in error.what
