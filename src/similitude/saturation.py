"""Saturation: a force that has a greatest value, as a function that the rates of a model may use.

    s(x) = x (1 + |x| + x^2/2) / (1 + |x| + x^2 + |x|^3/2)

Near zero it is x - x^3/2 to third order, as x/sqrt(1 + x^2) is: linear with a cubic onset, so that
what is learnt at small x is the slope at zero. Far away it is the sign of x. It needs one division and
no libm, and is three times differentiable at zero.

Invariant: a step program never holds the function; `spelt` puts statements in its place.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from similitude.program.ir import Assign

CUBIC = sp.Rational(7, 10)


class Saturation(sp.Function):
    """s(x), odd, between -1 and 1 [-]."""

    nargs = 1
    is_real = True

    @classmethod
    def eval(cls, x: sp.Expr) -> sp.Expr | None:
        """Nothing without a force."""
        return sp.Integer(0) if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """ds/dx."""
        return SaturationSlope(self.args[0])

    def doit(self, **_: bool) -> sp.Expr:
        """The function as a rational expression in x and \\|x\\|."""
        x = self.args[0]
        size = sp.Max(x, -x)
        over = _over(size)
        return x * over / (1 + size * over)


class SaturationSlope(sp.Function):
    """ds/dx = (1 + 2 |x| + 3/2 x^2) / (1 + |x| + x^2 + |x|^3/2)^2, even, between 0 and 1 [-]."""

    nargs = 1
    is_real = True

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """d2s/dx2."""
        return SaturationBend(self.args[0])

    def doit(self, **_: bool) -> sp.Expr:
        """The slope as a rational expression in \\|x\\|."""
        x = self.args[0]
        size = sp.Max(x, -x)
        return _slope_over(size) / (1 + size * _over(size)) ** 2


class SaturationBend(sp.Function):
    """d2s/dx2, odd, zero at zero: what a linearised tyre's sensitivities need. No step program holds it."""

    nargs = 1
    is_real = True

    def doit(self, **_: bool) -> sp.Expr:
        """The second derivative as a rational expression in \\|x\\| and the sign of x."""
        x, size = self.args[0], sp.Dummy(positive=True)
        bend = sp.diff(_slope_over(size) / (1 + size * _over(size)) ** 2, size)
        return sp.sign(x) * bend.xreplace({size: sp.Max(x, -x)})


def _over(size: sp.Expr) -> sp.Expr:
    return 1 + size * (1 + CUBIC * size)


def _slope_over(size: sp.Expr) -> sp.Expr:
    return 1 + size * (2 + 3 * CUBIC * size)


def arguments(named: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
    """``load<i>`` -> what is saturated, each once, in a fixed order."""
    found = {f.args[0] for e in named.values() for f in e.atoms(Saturation, SaturationSlope)}
    return {f"load{i}": x for i, x in enumerate(sorted(found, key=sp.default_sort_key))}


def spelt(
    named: Mapping[str, sp.Expr], loads: Mapping[str, sp.Expr]
) -> tuple[list[Assign], dict[str, sp.Expr]]:
    """Statements that saturate each load, and the expressions with their results in place.

    The loads themselves must have been assigned before.
    """
    lines: list[Assign] = []
    replace: dict[sp.Expr, sp.Expr] = {}
    for i, (name, x) in enumerate(loads.items()):
        load, size, over, part = (sp.Symbol(n, real=True) for n in (name, f"size{i}", f"over{i}", f"part{i}"))
        lines += [
            Assign(size.name, sp.Max(load, -load)),
            Assign(over.name, _over(size)),
            Assign(part.name, 1 / (1 + size * over), "force over load" if i == 0 else ""),
        ]
        replace[Saturation(x)] = load * over * part
        replace[SaturationSlope(x)] = _slope_over(size) * part**2
    return lines, {name: e.xreplace(replace) for name, e in named.items()}
