"""Groups: a Model rewritten in Pi groups and dimensionless time, with the scales that lead back.

Invariant: after the rewrite no dimensional symbol is left in any rate or output; that it cancels
exactly is checked, not assumed (paper, section 4, eqs 17-20).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from similitude.dimensional.base_advice import advise_base
from similitude.dimensional.exact_span import span_of
from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.units import Dimension, parse_unit


@dataclass(frozen=True)
class Group:
    """One Pi group: its name, the parameter it measures and its exact exponents."""

    name: str
    parameter: str
    exponents: Mapping[str, Fraction]

    @property
    def symbol(self) -> sp.Symbol:
        """The symbol of the group in the rewritten rates."""
        return sp.Symbol(self.name, real=True)


@dataclass(frozen=True)
class Groups:
    """A rewritten model.

    ``rates`` are d(x*)/d(t*) in the groups and in the dimensionless states and inputs, which keep
    the names of the dimensional ones; ``output_map`` likewise. ``scale`` leads back:
    quantity = scale * dimensionless quantity, and ``time_scale`` is the unit of time.
    """

    model: Model
    base: tuple[str, ...]
    groups: tuple[Group, ...]
    scale: Mapping[str, sp.Expr]
    time_scale: sp.Expr
    rates: Mapping[str, sp.Expr]
    output_map: Mapping[str, sp.Expr]
    constraints: Mapping[str, sp.Expr]

    @property
    def angles(self) -> dict[str, Fraction]:
        """Group -> power of the radian, for groups that are not dimensionless where the radian counts."""
        found = {}
        for group in self.groups:
            powers = (
                self.model.quantity(n).measure(angle=True).angle * e for n, e in group.exponents.items()
            )
            if power := sum(powers, Fraction(0)):
                found[group.name] = power
        return found

    def value(self, values: Mapping[str, float]) -> dict[str, float]:
        """Numerical groups [-] from parameter values in SI units."""
        result = {}
        for group in self.groups:
            product = 1.0
            for name, exponent in group.exponents.items():
                product *= values[name] ** float(exponent)
            result[group.name] = product
        return result


def reparameterize(model: Model, *, base: Sequence[str]) -> Groups:
    """Rewrite a model in Pi groups with the named repeating variables.

    Parameters
    ----------
    model : Model             with units on every quantity.
    base : repeating variables, parameters whose dimensions are independent and span the model's.

    Returns
    -------
    Groups                    one group per remaining parameter, in the model's order.

    Raises
    ------
    ModelError                the base does not span, or a rate is not homogeneous in the units.

    References
    ----------
    Brennan & Alleyne 2004, eqs 17-20.
    """
    columns = [model.quantity(name).dimension for name in base]
    scale = {q.name: _monomial(_solve(model, base, columns, q.name, q.dimension)) for q in model.quantities}
    second = parse_unit(model.time_unit if model.states else "1").dimension  # a static model has no time
    time = _monomial(_solve(model, base, columns, "time", second))
    free = [q for q in model.parameters if q.name not in base]
    groups = tuple(_group(model, base, columns, q, i + 1) for i, q in enumerate(free))
    substitution = {q.symbol: scale[q.name] * g.symbol for q, g in zip(free, groups, strict=True)}
    signals = (*model.states, *model.inputs)
    substitution |= {q.symbol: scale[q.name] * q.symbol for q in signals}
    one = {model.quantity(n).symbol: sp.Integer(1) for n in base}

    def dimensionless(expression: sp.Expr, unit: sp.Expr, where: str) -> sp.Expr:
        result = sp.expand(sp.sympify(expression).xreplace(substitution) / unit)
        if result.free_symbols & one.keys():  # sums under a fraction, a root or in a function
            # The model is homogeneous, so the base cancels, and the value for a base of ones is the value.
            result = sp.sympify(expression).xreplace(substitution).xreplace(one)
        left = sorted({s.name for s in result.free_symbols} & set(base))
        if left:
            raise ModelError(
                f"model {model.name!r}: {where} is not homogeneous, {', '.join(left)} does not cancel"
                f" from {sp.sstr(result)[:160]}",
                usually="Two terms of the sum have different units, or a quantity's unit is wrong.",
                paste="Quantity('Caf', 'N/rad', 'cornering stiffness')   # check each unit",
                read="docs/architecture.md, 'Groups'",
            )
        return sp.factor_terms(result)

    constraints = {
        name: dimensionless(e, scale[name], f"the constraint on {name!r}")
        for name, e in model.constraints.items()
    }
    return Groups(
        model=model,
        base=tuple(base),
        groups=groups,
        scale=scale,
        time_scale=time,
        rates={
            name: dimensionless(rate, scale[name] / time, f"the rate of {name!r}")
            for name, rate in model.rates.items()
        },
        output_map={
            name: dimensionless(out, scale[name], f"the output {name!r}")
            for name, out in model.output_map.items()
        },
        constraints=_constraints(constraints, {q.name: g for q, g in zip(free, groups, strict=True)}),
    )


def _constraints(rewritten: Mapping[str, sp.Expr], groups: Mapping[str, Group]) -> dict[str, sp.Expr]:
    """Group name -> expression. What constrains a base parameter (1 = e) is solved for a group of e."""
    found = {groups[name].name: e for name, e in rewritten.items() if name in groups}
    for e in (e for name, e in rewritten.items() if name not in groups):
        for symbol in sorted(e.free_symbols, key=lambda s: s.name):
            solved = sp.solve(e - 1, symbol) if symbol.name not in found else []
            if len(solved) == 1:
                found[symbol.name] = solved[0]
                break
    return found


def _group(model: Model, base: Sequence[str], columns: list[Dimension], q: Quantity, number: int) -> Group:
    powers = _solve(model, base, columns, q.name, q.dimension)
    exponents = {q.name: Fraction(1)} | {name: -p for name, p in powers.items() if p}
    return Group(f"pi{number}", q.name, exponents)


def _monomial(powers: Mapping[str, Fraction]) -> sp.Expr:
    return sp.Mul(
        *(sp.Symbol(n, real=True) ** sp.Rational(p.numerator, p.denominator) for n, p in powers.items())
    )


def _solve(
    model: Model, base: Sequence[str], columns: list[Dimension], name: str, wanted: Dimension
) -> dict[str, Fraction]:
    """Exponents of the base whose product has the wanted dimension, exactly."""
    span = span_of([d.powers for d in columns], len(wanted.powers))
    solution = None if span is None else span.exponents(wanted.powers)
    if solution is None:
        raise ModelError(
            f"model {model.name!r}: {', '.join(base)} cannot be a base: {_why_not(model, base)}",
            usually="one mass, one length and one time among the parameters is the usual choice.",
            paste="similitude.advise_base(model)   # lists the bases that can",
            read='docs/groups.md, "A base that cannot be one"',
        )
    return dict(zip(base, solution, strict=True))


def _why_not(model: Model, base: Sequence[str]) -> str:
    wrong = [name for name in base if name not in {q.name for q in model.parameters}]
    if wrong:
        return f"{', '.join(wrong)} is no parameter"
    return advise_base(model).check(list(base)).reason
