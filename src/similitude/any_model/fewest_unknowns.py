"""Fewest unknowns: groups, and scales where they are unknown, as few numbers as the output tells.

    ln z = E ln p      z unknowns, p parameters;    covariance of ln z = E covariance E'

Of groups and of the scales of time, input and output, those are unknown that hold an uncertain parameter; of
these an independent set is kept, the others are powers of it. Where the base itself is uncertain, the ratio
of the true unit of time to the nominal one is an unknown like any other. Directions that the output cannot
see at all are taken out by holding one member at its median.

Invariant: the output depends on the parameters through the unknowns alone; `exponents` leads from one to the
other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.any_model.knowledge import Knowledge
from similitude.errors import ModelError
from similitude.groups import Group, Groups, reparameterize
from similitude.model import Model, Quantity
from similitude.population import Prior
from similitude.reduction import Reduction, Unknown
from similitude.symmetry.identifiability import identifiable

RATIOS = ("time_ratio", "input_ratio", "output_ratio")
SLOWEST = 10  # a signal below its nominal value over this hides the dynamics


@dataclass(frozen=True, eq=False)
class FewestUnknowns:
    """A reduction, its prior and its units, and how its q unknowns follow from p parameters.

    ``units``: name of a unit of the reduction -> value [SI]; ``signals``: name -> nominal value [SI];
    ``exponents``: (q, p) of |parameters| in the order of `knowledge`; ``notes``: what was simplified.
    """

    reduction: Reduction
    prior: Prior
    units: Mapping[str, float]
    signals: Mapping[str, float]
    exponents: NDArray[np.float64]
    knowledge: Knowledge
    base: tuple[str, ...]
    notes: tuple[str, ...]

    def unknowns_of(self, values: Mapping[str, float]) -> NDArray[np.float64]:
        """The unknowns (q,) of a system with these parameters [SI]."""
        logs = np.array([np.log(abs(values[n])) for n in self.knowledge.names])
        return self.prior.mean * np.exp(self.exponents @ (logs - self.knowledge.mean))

    def parameters(self, mean: NDArray, covariance: NDArray) -> tuple[NDArray, NDArray]:
        """Parameters (p,) [SI] and covariance (p, p) of their logarithms, given those of the unknowns.

        Parameters
        ----------
        mean : (q,) unknowns.    covariance : (q, q) of their logarithms.
        """
        S, E = self.knowledge.covariance, self.exponents
        gain = np.linalg.solve(E @ S @ E.T, E @ S).T  # (p, q)
        moved = gain @ np.log(mean / self.prior.mean)
        after = S - gain @ (E @ S @ E.T - covariance) @ gain.T
        return self.knowledge.signs * np.exp(self.knowledge.mean + moved), after


@dataclass(frozen=True)
class _Row:
    """A monomial of the parameters: a group or the ratio of a scale, with the powers of the signals."""

    name: str
    powers: Mapping[str, Fraction]
    signals: Mapping[str, Fraction]
    sign: float
    meaning: str

    def value(self, knowledge: Knowledge) -> float:
        """Its size [SI] at the medians."""
        return float(np.exp(sum(float(p) * np.log(abs(knowledge.values[n])) for n, p in self.powers.items())))


def fewest_unknowns(
    model: Model,
    base: Sequence[str],
    knowledge: Knowledge,
    *,
    signals: Mapping[str, float],
    start: Mapping[str, float],
    meanings: Mapping[str, str] | None = None,
) -> FewestUnknowns:
    """Reduce a model with one input and one output to what is unknown and seen.

    Parameters
    ----------
    model : Model                 from `one_channel`.
    base : repeating variables; they may be unknown.
    knowledge : Knowledge         of every parameter.
    signals : signal -> nominal value [SI].    start : state -> value [SI] about which it moves.
    meanings : parameter -> what its group tells, in words.

    Returns
    -------
    FewestUnknowns

    Raises
    ------
    ModelError    the base is none, or everything is known, or nothing of what is unknown is seen.
    """
    groups = reparameterize(model, base=tuple(base))
    rows = _rows(groups, knowledge, meanings or {})
    names, uncertain = knowledge.names, [knowledge.names.index(n) for n in knowledge.uncertain]
    E = np.array([[row.powers.get(n, Fraction(0)) for n in names] for row in rows], dtype=object)
    kept, combined = _independent(E[:, uncertain])
    if not kept:
        raise _nothing_unknown(model, knowledge)
    matrix, numbers = E[kept].astype(float), {}
    mean = np.array([1.0 if rows[k].name in RATIOS else rows[k].value(knowledge) for k in kept])
    expressions = _expressions(rows, kept, combined, mean, knowledge, numbers)
    unseen, notes = _unseen(model, knowledge, E[kept])
    held, matrix = _hold(unseen, matrix)
    seen = [i for i in range(len(kept)) if i not in held]
    if not seen:
        raise _nothing_seen(model, knowledge)
    renamed = {
        _symbol(rows[kept[i]].name): _constant(numbers, f"{rows[kept[i]].name}_held", mean[i]) for i in held
    }
    unknowns = []
    for i in seen:
        row = rows[kept[i]]
        own = bool(np.abs(matrix[i] - E[kept[i]].astype(float)).max() > 0)
        name = f"{row.name}_seen" if own else row.name
        renamed[_symbol(row.name)] = _symbol(name)
        meaning = _formula(matrix[i], knowledge.names) if own else row.meaning
        unknowns.append(Unknown(name, _unit(model, row.signals), "log", "estimate", meaning))
    rewritten = _in_nominal_units(groups, rows, knowledge, start, numbers)
    expressions |= {n: e.xreplace({_symbol(k): v for k, v in expressions.items()})
                    for n, e in groups.constraints.items()}  # fmt: skip
    substitution = {g.name: sp.sympify(expressions[g.name]).xreplace(renamed) for g in rewritten.groups}
    first = replace(unknowns[0], role="identify")
    live = sp.And(*(_symbol(q.name) > signals[q.name] / SLOWEST for q in _signals(model)))
    reduction = Reduction(rewritten, (first, *unknowns[1:]), substitution, live)
    matrix = matrix[seen]
    prior = Prior(
        tuple(u.name for u in unknowns),
        ("log",) * len(unknowns),
        mean[seen],
        matrix @ knowledge.covariance @ matrix.T,
    )
    return FewestUnknowns(reduction, prior, numbers, dict(signals), matrix, knowledge, tuple(base), notes)


def _symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, real=True)


def _constant(numbers: dict[str, float], name: str, value: float) -> sp.Symbol:
    """A number of the configuration in place of a literal: one C for all systems of a kind."""
    numbers[name] = float(value)
    return _symbol(name)


def _signals(model: Model) -> list[Quantity]:
    return [model.quantity(n) for n in model.signals]


def _rows(groups: Groups, knowledge: Knowledge, meanings: Mapping[str, str]) -> list[_Row]:
    """Ratios of scales first: where a scale is unknown, it is worth a number of its own."""
    model = groups.model
    values = knowledge.values
    found = []
    scales = (groups.time_scale, groups.scale[model.inputs[0].name], groups.scale[model.outputs[0].name])
    for name, what, scale in zip(RATIOS, ("time", "input", "output"), scales, strict=True):
        powers = {s.name: Fraction(int(e.p), int(e.q)) for s, e in sp.sympify(scale).as_powers_dict().items()
                  if s.is_Symbol}  # fmt: skip
        if set(powers) & set(knowledge.uncertain):
            unknown = {n: p for n, p in powers.items() if n in knowledge.uncertain}
            text = f"unit of {what}, {sp.sstr(scale)}, over its nominal value"
            found.append(_Row(name, unknown, {}, 1.0, text))
    for group in groups.groups:
        if group.name in groups.constraints:
            continue
        own = {n: e for n, e in group.exponents.items() if n not in model.signals}
        also = {n: e for n, e in group.exponents.items() if n in model.signals}
        sign = float(np.prod([np.sign(values[n]) for n in own if own[n].denominator == 1 and own[n] % 2]))
        formula = _formula([float(own.get(n, 0)) for n in knowledge.names], knowledge.names)
        word = meanings.get(group.parameter)
        text = f"{'-' if sign < 0 else ''}{formula}" + (f", {word}" if word else "")
        found.append(_Row(f"{group.name}_steady" if also else group.name, own, also, sign, text))
    return found


def _independent(E: NDArray) -> tuple[list[int], dict[int, dict[int, Fraction]]]:
    """Rows kept, and each other row as powers of them; exact."""
    kept: list[int] = []
    combined: dict[int, dict[int, Fraction]] = {}
    for i, row in enumerate(E):
        if not any(row):
            combined[i] = {}
            continue
        stacked = sp.Matrix([[sp.Rational(x.numerator, x.denominator) for x in E[k]] for k in (*kept, i)])
        if stacked.rank() == len(kept) + 1:
            kept.append(i)
            continue
        powers = stacked.T[:, :-1].gauss_jordan_solve(stacked.T[:, -1])[0]
        combined[i] = {k: powers[j] for j, k in enumerate(kept) if powers[j] != 0}
    return kept, combined


def _expressions(
    rows: Sequence[_Row],
    kept: Sequence[int],
    combined: Mapping[int, Mapping[int, sp.Rational]],
    mean: NDArray,
    knowledge: Knowledge,
    numbers: dict[str, float],
) -> dict[str, sp.Expr]:
    """Name of a group or ratio -> expression in the unknowns and signals.

    A ratio is one at the median, so it is its monomial over that of the medians.
    """
    at = {k: float(m) for k, m in zip(kept, mean, strict=True)}
    result = {}
    for i, row in enumerate(rows):
        bare = _symbol(row.name)
        if i not in at:
            powers = combined[i]
            bare = sp.Mul(*(_symbol(rows[k].name) ** e for k, e in powers.items()))
            level = 1.0 if row.name in RATIOS else row.value(knowledge)
            level /= float(np.prod([at[k] ** float(e) for k, e in powers.items()]))
            if level != 1.0:
                bare = _constant(numbers, f"{row.name}_{'level' if powers else 'known'}", level) * bare
        moving = sp.Mul(
            *(_symbol(n) ** sp.Rational(p.numerator, p.denominator) for n, p in row.signals.items())
        )
        result[row.name.removesuffix("_steady")] = int(row.sign) * bare * moving
    return result


def _unseen(model: Model, knowledge: Knowledge, E: NDArray) -> tuple[NDArray, tuple[str, ...]]:
    """Directions (q, k) of the unknowns that the output cannot see, exact, and what is to be said of them."""
    exact = [n for n in knowledge.names if n not in knowledge.uncertain]
    given = [q.name for q in model.parameters if q.known and q.name not in model.signals]
    found = identifiable(model, known=[n for n in exact if n not in given])
    names = knowledge.names
    directions = [[sp.Integer(d.get(n, 0)) for n in names] for d in found.unseen]
    rational = sp.Matrix([[sp.Rational(x.numerator, x.denominator) for x in row] for row in E])
    moved = rational * sp.Matrix(directions).T if directions else sp.zeros(rational.rows, 0)
    notes = [
        "the output does not change where these scale together: "
        + ", ".join(f"{n}^{p}" if p != 1 else n for n, p in d.items() if n in names)
        for d in found.unseen
    ]
    if found.curved:
        notes.append(f"{found.curved} more combination{'s' * (found.curved > 1)} cannot be told from the "
                     "output at all; the prior alone holds it")  # fmt: skip
    return np.array(moved.tolist(), dtype=object).reshape(rational.rows, moved.cols), tuple(notes)


def _hold(unseen: NDArray, matrix: NDArray) -> tuple[list[int], NDArray]:
    """Unknowns held at their medians, one for each unseen direction, and the exponents of the others."""
    held: list[int] = []
    left = [sp.Matrix(list(column)) for column in unseen.T] if unseen.size else []
    matrix = matrix.copy()
    while any(any(column) for column in left):
        column = next(c for c in left if any(c))
        pivot = max((i for i in range(len(column)) if column[i] != 0), key=lambda i: (abs(column[i]) == 1, i))
        for i in range(len(column)):
            if i != pivot and column[i] != 0:
                matrix[i] = matrix[i] - float(column[i] / column[pivot]) * matrix[pivot]
        left = [c - column * (c[pivot] / column[pivot]) for c in left if c is not column]
        held.append(pivot)
    return held, matrix


def _in_nominal_units(
    groups: Groups,
    rows: Sequence[_Row],
    knowledge: Knowledge,
    start: Mapping[str, float],
    numbers: dict[str, float],
) -> Groups:
    """The rewritten model in constant units, with the ratios of the true units as further groups."""
    model, values = groups.model, knowledge.values
    u, y = model.inputs[0], model.outputs[0]
    ratios = {row.name: _symbol(row.name) for row in rows if row.name in RATIOS}
    theta, xi, zeta = (ratios.get(n, sp.Integer(1)) for n in RATIOS)
    quantities = {q.name: q for q in (*model.states, u, y)}
    constants = [Quantity(n, "1", f"{n.replace('_', ', ')} beforehand") for n in numbers]

    def unit(name: str, scale: sp.Expr) -> sp.Expr:
        known = {_symbol(n): values[n] for n in groups.base if n in values}
        powers = sp.sympify(scale).as_powers_dict()
        moving = sp.Mul(*(s**e for s, e in powers.items() if s.is_Symbol and s.name in model.signals))
        return _constant(numbers, name, float((sp.sympify(scale) / moving).subs(known))) * moving

    scale = {n: unit(f"{n}_unit", groups.scale[n]) for n in quantities}
    time = unit("time_unit", groups.time_scale)
    shifted = {}
    for q in model.states:
        if start.get(q.name):
            name, value = f"{q.name}_start", start[q.name] / numbers[f"{q.name}_unit"]
            shifted[q.symbol] = q.symbol + _constant(numbers, name, value)
            constants.append(Quantity(name, "1", f"{q.meaning or q.name} at the start, in its unit"))
    into = {**shifted, u.symbol: u.symbol / xi}
    measured = [
        Quantity(n, _unit_text(groups, quantities, n), f"unit of {n.removesuffix('_unit')}, nominal")
        for n in numbers
        if n.endswith("_unit")
    ]
    named = replace(
        model,
        parameters=(*model.parameters, *measured, *constants),
        validity=_known_validity(model, knowledge),
    )
    return Groups(
        model=named,
        base=(*numbers, *model.signals),
        groups=(*groups.groups, *(Group(n, n, {n: Fraction(1)}) for n in ratios)),
        scale={**groups.scale, **scale},
        time_scale=time,
        rates={n: e.xreplace(into) / theta for n, e in groups.rates.items()},
        output_map={n: zeta * e.xreplace(into) for n, e in groups.output_map.items()},
        constraints=groups.constraints,
    )


def _known_validity(model: Model, knowledge: Knowledge):
    """The validity with exact parameters as numbers; none where it holds an uncertain one."""
    if model.validity is None or model.validity[1].value is None:
        return None
    exact = {sp.Symbol(n, real=True): v for n, v in knowledge.values.items() if n not in knowledge.uncertain}
    formula = model.validity[0]
    uncertain = {sp.Symbol(n, real=True) for n in knowledge.uncertain}
    if formula.free_symbols & (uncertain | exact.keys()):
        return None
    return model.validity


def _unit_text(groups: Groups, quantities: Mapping[str, Quantity], name: str) -> str:
    """Unit of a constant: that of the quantity, without what the signals bring along."""
    model, plain = groups.model, name.removesuffix("_unit")
    own = model.time_unit if name == "time_unit" else quantities[plain].unit
    scale = groups.time_scale if name == "time_unit" else groups.scale[plain]
    powers = sp.sympify(scale).as_powers_dict()
    more = [
        f"({model.quantity(n).unit})^{-powers[_symbol(n)]}" for n in model.signals if _symbol(n) in powers
    ]
    return " ".join([f"({own})", *more]) if more else own


def _unit(model: Model, signals: Mapping[str, Fraction]) -> str:
    """The unit of a group times the inverse powers of its signals."""
    parts = [f"({model.quantity(n).unit})^{-p}" for n, p in signals.items()]
    return " ".join(parts) or "-"


def _formula(powers: Sequence[float], names: Sequence[str]) -> str:
    parts = [
        (n, Fraction(p).limit_denominator(60)) for n, p in zip(names, powers, strict=True) if abs(p) > 1e-12
    ]
    over = [n if p == 1 else f"{n}^{p if p.denominator == 1 else f'({p})'}" for n, p in parts if p > 0]
    under = [n if p == -1 else f"{n}^{-p if p.denominator == 1 else f'({-p})'}" for n, p in parts if p < 0]
    text = " ".join(over) or "1"
    return f"{text}/({' '.join(under)})" if len(under) > 1 else f"{text}/{under[0]}" if under else text


def _nothing_unknown(model: Model, knowledge: Knowledge) -> ModelError:
    name = knowledge.names[0]
    return ModelError(
        f"everything about {model.name!r} is known exactly: there is nothing to estimate",
        usually="no parameter was given a spread.",
        paste=f"prior={{{name!r}: '{knowledge.values[name]:.4g} {model.quantity(name).unit} +- 30 %'}}",
        read='docs/estimator.md, "What is known beforehand"',
    )


def _nothing_seen(model: Model, knowledge: Knowledge) -> ModelError:
    return ModelError(
        f"the output {model.outputs[0].name!r} of {model.name!r} does not depend on "
        f"{', '.join(knowledge.uncertain)}",
        usually="another output tells them, or the parameter only scales and is in no equation.",
        paste="similitude.identifiable(model).unseen",
        read='docs/symmetries.md, "What the outputs cannot see"',
    )
