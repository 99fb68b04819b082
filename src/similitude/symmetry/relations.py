"""What an equation asks of a scaling, as exact rows: sum over variables of row * weight = 0.

A scaling multiplies every variable z by lambda^w(z). It keeps a function R as it is exactly where

    sum_j w_j z_j dR/dz_j = 0        at every point                                              (1)

so the rows (z_j dR/dz_j) at enough random points, reduced, are all that R asks. For rational R they are
computed in integers modulo a prime and read back as fractions: no expansion, no common denominator.

What is not rational is first made so:

    sin, exp, tanh, ... (a)    a must not change; the value is a constant
    log(a)                     a value to which a scaling adds the weight of a
    a^(1/d)                    z with z^d scaling as a
    a^n, n not a number        n must not change; z whose weight is n times that of a, kept apart
    abs, max, min              z scaling as each argument that is not zero
    sign, atan2                arguments scale alike; the value is a constant

These conditions are sufficient, and for rational equations necessary.

References: Hubert & Labahn 2013, section 4 (there by exponents of expanded numerators and denominators).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.arithmetic import PRIMES, BadPoint, Modular, run
from similitude.symmetry.lattice import integers
from similitude.symmetry.residues import eliminate, fraction_of, joined
from similitude.symmetry.tape import Tape, record

SPARE = 3  # points more than a function has variables
TRIES = 20  # of points, before a function is called singular everywhere
UNIT = sp.Integer(1)
LARGEST = 10**7  # numerator and denominator of an entry: a random residue is one four times in 100 000


@dataclass
class Relations:
    """Rational functions that must not change, over variables and what was put in place of functions."""

    invariant: list[sp.Expr] = field(default_factory=list)
    constants: set[sp.Symbol] = field(default_factory=set)  # values that do not change
    powers: dict[sp.Symbol, tuple[sp.Symbol, sp.Expr]] = field(default_factory=dict)  # z: weight m w(a)
    logarithms: set[sp.Symbol] = field(
        default_factory=set
    )  # to which the weight of theirs in powers is added
    known: dict[sp.Expr, sp.Expr] = field(default_factory=dict)
    spare: list[sp.Symbol] = field(default_factory=list)

    def keep(self, expression: sp.Expr) -> None:
        """Ask that an expression does not change."""
        self.invariant.append(self.rational(expression))

    def rational(self, e: sp.Expr) -> sp.Expr:
        """The expression with a symbol in place of everything that is not rational."""
        if e.is_Symbol or e.is_Rational:
            return e
        if e not in self.known:
            self.known[e] = self._replaced(e)
        return self.known[e]

    def _replaced(self, e: sp.Expr) -> sp.Expr:
        if e.is_Float:
            return sp.Rational(str(e))
        if e.is_number and e.is_finite:
            return self._constant()
        if e.is_Add or e.is_Mul:
            return e.func(*(self.rational(a) for a in e.args))
        if e.is_Pow:
            return self._power(e.base, e.exp)
        if isinstance(e, sp.Abs | sp.Max | sp.Min):
            return self._alike(e.args)
        if isinstance(e, sp.sign | sp.atan2):
            self._alike(e.args)
            return self._constant()
        if isinstance(e, sp.log):
            return self._logarithm(e.args[0])
        if isinstance(e, sp.Piecewise):
            return self._piecewise(e)
        if isinstance(e, sp.Function):
            for argument in e.args:
                self.keep(argument)
            return self._constant()
        raise ModelError(
            f"{sp.sstr(e)[:80]} ({type(e).__name__}) is no formula whose scaling could be told",
            usually="A derivative, an integral or a matrix stands in a rate.",
            paste="rates={'x': v, 'v': -k*x/m}   # one rate a state, no derivatives on the right",
            read='docs/symmetries.md, "Functions"',
        )

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        if exponent.is_Float:
            exponent = sp.Rational(str(exponent))
        if exponent.is_Integer:
            return self.rational(base) ** exponent
        if exponent.is_Rational:
            root = self._root(base, exponent.q)
            return root**exponent.p
        if exponent.free_symbols:
            self.keep(exponent)
        result = UNIT
        for part in sp.Add.make_args(sp.expand(exponent)):
            number, kind = part.as_coeff_Mul()
            if kind == 1:
                result *= self._power(base, number)
            elif number.is_Rational:
                result *= self._of_kind(base, kind) ** number.p if number.q == 1 else self._root(
                    self._of_kind(base, kind), number.q
                ) ** number.p  # fmt: skip
        return result

    def _of_kind(self, base: sp.Expr, kind: sp.Expr) -> sp.Expr:
        """base^kind, of which only the kind and the weight of the base are known."""
        key = sp.Pow(base, kind, evaluate=False)
        if key not in self.known:
            whole = self._whole(base)
            self.known[key] = self._new()
            self.powers[self.known[key]] = (whole, kind)
        return self.known[key]

    def _logarithm(self, base: sp.Expr) -> sp.Expr:
        whole = self._whole(base)
        value = self._new()
        self.powers[value] = (whole, UNIT)
        self.logarithms.add(value)
        return value

    def _whole(self, base: sp.Expr) -> sp.Symbol:
        """A symbol that scales as an expression does."""
        return base if base.is_Symbol else self._alike((base,))

    def _root(self, base: sp.Expr, degree: int) -> sp.Expr:
        key = sp.Pow(base, sp.Rational(1, degree), evaluate=False)
        if key not in self.known:
            self.known[key] = self._new()
            self.invariant.append(self.rational(base) / self.known[key] ** degree)
        return self.known[key]

    def _alike(self, arguments: Sequence[sp.Expr]) -> sp.Expr:
        value = self._new()
        for argument in arguments:
            if argument != 0:
                self.invariant.append(self.rational(argument) / value)
        return value

    def _piecewise(self, e: sp.Expr) -> sp.Expr:
        for _, condition in e.args:
            for relation in condition.atoms(sp.core.relational.Relational):
                self._alike((relation.lhs, relation.rhs))
        return self._alike([value for value, _ in e.args])

    def _constant(self) -> sp.Expr:
        self.constants.add(self._new())
        return self.spare[-1]

    def _new(self) -> sp.Expr:
        self.spare.append(sp.Symbol(f"_{len(self.spare)}_", real=True))
        return self.spare[-1]


def constraint_rows(relations: Relations, variables: Sequence[sp.Symbol]) -> list[list[int]]:
    """Rows over the variables and, behind them, over what stands for functions.

    Returns
    -------
    list of integer rows (n + number of spare symbols)    their kernel are the weights.
    """
    columns = [*variables, *relations.spare]
    place = {symbol: j for j, symbol in enumerate(columns)}
    rows: list[list[int]] = []
    for number, function in enumerate(relations.invariant):
        symbols = sorted(function.free_symbols, key=place.__getitem__)
        scaled = [s for s in symbols if s not in relations.constants]
        if not scaled:
            continue
        for small in _asked(function, scaled, symbols, number, relations.logarithms):
            rows += _split(dict(zip(scaled, small, strict=True)), relations, place)
    return rows


def _asked(
    function: sp.Expr,
    scaled: list[sp.Symbol],
    symbols: list[sp.Symbol],
    seed: int,
    logarithms: set[sp.Symbol],
) -> list[list[int]]:
    """The reduced rows of (1) for one function, over the symbols that scale."""
    tape = record([function])
    for attempt in range(TRIES):
        rng = np.random.default_rng([seed, attempt])
        try:
            found = [_gradient(tape, scaled, symbols, Modular(prime), rng, logarithms) for prime in PRIMES]
        except BadPoint:
            continue
        rows = rational_rows(*found)
        if rows is not None:
            return [integers(row) for row in rows]
    raise ModelError(
        f"{sp.sstr(function)[:120]} is singular wherever it was tried, or an exponent has over seven digits",
        usually="A denominator is zero whatever the quantities are, or a fitted exponent was not rounded.",
        paste="rates={'x': '-k*x^0.857/(c + x)'}",
        read='docs/symmetries.md, "Rates as text"',
    )


def _gradient(
    tape: Tape,
    scaled: list[sp.Symbol],
    symbols: list[sp.Symbol],
    modular: Modular,
    rng: np.random.Generator,
    logarithms: set[sp.Symbol],
) -> np.ndarray:
    """Slopes of the function at random points, along each symbol that scales."""
    points = len(scaled) + SPARE
    values = {}
    for symbol in symbols:
        value = np.zeros((points, 1 + len(scaled)), dtype=np.int64)
        value[:, 0] = modular.draw(rng, points)
        if symbol in scaled:  # the slope along ln z is z, and of ln z itself it is one
            value[:, 1 + scaled.index(symbol)] = 1 if symbol in logarithms else value[:, 0]
        values[symbol.name] = value
    return run(tape, modular, values)[0][:, 1:]


def _split(row: dict[sp.Symbol, int], relations: Relations, place: dict) -> list[list[int]]:
    """A row taken apart by kinds of exponent: 1, n, n^2, ... each must vanish by itself."""
    kinds: dict[sp.Expr, list[int]] = {}
    for symbol, entry in row.items():
        kind, target = UNIT, symbol
        while target in relations.powers:
            target, more = relations.powers[target]
            kind *= more
        kinds.setdefault(kind, [0] * len(place))[place[target]] += entry
    return [part for part in kinds.values() if any(part)]


def rational_rows(*matrices: np.ndarray) -> list[list[Fraction]] | None:
    """The row space of residues (m, n) modulo each of PRIMES as reduced rows of fractions.

    None where the two do not agree on the pivots, or an entry is no fraction of seven digits: of two primes'
    product any residue is some fraction of nine.
    """
    (first, pivots), (second, others) = (eliminate(m, p) for m, p in zip(matrices, PRIMES, strict=True))
    if pivots != others:
        return None
    modulus = PRIMES[0] * PRIMES[1]
    rows = [
        [fraction_of(joined(x, y, PRIMES), modulus) for x, y in zip(one, other, strict=True)]
        for one, other in zip(first, second, strict=True)
    ]
    small = all(max(abs(x.numerator), x.denominator) <= LARGEST for row in rows for x in row)
    return rows if small else None
