"""An Inspection as one HTML page: findings first, then charts of the signals and all numbers.

Invariant: every text of the file is escaped, and nothing depends on when or where it was written.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from similitude.inspection.advice import MEANING, UNITS, doubtful, outlook, percent, relations
from similitude.inspection.excitation import HARDLY, KINDS, LINEAR, WINDOW, Window, seconds_by_kind
from similitude.log_quantities import QUANTITIES
from similitude.report.html_chart import Chart, Line, Span
from similitude.report.html_page import (
    Html,
    badge,
    bullets,
    facts,
    figure,
    joined,
    lead,
    page,
    paragraph,
    section,
    strong,
    table,
)
from similitude.report.numerals import DEGREES_PER_RADIAN, plain, pretty_name

if TYPE_CHECKING:
    from similitude.inspection.inspection import Inspection

VERDICTS = {
    "identified": ("can be identified", "good"),
    "weak": ("can be identified weakly", "fair"),
    "not_excited": ("nothing to learn", "plain"),
}
KIND_COLOURS = {
    "missing": "no_measurement",
    "standing": "not_excited",
    "reverse": "at_limit",
    "beyond_linear": "outside_linear",
    "straight": "too_slow",
    "steered": "gained",
}
TINT = 0.35  # of a stretch: it lies behind the lines


def inspect_html(look: Inspection) -> str:
    """Compose the page.

    Parameters
    ----------
    look : Inspection    a log that was looked over

    Returns
    -------
    str                  an HTML document that needs no other file
    """
    charts = _charts(look)
    parts = [_head(look), *_findings(look), *(figure(name, chart) for name, chart in charts.items())]
    if look.windows:
        seconds = seconds_by_kind(look.windows)
        parts.append(facts({KINDS[kind]: f"{s:.0f} s" for kind, s in seconds.items() if s}))
    rows = relations(look)
    if rows:
        parts.append(section("Relations", table(["", "value ± sd", ""], rows)))
    if look.prospects is not None:
        parts.append(section("What it can show", _unknowns(look)))
    parts.append(section("Columns", _columns(look)))
    if look.clock is not None:
        parts.append(section("Clock", facts(_clock(look))))
    if look.missing:
        parts.append(section("Left unsaid", bullets(look.missing)))
    return page(look.survey.path.name, parts, charts)


def _head(look: Inspection) -> Html:
    plan = look.prospects
    if look.survey.certain:
        word, tone = "refused by identify", "bad"
    else:
        word, tone = ("looked over", "plain") if plan is None else VERDICTS[plan.verdict]
    said = outlook(plan) if plan is not None else ()
    doubt = doubtful(look)
    if doubt:
        word, tone, said = f"{word}, in doubt", "fair", (doubt, *said)
    return lead(paragraph(badge(word, tone), " ", " ".join(said)))


def _findings(look: Inspection) -> list[Html]:
    if not look.findings:
        return []
    return [section("Findings", bullets(_finding(one) for one in look.findings))]


def _finding(one) -> Html:
    tone = badge("refuses", "bad") if one.certain else badge("likely", "fair")
    return joined([
        tone, " ", strong(one.what), paragraph(f"Usually: {one.usually}", quiet=True),
        paragraph(f"Paste: {one.paste}", quiet=True), paragraph(f"Read: {one.read}", quiet=True),
    ])  # fmt: skip


def _charts(look: Inspection) -> dict[str, Chart]:
    """The signals on one clock, tinted by what the car was doing, and the excitation in steps."""
    signals = look.signals
    if signals is None or signals.t.size < 2:
        return {}
    spans = tuple(_spans(look))
    kinds = {one.kind for one in look.windows}
    labels = {KIND_COLOURS[kind]: KINDS[kind] for kind in KINDS if kind in kinds}
    drawn = (
        ("steer", "steer", signals.steer, "deg", DEGREES_PER_RADIAN, "second"),
        ("yaw-rate", "yaw rate", signals.r, "deg/s", DEGREES_PER_RADIAN, "estimate"),
        ("speed", "speed", signals.U, "m/s", 1.0, "third"),
        ("ay", "lateral acceleration", signals.ay, "m/s²", 1.0, "ink"),
    )
    charts = {
        name: Chart(
            title=words[:1].upper() + words[1:],
            y_label=words,
            x=signals.t,
            lines=(Line(words, scale * y, colour),),
            spans=spans,
            unit=unit,
            height=150,
            span_labels=labels,
        )
        for name, words, y, unit, scale, colour in drawn
        if y is not None and np.isfinite(y).any()
    }
    return charts | _excitation(look, spans, labels) | _gained(look, spans, labels)


def _spans(look: Inspection):
    """Windows of one kind next to one another as one stretch."""
    start = 0
    for i, one in enumerate(look.windows):
        last = i + 1 == len(look.windows)
        if last or look.windows[i + 1].kind != one.kind:
            end = one.at + WINDOW
            yield Span(look.windows[start].at, end, KIND_COLOURS[one.kind], TINT)
            start = i + 1


def _measured(window: Window, name: str) -> float:
    """A number of a window; NaN where most of it was not measured, so that no line leads across."""
    value = getattr(window, name)
    return np.nan if value is None or window.kind == "missing" else value


def _excitation(look: Inspection, spans, labels) -> dict[str, Chart]:
    if len(look.windows) < 2:
        return {}
    t = np.array([one.at + WINDOW / 2 for one in look.windows])
    rms, sideways = (
        np.array([_measured(one, name) for one in look.windows]) for name in ("steer_rms", "sideways")
    )
    least = HARDLY * (16.0 if look.signals.at_wheel else 1.0)
    limits = np.where(np.isfinite(sideways), [[1e3 * least], [LINEAR]], np.nan)
    drawn = {
        "steer-rms": (
            "Steer rms of two seconds",
            "steer rms",
            1e3 * rms,
            "mrad",
            limits[0],
            "least that teaches",
        ),
        "sideways": (
            "Largest |r U| of two seconds",
            "|r U|",
            sideways,
            "m/s²",
            limits[1],
            "linear up to 0.3 g",
        ),
    }
    return {
        name: Chart(
            title=title,
            y_label=words,
            x=t,
            lines=(Line(words, y, "gained"), Line(limit_words, limit, "measured", dashed=True)),
            spans=spans,
            unit=unit,
            height=150,
            span_labels=labels,
        )
        for name, (title, words, y, unit, limit, limit_words) in drawn.items()
        if np.isfinite(y).any()
    }


def _gained(look: Inspection, spans, labels) -> dict[str, Chart]:
    """Where in the drive K was learnt."""
    if look.prospects is None:
        return {}
    words = "information about K"
    gained = Chart(
        title="Learnt about the tyres",
        y_label=words,
        x=look.survey.values["t"],
        lines=(Line(words, look.prospects.information, "gained"),),
        spans=spans,
        height=150,
        span_labels=labels,
    )
    return {"learnt": gained}


def _unknowns(look: Inspection) -> Html:
    rows = []
    for name, meaning in MEANING.items():
        one = look.prospects.unknowns[name]
        scale = DEGREES_PER_RADIAN if name in UNITS else 1.0
        as_number = name in UNITS or name == "pi1"
        before, after = (
            f"± {plain(scale * sd, 2)} {UNITS.get(name, '')}" if as_number else percent(sd)
            for sd in (one.before, one.after)
        )
        label = meaning if name in UNITS else f"{pretty_name(name)}, {meaning}"
        rows.append([label, one.word, before, after])
    return table(["unknown", "", "before", "after this drive"], rows, numeric=(2, 3))


def _columns(look: Inspection) -> Html:
    head = [
        "column",
        "taken for",
        "lowest",
        "highest",
        "mean",
        "noise",
        "grid",
        "new in",
        "a reading",
        "lacks",
    ]
    rows = []
    for one in look.channels:
        words = QUANTITIES[one.taken_for].words if one.taken_for else "not used"
        numbers = [plain(x) if x is not None else "–" for x in (one.low, one.high, one.mean)]
        noise = "–" if not one.noise else f"{'< ' if one.noise_is_bound else ''}{plain(one.noise, 2)}"
        grid = plain(one.resolution, 2) if one.resolution else "–"
        step = f"{plain(1000 * look.clock.step * one.hold, 2)} ms" if look.clock else "–"
        shares = [f"{100 * one.fresh:.0f} %", step, f"{100 * one.missing:.2g} %"]
        rows.append([one.header, words, *numbers, noise, grid, *shares])
    return table(head, rows, numeric=range(2, len(head)))


def _clock(look: Inspection) -> dict[str, str]:
    clock = look.clock
    facts = {
        "rows": str(clock.rows),
        "duration": f"{plain(clock.duration)} s",
        "usual step": f"{plain(1000 * clock.step)} ms",
        "98 % of the steps": f"{plain(1000 * clock.step_low)} to {plain(1000 * clock.step_high)} ms",
    }
    for words, pauses in (("gaps", clock.gaps), ("jumps", clock.jumps)):
        largest = f", the largest {plain(pauses[0].length)} s in data row {pauses[0].row}" if pauses else ""
        facts[words] = f"{len(pauses)}{largest}"
    return facts
