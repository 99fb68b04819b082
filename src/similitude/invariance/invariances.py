"""Invariances: what the units of a model say about the logarithmic sensitivities of one of its outputs.

    D S = d         one row for each base dimension         S_j = (x_j/y) dy/dx_j

Brennan & Alleyne 2004, eqs 5-14, with every argument counted: time in a time response, the Laplace
variable in a frequency response, the sample time in a sampled one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import Measure
from similitude.homogeneity.walk import measure_of_expression, mismatches
from similitude.invariance.compiled import log_slope
from similitude.invariance.explicit_response import explicit_response
from similitude.invariance.given_values import read_values
from similitude.invariance.linear_response import (
    frequency_response,
    gain_response,
    pole_response,
    sampled_response,
    zero_response,
)
from similitude.invariance.model_equations import READ, equations
from similitude.invariance.response import Response
from similitude.invariance.rows import Row, rows_of, solve_rows
from similitude.invariance.steady_response import steady_response
from similitude.invariance.time_response import time_response
from similitude.model import Model, Quantity
from similitude.model_formulas import read_formula

RESPONSES = ("time", "frequency", "z", "poles", "zeros", "dc_gain", "steady_state")


@dataclass(frozen=True)
class Invariances:
    """The rows of one output.

    Parameters
    ----------
    response : the output as a function of its arguments.
    rows : one for each base dimension that occurs, in the order of the SI; none where nothing has any.
    model : the model it is of, None for a plain function.
    """

    response: Response
    rows: tuple[Row, ...]
    model: Model | None = None

    @property
    def arguments(self) -> tuple[str, ...]:
        """Everything the output depends on."""
        return tuple(self.response.arguments)

    def verify(self, values: Mapping[str, object] | None = None) -> dict[str, object]:
        """The residual ``D S - d`` of each row.

        Parameters
        ----------
        values : of every argument, in SI or as text with a unit; t, s, z may be arrays. Left out: the
            rows are proven in symbols, for all values at once.

        Returns
        -------
        dict    dimension -> residual [-]. In symbols ``0`` where it is proven; an expression that is left
                over where it is not zero. With values the greatest size over all points, for a y that
                passes through zero relative to its greatest size.

        Raises
        ------
        ModelError, UnitError    a value is missing, unknown or cannot be read.
        """
        if values is None:
            return {row.dimension: self._proof(row) for row in self.rows}
        y, slopes = self._evaluated(values)
        size = np.abs(y).max() if np.size(y) else 1.0
        residual = {}
        for row in self.rows:
            left = row.left_side({n: slopes[n] for n in row.coefficients}) - float(row.rhs) * y
            residual[row.dimension] = float(np.abs(left).max() / size) if np.size(y) and size else 0.0
        return residual

    def _proof(self, row: Row) -> sp.Expr:
        """What is left of a row in symbols: of its own numbers against those proven, and of the proofs."""
        r, dimension = self.response, row.dimension
        proven = {n: m.exponents.get(dimension, 0) for n, m in r.arguments.items()}
        names = sorted(proven.keys() | row.coefficients.keys())
        apart = {n: row.coefficients.get(n, 0) - proven.get(n, 0) for n in names}
        left = sum((sp.Rational(str(x)) * sp.Symbol(f"S_{n}") for n, x in apart.items()), sp.Integer(0))
        left -= sp.Rational(str(row.rhs - r.output.exponents.get(dimension, 0)))
        for certificate in r.certificates:
            left = left or certificate.residual(r.symbols, dimension)
        return left

    def sensitivities(self, values: Mapping[str, object] | None = None) -> dict[str, object]:
        """Bode sensitivities ``(x/y) dy/dx`` to every argument.

        Parameters
        ----------
        values : as for `verify`. Left out: as expressions, for a response that is a formula.

        Returns
        -------
        dict    argument -> S [-]: expressions, numbers, or arrays over the points of t, s, z or over the
                poles or zeros; not a number where y is zero.

        Raises
        ------
        ModelError, UnitError    a value is missing, unknown or cannot be read; or no values are given
                and the response is no formula.

        References
        ----------
        Brennan & Alleyne 2004, eqs 15, 16.
        """
        if values is None:
            return self._formulas()
        y, slopes = self._evaluated(values)
        with np.errstate(all="ignore"):
            return {name: (slopes[name] / y)[()] for name in self.arguments}

    def value(self, values: Mapping[str, object]):
        """The output itself in SI, a number or an array, at values given as for `verify`."""
        return self._evaluated(values)[0][()]

    def solve_for(self, names: Sequence[str], sensitivities: Mapping) -> dict:
        """Sensitivities that the rows determine from the others: three of seven for three dimensions.

        Parameters
        ----------
        names : arguments wanted, such as ``("m", "Iz", "Caf")``.
        sensitivities : argument -> S [-] of the others, as `sensitivities` gives them; more may be there.

        Raises
        ------
        ModelError    the rows cannot tell the names apart, or another sensitivity is missing.
        """
        return solve_rows(self.rows, list(names), sensitivities)

    def _evaluated(self, values: Mapping[str, object]) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        r = self.response
        numbers = read_values(values, r.arguments, model=self.model, optional=r.guesses)
        y, slopes = r.evaluate(numbers)
        return np.asarray(y), {n: np.asarray(slopes[n]) for n in r.arguments}

    def _formulas(self) -> dict[str, sp.Expr]:
        y = self.response.formula
        if y is None:
            raise ModelError(
                f"the {self.response.kind} response has no closed form, so its sensitivities need values",
                usually="Expressions were asked for; they exist for frequency, dc_gain and plain functions.",
                paste=f"invariances.sensitivities({{{(self.arguments or ('m',))[0]!r}: ..., ...}})",
                read='docs/invariances.md, "Values"',
            )
        by_name = {symbol.name: symbol for symbol in y.free_symbols}
        return {name: log_slope(y, by_name[name]) / y for name in self.arguments}

    def __str__(self) -> str:
        head = f"{self.response.about} [{self.response.output}], a function of {', '.join(self.arguments)}"
        if all(row.is_empty for row in self.rows):
            return f"{head}\n  every row is empty: nothing here has a dimension, no sensitivity is coupled"
        width = max(len(row.dimension) for row in self.rows)
        return "\n".join([head, *(f"  {str(row).replace(':', ':' + ' ' * (width - len(row.dimension)), 1)}"
                                  for row in self.rows)])  # fmt: skip


def invariances(
    model: Model,
    output: str | sp.Expr | None = None,
    response: str = "time",
    *,
    input: str | None = None,
    drive: Mapping[str, str | sp.Expr] | None = None,
    quantities: Sequence[Quantity] = (),
    initial: Sequence[str] | None = None,
    angle: bool = False,
    dimensions: Sequence[str] = (),
) -> Invariances:
    """The sensitivity invariances of one output of a model.

    Parameters
    ----------
    model : Model
    output : name of an output or state, or a formula in the model's quantities; left out: the first output.
    response : "time" (after a step, or as driven), "frequency" (G(s)), "z" (sampled every Ts, input held),
        "poles", "zeros", "dc_gain" or "steady_state". Of a model that is not linear, G, poles and zeros
        are those of the model linearised, and the operating point is among the arguments.
    input : from which a transfer function leads; may be left out where there is one.
    drive, quantities, initial : of a time response: inputs as formulas in t, what those are made of, and
        the states that do not start at zero (all, where nothing drives the model).
    angle : whether the radian is a base dimension of its own.
    dimensions : dimensions that get a row even where it is empty.

    Returns
    -------
    Invariances

    Raises
    ------
    ModelError    a name that is not there, a response that does not exist, or a model that is not
                  homogeneous where angles count.

    References
    ----------
    Brennan & Alleyne 2004, eqs 9, 13, 14.
    """
    eq = equations(model, output, angle=angle)
    if response == "time":
        made = time_response(eq, drive=drive or {}, quantities=quantities, initial=initial)
    elif response in ("frequency", "z", "zeros", "dc_gain"):
        kinds = {
            "frequency": frequency_response,
            "z": sampled_response,
            "zeros": zero_response,
            "dc_gain": gain_response,
        }
        made = kinds[response](eq, input)
    elif response in ("poles", "steady_state"):
        made = pole_response(eq) if response == "poles" else steady_response(eq)
    else:
        raise ModelError(
            f"there is no response {response!r} (there are {', '.join(RESPONSES)})",
            usually="The name was misspelt.",
            paste="invariances(model, response='time')",
            read=READ,
        )
    return Invariances(made, rows_of(made.arguments, made.output, dimensions), model)


def euler_rows(
    expression: str | sp.Expr, quantities: Sequence[Quantity], *, output: str = "", angle: bool = False
) -> Invariances:
    """Euler's theorem for any homogeneous function: the rows of ``y = expression``.

    Parameters
    ----------
    expression : text or a SymPy expression in the quantities.
    quantities : what it depends on, with units.
    output : its unit; left out: as the expression has it.
    angle : whether the radian is a base dimension of its own.

    Raises
    ------
    ModelError    terms of the expression differ in units, or it is in another unit than ``output``.

    References
    ----------
    Brennan & Alleyne 2004, eqs 5-12.

    Examples
    --------
    >>> print(euler_rows("S**3", [Quantity("S", "m")]).rows[0])
    length: S_S = 3
    """
    formula = read_formula(expression, [q.name for q in quantities], what="the expression")
    symbols = {q.symbol: (q.measure(angle=angle), q.unit) for q in quantities}
    strange = sorted(s.name for s in formula.free_symbols - symbols.keys())
    if strange:
        raise _not_homogeneous(f"{sp.sstr(formula)} uses {', '.join(strange)}, which is not declared")
    measure = measure_of_expression(formula, symbols)
    wanted = Quantity("y", output).measure(angle=angle) if output else measure or Measure()
    found = mismatches(formula, symbols, wanted, "the whole")
    if found:
        raise _not_homogeneous(f"{sp.sstr(formula)} is not homogeneous: {found[0]}")
    measures = {q.name: q.measure(angle=angle) for q in quantities}
    made = explicit_response(formula, measures, wanted, kind="function", about=sp.sstr(formula))
    return Invariances(made, rows_of(made.arguments, made.output))


def _not_homogeneous(what: str) -> ModelError:
    return ModelError(
        what,
        usually="A quantity is missing, or one has another unit than was meant.",
        paste="euler_rows('S**3', [Quantity('S', 'm', 'edge')])",
        read='docs/invariances.md, "Any homogeneous function"',
    )
