"""A Run as one HTML page: the verdict first, what it rests on after it, where it came from last.

Invariant: nothing on the page depends on when or where it was written; every number of the summary
is on it, and every text of the user's is escaped.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from typing import TYPE_CHECKING, Any

import numpy as np

from similitude.report import html_tables
from similitude.report.alarm_words import alarm_lines, known_lines
from similitude.report.cost_curve import cost_curve
from similitude.report.html_chart import Chart
from similitude.report.html_charts import charts_of
from similitude.report.html_page import (
    Html,
    aside,
    badge,
    bullets,
    details,
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
from similitude.report.numerals import plain, uncertain

if TYPE_CHECKING:
    from similitude.run import CrossCheck, Run

TONES = {
    "identified": "good",
    "weak": "fair",
    "not_excited": "plain",
    "outside_model": "poor",
    "outside_population": "odd",
    "bad_data": "bad",
    "diverged": "bad",
}
GRAVITY = 9.80665  # m/s^2
AGREED = 2.0  # sd between two estimators up to which they are said to agree


def html_report(run: Run, record: Mapping[str, Any]) -> str:
    """Compose the page of a run.

    Parameters
    ----------
    run : Run
        A finished identification.
    record : mapping
        What `similitude.report.summary.summary` says of the run, the paths of its files included.

    Returns
    -------
    str
        An HTML document that needs no other file; equal runs give equal text.
    """
    charts = charts_of(run)
    parts = [_verdict(run), *_changes(run)]
    if run.log.fixes:
        parts.append(section("Repaired as asked", bullets(run.log.fixes)))
    if run.warnings:
        parts.append(section("Warnings", bullets(run.warnings)))
    parts += [_glance(run, charts), _estimate(run, charts)]
    if run.cross_check is not None:
        parts.append(_cross_check(run.cross_check))
    if run.handling:
        parts.append(_handling(run))
    if run.groups:
        note = "Grey is the population's 95 % interval, blue the one after this drive; logarithmic scale."
        told = html_tables.groups_table(run.groups)
        parts.append(section("Groups against the population", told, paragraph(note, quiet=True)))
    if run.nuisance:
        parts.append(section("Estimated alongside", html_tables.nuisance_table(run.nuisance)))
    parts.append(_lag(run, charts))
    if run.prediction:
        parts.append(_prediction(run))
    parts.append(_origins(run))
    parts.append(_files(record))
    return page(f"{run.log.name}: {run.vehicle.name}", parts, charts)


def _verdict(run: Run) -> Html:
    value, std = uncertain(run.K.value, run.K.std)
    low, high = (uncertain(edge, run.K.std)[0] for edge in (run.K.lo, run.K.hi))
    word = badge(run.verdict.replace("_", " "), TONES.get(run.verdict, "plain"))
    answer = strong(f"K = {value} ± {std} m²/s²")
    count = len(run.warnings)
    said = f"{count} warning{'s' if count > 1 else ''}, below." if count else "No warnings."
    return lead(
        paragraph(word, answer, aside(f"95 %: {low} to {high}")),
        paragraph(run.reason),
        paragraph(said, quiet=True),
    )


def _changes(run: Run) -> list[Html]:
    """What the monitor found, and what is known so far."""
    found = [section("Changes", bullets(alarm_lines(run)))] if run.alarms else []
    known = known_lines(run)
    return found + ([section("Known so far", bullets(known))] if known else [])


def _glance(run: Run, charts: Mapping[str, Chart]) -> Html:
    log, ay = run.log, run.trace.ay_kinematic
    missing = ~(np.isfinite(log.r) & np.isfinite(log.delta) & np.isfinite(log.U))
    told = facts(
        {
            "vehicle": run.vehicle.name,
            "estimator": run.estimator,
            "duration": f"{log.duration:.1f} s",
            "rate": f"{plain(log.rate)} Hz",
            "samples": f"{log.samples}",
            "rows with a value missing": f"{plain(100 * float(missing.mean()), 2)} %",
            "speed": f"{_range(log.U)} m/s",
            "lateral acceleration": f"{_range(ay)} m/s²",
            "the same in g": f"up to {plain(float(np.max(np.abs(ay))) / GRAVITY, 2)} g",
        }
    )
    note = paragraph("Lateral acceleration is speed times yaw rate.", quiet=True)
    driven = (figure("speed", charts["speed"]), figure("steer", charts["steer"]))
    return section("The log at a glance", told, note, *driven, html_tables.status_table(run.trace.status))


def _range(values: np.ndarray) -> str:
    known = values[np.isfinite(values)]
    if not known.size:
        return "–"
    return f"{known.min():.1f} to {known.max():.1f}".replace("-", "−")


def _estimate(run: Run, charts: Mapping[str, Chart]) -> Html:
    names = ("estimate", "yaw-rate", "innovation", "information")
    return section("Estimate", html_tables.answer_table(run), *(figure(name, charts[name]) for name in names))


def _cross_check(check: CrossCheck) -> Html:
    """One sentence on whether two estimators of different kinds agree, and both numbers."""
    apart = abs(check.apart) / check.std
    told = (
        f"They differ by {100 * check.apart:+.1f} %, with an sd of {100 * check.std:.1f} % were both right: "
    )
    told += f"{apart:.1f} sd; with the population's average groups in robust "
    told += f"{abs(check.average_apart) / check.average_std:.1f} sd."
    what = "Two estimators of different kinds agree."
    if apart > AGREED:
        what = (
            f"Two estimators of different kinds lie {apart:.1f} sd apart: more than usual, less than what is "
            "called an error of the structure."
        )
    if check.structure_error:
        what = "Two estimators of different kinds disagree: an error of the structure, see the warnings."
    shown = html_tables.cross_check_table(check)
    return section("Cross-check", paragraph(what), shown, paragraph(told.replace("-", "−"), quiet=True))


def _handling(run: Run) -> Html:
    return section("Handling", *_understeer(run.handling), html_tables.handling_table(run.handling))


def _understeer(handling: Mapping[str, Mapping[str, Any]]) -> list[Html]:
    """One sentence on the sign of the understeer gradient, when it is among the numbers."""
    found = handling.get("understeer_gradient")
    if found is None:
        return []
    if found["lo"] > 0:
        return [paragraph("The car understeers: more steer is needed the harder the corner.")]
    if found["hi"] < 0:
        return [paragraph("The car oversteers: less steer is needed the harder the corner.")]
    return [paragraph("Whether the car under- or oversteers cannot be told from this drive.")]


def _lag(run: Run, charts: Mapping[str, Chart]) -> Html:
    answer = cost_curve(run.lag).plain.split("\n")[0]
    drawn = [figure("lag", charts["lag"])] if "lag" in charts else []
    return section("Steering lag", paragraph(answer), *drawn)


def _prediction(run: Run) -> Html:
    horizon = plain(run.prediction["horizon_s"], 2)
    count = run.prediction["predictions"]
    said = f"Yaw rate {horizon} s ahead from the steer and speed that were driven, {count} times."
    return section("Prediction", paragraph(said), html_tables.prediction_table(run.prediction))


def _origins(run: Run) -> Html:
    columns = [(name, source) for name, source in run.log.sources.items()]
    parts = [table(["from the log", "column"], columns)]
    if run.assumed:
        note = "What follows was not in the log."
        parts += [paragraph(note, quiet=True), html_tables.assumed_table(run.assumed)]
    return section("Where each number came from", joined(parts))


def _files(record: Mapping[str, Any]) -> Html:
    told = {"similitude": _version(), "log": record["log"], **record["files"]}
    every = details("Every number with all its digits, as in summary.json", html_tables.record_table(record))
    return section("Files and versions", table(["", ""], list(told.items())), every)


def _version() -> str:
    try:
        return f"version {version('similitude')}"
    except PackageNotFoundError:
        return "run from its source without being installed"
