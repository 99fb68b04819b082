"""A chart of an HTML page as a value, and the compact JSON a page carries for it.

Invariant: no line has more than 4000 points (`decimate`, `envelope`: extremes stay), a number has seven
significant digits (x nine), a gap is a null, and the JSON is ASCII without `<`, `>` or `&`, so that no
name of a user can end the script element it lies in.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from similitude.report.decimate import BUCKETS, decimate, envelope

COLOURS = (  # each a CSS variable --NAME of html_page.css, for light, dark and paper
    *("estimate", "measured", "noise", "gained", "prior", "ink", "second", "third"),
    *("outside_linear", "bad_sample", "no_measurement", "at_limit", "too_slow", "not_excited", "restarted"),
)
KINDS = ("line", "points", "bars")
DIGITS = 7  # of a float32
X_DIGITS = 9  # a millisecond in eleven days


@dataclass(frozen=True, eq=False)
class Line:
    """One signal of a chart.

    Parameters
    ----------
    label : str      in the legend, any text; empty for a line that needs no entry there
    y : (n,)         values in the chart's unit; NaN where there is none, which breaks the line
    colour : str     one of `COLOURS`
    kind : str       ``line``, ``points`` or ``bars`` (one bar at each x)
    width : float    of the line [px]
    dashed : bool    for what is a limit or a reference
    """

    label: str
    y: np.ndarray
    colour: str = "estimate"
    kind: str = "line"
    width: float = 1.3
    dashed: bool = False


@dataclass(frozen=True, eq=False)
class Band:
    """An area between two edges, (n,) each and finite, or two numbers; without a label, no legend entry."""

    label: str
    lower: np.ndarray | float
    upper: np.ndarray | float
    colour: str = "estimate"


@dataclass(frozen=True)
class Span:
    """A stretch of x that is tinted over the whole height, the stronger the nearer ``share`` is to 1."""

    start: float
    end: float
    colour: str
    share: float = 1.0


@dataclass(frozen=True, eq=False)
class Chart:
    """Lines, bands and tinted stretches over one x axis.

    Parameters
    ----------
    title : str                  heading of the chart, any text
    y_label : str                what is drawn, without its unit
    x : (n,)                     increasing, finite
    lines : tuple of Line        at least one
    bands, spans : tuples        drawn behind the lines
    unit, x_unit : str           as people read them: ``deg/s``; empty for a pure number
    x_label : str                what x is
    sync : str                   charts of one name zoom and point together; empty for one alone
    log : bool                   a logarithmic y axis; every value is positive then
    y_range : (low, high)        what is shown before anybody zooms; None for all of it
    height : int                 [px]
    span_labels : mapping        colour of a span -> its words in the legend
    """

    title: str
    y_label: str
    x: np.ndarray
    lines: tuple[Line, ...]
    bands: tuple[Band, ...] = ()
    spans: tuple[Span, ...] = ()
    unit: str = ""
    x_label: str = "time"
    x_unit: str = "s"
    sync: str = "time"
    log: bool = False
    y_range: tuple[float, float] | None = None
    height: int = 220
    span_labels: Mapping[str, str] | None = None

    @property
    def is_decimated(self) -> bool:
        """Whether extremes stand for all samples in at least one line."""
        counts = [int(np.isfinite(line.y).sum()) for line in self.lines]
        return max(counts, default=0) > 2 * BUCKETS


def charts_json(charts: Mapping[str, Chart]) -> str:
    """Write charts as the JSON that html_page.js draws.

    Parameters
    ----------
    charts : mapping of str to Chart
        Name of the figure to its chart.

    Returns
    -------
    str
        Strict ASCII JSON without ``<``, ``>`` and ``&``: {"charts": {name: ...}, "spans": [...]}.
    """
    spans: dict[tuple[Span, ...], int] = {}
    drawn = {name: _chart(chart, spans) for name, chart in charts.items()}
    listed = [[_span(span) for span in group] for group in spans]
    text = json.dumps({"charts": drawn, "spans": listed}, allow_nan=False, separators=(",", ":"))
    return text.replace("<", r"\u003c").replace(">", r"\u003e").replace("&", r"\u0026")


def _chart(chart: Chart, spans: dict[tuple[Span, ...], int]) -> dict:
    x = np.asarray(chart.x, np.float64)
    return {
        "title": chart.title,
        "y_label": chart.y_label,
        "unit": chart.unit,
        "x_label": chart.x_label,
        "x_unit": chart.x_unit,
        "sync": chart.sync,
        "log": chart.log,
        "y_range": None if chart.y_range is None else _numbers(np.array(chart.y_range)),
        "x_range": _numbers(x[[0, -1]], X_DIGITS),
        "height": chart.height,
        "lines": [_line(x, line) for line in chart.lines],
        "bands": [_band(x, band) for band in chart.bands],
        # Charts over one time share one list: it is written once.
        "spans": spans.setdefault(tuple(chart.spans), len(spans)),
        "span_labels": dict(chart.span_labels or {}),
    }


def _line(x: np.ndarray, line: Line) -> dict:
    at, y = decimate(x, np.asarray(line.y, np.float64))
    return {
        "label": line.label,
        "colour": line.colour,
        "kind": line.kind,
        "width": line.width,
        "dashed": line.dashed,
        "x": _rising(at, y),
        "y": _numbers(y),
    }


def _band(x: np.ndarray, band: Band) -> dict:
    if np.ndim(band.lower) == 0 and np.ndim(band.upper) == 0:
        at = x[[0, -1]]
        lower, upper = np.full(2, band.lower, np.float64), np.full(2, band.upper, np.float64)
    else:
        edges = (np.broadcast_to(np.asarray(y, np.float64), x.shape) for y in (band.lower, band.upper))
        at, lower, upper = envelope(x, *edges)
    return {
        "label": band.label,
        "colour": band.colour,
        "x": _rising(at, lower),
        "lower": _numbers(lower),
        "upper": _numbers(upper),
    }


def _span(span: Span) -> list:
    start, end = _numbers(np.array([span.start, span.end]), X_DIGITS)
    return [start, end, span.colour, round(span.share, 2)]


def _rising(x: np.ndarray, y: np.ndarray) -> list[float]:
    """x with the break of a line, which shares the x of the point after it, moved into the gap."""
    broken = np.flatnonzero(~np.isfinite(y))
    x = x.copy()
    x[broken] = 0.5 * (x[broken - 1] + x[broken])
    return _numbers(x, X_DIGITS)


def _numbers(values: np.ndarray, digits: int = DIGITS) -> list[float | None]:
    """Values with so many significant digits, None where not finite; -0 is 0."""
    known = np.isfinite(values)
    size = np.abs(np.where(known & (values != 0), values, 1.0))
    scale = 10.0 ** (digits - 1 - np.floor(np.log10(size)))
    rounded = (np.round(np.where(known, values, 0.0) * scale) / scale + 0.0).tolist()
    return rounded if known.all() else [v if k else None for v, k in zip(rounded, known, strict=True)]
