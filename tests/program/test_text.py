"""One text for both languages: the same bits in C and Python, the exact value in rationals."""

import ctypes
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from similitude.errors import ProgramError
from similitude.program.compile import load_library
from similitude.program.text import PYTHON, C, Language, count_operations, expression_text

NAMES = ("a", "b", "c", "d")
SYMBOLS = sp.symbols(NAMES, real=True)
EXACT = Language("F('{}')", PYTHON.select, " and ", " or ", "not ({})")
x, y, z, _ = SYMBOLS

leaves = st.one_of(
    st.sampled_from(SYMBOLS),
    st.integers(-9, 9).map(sp.Integer),
    st.sampled_from([sp.Rational(1, 2), sp.Rational(-3, 4), sp.Float(0.625), sp.Rational(5, 8)]),
)


def grow(inner):
    pair = st.tuples(inner, inner)
    triple = st.tuples(inner, inner, inner, inner)
    return st.one_of(
        st.lists(inner, min_size=2, max_size=4).map(lambda t: sp.Add(*t)),
        st.lists(inner, min_size=2, max_size=4).map(lambda t: sp.Mul(*t)),
        pair.map(lambda t: sp.Add(*t, evaluate=False)),
        pair.map(lambda t: t[0] / (1 + t[1] ** 2)),
        st.tuples(inner, st.integers(2, 4)).map(lambda t: t[0] ** t[1]),
        st.tuples(inner, st.integers(1, 3)).map(lambda t: (2 + t[0] ** 2) ** -t[1]),
        inner.map(lambda e: -e),
        pair.map(lambda t: sp.Max(*t)),
        pair.map(lambda t: sp.Min(*t)),
        triple.map(lambda t: sp.Piecewise((t[0], t[1] < t[2]), (t[3], True))),
        triple.map(lambda t: sp.Piecewise((t[0], (t[1] > 0) | (t[2] >= t[3])), (t[1], True))),
        triple.map(lambda t: sp.Piecewise((t[0], sp.Not((t[1] > 1) & (t[2] > 0))), (t[3], True))),
    )


expressions = st.recursive(leaves, grow, max_leaves=12)
numbers = st.floats(-1e3, 1e3).map(lambda v: v if abs(v) > 1e-3 else 0.5)
points = st.lists(st.tuples(*[numbers] * 4), min_size=3, max_size=3)


def python_value(expression, point, language=PYTHON):
    scope = {"F": Fraction, **dict(zip(NAMES, point, strict=True))}
    return eval(expression_text(expression, language), {}, scope)


def c_source(trees) -> str:
    arguments = ", ".join(f"double {n}" for n in NAMES)
    silent = " ".join(f"(void){n};" for n in NAMES)
    lines = ["#define R(x) ((double)(x))", "#define API __attribute__((visibility(\"default\")))"]
    for i, tree in enumerate(trees):
        text = expression_text(tree, C)
        lines.append(f"API double e{i}({arguments}) {{ {silent} return {text}; }}")
    return "\n".join(lines)


@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.lists(expressions, min_size=12, max_size=12), points)
def test_c_and_python_give_the_same_bits(trees, places):
    library = load_library(c_source(trees), name="expressions")
    for i, tree in enumerate(trees):
        function = getattr(library, f"e{i}")
        function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * 4
        for point in places:
            ours, theirs = np.float64(python_value(tree, point)), np.float64(function(*point))
            assert ours.tobytes() == theirs.tobytes(), (tree, point, ours, theirs)


@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
@given(expressions, st.tuples(*[st.fractions(-9, 9, max_denominator=8)] * 4))
def test_the_text_means_what_the_expression_means(tree, point):
    """In rational arithmetic nothing is rounded, so the two must be equal."""
    values = {s: sp.Rational(v.numerator, v.denominator) for s, v in zip(SYMBOLS, point, strict=True)}
    expected = sp.nsimplify(sp.sympify(tree).subs(values), rational=True)
    assume(expected.is_Rational)

    found = python_value(tree, point, EXACT)

    assert Fraction(found) == Fraction(int(expected.p), int(expected.q))


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x - y, "a - b"),
        (-x - y, "(-a) - b"),
        (x * (y - z), "a*(b - c)"),
        (x / (y * z), "a/(b*c)"),
        (x**3, "(a*a*a)"),
        (1 / x**2, "(1.0/(a*a))"),
        (sp.Rational(1, 3) * x, "0.3333333333333333*a"),
        (sp.Max(x, y), "(a if (a) > (b) else b)"),
        (x < y, "a < b"),
        (sp.Not((x < y) & (y < z)), "not ((a < b) and (b < c))"),
    ],
)
def test_the_text_reads_like_the_formula(expression, text):
    assert expression_text(expression, PYTHON) == text


def test_a_condition_of_nan_stays_false_when_it_is_negated():
    """`not (a < b)` may not become `a >= b`: with a NaN both are false."""
    guard = expression_text(sp.Not((x < y) & (x > z)), PYTHON)

    assert eval(guard, {}, {"a": float("nan"), "b": 1.0, "c": 0.0})


@pytest.mark.parametrize(
    "expression",
    [sp.sin(x), sp.sqrt(x), sp.exp(x), x**y, sp.Abs(x), sp.oo, sp.nan, sp.zoo, sp.I, x**-0.5],
)
def test_what_needs_a_mathematics_library_is_refused(expression):
    with pytest.raises(ProgramError):
        expression_text(expression, C)


def test_a_select_needs_an_otherwise():
    with pytest.raises(ProgramError, match="otherwise"):
        expression_text(sp.Piecewise((x, y > 0)), C)


@pytest.mark.parametrize(
    ("expression", "count"),
    [
        (x, 0),
        (-x, 0),  # a change of sign costs nothing on any target worth counting for
        (x + y * z, 2),
        (sp.Float(1e-7) * x, 1),  # no operation in the exponent of a literal
        (x**3 / y, 3),
        (sp.Max(x, y), 2),  # a comparison and a select
        (x - y / (z + 1), 3),
    ],
)
def test_operations_are_counted_as_one_would_by_hand(expression, count):
    assert count_operations(expression_text(expression, C)) == count
