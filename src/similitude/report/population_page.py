"""A population as one HTML page and as a terminal page: groups, relations, pictures, what it rests on.

Invariant: every text of a table is escaped, and nothing depends on when or where it was written.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

from similitude.populations.monomial import monomial_text
from similitude.report.html_page import Html, bullets, facts, lead, page, paragraph, picture, section, strong
from similitude.report.html_page import table as html_table
from similitude.report.numerals import plain, pretty_name
from similitude.report.population_pictures import (
    distribution_picture,
    pairs_picture,
    png,
    running_average_picture,
)

if TYPE_CHECKING:
    from similitude.populations.portrait import Portrait
    from similitude.populations.relations import Relation

MOST_DISTRIBUTIONS = 8
FEWEST_DRAWN = 5  # values that a histogram needs
RELATION_HEAD = ("relation", "", "95 %", "out of sample", "systems", "p")
GROUP_HEAD = ("group", "formula", "systems", "typical", "95 % of systems", "skew raw", "skew log")


def population_html(portrait: Portrait) -> str:
    """Compose the page.

    Parameters
    ----------
    portrait : Portrait    from `similitude.populations.portrait.portray`.

    Returns
    -------
    str                    an HTML document that needs no other file.
    """
    table = portrait.population.table
    parts = [
        lead(paragraph(strong(f"{len(table)} systems of {table.model.name}"),
                       f", weight {table.weight.sum():.4g}")),
        section("Groups", html_table(GROUP_HEAD, group_rows(portrait), numeric=range(2, 7))),
        section("Relations",
                html_table(RELATION_HEAD, map(relation_row, portrait.shown_relations), numeric=(3, 4, 5)),
                paragraph(_tried(portrait), quiet=True)),
        *_pictures(portrait),
        section("What it rests on", facts({s: f"{n} rows" for s, n in _sources(portrait).items()})),
    ]  # fmt: skip
    if portrait.notes:
        parts.append(section("Notes", bullets(portrait.notes)))
    return page(f"Population of {table.name}", parts, {})


def print_population(portrait: Portrait, console: Console) -> None:
    """Print groups, relations and notes."""
    table = portrait.population.table
    console.print(f"[bold]{len(table)} systems[/] of {table.model.name}, {table.name}")
    for head, rows, title in (
        (GROUP_HEAD, group_rows(portrait), "Groups"),
        (RELATION_HEAD, map(relation_row, portrait.shown_relations), "Relations"),
    ):
        shown = Table(title=title, box=box.SIMPLE_HEAD, title_justify="left")
        for name in head:
            shown.add_column(name, justify="left" if name in (*head[:2], "95 %") else "right")
        for row in rows:
            shown.add_row(*map(str, row))
        console.print(shown)
    console.print(_tried(portrait))
    for note in portrait.notes:
        console.print(f"- {note}", markup=False)


def group_rows(portrait: Portrait) -> list[list[str]]:
    """One row a group, for either page."""
    rows = []
    for j, (name, product) in enumerate(portrait.products.items()):
        d = portrait.distributions.get(name)
        mean, sd = portrait.mean[j], np.sqrt(portrait.covariance[j, j])
        taught = np.isfinite(mean)
        low, high = (np.exp(mean + s * 1.96 * sd) if taught else np.nan for s in (-1, 1))
        skews = ["–" if d is None or s is None else f"{s:+.2f}" for s in
                 ((None, None) if d is None else (d.skew_raw, d.skew_log))]  # fmt: skip
        rows.append([
            pretty_name(name) if name.startswith("pi") else name, monomial_text(product),
            str(0 if d is None else d.n), plain(float(np.exp(mean))) if taught else "–",
            f"{plain(float(low))} to {plain(float(high))}" if taught else "–", *skews,
        ])  # fmt: skip
    return rows


def relation_row(one: Relation) -> list[str]:
    """One relation, for either page."""
    if one.kind == "constraint":
        return [one.text, "exact", "", "", str(one.n), ""]
    ends = f"{one.interval[0]:.4g} to {one.interval[1]:.4g}"
    word = "found" if one.found else "too few systems to prove"
    loss = "" if one.loss is None else f", output {100 * one.loss:.2g} %"
    return [one.text, word, ends, f"{100 * one.out_of_sample:.3g} %{loss}", str(one.n), f"{one.p:.2g}"]


def _tried(portrait: Portrait) -> str:
    r = portrait.relations
    many = "1 relation was" if r.tried == 1 else f"{r.tried} relations were"
    return (
        f"{many} tried against independent raw parameters given the shared base; of those called found, "
        f"{100 * r.level:g} % may be chance."
    )


def _sources(portrait: Portrait) -> dict[str, int]:
    sources = portrait.population.table.sources
    return {source: sources.count(source) for source in sorted(set(sources))}


def _pictures(portrait: Portrait) -> list[Html]:
    drawn = {n: x for n, x in portrait.values.items() if np.isfinite(x).sum() >= FEWEST_DRAWN}
    table = portrait.population.table
    raw = {n: table.value[:, j] for j, n in enumerate(table.names)}
    raw = {n: x for n, x in raw.items() if np.isfinite(x).sum() >= FEWEST_DRAWN and n not in drawn}
    shown = sorted({**drawn, **raw}.items(), key=lambda one: -np.isfinite(one[1]).sum())
    said = "The line is the normal distribution of the same mean and sd; red is what it puts below zero."
    histograms = [picture(png(distribution_picture(x, n)), n) for n, x in shown[:MOST_DISTRIBUTIONS]]
    parts = [section("Distributions", paragraph(said), *histograms)]
    pairs = pairs_picture(portrait.population.logs, portrait.population.names)
    if pairs is not None:
        said = "Logarithmic axes; lines of total least squares."
        parts.append(section("Pairs", picture(png(pairs), said)))
    if drawn:
        most = dict(sorted(drawn.items(), key=lambda one: -np.isfinite(one[1]).sum())[:3])
        said = "One order of the systems, and 95 % of 200 orders."
        parts.append(section("Running averages", picture(png(running_average_picture(most)), said)))
    return parts
