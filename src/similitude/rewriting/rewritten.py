"""Rewritten: a Model in Pi groups and dimensionless time, as a Model, with the way there and back.

    x = c x*,  t = T t*,  p = c Pi        c, T products of powers of the base

    dx*/dt* = (T/c) f  -  x* sum over moving base parameters b of  e_b (T/b) db/dt      c = ... b^e_b ...

The sum is the chain rule's, for scales that are measured and change on the way (a car's speed).

Invariant: terms of the chain rule are either in the model, as an input ``<name>_rate``, or in ``left_out``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from similitude.errors import ModelError
from similitude.groups import Groups, reparameterize
from similitude.model import Model, Quantity
from similitude.rewriting.moving_scales import chain_terms, rate_symbol

READ = 'docs/model.md, "Rewriting"'


@dataclass(frozen=True)
class Rewritten:
    """A model without dimensions.

    Parameters
    ----------
    groups : the groups, the scales that lead back, and the model it was made of.
    model : the same system with every unit "1": states, inputs and outputs keep their names, groups take
        the place of the parameters, and time is dimensionless.
    moving : base parameters whose change on the way is in the model, as inputs ``<name>_rate`` [-].
    left_out : state -> what was left out of its rate because a scale that is a measured signal is taken
        as constant, in the model's symbols and ``<name>_rate``; empty where nothing was.
    """

    groups: Groups
    model: Model
    moving: tuple[str, ...]
    left_out: Mapping[str, sp.Expr]

    @property
    def statement(self) -> str:
        """What was left out, in words; empty where nothing was."""
        if not self.left_out:
            return ""
        rates = sorted(
            {s.name for e in self.left_out.values() for s in e.free_symbols if s.name.endswith("_rate")}
        )
        names = [name.removesuffix("_rate") for name in rates]
        terms = "; ".join(f"{sp.sstr(e)} in the rate of {name}" for name, e in self.left_out.items())
        meaning = ", ".join(f"{n}_rate = (d{n}/dt) ({sp.sstr(self.groups.time_scale)})/{n}" for n in names)
        return f"{', '.join(names)} taken as constant; left out: {terms} ({meaning})"

    def back(self) -> Model:
        """The model in the dimensional quantities again, its rates made of the rewritten ones.

        Returns
        -------
        Model    equal to the original as functions, not always term by term.
        """
        g, original = self.groups, self.groups.model
        into = {q.symbol: q.symbol / g.scale[q.name] for q in (*original.states, *original.inputs)}
        into |= {group.symbol: _product(group.exponents) for group in g.groups}
        return replace(
            original,
            rates={n: sp.expand(g.scale[n] / g.time_scale * e.xreplace(into)) for n, e in g.rates.items()},
            output_map={n: sp.expand(g.scale[n] * e.xreplace(into)) for n, e in g.output_map.items()},
        )

    def __str__(self) -> str:
        g = self.groups
        lines = [f"{g.model.name}, measured in {', '.join(g.base) or 'nothing'}"]
        lines += [f"  {group.name} = {sp.sstr(_product(group.exponents))}" for group in g.groups]
        lines.append(f"  t* = t/({sp.sstr(g.time_scale)})")
        lines += [f"  {q.name}* = {q.name}/({sp.sstr(g.scale[q.name])})" for q in g.model.states]
        lines += [f"  d{q.name}*/dt* = {sp.sstr(self.model.rates[q.name])}" for q in g.model.states]
        return "\n".join(lines + ([f"  {self.statement}"] if self.left_out else []))


def rewrite(model: Model, *, base: Sequence[str], moving: Sequence[str] = ()) -> Rewritten:
    """Rewrite a model in Pi groups and dimensionless time, states and inputs.

    Parameters
    ----------
    model : Model
    base : repeating variables, parameters whose dimensions are independent and span the model's.
    moving : base parameters that change on the way and whose rate of change can be had: their terms of
        the chain rule come in, each with an input ``<name>_rate``. Signals of the model that are in the
        base and not named here are taken as constant, which the result states.

    Returns
    -------
    Rewritten

    Raises
    ------
    ModelError    the base cannot measure the model, or ``moving`` names what is not in the base.

    References
    ----------
    Brennan & Alleyne 2004, eqs 17-20, which take the speed as constant.

    Examples
    --------
    >>> from similitude.systems.bicycle import BICYCLE
    >>> print(rewrite(BICYCLE, base=("m", "L", "U")).statement)  # doctest: +ELLIPSIS
    U taken as constant; left out: -U_rate*v in the rate of v; -U_rate*r in the rate of r...
    """
    strange = [name for name in moving if name not in base]
    if strange:
        raise ModelError(
            f"{strange[0]!r} is said to move, but is not in the base ({', '.join(base)})",
            usually="Only scales add terms; what else changes is a signal of the rewritten model.",
            paste=f"rewrite(model, base={tuple(base)!r}, moving={tuple(base)[-1:]!r})",
            read=READ,
        )
    groups = reparameterize(model, base=base)
    terms = chain_terms(groups, moving)
    still = [name for name in model.signals if name in base and name not in moving]
    rates = {name: e + terms.get(name, sp.Integer(0)) for name, e in groups.rates.items()}
    return Rewritten(groups, _dimensionless(groups, rates, moving), tuple(moving), chain_terms(groups, still))


def _dimensionless(groups: Groups, rates: Mapping[str, sp.Expr], moving: Sequence[str]) -> Model:
    model = groups.model
    varying = {*model.signals, *moving}
    return Model(
        name=f"{model.name}_in_groups",
        states=[_bare(q, groups) for q in model.states],
        inputs=[
            *(_bare(q, groups) for q in model.inputs),
            *(
                Quantity(rate_symbol(name).name, "1", f"relative change of {name} a unit of time")
                for name in moving
            ),
        ],
        outputs=[_bare(q, groups) for q in model.outputs],
        parameters=[Quantity(g.name, "1", sp.sstr(_product(g.exponents))) for g in groups.groups],
        rates=rates,
        output_map=groups.output_map,
        constraints=groups.constraints,
        signals=[g.name for g in groups.groups if varying & set(g.exponents)],
        validity=_validity(groups),
        source=model.source,
        time_unit="1",
    )


def _bare(quantity: Quantity, groups: Groups) -> Quantity:
    scale = groups.scale[quantity.name]
    over = "" if scale == 1 else f" over {sp.sstr(scale)}"
    return Quantity(quantity.name, "1", f"{quantity.meaning or quantity.name}{over}")


def _validity(groups: Groups) -> tuple[sp.Expr, Quantity] | None:
    """The model is homogeneous: the formula for a base of ones is the formula over its own scale."""
    if groups.model.validity is None:
        return None
    formula, limit = groups.model.validity
    ones = {sp.Symbol(name, real=True): sp.Integer(1) for name in groups.base}
    named = {sp.Symbol(g.parameter, real=True): g.symbol for g in groups.groups}
    return formula.xreplace(named | ones), Quantity(limit.name, "1", limit.meaning)


def _product(exponents: Mapping) -> sp.Expr:
    return sp.Mul(
        *(sp.Symbol(n, real=True) ** sp.Rational(e.numerator, e.denominator) for n, e in exponents.items())
    )
