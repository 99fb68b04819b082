"""Expressions of a step program as scaled integers.

Invariant: what is compared, chosen or clamped is compared at one fraction, exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import sympy as sp

from similitude.errors import ProgramError
from similitude.program.fixed import integer as it
from similitude.program.fixed.arithmetic import FEW, Scaled, Value, at, literal, ratio, thin, times, total
from similitude.program.fixed.formats import WIDE_ROOM, Format, format_of, fraction_of
from similitude.program.fixed.slim import Term, odd_part, plain, product, settled
from similitude.program.fixed.slim import total as slim_total


class Expressions:
    """Lowers expressions where ``here`` are constants, ``formats`` fields and ``env`` ranges of now."""

    def __init__(
        self,
        here: Mapping[str, Fraction],
        formats: Mapping[str, Format],
        temporaries: dict[str, Format],
        env: dict[str, tuple[int, int]],
        again: Mapping[tuple[str, Fraction], int] | None = None,
        products: dict[tuple[str, Fraction], tuple[Scaled, Fraction]] | None = None,
    ) -> None:
        self.again, self.products = again or {}, {} if products is None else products
        self.here, self.formats, self.temporaries, self.env = here, formats, temporaries, env
        self.made: list[tuple[str, it.Int]] = []

    def exact(self, e: sp.Basic) -> Fraction:
        """The value of an expression in constants alone."""
        value = self.value(e)
        assert isinstance(value, Fraction), e
        return value

    def value(self, e: sp.Basic, target: Format | None = None, *, full: bool = False) -> Value:
        """An expression; ``target`` is the format it is assigned to, which a division needs.

        ``full``: in 64 bits, as what goes into a wide variable is.
        """
        full = full or (target is not None and target.wide)
        if not full and isinstance(e, sp.Add | sp.Mul | sp.Pow):
            found = self._slim(e, target)
            if found is not None:
                return found
        if isinstance(e, sp.Symbol):
            return self._symbol(e.name)
        if isinstance(e, sp.Rational):
            return Fraction(int(e.p), int(e.q))
        if isinstance(e, sp.Number):
            return Fraction(float(e))
        if isinstance(e, sp.Add):
            most = target.fraction if target is not None and target.wide else None
            return total([self.value(a, full=True) for a in sorted(e.args, key=sp.default_sort_key)], most)
        if isinstance(e, sp.Mul | sp.Pow):
            return self._product(e, target, full=full)
        if isinstance(e, sp.Max | sp.Min):
            return self._extreme(e, target, full=full)
        if isinstance(e, sp.Piecewise):
            return self._piecewise(e, full=full)
        raise ProgramError(
            f"{type(e).__name__} in {sp.sstr(e)[:80]!r} has no fixed-point form",
            usually="A function reached the step that the fixed profile does not know.",
            paste="--real float",
            read="docs/embedded.md, 'Fixed point'",
        )

    def _symbol(self, name: str) -> Value:
        if name in self.here:
            return self.here[name]
        kept = self.formats.get(name) or self.temporaries[name]
        return Scaled(it.name(name, *self.env[name], wide=kept.wide), kept.fraction)

    def _slim(self, e: sp.Expr, target: Format | None) -> Value | None:
        """The expression in 32 bits, or None where it divides or something in it is wider."""
        terms, rest = [], Fraction(0)
        for part in sorted(sp.Add.make_args(e), key=sp.default_sort_key):
            term = self._term(part)
            if term is None:
                return None
            if isinstance(term, Fraction):
                rest += term
            elif term.number:
                terms.append(term)
        if not terms:
            return rest
        fraction = None if target is None else target.fraction
        if len(terms) == 1 and not rest and plain(terms[0].number) is not None:
            value, k = terms[0].value, plain(terms[0].number)
            node = it.neg(value.node) if terms[0].number < 0 else value.node
            return Scaled(node, value.fraction - k)
        return slim_total(terms, rest, fraction, self._shared)

    def _term(self, e: sp.Expr) -> Term | Fraction | None:
        """A product as a value in 32 bits times a number."""
        number, factors = Fraction(1), []
        for factor in sp.Mul.make_args(e):
            base, exponent = factor.as_base_exp()
            if not exponent.is_Integer:
                base, exponent = self._refuse(e), sp.Integer(1)
            lowered = self.value(base)
            if isinstance(lowered, Fraction):
                number *= lowered ** int(exponent)
            elif exponent < 0:
                return None
            else:
                factors += [thin(lowered) if lowered.node.bits <= 31 + FEW else lowered] * int(exponent)
        if not factors:
            return number
        found = product(factors)
        return None if found is None else Term(found, number)

    def _shared(self, term: Term, fraction: int) -> Term:
        """The term by a product that was taken before, or is taken now because it comes again."""
        x, c = term.value.node, abs(term.number)
        power = plain(c)
        if power is not None or x.kind != "name":
            return term
        key = (x.args[0], odd_part(c))
        if self.again.get(key, 0) < 2:
            return term
        if key not in self.products:
            node = settled(Term(term.value, c), fraction)
            if node is None:
                return term
            held = self.atom(node)
            self.products[key] = (Scaled(held, fraction), c)
        made, first = self.products[key]
        return Term(made, term.number / first)

    def _product(self, e: sp.Expr, target: Format | None, *, full: bool = True) -> Value:
        over: list[Value] = []
        under: list[Value] = []
        for factor in sp.Mul.make_args(e):
            base, exponent = factor.as_base_exp()
            if not exponent.is_Integer:
                base, exponent = factor, sp.Integer(1)
            lowered = self.value(base, full=full) if base is not e else self._refuse(e)
            (over if exponent > 0 else under).extend([lowered] * abs(int(exponent)))
        over += [1 / f for f in under if isinstance(f, Fraction)]
        below = self._all([f for f in under if isinstance(f, Scaled)])
        above = self._all(over)
        return above if isinstance(below, Fraction) else self._ratio(above, below, target)

    def _refuse(self, e: sp.Expr) -> Value:
        raise ProgramError(
            f"the power {sp.sstr(e)[:80]!r} is not a whole one",
            usually="A square root or fractional power reached the step.",
            paste="carry the square as the state instead",
            read="docs/embedded.md, 'Fixed point'",
        )

    def _all(self, factors: list[Value]) -> Value:
        """The product; numbers first, then from the narrowest factor to the widest."""
        number = Fraction(1)
        scaled = []
        for f in factors:
            if isinstance(f, Fraction):
                number *= f
            else:
                scaled.append(f)
        if not scaled:
            return number
        scaled.sort(key=lambda s: s.node.bits)
        product: Value = scaled[0]
        for s in scaled[1:]:
            product = times(product, s)
        return times(product, number)

    def _ratio(self, above: Value, below: Scaled, target: Format | None) -> Value:
        if isinstance(above, Fraction) and not above:
            return above
        if target is None or target.wide:
            least = max(below.node.lo, 1) / Fraction(2) ** below.fraction
            most = (abs(above) if isinstance(above, Fraction) else above.magnitude) / least
            target = format_of(float(-most), float(most))
        return ratio(above, below, target)

    def _extreme(self, e: sp.Max | sp.Min, target: Format | None, *, full: bool) -> Value:
        values = [self.value(a, target, full=full) for a in sorted(e.args, key=sp.default_sort_key)]
        is_max = isinstance(e, sp.Max)
        plain = [v for v in values if isinstance(v, Fraction)]
        scaled = [v for v in values if isinstance(v, Scaled)]
        if not scaled:
            return max(plain) if is_max else min(plain)
        best = scaled[0]
        for other in scaled[1:]:
            a, b, fraction = self._aligned(best, other)
            first = it.less(b, a, equal=False) if is_max else it.less(a, b, equal=False)
            best = Scaled(it.choose(first, a, b), fraction)
        for p in plain:
            edge = literal(p, best.fraction).lo
            low, high = (edge, it.MOST) if is_max else (-it.MOST, edge)
            best = Scaled(it.clamp(best.node, low, high), best.fraction)
        return best

    def _aligned(self, a: Scaled, b: Scaled) -> tuple[it.Int, it.Int, int]:
        """Both as variables at one fraction."""
        fraction = max(a.fraction, b.fraction)
        fraction = min(fraction, fraction_of(max(a.magnitude, b.magnitude), WIDE_ROOM))
        return self.atom(at(a, fraction)), self.atom(at(b, fraction)), fraction

    def _piecewise(self, e: sp.Piecewise, *, full: bool) -> Value:
        *cases, (last, _) = e.args
        value = self.value(last, full=full)
        for chosen, condition in reversed(cases):
            this, test = self.value(chosen, full=full), self.condition(condition)
            if isinstance(this, Fraction) and isinstance(value, Fraction):
                whole = max(this.denominator, value.denominator).bit_length() - 1
                a, b, f = literal(this, whole), literal(value, whole), whole
            else:
                f = max(v.fraction for v in (this, value) if isinstance(v, Scaled))
                a, b = at(this, f), at(value, f)
            value = Scaled(it.choose(test, a, b), f)
        return value

    def atom(self, node: it.Int) -> it.Int:
        """The node, or a temporary that holds it where it is more than a variable or a number."""
        if node.kind in ("name", "const"):
            return node
        name = f"held_{len(self.temporaries)}"
        wide = not node.is_narrow
        self.temporaries[name] = Format(0, node.lo, node.hi, wide)
        self.env[name] = (node.lo, node.hi)
        self.made.append((name, node))
        return it.name(name, node.lo, node.hi, wide=wide)

    def tidy(self, value: Value, *, wide: bool) -> Scaled:
        """A value as a temporary keeps it: in 32 bits unless it is to be wide."""
        assert isinstance(value, Scaled)
        return value if wide else thin(value)

    def condition(self, c: sp.Basic) -> it.Cond:
        """A condition."""
        if isinstance(c, sp.And):
            return it.every([self.condition(a) for a in sorted(c.args, key=sp.default_sort_key)])
        if isinstance(c, sp.Or):
            return it.some([self.condition(a) for a in sorted(c.args, key=sp.default_sort_key)])
        if isinstance(c, sp.Not):
            return it.opposite(self.condition(c.args[0]))
        left, right = self.value(c.lhs), self.value(c.rhs)
        if isinstance(c, sp.StrictGreaterThan | sp.GreaterThan):
            left, right = right, left
        equal = isinstance(c, sp.LessThan | sp.GreaterThan)
        return self._less(left, right, equal=equal)

    def _less(self, left: Value, right: Value, *, equal: bool) -> it.Cond:
        if isinstance(left, Fraction) and isinstance(right, Fraction):
            return it.TRUE if left < right or (equal and left == right) else it.FALSE
        if isinstance(right, Fraction):  # x < c: the last integer that is still below
            edge = right * Fraction(2) ** left.fraction
            last = edge.__floor__() if equal or edge.denominator != 1 else int(edge) - 1
            return it.less(left.node, it.const(_near(last)), equal=True)
        if isinstance(left, Fraction):
            edge = left * Fraction(2) ** right.fraction
            first = edge.__ceil__() if equal or edge.denominator != 1 else int(edge) + 1
            return it.less(it.const(_near(first)), right.node, equal=True)
        fraction = min(
            max(left.fraction, right.fraction), fraction_of(max(left.magnitude, right.magnitude), WIDE_ROOM)
        )
        return it.less(at(left, fraction), at(right, fraction), equal=equal)


def _near(edge: int) -> int:
    return min(max(edge, -it.MOST), it.MOST)
