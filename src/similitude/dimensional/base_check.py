"""BaseCheck: whether named variables can be a base, and if not, why not and what would make them one.

Invariant: a base is valid exactly when its dimensions are independent and every variable lies in what
they span; a completion that is listed makes it valid.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice

from similitude.dimensional.exact_span import Column, Span, leading, smallest_integers
from similitude.dimensional.matrix import DimensionMatrix, column_text

MOST_COMPLETIONS = 6  # as many as a reader looks at


@dataclass(frozen=True)
class BaseCheck:
    """What a base can and cannot do for a set of variables.

    Parameters
    ----------
    base : the names as given.
    spans : the independent dimensions it reaches, in SI symbols.
    product : exponents [-] of a product of its own variables that has no dimension; empty where its
        dimensions are independent.
    kept : the first of its variables that are independent of those before them.
    unreached : the variables it cannot measure, with their dimensions in SI symbols.
    lonely : those of the unreached that no other variables can cancel: they are in no group at all.
    completions : sets of variables any of which makes ``kept`` a base, at most six.
    rank : how many variables a base of these variables has.
    """

    base: tuple[str, ...]
    spans: tuple[str, ...]
    product: Mapping[str, Fraction]
    kept: tuple[str, ...]
    unreached: Mapping[str, str]
    lonely: tuple[str, ...]
    completions: tuple[tuple[str, ...], ...]
    rank: int

    @property
    def valid(self) -> bool:
        """Whether it is a base."""
        return not self.product and not self.unreached

    @property
    def reason(self) -> str:
        """In words: that it is valid, or why it is not and what would make it so."""
        reached = f"it spans {', '.join(self.spans) or 'nothing'}"
        if self.valid:
            return f"valid; {reached} and reaches every variable"
        clauses = []
        if self.product:
            clauses.append(f"its variables are dependent, {product_text(self.product)} has no dimension")
        if self.unreached and self.product:
            clauses.append(f"its rank is {len(self.spans)}, the variables have rank {self.rank}")
        elif self.unreached:
            clauses.append(f"it has too few variables, {len(self.base)} where these need {self.rank}")
        clauses.append(reached)
        if self.unreached:
            some = [f"{name} [{text}]" for name, text in islice(self.unreached.items(), 4)]
            more = len(self.unreached) - len(some)
            clauses.append(f"it does not reach {', '.join(some)}" + (f" and {more} more" if more else ""))
        clauses += [self._alone(name) for name in self.lonely]
        if self.completions:
            ways = " or ".join(", ".join(names) for names in self.completions)
            begun = f"{', '.join(self.kept)} with {ways}" if self.kept else ways
            clauses.append(f"a base would be {begun}" if ways else f"{', '.join(self.kept)} would do")
        return "; ".join(clauses)

    def _alone(self, name: str) -> str:
        return (
            f"no other variable can cancel the dimension of {name} [{self.unreached[name]}], so {name} can be"
            f" in no group: leave it out, or give it a partner"
        )


def product_text(exponents: Mapping[str, Fraction]) -> str:
    """A product of powers, such as ``a/L`` or ``mu/(rho V D)``; ``1`` for the empty one."""
    above = [_power(name, x) for name, x in exponents.items() if x > 0]
    below = [_power(name, -x) for name, x in exponents.items() if x < 0]
    over = " ".join(above) or "1"
    if not below:
        return over
    return f"{over}/{below[0] if len(below) == 1 else '(' + ' '.join(below) + ')'}"


def _power(name: str, x: Fraction) -> str:
    if x == 1:
        return name
    return f"{name}^{x}" if x.denominator == 1 else f"{name}^({x})"


def check_base(
    matrix: DimensionMatrix, base: Sequence[str], candidates: Sequence[str] | None = None
) -> BaseCheck:
    """Look at a base.

    Parameters
    ----------
    matrix : DimensionMatrix   of everything the base has to measure.
    base : different names of variables.
    candidates : names that may complete it; all variables when left out.

    Returns
    -------
    BaseCheck
    """
    columns = [matrix.column(name) for name in base]
    places, span = leading(columns, len(matrix.rows))
    kept = tuple(base[place] for place in places)
    unreached = {
        name: column_text(column)
        for name, column in zip(matrix.names, matrix.columns, strict=True)
        if not span.holds(column)
    }
    product = next((_product(base, columns, kept, span, p) for p in range(len(base)) if p not in places), {})
    names = matrix.names if candidates is None else candidates
    wanted = independent_sets(matrix, names, span)
    valid = not product and not unreached
    return BaseCheck(
        base=tuple(base),
        spans=tuple(_spanned(columns)),
        product=product,
        kept=kept,
        unreached=unreached,
        lonely=tuple(name for name in lonely(matrix) if name in unreached),
        completions=() if valid else tuple(islice(wanted, MOST_COMPLETIONS)),
        rank=matrix.rank,
    )


def _product(base, columns, kept, span: Span, place: int) -> dict[str, Fraction]:
    names = (*kept, base[place])
    exponents = smallest_integers((*(-x for x in span.exponents(columns[place])), Fraction(1)))
    if exponents[-1] < 0:
        exponents = tuple(-x for x in exponents)
    return {name: Fraction(x) for name, x in sorted(zip(names, exponents, strict=True), key=_last_first) if x}


def _last_first(pair: tuple[str, int]) -> bool:
    return pair[1] < 0


def lonely(matrix: DimensionMatrix) -> tuple[str, ...]:
    """The variables that are in no dimensionless product: nothing else cancels their dimension."""
    places, span = matrix.leading
    used = [False] * span.rank
    for column in {c for place, c in enumerate(matrix.columns) if place not in places}:
        used = [was or bool(x) for was, x in zip(used, span.exponents(column), strict=True)]
    return tuple(matrix.names[place] for place, was in zip(places, used, strict=True) if not was)


def independent_sets(matrix: DimensionMatrix, names: Sequence[str], span: Span) -> Iterator[tuple[str, ...]]:
    """Sets of variables that widen a span until it holds everything, one after the other.

    Parameters
    ----------
    matrix : DimensionMatrix   of everything that has to be reached.
    names : candidates; sets are made in this order, lexicographically, and only when asked for.
    span : where to start; `empty_span` for whole bases.

    Yields
    ------
    names of one set, in the order of the candidates; nothing where the candidates do not suffice.
    """
    columns = [matrix.column(name) for name in names]
    size = len(matrix.rows)
    # What the candidates from each place on can still add: a dead end is seen before it is entered.
    later: list[tuple[Column, ...]] = [()]
    for column in reversed(columns):
        kept = leading((column, *later[-1]), size)[0]
        later.append(tuple((column, *later[-1])[place] for place in kept))
    later.reverse()

    def suffices(held: Span, place: int) -> bool:
        for column in later[place]:
            held = held.extended(column) or held
        return held.rank == matrix.rank

    def grow(held: Span, place: int) -> Iterator[tuple[str, ...]]:
        if held.rank == matrix.rank:
            yield ()
            return
        for at in range(place, len(columns)):
            if not suffices(held, at):
                return
            wider = held.extended(columns[at])
            if wider is not None:
                yield from ((names[at], *rest) for rest in grow(wider, at + 1))

    if span.rank == matrix.rank or suffices(span, 0):
        yield from grow(span, 0)


def _spanned(columns: Sequence[Column]) -> list[str]:
    """The reduced row echelon form of the columns, as rows: the plainest dimensions they span."""
    rows = [list(map(Fraction, column)) for column in columns]
    found: list[list[Fraction]] = []
    for k in range(len(rows[0]) if rows else 0):
        lead = next((row for row in rows if row[k]), None)
        if lead is None:
            continue
        rows.remove(lead)
        lead = [x / lead[k] for x in lead]
        rows = [[x - row[k] * y for x, y in zip(row, lead, strict=True)] for row in rows]
        found = [[x - row[k] * y for x, y in zip(row, lead, strict=True)] for row in found] + [lead]
    return [column_text(tuple(map(Fraction, smallest_integers(row)))) for row in found]
