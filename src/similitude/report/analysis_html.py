"""An Analysis as one HTML page: the sections of the terminal with typeset mathematics, no network.

Invariant: every text of a model is escaped; equal analyses give equal bytes.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

import sympy as sp

from similitude.dimensional.matrix import SYMBOLS
from similitude.report.analysis_words import (
    AFTER,
    account,
    headline,
    residual_words,
    rewrite_words,
    rows_are_empty,
    seen_words,
)
from similitude.report.html_page import Html, bullets, joined, lead, page, paragraph, section, strong, table
from similitude.report.numerals import pretty_unit
from similitude.report.typeset import math, math_product, math_rate

if TYPE_CHECKING:
    from similitude.analysis.analysis import Analysis, CheckedRow
    from similitude.symmetry.identifiability import Identifiability


def analysis_html(found: Analysis) -> str:
    """Compose the page.

    Parameters
    ----------
    found : Analysis

    Returns
    -------
    str    an HTML document that needs no other file
    """
    removed = table(["", "", ""], account(found), numeric=(1,))
    head = [
        paragraph(headline(found).capitalize(), "."),
        *([paragraph(found.model.source, quiet=True)] * bool(found.model.source)),
    ]
    parts = [
        lead(*head),
        section("The equations", _equations(found)),
        section("What removes what", removed),
        section("Dimensions", _dimensions(found)),
        section("Invariances", _invariances(found)),
        section("Pi groups", _groups(found)),
        section("Rewritten", _rewritten(found)),
        section("Scalings", *_scalings(found)),
        section("What the outputs tell", *_told(found)),
    ]
    return page(found.model.name, parts, {})


def _lines(rows) -> Html:
    """Equations below one another."""
    return joined(paragraph(left, Html(" <math><mo>=</mo></math> "), right) for left, right in rows)


def _equations(found: Analysis) -> Html:
    time = found.equations.time
    rows = [(math_rate(name, time=time), math(rate)) for name, rate in found.model.rates.items()]
    others = {**found.model.output_map, **found.model.constraints}
    rows += [(_name(n), math(sp.sympify(e))) for n, e in others.items() if n not in found.model.rates]
    return _lines(rows)


def _name(name: str, starred: Collection[str] = ()) -> Html:
    return math_product({name: Fraction(1)}, starred)


def _dimensions(found: Analysis) -> Html:
    matrix = found.matrix
    used = [i for i in range(len(matrix.rows)) if any(column[i] for column in matrix.columns)]
    known = {q.name: q for q in found.model.quantities}
    rows = []
    for name, column in zip(matrix.names, matrix.columns, strict=True):
        unit = known[name].unit if name in known else found.model.time_unit
        meaning = known[name].meaning if name in known else "time"
        exponents = [str(column[i]) if column[i] else "" for i in used]
        rows.append([_name(name), pretty_unit(unit) or "-", *exponents, meaning])
    head = ["", "unit", *(SYMBOLS[i] for i in used), "meaning"]
    return table(head, rows, numeric=range(2, 2 + len(used)))


def _invariances(found: Analysis) -> Html:
    if not found.invariances:
        return paragraph("There is no output, or nothing has a dimension.", quiet=True)
    note = paragraph(
        math(sp.Symbol("S_x")), Html(" <math><mo>=</mo></math> "), "d ln y/d ln x, y the output.", quiet=True
    )
    rows = [[_name(row.output), row.dimension, _row(row), residual_words(row)] for row in found.invariances]
    after = [paragraph(AFTER, quiet=True)] if rows_are_empty(found) else []
    return joined([note, table(["output", "dimension", "", "residual"], rows), *after])


def _row(row: CheckedRow) -> Html:
    parts = []
    for i, (name, c) in enumerate(row.coefficients.items()):
        sign = ("<mo>−</mo>" if c < 0 else "") if i == 0 else f"<mo>{'−' if c < 0 else '+'}</mo>"
        size = abs(Fraction(c))
        number = "" if size == 1 else f"<mn>{size}</mn>"
        parts.append(f"{sign}{number}<msub><mi>S</mi>{_inside(name)}</msub>")
    return Html(f"<math>{''.join(parts) or '<mn>0</mn>'}<mo>=</mo><mn>{row.rhs}</mn></math>")


def _inside(name: str) -> str:
    return f"<mrow>{_name(name).partition('>')[2].removesuffix('</math>')}</mrow>"


def _groups(found: Analysis) -> Html:
    rows = [[_name(g.name), math_product(g.exponents), g.meaning] for g in found.groups]
    if found.rewritten is None:
        note = f"No base of parameters: {found.why}."
    else:
        origin = f" ({found.base_origin})" if found.base_origin else ""
        note = f"Base {', '.join(found.base) or 'of nothing'}{origin}."
    return joined([table(["", "", "meaning"], rows), paragraph(note, quiet=True)])


def _rewritten(found: Analysis) -> Html:
    if found.rewritten is None:
        return paragraph("No base of parameters measures every state, input and output.", quiet=True)
    groups, model, time = found.rewritten.groups, found.model, found.equations.time
    signals = dict.fromkeys(q.name for kind in (model.states, model.inputs, model.outputs) for q in kind)
    scaled = {n: groups.scale[n] for n in signals if groups.scale[n] != 1}
    scaled |= {time: groups.time_scale} if groups.time_scale != 1 else {}
    stars = set(scaled)
    rows = [(math_rate(name, stars, time), math(rate, stars)) for name, rate in groups.rates.items()]
    others = {**groups.output_map, **groups.constraints}
    rows += [(_name(n, stars), math(e, stars)) for n, e in others.items() if n not in groups.rates]
    back = joined((_back(n, e, stars) for n, e in scaled.items()), ", ")
    said = [paragraph("Back: ", back, quiet=True)] if scaled else []
    return joined([_lines(rows), *said, *(paragraph(line, quiet=True) for line in rewrite_words(found))])


def _back(name: str, scale: sp.Expr, stars: Collection[str]) -> Html:
    return joined(
        [_name(name), Html(" <math><mo>=</mo></math> "), _name(name, stars), Html(" "), math(scale)]
    )


def _scalings(found: Analysis) -> list[Html]:
    scalings, check = found.scalings, found.check
    proven = "checked at random points" if check else f"check failed: {check}"
    if check.missed > 0:
        proven = f"{check.missed} more exist that no powers of these functions show"
    parts = [paragraph(f"{scalings.count} in all, {found.units} of them units; {proven}.")]
    if found.beyond:
        parts.append(paragraph("Beyond the units, what may be scaled together:"))
        parts.append(bullets(_together(row) for row in found.beyond))
    invariants = joined((math_product(group) for group in scalings.invariants), ", ")
    return [*parts, paragraph(strong("Unchanged by all of them: "), invariants or "nothing")]


def _together(row: Mapping[str, int]) -> Html:
    return joined((math_product({name: Fraction(power)}) for name, power in row.items()), ", ")


def _told(found: Analysis) -> list[Html]:
    parts = _seen(found.seen, ())
    if found.steady is not None and found.steady != found.seen:
        parts += _seen(found.steady, found.model.signals)
    return parts


def _seen(seen: Identifiability, held: tuple[str, ...]) -> list[Html]:
    parts, items = [paragraph(seen_words(seen, held))], []
    parameters = set(seen.parameters)
    if seen.seen and not seen.is_complete:
        items.append(joined(["Tells ", joined((math_product(one) for one in seen.seen), ", ")]))
    for direction in seen.unseen:
        own = {name: power for name, power in direction.items() if name in parameters}
        items.append(joined(["Cannot see ", _together(own), " scaled together" if len(own) > 1 else ""]))
    for direction in seen.shifts:
        terms = sp.Add(*(w * sp.Symbol(n, real=True) for n, w in direction.items() if n in parameters))
        items.append(joined(["Cannot see what is added along ", math(terms)]))
    if seen.curved > len(seen.shifts):
        of = joined((_name(name) for name in seen.involved), ", ")
        items.append(joined([f"Cannot see {seen.curved - len(seen.shifts)} more, no power law, in ", of]))
    if seen.hidden_states:
        items.append(joined(["Cannot see where ", joined(map(_name, seen.hidden_states), ", "), " started"]))
    return [*parts, bullets(items)] if items else parts
