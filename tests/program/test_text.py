"""One text for both languages: the same bits in C and Python, the exact value in rationals."""

import ctypes
import math
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.errors import ProgramError
from similitude.program.compile import load_library
from similitude.program.text import PYTHON, C, Language, count_operations, expression_text

NAMES = ("a", "b", "c", "d")
SYMBOLS = sp.symbols(NAMES, real=True)
EXACT = Language("F('{}')", PYTHON.select, " and ", " or ", "not ({})")
x, y, z, _ = SYMBOLS

LEAVES = (
    *SYMBOLS,
    *(sp.Integer(n) for n in range(-4, 5)),
    sp.Rational(1, 2),
    sp.Rational(-3, 4),
    sp.Rational(5, 8),
)
GROW = (
    lambda p, q, r, s: p + q,
    lambda p, q, r, s: p - q + r - s,
    lambda p, q, r, s: p * q,
    lambda p, q, r, s: -p * q * r,
    lambda p, q, r, s: sp.Add(p, sp.Add(q, r), evaluate=False),
    lambda p, q, r, s: p / (1 + q**2),
    lambda p, q, r, s: p * q / ((2 + q**2) * (3 + r**2)),
    lambda p, q, r, s: (p + q) ** 3,
    lambda p, q, r, s: (2 + p**2) ** -2,
    lambda p, q, r, s: -(p - q),
    # SymPy's own comparison of nested selects may never end: conditions are kept simple
    lambda p, q, r, s: sp.Max(p, q, evaluate=False),
    lambda p, q, r, s: sp.Min(p, q, r, evaluate=False),
    lambda p, q, r, s: sp.Max(x, y - 1) * p,
    lambda p, q, r, s: sp.Piecewise((p, x < y), (q, True)),
    lambda p, q, r, s: sp.Piecewise((p, (y > 0) | (x >= z)), (q, True)),
    lambda p, q, r, s: sp.Piecewise((p, sp.Not((x > 1) & (z > 0))), (s, y > z), (r, True)),
)


def tree(random: np.random.Generator, depth: int) -> sp.Expr:
    """A random expression; SymPy may have simplified it, as it does the ones of a model."""
    if depth == 0 or random.random() < 0.2:
        return LEAVES[random.integers(len(LEAVES))]
    grow = GROW[random.integers(len(GROW))]
    return grow(*(tree(random, depth - 1) for _ in range(4)))


def forest(seed: int, size: int, depth: int) -> list[sp.Expr]:
    random = np.random.default_rng(seed)
    return [tree(random, depth) for _ in range(size)]


seeds = st.integers(0, 2**32 - 1)
numbers = st.floats(-1e3, 1e3)
points = st.lists(st.tuples(*[numbers] * 4), min_size=3, max_size=3)


def python_value(expression, point, language=PYTHON):
    scope = {"F": Fraction, **dict(zip(NAMES, point, strict=True))}
    return eval(expression_text(expression, language), {}, scope)


def exact(node, values):
    """Value of an expression, or truth of a condition, in rational arithmetic."""
    if isinstance(node, sp.Piecewise):
        return next(exact(value, values) for value, holds in node.args if exact(holds, values))
    if node.is_Symbol:
        return values[node.name]
    if node.is_Number:
        return Fraction(int(node.p), int(node.q))
    if node in (sp.true, sp.false):
        return bool(node)
    parts = [exact(part, values) for part in node.args]
    if node.is_Relational:
        return bool(node.func(*(sp.Rational(p.numerator, p.denominator) for p in parts)))
    return OPERATIONS[node.func](parts)


OPERATIONS = {
    sp.Add: sum,
    sp.Mul: math.prod,
    sp.Pow: lambda parts: parts[0] ** int(parts[1]),
    sp.Max: max,
    sp.Min: min,
    sp.And: all,
    sp.Or: any,
    sp.Not: lambda parts: not parts[0],
}


def c_source(trees) -> str:
    arguments = ", ".join(f"double {n}" for n in NAMES)
    silent = " ".join(f"(void){n};" for n in NAMES)
    lines = ["#define R(x) ((double)(x))", '#define API __attribute__((visibility("default")))']
    for i, expression in enumerate(trees):
        text = expression_text(expression, C)
        lines.append(f"API double e{i}({arguments}) {{ {silent} return {text}; }}")
    return "\n".join(lines)


@settings(max_examples=6, deadline=None)
@given(seeds, points)
def test_c_and_python_give_the_same_bits(seed, places):
    trees = forest(seed, 20, 2)
    library = load_library(c_source(trees), name="expressions")
    for i, expression in enumerate(trees):
        function = getattr(library, f"e{i}")
        function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * 4
        for point in places:
            ours, theirs = np.float64(python_value(expression, point)), np.float64(function(*point))
            assert ours.tobytes() == theirs.tobytes(), (expression, point, ours, theirs)


@settings(max_examples=60, deadline=None)
@given(seeds, st.tuples(*[st.fractions(-9, 9, max_denominator=8)] * 4))
def test_the_text_means_what_the_expression_means(seed, point):
    """The text evaluated in rational arithmetic against the tree evaluated node by node."""
    values = dict(zip(NAMES, point, strict=True))
    for expression in forest(seed, 3, 2):
        expected = exact(sp.sympify(expression), values)

        found = Fraction(python_value(expression, point, EXACT))

        # nothing is rounded but literals such as 1/17: 2^-53 each, times values up to 1e6
        assert abs(found - expected) <= 1e-9 * (1 + abs(found)), expression


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
        (sp.Abs(x - y) < z, "abs(a - b) < c"),
        (sp.Abs(x) > 1, "abs(a) > 1.0"),
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
        (sp.Abs(x) < y, 1),  # the comparison; a sign bit costs nothing
        (x - y / (z + 1), 3),
    ],
)
def test_operations_are_counted_as_one_would_by_hand(expression, count):
    assert count_operations(expression_text(expression, C)) == count
