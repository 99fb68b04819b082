"""Pictures of a population: distributions raw and in logarithms, pairs with lines, running averages.

The Agg canvas is used directly, as in `similitude.report.plot`. Colours: systems teal, fits ink, what is
wrong with a symmetric fit (mass below zero) red.
"""

from __future__ import annotations

import io
import itertools
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from similitude.populations.distribution import describe
from similitude.populations.lines import total_least_squares
from similitude.report.numerals import plain, pretty_name

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

INK, MUTED, GRID, POINTS, WRONG = "#1d2730", "#5b6b7b", "#e3e8ec", "#2a7f8e", "#c9411c"
STEEPEST = 20.0  # slope in logarithms beyond which a line says nothing
ORDERS = 200  # shuffles of the systems behind a running average


def png(figure: Figure, *, dpi: int = 100) -> bytes:
    """A figure as the bytes of a PNG file."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=dpi, format="png", pil_kwargs={"compress_level": 6})
    return buffer.getvalue()


def distribution_picture(values: NDArray, name: str, unit: str = "") -> Figure:
    """One quantity raw and in logarithms, each with the normal distribution of its mean and sd.

    Parameters
    ----------
    values : (n,) positive; NaN where not known, two or more known.
    name, unit : for the axis.
    """
    from scipy.stats import norm

    x = values[np.isfinite(values)]
    d = describe(name, x)
    figure, (left, right) = _panels(2, (9.0, 3.1))
    label = f"{pretty_name(name)}{f' [{unit}]' if unit else ''}"
    for axes, data, words, skew, p in (
        (left, x, label, d.skew_raw, d.normal_raw),
        (right, np.log(x), f"ln {label}", d.skew_log, d.normal_log),
    ):
        bins = int(np.clip(2 * len(data) ** (1 / 3) + 3, 5, 40))
        axes.hist(data, bins=bins, density=True, color=POINTS, alpha=0.75, edgecolor="white", lw=0.5)
        mean, sd = data.mean(), max(data.std(ddof=1), 1e-12)
        grid = np.linspace(min(data.min(), mean - 3.3 * sd), max(data.max(), mean + 3.3 * sd), 300)
        axes.plot(grid, norm.pdf(grid, mean, sd), color=INK, lw=1.4)
        if axes is left and grid[0] < 0:
            below = grid[grid <= 0]
            axes.fill_between(below, norm.pdf(below, mean, sd), color=WRONG, alpha=0.8, lw=0)
            axes.axvline(0, color=WRONG, lw=0.8)
        said = f"n = {len(data)}" if skew is None else f"skewness {skew:+.2f}, normal p = {p:.2g}"
        axes.set_title(said, fontsize=9.5, color=MUTED, loc="left")
        axes.set_xlabel(words, color=INK)
        axes.set_yticks([])
    return figure


def pairs_picture(logs: NDArray, names: tuple[str, ...], *, most: int = 6) -> Figure | None:
    """Every pair of groups, in logarithms, with its line of total least squares.

    Parameters
    ----------
    logs : (n, q) ln groups, NaN where not known.    names : (q,).    most : groups that are drawn.

    Returns
    -------
    Figure, or None where no pair is known in three systems.
    """
    known = np.isfinite(logs)
    chosen = [j for j in np.argsort(-known.sum(axis=0), kind="stable") if known[:, j].sum() >= 3][:most]
    chosen = sorted(chosen)
    if len(chosen) < 2:
        return None
    size = len(chosen) - 1
    figure = Figure(figsize=(min(2.1 * size + 1.0, 11), min(2.0 * size + 0.7, 10)), facecolor="white")
    FigureCanvasAgg(figure)
    grid = figure.subplots(size, size, squeeze=False)
    for axes in grid.ravel():
        axes.set_visible(False)
    for (i, a), (j, b) in itertools.combinations(enumerate(chosen), 2):
        axes = grid[j - 1, i]
        axes.set_visible(True)
        _quiet(axes)
        both = known[:, a] & known[:, b]
        x, y = logs[both, a], logs[both, b]
        axes.plot(np.exp(x), np.exp(y), ".", color=POINTS, ms=4, alpha=0.7)
        if len(x) >= 3 and np.ptp(x) > 0:
            slope, intercept = total_least_squares(x, y)
            ends = np.array([x.min(), x.max()])
            steep = abs(slope) > STEEPEST
            if not steep:
                axes.plot(np.exp(ends), np.exp(slope * ends + intercept), color=INK, lw=1.2)
            said = "no line" if steep else f"slope {slope:.2f}"
            axes.set_title(f"{said}, n = {len(x)}", fontsize=8, color=MUTED, loc="left")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.minorticks_off()
        for axis, ends in ((axes.xaxis, x), (axes.yaxis, y)):
            ticks = np.exp(np.linspace(ends.min(), ends.max(), 3)) if len(ends) else []
            axis.set_ticks(ticks, [plain(float(tick), 2) for tick in ticks])
        axes.tick_params(labelsize=7)
        if j == size:
            axes.set_xlabel(pretty_name(names[a]), color=INK)
        if i == 0:
            axes.set_ylabel(pretty_name(names[b]), color=INK)
    width, height = figure.get_size_inches()
    figure.subplots_adjust(
        left=0.8 / width, right=1 - 0.15 / width, top=1 - 0.3 / height, bottom=0.55 / height,
        wspace=0.35, hspace=0.4,
    )  # fmt: skip
    return figure


def running_average_picture(values: Mapping[str, NDArray], *, seed: int = 0) -> Figure:
    """Averages of the first k systems over shuffled orders, as shares of the average of all.

    Parameters
    ----------
    values : name -> (n,) positive, NaN where not known, two or more known.
    """
    rng = np.random.default_rng(seed)
    figure, panels = _panels(len(values), (9.0, 2.9))
    for axes, (name, column) in zip(panels, values.items(), strict=True):
        x = column[np.isfinite(column)]
        n = len(x)
        orders = np.argsort(rng.random((ORDERS, n)), axis=1)
        count = np.arange(1, n + 1)
        means = np.cumsum(x[orders], axis=1) / count / x.mean()
        low, high = np.percentile(means, (2.5, 97.5), axis=0)
        axes.fill_between(count, low, high, color=POINTS, alpha=0.25, lw=0)
        axes.plot(count, means[0], color=POINTS, lw=1.2)
        axes.axhline(1.0, color=INK, lw=0.8)
        if n >= 30:
            spread = 100 * max(high[29] - 1, 1 - low[29])
            axes.set_title(f"after 30: within {spread:.1f} %", fontsize=9.5, color=MUTED, loc="left")
        axes.set_xscale("log")
        axes.set_xlabel("systems averaged", color=INK)
        axes.set_ylabel(f"{pretty_name(name)} over its mean", color=INK)
    return figure


def _panels(count: int, size: tuple[float, float]):
    figure = Figure(figsize=size, facecolor="white")
    FigureCanvasAgg(figure)
    panels = figure.subplots(1, count, squeeze=False)[0]
    figure.subplots_adjust(left=0.08, right=0.98, top=0.88, bottom=0.19, wspace=0.12 if count < 3 else 0.36)
    for axes in panels:
        _quiet(axes)
    return figure, panels


def _quiet(axes) -> None:
    axes.grid(axis="y", color=GRID, lw=0.8, zorder=0)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color("#b9c3cb")
    axes.tick_params(labelsize=8.5, labelcolor=MUTED, color="#b9c3cb", length=3)
