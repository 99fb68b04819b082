"""ReducedSystem: equations with every scaling taken out, and the way back.

    z_j = s_j y_j,   s_j = prod_b z_b^X_bj over the base b        (`base`)
    dy_i/dsigma = f_i - y_i sum_b X_bi g_b,   everything with the base set to one

sigma is time measured in s_t (dt = s_t dsigma), g_b = s_t d ln z_b/dt the base's own drift: zero for a
parameter, f_b for a state, and the unknown `drift_b` for a signal, all with the base set to one.

Invariant: no name of the base occurs in `rates` or `relations`.

References: Hubert & Labahn 2013, section 5 (there with a section of the action that need not be made of
variables); Brennan & Alleyne 2004, eq 17, where the scalings are those of units.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from similitude.symmetry.equations import Equations

Exponents = Mapping[str, Fraction]


@dataclass(frozen=True)
class ReducedSystem:
    """What is left of a system when its scalings are taken out.

    ``definitions``: reduced name -> exponents over the original names. States, signals and time keep
    their names, parameters become pi1, pi2, ... ``rates``: d(state)/d(time), all reduced. ``drifts``: base
    state -> d ln(state)/d(reduced time), from which it follows by an integral. ``scale``: original name ->
    expression in the base with original = scale * reduced (for the base itself: original = scale).
    """

    base: tuple[str, ...]
    definitions: Mapping[str, Exponents]
    rates: Mapping[str, sp.Expr]
    relations: Mapping[str, sp.Expr]
    drifts: Mapping[str, sp.Expr]
    scale: Mapping[str, sp.Expr]
    new_name: Mapping[str, str]

    def __str__(self) -> str:
        lines = [f"measured in {', '.join(self.base) or 'nothing'}:"]
        for name, powers in self.definitions.items():
            lines.append(f"  {name} = " + " ".join(n if p == 1 else f"{n}^{p}" for n, p in powers.items()))
        lines += [f"  d({name}) = {sp.sstr(rate)}" for name, rate in self.rates.items()]
        lines += [f"  {name} = {sp.sstr(value)}" for name, value in self.relations.items()]
        lines += [f"  d(ln {name}) = {sp.sstr(drift)}" for name, drift in self.drifts.items()]
        return "\n".join(lines)

    def restore(self, state: str) -> sp.Expr:
        """The original rate of a state that is not in the base, from the reduced one."""
        time = next(iter(self.scale))  # the first name is time
        back = {sp.Symbol(new, real=True): self._reduced(old) for old, new in self.new_name.items()}
        own = self._reduced(state)
        drift = sum(
            (power * self.drifts.get(b, sp.Integer(0)) for b, power in self._powers(state).items()),
            sp.Integer(0),
        )
        return self.scale[state] / self.scale[time] * (
            self.rates[state].xreplace(back) + own * drift.xreplace(back)
        )  # fmt: skip

    def _reduced(self, name: str) -> sp.Expr:
        return sp.Symbol(name, real=True) / self.scale[name]

    def _powers(self, name: str) -> dict[str, sp.Rational]:
        given = self.definitions[self.new_name[name]]
        return {b: -_rational(given[b]) for b in self.base if b in given}


def reduce_by(
    equations: Equations, base: Sequence[str], powers: Sequence[Sequence[Fraction]]
) -> ReducedSystem:
    """Measure everything in the base.

    Parameters
    ----------
    equations : Equations    n names
    base : r names
    powers : X (r, n), the exponents by which the base makes up each name's weight.

    Returns
    -------
    ReducedSystem    with n - r names left.
    """
    column = {name: {b: row[j] for b, row in zip(base, powers, strict=True) if row[j]}
              for j, name in enumerate(equations.names)}  # fmt: skip
    left = [name for name in equations.names if name not in base]
    new_name = _new_names(equations, left, column)
    to_one = {_symbol(b): sp.Integer(1) for b in base}
    renamed = {_symbol(old): _symbol(new) for old, new in new_name.items() if old != new}

    def at_one(e: sp.Expr) -> sp.Expr:
        return e.xreplace(to_one).xreplace(renamed)

    drifts = {b: at_one(equations.rates[b]) for b in base if b in equations.rates}
    drifts |= {b: _symbol(f"drift_{b}") for b in base if b in equations.signals}
    drifts |= {b: sp.Integer(1) for b in base if b == equations.time}

    def rate(name: str, own: sp.Expr) -> sp.Expr:
        shift = sp.Add(*(_rational(column[name][b]) * drifts[b] for b in column[name] if b in drifts))
        return own - _symbol(new_name[name]) * shift

    rates = {name: rate(name, at_one(equations.rates[name])) for name in equations.states if name in left}
    time = equations.time
    if time in left and any(
        b in drifts for b in column[time]
    ):  # dt*/dsigma is one only where s_t is constant
        if any(_symbol(time) in e.free_symbols for e in (*rates.values(), *drifts.values())):
            rates[time] = rate(time, sp.Integer(1))
    relations = {new_name[name]: at_one(e) for name, e in equations.relations.items() if name in left}
    return ReducedSystem(
        base=tuple(base),
        definitions={new_name[n]: {n: Fraction(1)} | {b: -p for b, p in column[n].items()} for n in left},
        rates=rates,
        relations=relations,
        drifts=drifts,
        scale={
            name: _symbol(name)
            if name in base
            else sp.Mul(*(_symbol(b) ** _rational(p) for b, p in column[name].items()))
            for name in equations.names
        },
        new_name=new_name,
    )


def _new_names(equations: Equations, left: Sequence[str], column: Mapping[str, Exponents]) -> dict[str, str]:
    """Parameters that a base measures become pi1, pi2, ...; all other names stay."""
    names, taken, number = {}, set(equations.names), 0
    for name in left:
        if name not in equations.parameters or not column[name]:
            names[name] = name
            continue
        number += 1
        while f"pi{number}" in taken:
            number += 1
        names[name] = f"pi{number}"
    return names


def _symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, real=True)


def _rational(value: Fraction) -> sp.Rational:
    return sp.Rational(value.numerator, value.denominator)
