"""How large can each variable of a step get? Real intervals through the statements of a program.

Sample fields, and those states that a clamp or a filter bounds, come with a stated range; a sum with
forgetting x <- c x + e is bounded by |e|/(1 - c); every other variable follows from these through gates
and statements: inside a guard, what it compares is known to lie on that side.

Invariant: intervals only ever grow where two ways through a guard meet.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import sympy as sp

from similitude.errors import ProgramError
from similitude.program.ir import Program, Statement, When, walk

Span = tuple[float, float]
ROUNDS = 4  # until the sums that depend on one another are bounded
SETTLED = 1e-9  # of a bound: what a last round may move it by
MARGIN = 1 + 2.0**-12  # over a derived bound: rounding, which comes on top of the real value


@dataclass(frozen=True)
class Ranges:
    """What the lowering is told of a program's variables.

    ``stated`` least and greatest of sample fields, bounded states and temporaries that are clamped;
    ``wide`` those kept in 64 bits; ``whole`` those that count. ``full``: products of narrow variables are
    exact too, in 64 bits, where 29 bits are not enough.
    """

    stated: Mapping[str, Span]
    wide: frozenset[str] = field(default_factory=frozenset)
    whole: frozenset[str] = field(default_factory=frozenset)
    full: bool = False


def bounds(program: Program, constants: Mapping[str, float], ranges: Ranges) -> dict[str, Span]:
    """Least and greatest value of every sample field, state, working value and output.

    Raises
    ------
    ProgramError    a state has no bound: it is neither stated nor a sum with forgetting.
    """
    before = walked(program, constants, ranges)
    found = walked(program, constants, ranges, before)
    states = [s.name for f in program.state for s in f.symbols if s.name not in constants]
    loose = [n for n in states if not _settled(found.get(n), before.get(n))]
    if loose:
        raise ProgramError(
            f"{program.name}: nothing bounds {', '.join(loose)}",
            usually="A state that is no sum with forgetting and whose range was not stated.",
            paste=f"Ranges(stated={{{loose[0]!r}: (-1.0, 1.0)}})",
            read="docs/embedded.md, 'Fixed point'",
        )
    return found


def walked(
    program: Program, constants: Mapping[str, float], ranges: Ranges, found: Mapping[str, Span] | None = None
) -> dict[str, Span]:
    """Spans of every variable after some rounds through the step, whether they have settled or not."""
    found = dict(ranges.stated if found is None else found)
    for _ in range(ROUNDS):
        way = _Walk(ranges.stated)
        way.body(program.step, {**found, **{n: (v, v) for n, v in constants.items()}})
        found = {**way.seen, **ranges.stated}
    return found


def _settled(now: Span | None, before: Span | None) -> bool:
    """Whether a bound is finite and the last round through the statements left it where it was."""
    if now is None or before is None or not all(map(math.isfinite, now)):
        return False
    room = SETTLED * max(map(abs, before))
    return before[0] - room <= now[0] and now[1] <= before[1] + room


class _Walk:
    def __init__(self, stated: Mapping[str, Span]) -> None:
        self.stated = stated
        self.seen: dict[str, Span] = {}

    def body(self, statements: Iterable[Statement], env: dict[str, Span]) -> dict[str, Span]:
        """The environment after the statements."""
        for s in statements:
            if isinstance(s, When):
                inside = self.body(s.body, refined(s.condition, env, True))
                other = self.body(s.otherwise, refined(s.condition, env, False))
                env = {n: hull(inside[n], other[n]) for n in inside.keys() & other.keys()}
                continue
            value = span(s.expression, env)
            if forgotten := _forgetting(s.target, s.expression, env):
                value = forgotten
            if s.target in self.stated:
                low, high = self.stated[s.target]
                value = min(max(value[0], low), high), max(min(value[1], high), low)
            else:
                self.seen[s.target] = hull(value, self.seen.get(s.target, value))
            env = {**env, s.target: value}
        return env


def _forgetting(target: str, expression: sp.Expr, env: dict[str, Span]) -> Span | None:
    """The bound of x where x <- c x + e with a constant 0 < c < 1, or x <- x + p (e - x), 0 <= p <= 1."""
    x = sp.Symbol(target, real=True)
    if x not in expression.free_symbols or not isinstance(expression, sp.Add):
        return None
    kept = sp.diff(expression, x)
    if x in kept.free_symbols or kept == 1:
        return None
    low, high = span(kept, env)
    added = expression.xreplace({x: sp.Integer(0)})
    if low == high and 0 < high < 1:
        least, most = span(added, env)
        room = MARGIN / (1 - high)
    elif (share := span(1 - kept, env))[0] >= 0 and share[1] <= 1:
        least, most = span(sp.cancel(added / (1 - kept)), env)
        room = MARGIN
    else:
        return None
    return min(least, 0.0) * room, max(most, 0.0) * room


def hull(a: Span, b: Span) -> Span:
    """The interval that holds both."""
    return min(a[0], b[0]), max(a[1], b[1])


def span(e: sp.Basic, env: Mapping[str, Span]) -> Span:
    """Interval of an expression; infinite where a divisor may be zero."""
    if isinstance(e, sp.Symbol):
        return env.get(e.name, (-math.inf, math.inf))
    if isinstance(e, sp.Number):
        return float(e), float(e)
    parts = e.args
    if isinstance(e, sp.Add):
        spans = [span(p, env) for p in parts]
        return math.fsum(s[0] for s in spans), math.fsum(s[1] for s in spans)
    if isinstance(e, sp.Mul):
        return _product([span(p, env) for p in parts])
    if isinstance(e, sp.Pow):
        return _power(span(e.base, env), int(e.exp))
    if isinstance(e, sp.Max | sp.Min):
        spans = [span(p, env) for p in parts]
        pick = max if isinstance(e, sp.Max) else min
        return pick(s[0] for s in spans), pick(s[1] for s in spans)
    if isinstance(e, sp.Piecewise):
        spans = [span(value, refined(condition, env, True)) for value, condition in parts]
        return min(s[0] for s in spans), max(s[1] for s in spans)
    raise ProgramError(
        f"{type(e).__name__} has no interval here",
        usually="A function reached the step that the fixed profile does not know.",
        paste="--real float",
        read="docs/embedded.md, 'Fixed point'",
    )


def _product(spans: list[Span]) -> Span:
    low = high = 1.0
    for a, b in spans:
        corners = [0.0 if 0.0 in (x, y) else x * y for x in (low, high) for y in (a, b)]
        low, high = min(corners), max(corners)
    return low, high


def _power(base: Span, exponent: int) -> Span:
    if exponent < 0:
        if base[0] <= 0 <= base[1]:
            return -math.inf, math.inf
        return _power((1 / base[1], 1 / base[0]), -exponent)
    corners = [base[0] ** exponent, base[1] ** exponent]
    if exponent % 2 == 0 and base[0] <= 0 <= base[1]:
        corners.append(0.0)
    return min(corners), max(corners)


def refined(condition: sp.Basic, env: Mapping[str, Span], holds: bool) -> dict[str, Span]:
    """The environment where a condition is known to hold, or not to."""
    new = dict(env)
    for low, symbol, high in _compared(condition, env, holds):
        a, b = new.get(symbol, (-math.inf, math.inf))
        a, b = max(a, low), min(b, high)
        new[symbol] = (a, b) if a <= b else (new[symbol][0], new[symbol][0])
    return new


def _compared(
    condition: sp.Basic, env: Mapping[str, Span], holds: bool
) -> Iterable[tuple[float, str, float]]:
    """Least, name, greatest of every variable that a condition compares."""
    if isinstance(condition, sp.Not):
        yield from _compared(condition.args[0], env, not holds)
    elif isinstance(condition, sp.And if holds else sp.Or):
        for part in condition.args:
            yield from _compared(part, env, holds)
    elif isinstance(condition, sp.core.relational.Relational):
        left, right = condition.lhs, condition.rhs
        is_less = isinstance(condition, sp.StrictLessThan | sp.LessThan) == holds
        below, above = (left, right) if is_less else (right, left)
        if isinstance(below, sp.Symbol):
            yield -math.inf, below.name, span(above, env)[1]
        if isinstance(above, sp.Symbol):
            yield span(below, env)[0], above.name, math.inf


def read_names(program: Program) -> set[str]:
    """Every name that the step reads."""
    return {
        s.name
        for node in walk(program.step)
        for s in (node.condition if isinstance(node, When) else node.expression).free_symbols
    }
