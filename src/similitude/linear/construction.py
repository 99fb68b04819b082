"""Linear models from matrices or from transfer functions, with units on everything.

    x' = A x + B u,  y = C x + D u

    y/u = (b0 s^m + ... + bm)/(a0 s^n + ... + an)     in observable form:
    x1' = x2 - a1 x1 + b1 u, ..., xn' = -an x1 + bn u,  y = x1 + b0 u     (a0 divided out, b filled up to n)

Invariant: the states of a transfer function are in the output's unit over time to the 0, 1, ..., n - 1.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import measure_of
from similitude.homogeneity.walk import measure_of_expression
from similitude.model import Model, Quantity
from similitude.model_formulas import Formula, read_formula
from similitude.units import parse_unit

READ = 'docs/model.md, "Linear models"'
Matrix = Sequence[Sequence[Formula]] | sp.MatrixBase


def state_space_model(
    name: str,
    *,
    states: Sequence[Quantity],
    inputs: Sequence[Quantity],
    outputs: Sequence[Quantity],
    parameters: Sequence[Quantity],
    A: Matrix,
    B: Matrix,
    C: Matrix,
    D: Matrix | None = None,
    **more,
) -> Model:
    """A linear model from its matrices.

    Parameters
    ----------
    name : short name, a C identifier.
    states, inputs, outputs, parameters : n, m, p and any number of quantities with units.
    A, B, C, D : (n, n), (n, m), (p, n), (p, m) lists of rows, or SymPy matrices; entries are text,
        expressions or numbers in the parameters. D is zero where it is left out.
    **more : as `Model` takes them: constraints, signals, validity, source, time_unit.

    Raises
    ------
    ModelError    a matrix has another shape than its quantities, an entry cannot be read, or its unit
                  does not fit; the entry's row is named.
    """
    names = [q.name for q in parameters]
    n, m, p = len(states), len(inputs), len(outputs)
    read = {
        letter: _matrix(name, letter, given, shape, names)
        for letter, given, shape in (
            ("A", A, (n, n)),
            ("B", B, (n, m)),
            ("C", C, (p, n)),
            ("D", [[0] * m] * p if D is None else D, (p, m)),
        )
    }
    x, u = sp.Matrix([q.symbol for q in states]), sp.Matrix([q.symbol for q in inputs])
    f = read["A"] * x + (read["B"] * u if m else sp.zeros(n, 1))
    g = read["C"] * x + (read["D"] * u if m else sp.zeros(p, 1))
    return Model(
        name,
        states,
        inputs,
        outputs,
        parameters,
        rates={q.name: f[i] for i, q in enumerate(states)},
        output_map={q.name: g[i] for i, q in enumerate(outputs)},
        **more,
    )


def _matrix(name: str, letter: str, given: Matrix, shape: tuple[int, int], names: list[str]) -> sp.Matrix:
    rows = given.tolist() if hasattr(given, "tolist") else [list(row) for row in given]
    found = (len(rows), len(rows[0]) if rows else shape[1])
    if found != shape or any(len(row) != shape[1] for row in rows):
        raise ModelError(
            f"model {name!r}: {letter} is {found[0]} by {found[1]}, and its quantities want"
            f" {shape[0]} by {shape[1]}",
            usually="A row is missing, or a column vector was given as one row: [['b1'], ['b2']].",
            paste=f"{letter}=[{', '.join(['[' + ', '.join(['0'] * shape[1]) + ']'] * shape[0])}]",
            read=READ,
        )
    return sp.Matrix(
        *shape,
        lambda i, j: read_formula(rows[i][j], names, what=f"entry {i + 1},{j + 1} of {letter}"),
    )


def transfer_function_model(
    name: str,
    *,
    input: Quantity,
    output: Quantity,
    parameters: Sequence[Quantity],
    numerator: Sequence[Formula],
    denominator: Sequence[Formula],
    **more,
) -> Model:
    """A linear model from its transfer function, as a model in observable form.

    Parameters
    ----------
    name : short name, a C identifier.
    input, output, parameters : quantities with units.
    numerator, denominator : coefficients, highest power of s first; text, expressions or numbers.
    **more : as `Model` takes them.

    Returns
    -------
    Model    n states ``x1 .. xn``, x1 the output where the numerator is of lower degree.

    Raises
    ------
    ModelError    the degree of the numerator is greater, the denominator has no s, or coefficients differ
                  in units: they all have to be in one unit times a power of time.
    """
    names = [q.name for q in parameters]
    below = _coefficients("denominator", denominator, names)
    above = _coefficients("numerator", numerator, names)
    if len(below) < 2 or len(above) > len(below):
        raise ModelError(
            f"model {name!r}: numerator of degree {len(above) - 1} over denominator of degree"
            f" {len(below) - 1}",
            usually="The coefficients are in the wrong order (highest power first), or it is no system.",
            paste="numerator=['K'], denominator=['T', 1]   # K/(T s + 1)",
            read=READ,
        )
    n = len(below) - 1
    above = [sp.Integer(0)] * (n + 1 - len(above)) + above
    _check_units(name, parameters, above, below, input, output, more.get("time_unit", "s"))
    a, b = ([e / below[0] for e in row] for row in (below, above))
    taken = {q.name for q in (*parameters, input, output)}
    prefix = "x" if not {f"x{k + 1}" for k in range(n)} & taken else "state"
    states = [
        Quantity(f"{prefix}{k + 1}", _over_time(output.unit, k, more.get("time_unit", "s"))) for k in range(n)
    ]
    x, u = [q.symbol for q in states], input.symbol
    y = x[0] + b[0] * u
    rates = {
        q.name: (x[k + 1] if k + 1 < n else 0) - a[k + 1] * x[0] + (b[k + 1] - a[k + 1] * b[0]) * u
        for k, q in enumerate(states)
    }
    return Model(name, states, (input,), (output,), parameters, rates, {output.name: y}, **more)


def _coefficients(what: str, given: Sequence[Formula], names: list[str]) -> list[sp.Expr]:
    """Expressions, without leading zeros."""
    if isinstance(given, str):
        given = [given]
    read = [read_formula(e, names, what=f"coefficient {k + 1} of the {what}") for k, e in enumerate(given)]
    while read and read[0] == 0:
        read.pop(0)
    return read


def _over_time(unit: str, power: int, time: str) -> str:
    if power == 0 or time == "1":
        return unit
    plain = str(
        measure_of(parse_unit(unit), angle=True) / measure_of(parse_unit(f"{time}^{power}"), angle=True)
    )
    return "1" if plain == "-" else plain


def _check_units(name, parameters, above, below, given: Quantity, wanted: Quantity, time: str) -> None:
    """Each coefficient times its power of s, in one unit; the gain's in that of output over input."""
    symbols = {q.symbol: (q.measure(), q.unit) for q in parameters}
    second = measure_of(parse_unit(time), angle=False)
    n = len(below) - 1
    kinds = (("denominator", below), ("numerator", above))
    found = [
        (what, k, e, measure_of_expression(e, symbols))
        for what, row in kinds
        for k, e in enumerate(row)
        if e != 0
    ]
    gain = wanted.measure() / given.measure()
    first = found[0][3]
    for what, k, e, measure in found:
        right = None if first is None else first * second**-k * (gain if what == "numerator" else gain**0)
        if measure is None or measure != right:
            said = "terms of different units" if measure is None else f"in {measure}, and {right} is wanted"
            raise ModelError(
                f"model {name!r}: the coefficient of s^{n - k} in the {what}, {sp.sstr(e)}, is {said}",
                usually="Coefficients are listed from the highest power of s down, and a number has no unit:"
                " 1 fits only where the others fit it.",
                paste="numerator=['K'], denominator=['T', 1]   # T in s, K in the output's unit per input",
                read=READ,
            )
