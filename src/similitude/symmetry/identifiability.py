"""Identifiability: which combinations of parameters the chosen outputs can see, and which they cannot.

    y(t) = sum_k y_k t^k      y_k depends on parameters p and start x(0); J = d(y_0, y_1, ...)/d ln(p, x(0))

A direction of ln p (and ln x(0)) that J sends to zero leaves every output as it is, to first order, for any
input: no experiment tells it. J is evaluated at random points, from random starts and under random inputs,
in integers modulo a prime where the system is rational and in sixty digits where it is not.

    unseen     directions that are the same at every point: powers lambda^w of parameters, exactly
    shifts     the same for sums: parameters that may be added in these proportions
    curved     how many more directions there are that turn from point to point
    seen       monomials that every one of these directions leaves alone: what the outputs do tell

"Local": up to finitely many other values. "Generic": at almost every value, start and input; a system at
rest or an input that is held shows less.

References: A. Sedoglavic, A probabilistic algorithm to test local algebraic observability in polynomial
time, Journal of Symbolic Computation 33 (2002); J. Karlsson, M. Anguelova, M. Jirstrand, An efficient
method for structural identifiability analysis of large dynamic systems, SYSID 2012.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import sympy as sp

from similitude.errors import ModelError
from similitude.model import Model
from similitude.symmetry.arithmetic import DIGITS
from similitude.symmetry.equations import Equations, equations_of
from similitude.symmetry.lattice import kernel
from similitude.symmetry.output_slopes import OutputSlopes, SlopeRows, gather
from similitude.symmetry.row_space import reduced, whole_rows
from similitude.symmetry.tape import record


@dataclass(frozen=True)
class Identifiability:
    """What outputs can and cannot see of ``parameters``, with ``known`` ones given.

    ``unseen``, ``shifts``: name -> whole number, zeros left out; ``curved``: number of unseen directions that
    are no power laws, ``involved``: parameters that an unseen direction moves where there are such; ``seen``:
    monomials, name -> exponent; ``hidden_states``: states whose start the outputs do not tell although it
    moves no parameter.
    """

    outputs: tuple[str, ...]
    parameters: tuple[str, ...]
    known: tuple[str, ...]
    unseen: tuple[Mapping[str, int], ...]
    shifts: tuple[Mapping[str, int], ...]
    curved: int
    involved: tuple[str, ...]
    seen: tuple[Mapping[str, Fraction], ...]
    hidden_states: tuple[str, ...]

    @property
    def determined(self) -> int:
        """How many numbers the outputs tell: the monomials of ``seen``, and sums and the like."""
        return len(self.parameters) - len(self.unseen) - self.curved

    @property
    def is_complete(self) -> bool:
        """Whether every parameter can be told from the outputs, locally."""
        return not self.unseen and not self.curved


def identifiable(
    model: Model,
    outputs: Sequence[str] | None = None,
    *,
    known: Sequence[str] = (),
    held: Sequence[str] = (),
) -> Identifiability:
    """Which parameter combinations of a model its outputs determine.

    Parameters
    ----------
    model : Model        its parameters with known values are known, its signals known and changing.
    outputs : names of outputs or states that are measured; all outputs where left out.
    known : further parameters whose value is given.
    held : signals among the parameters that do not change during the experiment.

    Returns
    -------
    Identifiability      about all parameters that are neither known nor given by a constraint.

    Raises
    ------
    ModelError           a name that is not the model's, or a model that is singular at every point tried.

    Examples
    --------
    >>> from similitude.systems.bicycle import BICYCLE
    >>> identifiable(BICYCLE).unseen
    ({'m': 1, 'Caf': 1, 'Car': 1, 'Iz': 1},)

    References
    ----------
    Sedoglavic 2002; Karlsson, Anguelova & Jirstrand 2012.
    """
    formulas = {q.name: sp.sympify(q.symbol) for q in model.states} | dict(model.output_map)
    names = list(model.output_map) if outputs is None else list(outputs)
    for name, there, what in [
        *((n, formulas, "an output or a state") for n in names),
        *((n, model.signals, "a signal among the parameters") for n in held),
    ]:
        if name not in there:
            raise ModelError(
                f"model {model.name!r}: {name!r} is not {what} (there are {', '.join(there) or 'none'})",
                usually="A name was misspelt, or the model does not declare it.",
                paste=f"identifiable(model, {list(model.output_map)[:1]!r})",
                read='docs/symmetries.md, "What the outputs cannot see"',
            )
    given = [q.name for q in model.parameters if q.known and q.name not in model.signals]
    return identifiability(
        equations_of(model),
        {name: formulas[name] for name in names},
        known=tuple(dict.fromkeys([*given, *known, *held])),
        varying=[name for name in model.signals if name not in (*held, *known)],
    )


def identifiability(
    equations: Equations,
    outputs: Mapping[str, sp.Expr],
    *,
    known: Sequence[str] = (),
    varying: Sequence[str] = (),
) -> Identifiability:
    """Which parameter combinations the outputs determine.

    Parameters
    ----------
    equations : Equations    constraints among its relations are put in place of their parameter.
    outputs : name -> expression in states, signals and parameters.
    known : parameters whose value is given.
    varying : parameters that are measured and change in time; known as well.

    Returns
    -------
    Identifiability    about the parameters that are neither known nor given by a constraint.

    Raises
    ------
    ModelError    a name that is no parameter, or a system that is singular at every point tried.
    """
    strange = [name for name in (*known, *varying) if name not in equations.parameters]
    if strange:
        raise ModelError(
            f"known is given {strange[0]!r}, which is no parameter (there are "
            f"{', '.join(equations.parameters) or 'none'})",
            usually="A name was misspelt; states and inputs need not be named.",
            paste=f"known={list(equations.parameters[:1])!r}",
            read='docs/symmetries.md, "What the outputs cannot see"',
        )
    given = {sp.Symbol(n, real=True): e for n, e in equations.relations.items() if n in equations.parameters}
    free = [
        n
        for n in equations.parameters
        if n not in (*known, *varying) and sp.Symbol(n, real=True) not in given
    ]
    sides = [_free_of(e, given) for e in (*equations.rates.values(), *outputs.values())]
    tape = record(sides)
    plan = OutputSlopes(tape, equations, tuple(free), tuple(varying), len(outputs))
    with mpmath.workdps(DIGITS):
        return _judge(plan, gather(plan), outputs, known=(*known, *varying))


def _free_of(e: sp.Expr, given: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    for _ in given:  # a constraint may use another
        e = e.xreplace(given)
    return e


def _judge(
    plan: OutputSlopes, rows: SlopeRows, outputs: Mapping[str, sp.Expr], *, known: Sequence[str]
) -> Identifiability:
    columns, width, p = plan.columns, len(plan.columns), len(plan.free)
    common = kernel(whole_rows(rows.logarithmic), width)
    directions = [row for row in common if any(row[:p])]
    curved = len(reduced(rows.first[:, :p])[0]) - len(directions)
    added = kernel(whole_rows(rows.plain), width) if curved else []
    hidden = [row for row in common if not any(row[:p])]
    return Identifiability(
        outputs=tuple(outputs),
        parameters=plan.free,
        known=tuple(known),
        unseen=tuple(_named(columns, row, p) for row in directions),
        shifts=tuple(_named(columns, row, p) for row in added if sum(map(bool, row[:p])) > 1),
        curved=curved,
        involved=tuple(
            n for n, moved in zip(plan.free, rows.turning.T, strict=True) if curved and any(moved)
        ),
        seen=tuple(
            {n: Fraction(x) for n, x in zip(plan.free, row, strict=True) if x}
            for row in kernel(whole_rows(rows.turning), p)
        ),
        hidden_states=tuple(n for j, n in enumerate(columns) if j >= p and any(row[j] for row in hidden)),
    )


def _named(columns: Sequence[str], row: Sequence[int], p: int) -> dict[str, int]:
    names = [*columns[:p], *(f"{name}(0)" for name in columns[p:])]
    return {name: x for name, x in zip(names, row, strict=True) if x}
