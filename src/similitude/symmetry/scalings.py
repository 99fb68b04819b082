"""Scalings: all scalings of the variables that leave a system's equations true, and what they leave.

    z_j -> lambda^w_j z_j        z: time, states, signals, parameters (and outputs, where there are any)

A system dx/dt = f is left true where t f_i/x_i does not change, so these are the functions of
`relations`. Units are such scalings; a system may have more.

Invariant: the weights are a basis of all such scalings with whole weights, the invariants a basis of all
monomials that do not change (every rational invariant is a rational function of them), both unique.

References: E. Hubert and G. Labahn, Scaling invariants and symmetry reduction of dynamical systems,
Foundations of Computational Mathematics 13 (2013), 479-516.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.base import choose_base, exponents
from similitude.symmetry.check import ScalingCheck, check_scalings
from similitude.symmetry.equations import Equations, read_equations
from similitude.symmetry.lattice import kernel, saturated, solved
from similitude.symmetry.reduced_system import ReducedSystem, reduce_by
from similitude.symmetry.relations import Relations, constraint_rows


@dataclass(frozen=True)
class Scalings:
    """The scaling symmetries of a system.

    ``weights`` (count): name -> whole number, one mapping a scaling, zeros left out. ``invariants``
    (n - count): name -> exponent, time included. ``base``: the variables in which ``reduced`` measures
    the others.
    """

    equations: Equations
    weights: tuple[Mapping[str, int], ...]
    invariants: list[dict[str, Fraction]]
    base: tuple[str, ...]
    reduced: ReducedSystem

    @property
    def count(self) -> int:
        """How many independent scalings there are."""
        return len(self.weights)

    def __str__(self) -> str:
        lines = [f"{self.count} scaling{'s' * (self.count != 1)}; in each, what is multiplied together:"]
        lines += [
            "  " + ", ".join(_power(name, power) for name, power in row.items()) for row in self.weights
        ]
        unchanged = ",  ".join(" ".join(_power(*one) for one in group.items()) for group in self.invariants)
        return "\n".join([*lines, f"unchanged: {unchanged or 'nothing'}", str(self.reduced)])

    def verify(self) -> ScalingCheck:
        """Scale the equations at random points, undo the reduction, and count what was missed."""
        return check_scalings(self.equations, self.weights, self.reduced)

    def reduce(self, base: Sequence[str]) -> ReducedSystem:
        """The reduced system with another base.

        Raises
        ------
        ModelError    not as many names as scalings, an unknown one, or names that scale together.
        """
        names = self.equations.names
        matrix = _matrix(self.weights, names)
        known = [name for name in base if name in names]
        columns = [names.index(name) for name in known]
        square = [[row[j] for j in columns] for row in matrix]
        complete = len(known) == len(base) == self.count
        if not complete or solved(square, square) is None:
            raise ModelError(
                f"the base {', '.join(base)} does not measure a system of {self.count} scalings: "
                + (f"{len(base)} names are given, {self.count} are needed" if len(base) != self.count
                   else "a name is unknown" if not complete else "its names do not scale independently"),
                usually="One variable is needed for each scaling, and none that others already measure.",
                paste=f"scalings.reduce({list(self.base)!r})",
                read='docs/symmetries.md, "The reduced system"',
            )  # fmt: skip
        return reduce_by(self.equations, base, exponents(matrix, columns))


def scaling_symmetries(
    rates: Mapping[str, str | sp.Expr],
    parameters: Sequence[str],
    *,
    signals: Sequence[str] = (),
    time: str = "t",
) -> Scalings:
    """All scalings of time, states, signals and parameters that leave a system true.

    Parameters
    ----------
    rates : state -> d(state)/dt, as text or SymPy expression; text is read with the names declared here.
    parameters : names of constants.
    signals : names of inputs and other given functions of time.
    time : name of time.

    Returns
    -------
    Scalings    count, weights, invariants, the reduced system; `verify()` checks them.

    Raises
    ------
    ModelError    an undeclared name, a name with two roles, no rates, or a text that is no formula.

    Examples
    --------
    >>> found = scaling_symmetries({"x": "r*x*(1 - x/K)"}, ["r", "K"])
    >>> found.count
    2
    >>> [{name: str(power) for name, power in group.items()} for group in found.invariants]
    [{'t': '1', 'r': '1'}, {'x': '1', 'K': '-1'}]

    References
    ----------
    Hubert & Labahn 2013.
    """
    return scalings_of(read_equations(rates, parameters, signals=signals, time=time))


def scalings_of(equations: Equations, *, prefer: Sequence[str] = ()) -> Scalings:
    """The scaling symmetries of equations, those of a Model included.

    Parameters
    ----------
    equations : Equations
    prefer : names that the base takes before all others.

    Raises
    ------
    ModelError    a rate that is no formula, or is singular everywhere.
    """
    names = equations.names
    matrix = _weights(equations)
    place = {name: j for j, name in enumerate(names)}
    preference = [-1 if name in prefer else _preference(equations, name) for name in names]
    columns = choose_base(matrix, preference) if matrix else []
    powers = exponents(matrix, columns)
    base = [names[j] for j in columns]
    order = [j for j in range(len(names)) if j not in columns] + columns
    invariants = [dict(zip((names[j] for j in order), row, strict=True))
                  for row in kernel([[row[j] for j in order] for row in matrix], len(names))]  # fmt: skip
    if all(x.denominator == 1 for row in powers for x in row):
        matrix = [[int(x) for x in row] for row in powers]  # one scaling a variable of the base
    return Scalings(
        equations=equations,
        weights=tuple({n: w for n, w in zip(names, row, strict=True) if w} for row in matrix),
        invariants=[{n: Fraction(i[n]) for n in sorted(i, key=place.get) if i[n]} for i in invariants],
        base=tuple(base),
        reduced=reduce_by(equations, base, powers),
    )


def _weights(equations: Equations) -> list[list[int]]:
    """Canonical basis (count, n) of the whole weights."""
    symbols = [sp.Symbol(name, real=True) for name in equations.names]
    relations = Relations()
    for name, rate in equations.rates.items():
        if rate != 0:
            relations.keep(sp.Symbol(equations.time, real=True) * rate / sp.Symbol(name, real=True))
    for name, value in equations.relations.items():
        if value != 0:
            relations.keep(value / sp.Symbol(name, real=True))
    rows = constraint_rows(relations, symbols)
    n = len(symbols)
    found = kernel(rows, n + len(relations.spare))
    return saturated([row[:n] for row in found], n) if relations.spare else found


def _preference(equations: Equations, name: str) -> int:
    roles = (equations.parameters, equations.states, equations.signals, equations.results, (equations.time,))
    return next(k for k, role in enumerate(roles) if name in role)


def _power(name: str, power: int | Fraction) -> str:
    return name if power == 1 else f"{name}^{power}"


def _matrix(weights: Sequence[Mapping[str, int]], names: Sequence[str]) -> list[list[int]]:
    return [[row.get(name, 0) for name in names] for row in weights]
