"""The charts of a Run's HTML report: what plot.png shows, and what was driven.

Every chart but the lag's shares time and the tint of the stretches in which samples could not teach;
angles are in degrees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from similitude.report.cost_curve import INSIDE
from similitude.report.decimate import shares
from similitude.report.html_chart import Band, Chart, Line, Span
from similitude.report.numerals import DEGREES_PER_RADIAN
from similitude.report.panels import ENOUGH, FAULTS, prior_of_K, range_of_K
from similitude.report.plot import EPOCH
from similitude.report.table import WIDEST, Z95
from similitude.status import STATUS

if TYPE_CHECKING:
    from similitude.run import Run

GRADES = 8  # of a tint: neighbours of one grade become one stretch
SMALL = 130  # height of a chart of what was driven [px]


def charts_of(run: Run) -> dict[str, Chart]:
    """Make the charts of a run.

    Parameters
    ----------
    run : Run
        A finished identification of n >= 2 samples.

    Returns
    -------
    dict of str to Chart
        "speed", "steer", "estimate", "yaw-rate", "innovation" and "information" over time; "lag"
        where lags were scanned.
    """
    t, first = run.trace.t, float(run.trace.t[0])
    is_clock = abs(first) >= EPOCH
    along = {
        "x": t - first if is_clock else t,
        "x_label": f"time since t = {first:.3f} s" if is_clock else "time",
        "spans": (
            *fault_spans(t - first if is_clock else t, run.trace.status),
            *alarm_spans(run, first if is_clock else 0.0),
        ),
    }
    charts = {
        "speed": _speed(run, along),
        "steer": _steer(run, along),
        "estimate": _estimate(run, along),
        "yaw-rate": _yaw_rate(run, along),
        "innovation": _innovation(run, along),
        "information": _information(run, along),
    }
    return charts | ({"lag": _lag(run)} if np.isfinite(run.lag.cost).sum() > 2 else {})


def fault_spans(t: np.ndarray, status: np.ndarray) -> tuple[Span, ...]:
    """Find the stretches of time that are tinted, as in plot.png.

    Parameters
    ----------
    t : (n,) time [s], increasing.
    status : (n,) status codes.

    Returns
    -------
    tuple of Span
        In each stretch the status that comes first in `FAULTS`, with its share of the samples.
    """
    stretches = shares(t, status == 0).size
    colour, share = np.zeros(stretches, int), np.zeros(stretches)
    for number, name in reversed(list(enumerate(FAULTS, start=1))):
        marked = shares(t, status == STATUS[name])
        colour[marked > 0], share[marked > 0] = number, marked[marked > 0]
    grade = np.ceil(share * GRADES)
    edges = np.linspace(t[0], t[-1], stretches + 1)
    starts = np.flatnonzero(np.diff(colour * (GRADES + 1) + grade, prepend=-1))
    ends = np.append(starts[1:], stretches)
    names = ["", *FAULTS]
    return tuple(
        Span(float(edges[start]), float(edges[end]), names[colour[start]], float(grade[start] / GRADES))
        for start, end in zip(starts, ends, strict=True)
        if colour[start]
    )


def alarm_spans(run: Run, first: float) -> tuple[Span, ...]:
    """Stretches from the onset of each change to the moment it was found.

    Parameters
    ----------
    run : Run       with alarms told in the log's time.
    first : float   what the charts take off that time [s].
    """
    return tuple(Span(a["onset"] - first, a["t"] - first, "alarm") for a in run.alarms)


def _speed(run: Run, along: dict) -> Chart:
    line = Line("speed", run.log.U, "third")
    return Chart("Speed", "as logged", lines=(line,), unit="m/s", height=SMALL, **along)


def _steer(run: Run, along: dict) -> Chart:
    line = Line("steer", run.log.delta * DEGREES_PER_RADIAN, "second")
    return Chart("Steer", "angle of the road wheels", lines=(line,), unit="deg", height=SMALL, **along)


def _estimate(run: Run, along: dict) -> Chart:
    K = run.trace.K
    half = np.minimum(Z95 * run.trace.ln_K_std, WIDEST)
    lower, upper = K * np.exp(-half), K * np.exp(half)
    prior = prior_of_K(run)
    bands = [] if prior is None else [Band("population alone, 95 %", *prior, "prior")]
    return Chart(
        "Tyre constant K",
        "at each moment, from all samples before it",
        lines=(Line("estimate", K, width=1.6),),
        bands=(*bands, Band("its 95 % interval", lower, upper)),
        unit="m²/s²",
        log=True,
        y_range=range_of_K(K, lower, upper, prior),
        height=300,
        span_labels=_fault_labels(run.trace.status)
        | ({"alarm": "a change, from its onset until it was found"} if run.alarms else {}),
        **along,
    )


def _fault_labels(status: np.ndarray) -> dict[str, str]:
    found = {name: float(np.mean(status == STATUS[name])) for name in FAULTS}
    return {
        name: f"{FAULTS[name][1]} {100 * share:.2g} %" if share < 0.995 else f"{FAULTS[name][1]} throughout"
        for name, share in found.items()
        if share > 0
    }


def _yaw_rate(run: Run, along: dict) -> Chart:
    measured, predicted = (y * DEGREES_PER_RADIAN for y in (run.trace.r_measured, run.trace.r_predicted))
    return Chart(
        "Yaw rate",
        "measured, and predicted one step ahead",
        lines=(Line("measured", measured, "measured", width=2.2), Line("predicted", predicted, width=1.0)),
        unit="deg/s",
        y_range=_around(measured, predicted),
        **along,
    )


def _around(measured: np.ndarray, predicted: np.ndarray) -> tuple[float, float] | None:
    """Limits that show all that was measured; a prediction that ran away is cut at twice its span."""
    known = measured[np.isfinite(measured)]
    if not known.size:
        return None
    low, high = float(known.min()), float(known.max())
    room = max(high - low, 1e-3)
    low, high = max(min(low, predicted.min()), low - room), min(max(high, predicted.max()), high + room)
    return float(low - 0.08 * room), float(high + 0.08 * room)


def _innovation(run: Run, along: dict) -> Chart:
    innovation = run.trace.innovation * DEGREES_PER_RADIAN
    band = 2.0 * run.trace.innovation_std * DEGREES_PER_RADIAN
    known = np.isfinite(innovation)
    reach, title = float(np.quantile(band, 0.95)), "not predicted"
    if known.any():
        inside = float(np.mean(np.abs(innovation[known]) <= band[known]))
        title = f"measured − predicted; {100 * inside:.1f} % inside ±2 sd, 95 % expected"
        reach = max(reach, float(np.quantile(np.abs(innovation[known]), 0.995)))
    return Chart(
        "Innovation",
        title,
        lines=(
            Line("innovation", innovation, "noise", width=0.7),
            # On top: in a long log the innovations hide the band itself.
            Line("", band, width=0.9),
            Line("", -band, width=0.9),
        ),
        bands=(Band("±2 sd", -band, band),),
        unit="deg/s",
        y_range=(-1.5 * reach, 1.5 * reach) if reach > 0 else None,
        **along,
    )


def _information(run: Run, along: dict) -> Chart:
    gained = run.trace.information
    return Chart(
        "Information about ln K",
        "gained since the start, given everything else; K wanders, so what is long ago counts less by now",
        lines=(
            Line("gained", gained, "gained", width=1.6),
            Line(f"±15 % takes {ENOUGH:.0f}", np.full(gained.size, ENOUGH), "ink", width=1.0, dashed=True),
        ),
        bands=(Band("", np.zeros(gained.size), gained, "gained"),),
        y_range=(0.0, 1.1 * max(ENOUGH, float(gained.max()))),
        **along,
    )


def _lag(run: Run) -> Chart:
    cost = np.asarray(run.lag.cost, np.float64)
    # The foot of the curve and what speaks against no lag, not the heights of hopeless lags.
    known = cost[np.isfinite(cost)]
    top = min(float(known.max()), max(float(known[0]), 10.0 * INSIDE))
    return Chart(
        "Cost of each lag tried",
        "−ln L above the best; below the dashed line fits about as well",
        x=1000.0 * np.asarray(run.lag.lags, np.float64),
        x_label="steer lag",
        x_unit="ms",
        sync="",
        y_range=(0.0, 1.15 * max(top, INSIDE)),
        lines=(
            Line("cost", cost, width=1.6),
            Line("edge of 95 %", np.full(cost.size, INSIDE), "ink", width=1.0, dashed=True),
        ),
    )
