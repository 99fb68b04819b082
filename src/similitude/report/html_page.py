"""One self-contained HTML page: text that is always escaped, tables, badges and live charts.

Invariant: only `Html` is markup; every other string given to a function of this file is text of
somebody else and is escaped. A page loads nothing from anywhere, and equal parts give equal bytes.

    >>> parts = [section("Rate", paragraph("100 Hz"), figure("speed", chart))]   # doctest: +SKIP
    >>> page("My drive", parts, {"speed": chart})                                # doctest: +SKIP
"""

from __future__ import annotations

import base64
import html
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from importlib import resources

from similitude.report.html_chart import Chart, charts_json

TONES = ("good", "fair", "poor", "bad", "odd", "plain")  # of a badge, each a class of html_page.css


class Html(str):
    """Markup made by this file; everything that is not `Html` is escaped before it is shown."""

    __slots__ = ()


def markup(part: object) -> Html:
    """Turn anything into markup: `Html` stays as it is, all else is escaped text."""
    return part if isinstance(part, Html) else Html(html.escape(_visible(str(part))))


def joined(parts: Iterable[object], between: str = "") -> Html:
    """Put parts behind one another as markup, with escaped text between them."""
    return Html(markup(between).join(markup(part) for part in parts))


def paragraph(*parts: object, quiet: bool = False) -> Html:
    """Write a paragraph; a quiet one is a note."""
    return _element("p", joined(parts), "quiet" if quiet else "")


def strong(part: object) -> Html:
    """Write bold text."""
    return _element("strong", markup(part))


def badge(text: str, tone: str = "plain") -> Html:
    """Write a short word on a coloured ground.

    Parameters
    ----------
    text : str     such as a verdict
    tone : str     one of `TONES`

    Raises
    ------
    KeyError       there is no such tone.
    """
    if tone not in TONES:
        raise KeyError(tone)
    return _element("span", markup(text), f"badge {tone}")


def bullets(items: Iterable[object]) -> Html:
    """Write a list, one item a line."""
    return _element("ul", joined(_element("li", markup(item)) for item in items))


def facts(pairs: Mapping[str, object]) -> Html:
    """Write names with their values, several beside one another where there is room."""
    cells = (
        _element("div", _element("dt", markup(name)) + _element("dd", markup(value)))
        for name, value in pairs.items()
    )
    return _element("dl", joined(cells), "facts")


def table(head: Sequence[object], rows: Iterable[Sequence[object]], *, numeric: Sequence[int] = ()) -> Html:
    """Write a table; the first cell of a row names it.

    Parameters
    ----------
    head : cells of the heading row, as many as each row has
    rows : rows of cells, `Html` or text
    numeric : columns, counted from 0, that are aligned to the right
    """
    sides = ["number" if column in numeric else "" for column in range(len(head))]
    headed = zip(head, sides, strict=True)
    top = joined(_element("th", markup(cell), side, scope="col") for cell, side in headed)
    body = joined(_row(row, sides) for row in rows)
    content = _element("thead", _element("tr", top)) + _element("tbody", body)
    return _element("div", _element("table", Html(content)), "scroll")


def lead(*parts: object) -> Html:
    """Write what a reader must see first, on a ground of its own; a paragraph each."""
    return _element("div", joined(parts), "lead")


def aside(part: object) -> Html:
    """Write text that stands back beside something strong."""
    return _element("span", markup(part), "aside")


def details(title: str, *parts: object) -> Html:
    """Write what only some readers want: closed until its title is clicked."""
    return _element("details", _element("summary", markup(title)) + joined(parts))


def interval(now: tuple[float, float], before: tuple[float, float]) -> Html:
    """Draw a 95 % interval as a bar over the wider grey one of before, on the scale of both.

    Parameters
    ----------
    now, before : (low, high) in one unit, finite.
    """
    low, high = min(now[0], before[0]), max(now[1], before[1])
    scale = 100.0 / (high - low) if high > low else 0.0
    bars = [
        f'<rect class="{kind}" x="{scale * (one[0] - low):.2f}" y="{y}" height="{height}" '
        f'width="{max(scale * (one[1] - one[0]), 1.0):.2f}"></rect>'
        for kind, one, y, height in (("before", before, 4, 6), ("now", now, 1, 12))
    ]
    marks = "".join(bars)
    return Html(f'<svg class="interval" viewBox="0 0 101 14" aria-hidden="true">{marks}</svg>')


def section(title: str, *parts: object) -> Html:
    """Write a section with its heading; its anchor is the title in small letters with hyphens."""
    return _element("section", _element("h2", markup(title)) + joined(parts), id=anchor(title))


def anchor(title: str) -> str:
    """The id of a section: the title in small letters, hyphens for all but letters and digits."""
    return re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-") or "section"


def figure(name: str, chart: Chart) -> Html:
    """Write the place of a chart that `page` gets under the same name.

    Parameters
    ----------
    name : str       small letters, digits and hyphens, once a page
    chart : Chart    its title becomes the caption, which also says when extremes stand for samples
    """
    drawn = chart.y_label + (f" [{chart.unit}]" if chart.unit else "")
    notes = [drawn, *([f"{len(chart.x)} samples by their extremes"] if chart.is_decimated else [])]
    caption = markup(chart.title) + _element("small", markup(", ".join(notes)))
    inside = _element("figcaption", Html(caption)) + _element("div", Html(""), "legend")
    inside += _element("div", Html(""), "plot", style=f"min-height:{chart.height}px")
    return _element("figure", Html(inside), "chart", id=f"chart-{name}")


def picture(title: str, png: bytes) -> Html:
    """Write a PNG picture into the page, with its caption.

    Parameters
    ----------
    title : str     the caption, any text
    png : bytes     of a PNG file
    """
    data = base64.b64encode(png).decode("ascii")
    image = f'<img src="data:image/png;base64,{data}" alt="{html.escape(title)}" style="max-width:100%">'
    return _element("figure", Html(image) + _element("figcaption", markup(title)), "picture")


def page(title: str, parts: Sequence[object], charts: Mapping[str, Chart]) -> str:
    """Compose the whole page.

    Parameters
    ----------
    title : str                  of the window and the top of the page, any text
    parts : sequence             of `Html` (others are escaped), from top to bottom
    charts : mapping             name of each `figure` among the parts -> its chart

    Returns
    -------
    str
        An HTML document that needs no other file, to be written as UTF-8.

    Raises
    ------
    KeyError
        A chart has no figure among the parts.
    """
    body = joined(parts)
    for name in charts:
        if f'id="chart-{name}"' not in body:
            raise KeyError(name)
    return _asset("html_page.html").format(
        title=markup(title),
        hint="Drag over a chart to look closer, double-click to go back; a click on a name hides its line."
        if charts
        else "",
        css=_asset("vendor/uplot/uPlot.min.css") + _asset("html_page.css"),
        body=body,
        data=charts_json(charts),
        uplot=_asset("vendor/uplot/uPlot.iife.min.js"),
        script=_asset("html_page.js"),
    )


def _row(cells: Sequence[object], sides: Sequence[str]) -> Html:
    first, *others = zip(cells, sides, strict=True)
    name = _element("th", markup(first[0]), first[1], scope="row")
    return _element("tr", name + joined(_element("td", markup(cell), side) for cell, side in others))


def _element(tag: str, content: str, kind: str = "", **attributes: str) -> Html:
    """One element around markup; attribute values are escaped."""
    named = {"class": kind, **attributes}
    said = "".join(f' {name}="{html.escape(value)}"' for name, value in named.items() if value)
    return Html(f"<{tag}{said}>{content}</{tag}>")


def _visible(text: str) -> str:
    """Text without control characters, which HTML forbids: a replacement character shows there was one."""
    return re.sub(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff]", "\ufffd", text)


@cache
def _asset(name: str) -> str:
    return resources.files("similitude.report").joinpath(name).read_text(encoding="utf-8")
