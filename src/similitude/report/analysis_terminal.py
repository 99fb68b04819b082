"""An Analysis as one page on the terminal: what removes what, then each part by itself.

Invariant: fits 80 columns where names are short; long formulas break between terms.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from rich.console import Console, Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from similitude.dimensional.matrix import SYMBOLS
from similitude.report.analysis_words import (
    AFTER,
    account,
    headline,
    moved,
    residual_words,
    rewrite_words,
    rows_are_empty,
    seen_words,
)
from similitude.report.numerals import pretty_unit
from similitude.report.typeset import plain_formula, plain_name, plain_product

if TYPE_CHECKING:
    from similitude.analysis.analysis import Analysis, CheckedRow
    from similitude.symmetry.identifiability import Identifiability

HEADING, QUIET, VALUE = "bold cyan", "dim", "bold"


def print_analysis(found: Analysis, console: Console) -> None:
    """Print the page on a console, whose width decides the line breaks."""
    console.print(analysis_page(found))


def analysis_page(found: Analysis) -> Group:
    """Compose the page.

    Parameters
    ----------
    found : Analysis
    """
    source = f"\n{found.model.source}" if found.model.source else ""
    parts = [
        Text.assemble(("\n" + found.model.name, VALUE), (f" · {headline(found)}{source}", QUIET)),
        _section("What removes what", _rows(account(found))),
        _section("Dimensions", _dimensions(found)),
        _section("Invariances of the sensitivities S = d ln y/d ln x", _invariances(found)),
        _section("Pi groups", _groups(found)),
        _section("Rewritten", _rewritten(found)),
        _section("Scalings", _scalings(found)),
        _section("What the outputs tell", _told(found)),
    ]
    return Group(*parts, Text())


def _section(title: str, body) -> Group:
    return Group(Text("\n" + title, style=HEADING), Padding(body, (0, 0, 0, 2)))


def _grid(*titles: str) -> Table:
    table = Table(box=None, show_header=bool(titles), padding=(0, 2, 0, 0), pad_edge=False)
    for title in titles:
        table.add_column(title, header_style=QUIET)
    return table


def _rows(rows) -> Table:
    table = _grid()
    for name, value, meaning in rows:
        table.add_row(Text(name), Text(value, style=VALUE, no_wrap=True), Text(meaning, style=QUIET))
    return table


def _dimensions(found: Analysis) -> Table:
    """One row a variable; dimensions that nothing has are left out."""
    matrix = found.matrix
    used = [i for i in range(len(matrix.rows)) if any(column[i] for column in matrix.columns)]
    table = _grid("", "unit", *(SYMBOLS[i] for i in used), "")
    known = {q.name: q for q in found.model.quantities}
    for name, column in zip(matrix.names, matrix.columns, strict=True):
        unit = known[name].unit if name in known else found.model.time_unit
        meaning = known[name].meaning if name in known else "time"
        cells = (Text(str(column[i]) if column[i] else "·", justify="right") for i in used)
        table.add_row(
            Text(plain_name(name), style=VALUE), pretty_unit(unit) or "-", *cells, Text(meaning, style=QUIET)
        )
    return table


def _invariances(found: Analysis) -> Group | Text:
    if not found.invariances:
        return Text("There is no output, or nothing has a dimension.", style=QUIET)
    table = _grid("output", "dimension", "", "residual")
    before = None
    for row in found.invariances:
        output = "" if row.output == before else plain_name(row.output)
        table.add_row(Text(output, style=VALUE), row.dimension, _row_text(row), Text(residual_words(row)))
        before = row.output
    return Group(table, Text(AFTER, style=QUIET)) if rows_are_empty(found) else Group(table)


def _row_text(row: CheckedRow) -> str:
    terms = [f"{_sign(c, i)}{_size(c)}S_{plain_name(n)}" for i, (n, c) in enumerate(row.coefficients.items())]
    return f"{''.join(terms) or '0'} = {row.rhs}"


def _sign(c: Fraction, place: int) -> str:
    return ("-" if c < 0 else "") if place == 0 else (" - " if c < 0 else " + ")


def _size(c: Fraction) -> str:
    size = abs(Fraction(c))
    return "" if size == 1 else f"{size} " if size.denominator == 1 else f"({size}) "


def _groups(found: Analysis) -> Group | Table:
    table = _grid()
    for group in found.groups:
        name = Text(plain_name(group.name), style=VALUE, no_wrap=True)
        table.add_row(name, "=", Text(plain_product(group.exponents)), Text(group.meaning, style=QUIET))
    if not found.groups:
        return Text("none", style=QUIET)
    if found.rewritten is None:
        return Group(table, Text(f"No base of parameters: {found.why}.", style=QUIET))
    origin = f" ({found.base_origin})" if found.base_origin else ""
    return Group(table, Text(f"base {', '.join(found.base) or 'of nothing'}{origin}", style=QUIET))


def _rewritten(found: Analysis) -> Group | Text:
    if found.rewritten is None:
        return Text("No base of parameters measures every state, input and output.", style=QUIET)
    groups, model, time = found.rewritten.groups, found.model, found.equations.time
    signals = [q.name for kind in (model.states, model.inputs, model.outputs) for q in kind]
    scaled = {n: groups.scale[n] for n in dict.fromkeys(signals) if groups.scale[n] != 1}
    if groups.time_scale != 1:
        scaled[time] = groups.time_scale
    stars = set(scaled)
    equations = _grid()
    for name, rate in groups.rates.items():
        left = f"d{plain_name(name, stars)}/d{plain_name(time, stars)}"
        equations.add_row(Text(left, style=VALUE, no_wrap=True), "=", Text(plain_formula(rate, stars)))
    for name, value in {**groups.output_map, **groups.constraints}.items():
        if name not in groups.rates:
            left = Text(plain_name(name, stars), style=VALUE)
            equations.add_row(left, "=", Text(plain_formula(value, stars)))
    back = ", ".join(f"{plain_name(n)} = {_measured(n, e, stars)}" for n, e in scaled.items())
    said = [f"back: {back}" if back else "everything is a pure number already", *rewrite_words(found)]
    return Group(equations, *(Text(line, style=QUIET) for line in said))


def _measured(name: str, scale, stars: set[str]) -> str:
    """A starred name times its scale: ``t* L/U``, ``t*/k``."""
    product = plain_product(_powers(scale))
    star = plain_name(name, stars)
    return f"{star}{product[1:]}" if product.startswith("1/") else f"{star} · {product}"


def _powers(monomial) -> dict[str, Fraction]:
    return {b.name: Fraction(int(p.p), int(p.q)) for b, p in monomial.as_powers_dict().items() if b.is_Symbol}


def _scalings(found: Analysis) -> Group:
    scalings, check = found.scalings, found.check
    proven = "checked at random points" if check else f"check failed: {check}"
    if check.missed > 0:
        proven = f"{check.missed} more exist that no powers of these functions show"
    lines = [Text(f"{scalings.count} in all, {found.units} of them units; {proven}.")]
    for row in found.beyond:
        lines.append(Text.assemble(("together  ", QUIET), moved({plain_name(n): p for n, p in row.items()})))
    invariants = ",  ".join(plain_product(group) for group in scalings.invariants)
    lines.append(Text.assemble(("unchanged  ", QUIET), invariants or "nothing"))
    return Group(*lines)


def _told(found: Analysis) -> Group:
    parts = [_seen(found.seen, ())]
    if found.steady is not None and found.steady != found.seen:
        parts += [Text(), _seen(found.steady, found.model.signals)]
    return Group(*parts)


def _seen(seen: Identifiability, held: tuple[str, ...]) -> Group:
    lines = [Text(seen_words(seen, held))]
    table = _grid()
    if seen.seen and not seen.is_complete:
        table.add_row(Text("tells", style=QUIET), Text(",  ".join(plain_product(one) for one in seen.seen)))
    for direction in seen.unseen:
        own = {plain_name(n): p for n, p in direction.items() if n in seen.parameters}
        together = " scaled together" if len(own) > 1 else ""
        table.add_row(Text("cannot see", style=QUIET), Text(moved(own) + together))
    for direction in seen.shifts:
        own = {n: Fraction(w) for n, w in direction.items() if n in seen.parameters}
        added = "".join(f"{_sign(w, i)}{_size(w)}{plain_name(n)}" for i, (n, w) in enumerate(own.items()))
        table.add_row(Text("cannot see", style=QUIET), Text(f"what is added along {added}"))
    if seen.curved > len(seen.shifts):
        of = ", ".join(plain_name(n) for n in seen.involved)
        more = seen.curved - len(seen.shifts)
        table.add_row(Text("cannot see", style=QUIET), Text(f"{more} more, no power law, in {of}"))
    if seen.hidden_states:
        hidden = ", ".join(plain_name(n) for n in seen.hidden_states)
        table.add_row(Text("cannot see", style=QUIET), Text(f"where {hidden} started"))
    return Group(*lines, *([table] if table.row_count else []))
