"""One picture of a run: estimate, yaw rate, innovations and information, sharing time.

The Agg canvas is used directly: no window, no global state, and a third of pyplot's start-up.
"""

from __future__ import annotations

import os
import textwrap
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from similitude.report import panels
from similitude.report.numerals import uncertain

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from similitude.run import Run

VERDICT_COLOURS = {
    "identified": "#1f7a56",
    "weak": "#b07d10",
    "not_excited": "#5b6b7b",
    "outside_model": "#c9411c",
    "outside_population": "#8458b3",
    "bad_data": "#a3123a",
    "diverged": "#a3123a",
}
EPOCH = 1e5  # a first time stamp beyond this [s] is a clock, not a time into the drive


def draw(run: Run) -> Figure:
    """Draw the four panels.

    Parameters
    ----------
    run : Run
        A finished identification of n >= 2 samples.

    Returns
    -------
    matplotlib.figure.Figure
        10.9 x 9.1 inch on an Agg canvas; about 1200 x 1000 at 110 dpi.
    """
    figure = Figure(figsize=(10.91, 9.1), facecolor="white")
    FigureCanvasAgg(figure)
    t, time_label = _time_axis(run.trace.t)
    grid = figure.add_gridspec(
        4, 1, height_ratios=(1.75, 1.2, 0.95, 1.05), hspace=0.13,
        left=0.088, right=0.982, top=0.868, bottom=0.062,
    )  # fmt: skip
    first = None
    draw_panel = (panels.estimate_panel, panels.yaw_panel, panels.innovation_panel,
                  panels.information_panel)  # fmt: skip
    for row, panel in enumerate(draw_panel):
        axes = figure.add_subplot(grid[row], sharex=first)
        first = first or axes
        _quiet(axes, last=row == 3)
        panel(axes, run, t)
        panels.shade_faults(axes, t, run.trace.status)
        panels.mark_alarms(axes, run, t)
    axes.set_xlim(t[0], t[-1])
    axes.set_xlabel(time_label, color=panels.INK, fontsize=10)
    _headline(figure, run)
    return figure


def save_plot(run: Run, path: str | os.PathLike[str], *, dpi: int = 110) -> None:
    """Draw a run and write it as PNG.

    Parameters
    ----------
    run : Run
        A finished identification.
    path : path
        File to create or replace.
    dpi : int
        Dots per inch [1/inch].

    Raises
    ------
    OSError
        The file cannot be written.
    """
    draw(run).savefig(path, dpi=dpi, format="png", pil_kwargs={"compress_level": 4})


def _time_axis(t: np.ndarray) -> tuple[np.ndarray, str]:
    if abs(t[0]) < EPOCH:
        return t, "time [s]"
    return t - t[0], f"time since the first sample, t = {t[0]:.3f} [s]"


def _quiet(axes: Axes, *, last: bool) -> None:
    """Horizontal grid only, no box, small muted numbers."""
    axes.grid(axis="y", color=panels.GRID, lw=0.8, zorder=0)
    axes.set_axisbelow(True)
    for side in ("top", "right", "left"):
        axes.spines[side].set_visible(False)
    axes.spines["bottom"].set_color(panels.PRIOR)
    axes.tick_params(labelsize=9, labelcolor=panels.MUTED, color=panels.PRIOR, length=3)
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", labelbottom=last)
    axes.yaxis.set_label_coords(-0.0585, 0.5)
    axes.yaxis.label.set_size(10)
    axes.yaxis.label.set_color(panels.INK)


def _headline(figure: Figure, run: Run) -> None:
    """Verdict and K on the first line, the reason below, what was driven at the right."""
    colour = VERDICT_COLOURS.get(run.verdict, panels.INK)
    box = {"boxstyle": "round,pad=0.38,rounding_size=0.35", "fc": colour, "ec": "none"}
    verdict = figure.text(
        0.02, 0.962, run.verdict.replace("_", " "), fontsize=13, weight="bold", color="white",
        va="center", bbox=box,
    )  # fmt: skip
    width = verdict.get_window_extent().width / figure.bbox.width
    value, std = uncertain(run.K.value, run.K.std)
    low, high = uncertain(run.K.lo, run.K.std)[0], uncertain(run.K.hi, run.K.std)[0]
    figure.text(
        0.02 + width + 0.022, 0.962, f"K = {value} ± {std} m²/s²   (95 %: {low} to {high})",
        fontsize=13, color=panels.INK, va="center",
    )  # fmt: skip
    reason = textwrap.fill(run.reason, 128, max_lines=2, placeholder=" …")
    figure.text(0.014, 0.932, reason, fontsize=10.5, color=panels.MUTED, va="top", linespacing=1.3)
    name = str(run.log.name)
    name = name if len(name) <= 44 else f"{name[:20]}…{name[-23:]}"
    about = f"{name}\n{run.vehicle.name}, {run.log.duration:.0f} s at {run.log.rate:.0f} Hz"
    figure.text(0.982, 0.962, about, fontsize=9.5, color=panels.MUTED, va="center", ha="right",
                linespacing=1.35)  # fmt: skip
