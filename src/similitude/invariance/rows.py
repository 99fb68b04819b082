"""Row: what one base dimension says about the logarithmic sensitivities of an output.

    sum over arguments of  D_kj S_j  =  d_k         S_j = (x_j/y) dy/dx_j

D holds each argument's exponent of dimension k, d the output's (Brennan & Alleyne 2004, eq 14, which
follows from Euler's theorem for homogeneous functions, eq 9).

Invariant: exponents are exact, and arguments without the dimension are left out.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import SYMBOLS, Measure

READ = 'docs/invariances.md, "Sensitivities from other sensitivities"'


@dataclass(frozen=True)
class Row:
    """One invariance.

    Parameters
    ----------
    dimension : "mass", "length", "time", "current", ..., "angle".
    coefficients : argument -> its exponent of that dimension [-], zeros left out.
    rhs : the output's exponent [-].
    """

    dimension: str
    coefficients: Mapping[str, Fraction]
    rhs: Fraction

    @property
    def is_empty(self) -> bool:
        """True where nothing has the dimension, so that nothing is coupled."""
        return not self.coefficients and not self.rhs

    def left_side(self, sensitivities: Mapping, *, leave_out: Collection[str] = ()):
        """The weighted sum of sensitivities, in whatever they are in (numbers, arrays, expressions).

        Parameters
        ----------
        sensitivities : argument -> S [-].
        leave_out : arguments to take no notice of, as somebody who forgot them would.
        """
        parts = [
            _times(c, sensitivities[name]) for name, c in self.coefficients.items() if name not in leave_out
        ]
        return sum(parts[1:], parts[0]) if parts else 0

    def __str__(self) -> str:
        text = ""
        for name, c in self.coefficients.items():
            size = "" if abs(c) == 1 else f"{abs(c)} " if c.denominator == 1 else f"({abs(c)}) "
            text += f" {'-' if c < 0 else '+'} {size}S_{name}"
        text = text.removeprefix(" + ").replace(" - ", "-", 1) if text.startswith(" - ") else text[3:]
        return f"{self.dimension}: {text or '0'} = {self.rhs}"


def rows_of(
    arguments: Mapping[str, Measure], output: Measure, dimensions: Sequence[str] = ()
) -> tuple[Row, ...]:
    """The rows of a function of named arguments, in the order of the base dimensions.

    Parameters
    ----------
    arguments : name -> measure, the function's arguments.
    output : measure of its value.
    dimensions : dimensions that get a row even where it is empty.
    """
    present = {name for m in (*arguments.values(), output) for name in m.exponents} | set(dimensions)
    return tuple(
        Row(
            dimension,
            {n: m.exponents[dimension] for n, m in arguments.items() if dimension in m.exponents},
            output.exponents.get(dimension, Fraction(0)),
        )
        for dimension in SYMBOLS
        if dimension in present
    )


def solve_rows(rows: Sequence[Row], names: Sequence[str], sensitivities: Mapping) -> dict:
    """Sensitivities that the rows determine from the others.

    Parameters
    ----------
    rows : the invariances.
    names : arguments wanted, as many as the rows can tell apart or fewer.
    sensitivities : argument -> S [-] of all others in the rows: numbers, arrays or expressions.

    Returns
    -------
    dict    argument -> S [-], for each of ``names``.

    Raises
    ------
    ModelError    the rows cannot tell the names apart, or another sensitivity is missing.
    """
    matrix = sp.Matrix([[_rational(row.coefficients.get(n, Fraction(0))) for n in names] for row in rows])
    picked = matrix.T.rref()[1] if names and rows else ()
    if len(picked) < len(names):
        raise ModelError(
            f"{len(rows)} rows cannot give the {len(names)} sensitivities to {', '.join(names)}:"
            f" their columns have rank {len(picked)}",
            usually="Two of them have the same dimension, or there are more of them than dimensions.",
            paste="invariances.solve_for(('m', 'Iz', 'Caf'), known)   # one mass, one length, one time",
            read=READ,
        )
    chosen = [rows[i] for i in picked]
    others = {name for row in chosen for name in row.coefficients} - set(names)
    missing = sorted(others - set(sensitivities))
    if missing:
        raise ModelError(
            f"the sensitivity to {', '.join(missing)} is missing",
            usually="An argument was forgotten; t, s and Ts are arguments too.",
            paste=f"known = {{{missing[0]!r}: ..., **known}}",
            read=READ,
        )
    rest = [_minus(row.rhs, row.left_side(sensitivities, leave_out=names)) for row in chosen]
    inverse = sp.Matrix([matrix.row(i) for i in picked]).inv()
    return {
        name: sum(_times(Fraction(int(c.p), int(c.q)), r) for c, r in zip(inverse.row(k), rest, strict=True))
        for k, name in enumerate(names)
    }


def _times(coefficient: Fraction, value):
    """Exact for exact values, floating for floats and arrays."""
    if isinstance(value, sp.Basic):
        return _rational(coefficient) * value
    if isinstance(value, int | Fraction):
        return coefficient * value
    return float(coefficient) * value


def _minus(rhs: Fraction, value):
    return _rational(rhs) - value if isinstance(value, sp.Basic) else (
        rhs - value if isinstance(value, int | Fraction) else float(rhs) - value
    )  # fmt: skip


def _rational(value: Fraction) -> sp.Rational:
    return sp.Rational(value.numerator, value.denominator)
