"""The four panels of the picture, each one function of a Run and an Axes.

Every line goes through `decimate`, every band through `envelope`; angles are drawn in degrees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

from similitude.report.decimate import decimate, envelope, shares
from similitude.report.numerals import DEGREES_PER_RADIAN, thousands
from similitude.report.table import WIDEST, Z95
from similitude.status import STATUS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from similitude.run import Run

INK, MUTED, GRID = "#1d2733", "#6b7785", "#e6eaee"
ESTIMATE, PRIOR, MEASURED, GAINED = "#1667b7", "#c3c9d0", "#8a95a1", "#1f7a56"
NOISE = "#67727e"
ALARM = "#c8102e"
FAULTS = {  # status to (colour, words); in this order where several share a place
    "outside_linear": ("#e4572e", "beyond the linear tyre"),
    "bad_sample": ("#8f1d3f", "bad sample"),
    "no_measurement": ("#e9a820", "no measurement"),
    "at_limit": ("#8458b3", "at the population's edge"),
    "too_slow": ("#7d8fa3", "too slow"),
}
ENOUGH = 1.0 / 0.15**2  # information at which sd(ln K) is 15 %, the limit for "identified" [-]
A_LINE = 4  # names of a legend; five of the longest run out of the picture


def estimate_panel(axes: Axes, run: Run, t: np.ndarray) -> None:
    """Draw K [m^2/s^2] on a log scale with its 95 % band, over the 95 % band of the prior."""
    trace = run.trace
    half = np.minimum(Z95 * trace.ln_K_std, WIDEST)
    lower, upper = trace.K * np.exp(-half), trace.K * np.exp(half)
    prior = prior_of_K(run)
    handles = []
    if prior is not None:
        axes.axhspan(*prior, color=PRIOR, alpha=0.38, lw=0, zorder=0.5)
        handles.append(Patch(color=PRIOR, alpha=0.38, lw=0, label="population alone, 95 %"))
    axes.fill_between(*envelope(t, lower, upper), color=ESTIMATE, alpha=0.22, lw=0, zorder=2)
    axes.plot(*decimate(t, trace.K), color=ESTIMATE, lw=1.5, zorder=3)
    handles += [
        Line2D([], [], color=ESTIMATE, lw=1.5, label="estimate"),
        Patch(color=ESTIMATE, alpha=0.22, lw=0, label="its 95 % interval"),
    ]
    if run.alarms:
        handles.append(Line2D([], [], color=ALARM, lw=1.3, label="change found"))
    axes.set_yscale("log")
    low, high = range_of_K(trace.K, lower, upper, prior)
    axes.set_ylim(low, high)
    _readable_log_ticks(axes, low, high)
    axes.set_ylabel("tyre constant K\n[m²/s²]")
    _legend(axes, handles)


def yaw_panel(axes: Axes, run: Run, t: np.ndarray) -> None:
    """Draw the measured yaw rate and the filter's one-step prediction, both in deg/s."""
    trace = run.trace
    measured, predicted = (y * DEGREES_PER_RADIAN for y in (trace.r_measured, trace.r_predicted))
    axes.plot(*decimate(t, measured), color=MEASURED, lw=2.2, zorder=2, solid_capstyle="butt")
    axes.plot(*decimate(t, predicted), color=ESTIMATE, lw=0.9, zorder=3)
    finite = measured[np.isfinite(measured)]
    if finite.size:  # a prediction that ran away must not flatten what was measured
        centre, reach = np.median(finite), max(float(np.ptp(finite)), 1e-3)
        axes.set_ylim(
            max(min(finite.min(), predicted.min()) - 0.08 * reach, centre - 1.5 * reach),
            min(max(finite.max(), predicted.max()) + 0.22 * reach, centre + 1.5 * reach),
        )
    axes.set_ylabel("yaw rate\n[deg/s]")
    _legend(
        axes,
        [
            Line2D([], [], color=MEASURED, lw=2.2, label="measured"),
            Line2D([], [], color=ESTIMATE, lw=0.9, label="predicted"),
        ],
    )


def innovation_panel(axes: Axes, run: Run, t: np.ndarray) -> None:
    """Draw measured minus predicted yaw rate [deg/s] and the +-2 sd it should stay within."""
    trace = run.trace
    innovation = trace.innovation * DEGREES_PER_RADIAN
    band = 2.0 * trace.innovation_std * DEGREES_PER_RADIAN
    axes.fill_between(*envelope(t, -band, band), color=ESTIMATE, alpha=0.16, lw=0, zorder=1)
    for edge in (-band, band):  # on top: in a long log the innovations hide the band itself
        axes.plot(*decimate(t, edge), color=ESTIMATE, lw=0.9, zorder=3)
    axes.plot(*decimate(t, innovation), color=NOISE, lw=0.5, alpha=0.8, zorder=2)
    finite = np.isfinite(innovation)
    label = "what was not predicted"
    reach = float(np.quantile(band, 0.95))
    if finite.any():
        inside = float(np.mean(np.abs(innovation[finite]) <= band[finite]))
        label += f": {100 * inside:.1f} % inside"
        reach = max(reach, float(np.quantile(np.abs(innovation[finite]), 0.995)))
    reach = reach if reach > 0 else 1.0  # noise-free and exactly predicted
    axes.set_ylim(-1.5 * reach, 1.9 * reach)
    axes.set_ylabel("innovation\n[deg/s]")
    _legend(
        axes,
        [
            Line2D([], [], color=NOISE, lw=1.2, label=label),
            Patch(color=ESTIMATE, alpha=0.16, lw=0, label="±2 sd expected (95 %)"),
        ],
    )


def information_panel(axes: Axes, run: Run, t: np.ndarray) -> None:
    """Draw the information gained about ln K [-] and what "identified" takes."""
    gained = run.trace.information
    area = envelope(t, np.zeros_like(gained), gained)
    axes.fill_between(*area, color=GAINED, alpha=0.18, lw=0)
    axes.plot(*decimate(t, gained), color=GAINED, lw=1.4, zorder=3)
    axes.axhline(ENOUGH, color=INK, lw=0.8, ls=(0, (4, 3)), zorder=2)
    axes.set_ylim(0, 1.25 * max(ENOUGH, float(gained.max())))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda gain, _: thousands(gain)))
    axes.set_ylabel("information\nabout ln K [–]")
    handles = [
        Line2D([], [], color=GAINED, lw=1.4, label="gained so far"),
        Line2D([], [], color=INK, lw=0.8, ls=(0, (4, 3)), label=f"±15 % takes {ENOUGH:.0f}"),
    ]
    for name, (colour, words) in FAULTS.items():
        share = float(np.mean(run.trace.status == STATUS[name]))
        if share > 0:
            words = f"{words} {100 * share:.2g} %" if share < 0.995 else f"{words} throughout"
            handles.append(Patch(color=colour, alpha=0.35, lw=0, label=words))
    _legend(axes, handles)


def shade_faults(axes: Axes, t: np.ndarray, status: np.ndarray) -> None:
    """Tint the time in which samples could not teach, the stronger the more of them.

    Parameters
    ----------
    axes : Axes with time [s] along x.
    t : (n,) time [s].
    status : (n,) status codes.
    """
    image = np.zeros((1, shares(t, status == 0).size, 4), np.float32)
    for name, (colour, _) in reversed(FAULTS.items()):
        share = shares(t, status == STATUS[name])[None, :]
        seen = share > 0
        image[seen, :3] = to_rgb(colour)
        image[seen, 3] = 0.08 + 0.22 * share[seen]
    if image[..., 3].any():
        axes.imshow(
            image, extent=(t[0], t[-1], 0, 1), transform=axes.get_xaxis_transform(),
            aspect="auto", interpolation="nearest", zorder=0.7,
        )  # fmt: skip


def mark_alarms(axes: Axes, run: Run, t: np.ndarray) -> None:
    """Draw a line where each change was decided, dotted from its onset.

    Parameters
    ----------
    axes : Axes with time [s] along x.
    run : Run with alarms.
    t : (n,) time as drawn [s]; alarms are told in the log's time.
    """
    shift = t[0] - run.trace.t[0]
    for alarm in run.alarms:
        axes.axvspan(alarm["onset"] + shift, alarm["t"] + shift, color=ALARM, alpha=0.18, lw=0, zorder=1.5)
        axes.axvline(alarm["t"] + shift, color=ALARM, lw=1.3, zorder=4)


def prior_of_K(run: Run) -> tuple[float, float] | None:
    """Bounds of K [m^2/s^2] that the prior alone gives with 95 %; None when there is no prior.

    The first sample of a drive teaches next to nothing, so the first row of the trace is the prior.
    """
    mean, std = float(run.trace.K[0]), float(run.trace.ln_K_std[0])
    if not 0 < std < 2.0:
        return None
    return mean * np.exp(-Z95 * std), mean * np.exp(Z95 * std)


def range_of_K(K, lower, upper, prior) -> tuple[float, float]:
    """Limits that show the estimate, most of its band and the prior, but at most three decades."""
    late = slice(K.size // 20, None)
    low, high = float(np.quantile(lower[late], 0.02)), float(np.quantile(upper[late], 0.98))
    middle = float(np.median(K))
    low, high = max(low, middle / 30), min(high, middle * 30)
    if prior is not None:
        low, high = min(low, prior[0]), max(high, prior[1])
    low, high = min(low, K[late].min() / 1.05), max(high, K[late].max() * 1.05)
    return max(low, high / 1e4) / 1.08, high * 1.45


def _readable_log_ticks(axes: Axes, low: float, high: float) -> None:
    """Label 1-2-5 steps, finer when the axis spans little, as plain numbers."""
    for steps in ((1, 2, 3, 4, 5, 6, 8), (1, 2, 3, 5), (1, 2, 5), (1, 3), (1,)):
        powers = np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
        ticks = np.multiply.outer(10.0**powers, steps).ravel()
        ticks = ticks[(ticks >= low) & (ticks <= high)]
        if ticks.size <= 7:
            break
    if ticks.size < 2:
        ticks = np.array([low, (low * high) ** 0.5, high])
    axes.yaxis.set_major_locator(FixedLocator(ticks))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda K, _: f"{K:.3g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_minor_locator(FixedLocator([]))


def _legend(axes: Axes, handles: list) -> None:
    axes.legend(
        handles=handles, loc="upper left", ncols=min(len(handles), A_LINE), fontsize=8.5, labelcolor=INK,
        frameon=True, framealpha=0.85, edgecolor="none", facecolor="white", borderpad=0.25,
        handlelength=1.5, columnspacing=1.6, handletextpad=0.6, borderaxespad=0.35,
    ).set_zorder(6)  # fmt: skip
