"""Figures 2, 3 and 4: distributions from the tables at hand, and the lines of the z-coefficients."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter
from scipy import stats

from similitude.estimators.paper_design import PAPER_GROUPS, exact_coefficients, linearity_error, slopes
from similitude.paper import printed, seven
from similitude.paper.canvas import DARK, INK, LIGHT, MUTED, OTHER, OURS, PAPER, label, legend, panels
from similitude.paper.claims_noise import biases
from similitude.paper.claims_seven import stiffness, two_fits
from similitude.paper.vehicles import axles, inertias


def _bars(axes: Axes, many: np.ndarray, few: np.ndarray, edges: np.ndarray) -> None:
    """Relative frequency per class of both sets, as the paper shades them."""
    width = np.diff(edges)
    for values, colour, share, name in (
        (many, LIGHT, 1.0, f"{many.size} vehicles of the NHTSA table"),
        (few, DARK, 0.45, f"{few.size} of the literature"),
    ):
        count, _ = np.histogram(values, edges)
        axes.bar(edges[:-1] + width / 2, count / values.size, width * 0.92 * share, color=colour, label=name)
    axes.set_ylabel("relative frequency", fontsize=9, color=INK)


def figure_2() -> Figure:
    """Relative distribution of Iz, with a normal and a log-normal fit."""
    figure, (axes,) = panels(1, 3.0)
    many, cars = inertias().Iz, axles()
    edges = np.arange(0, 8001, 400.0)
    _bars(axes, many, cars.Iz[np.isfinite(cars.Iz)], edges)
    x = np.linspace(-1500, 8000, 400)
    normal = stats.norm.pdf(x, many.mean(), many.std(ddof=1)) * 400
    ln = np.log(many)
    fit = (
        np.where(
            x > 0, stats.norm.pdf(np.log(np.maximum(x, 1)), ln.mean(), ln.std(ddof=1)) / np.maximum(x, 1), 0
        )
        * 400
    )
    axes.plot(x, normal, color=PAPER, lw=1.4, label="normal fit")
    axes.fill_between(x, normal, where=x < 0, color=PAPER, alpha=0.5, lw=0)
    axes.plot(x[x > 0], fit[x > 0], color=OURS, lw=1.4, label="log-normal fit")
    label(axes, "Iz [kg m²]")
    legend(axes)
    return figure


def figure_3() -> Figure:
    """Relative distribution of pi5; of the 204 with pi1 at its average, which their table lacks."""
    figure, (axes,) = panels(1, 3.0)
    cars = axles()
    edges = np.arange(0.10, 0.3501, 0.0125)
    _bars(axes, inertias().pi5(printed.PI1), cars.pi5[np.isfinite(cars.pi5)], edges)
    axes.axvline(printed.PI5, color=PAPER, lw=1.4, label=f"average of the paper, {printed.PI5:.4f}")
    ours = inertias().pi5(printed.PI1).mean()
    axes.axvline(ours, color=OURS, lw=1.4, ls="--", label=f"of the 204, {ours:.4f}")
    label(axes, "π5 = Iz/(m L²) [-]")
    legend(axes, "upper left")
    return figure


def figure_4() -> Figure:
    """The four z-coefficients over pi3: exact, and the lines of eq 22; below, how far the lines are off."""
    figure, (axes, off) = panels(2, 4.6)
    pi3 = np.linspace(*printed.RANGE, 131)
    exact = exact_coefficients(pi3, printed.T, **PAPER_GROUPS)
    m1, m2 = slopes(printed.T, **PAPER_GROUPS)
    lines = pi3[:, None] * np.array([m1, -m1, m2, -m2])
    names, colours = ("b1", "b2", "a1 + 2", "a2 − 1"), (OURS, PAPER, INK, OTHER)
    for i, (name, colour) in enumerate(zip(names, colours, strict=True)):
        sign = np.sign(exact[0, i])
        axes.plot(pi3, sign * exact[:, i], color=colour, lw=1.6, label=f"{'−' if sign < 0 else ''}({name})")
        axes.plot(pi3, sign * lines[:, i], color=colour, lw=0.9, ls=(0, (3, 3)))
        off.plot(pi3, 100 * (lines[:, i] / exact[:, i] - 1), color=colour, lw=1.4)
    worst = linearity_error(printed.T, printed.PI1, printed.SLOPE, printed.PI5)["worst"]
    label(axes, y="coefficient [-]", title="exact (full), line of eq 22 (dashed)")
    label(off, "π3 [-]", "line over exact − 1 [%]", f"worst {100 * worst:.1f} %")
    legend(axes, "upper left", 2)
    return figure


def noise_picture() -> Figure:
    """Bias of the regression over the gyro's noise: closed form and compiled estimator."""
    figure, (axes,) = panels(1, 2.8)
    found = biases()
    level = np.array(list(found))
    simulated, told = (np.array([pair[i] for pair in found.values()]) for i in (0, 1))
    axes.loglog(level, 1 + told, color=OURS, lw=1.4, label="closed form")
    axes.loglog(level, 1 + simulated, "o", color=PAPER, ms=6, label="compiled estimator on simulated rows")
    axes.axhline(1, color=MUTED, lw=0.8, ls="--")
    label(axes, "white noise of the gyro [deg/s]", "π3 as read over true [-]")
    legend(axes, "lower right")
    return figure


def seven_picture() -> Figure:
    """Seven parameters at once: information by direction, and where two equally good fits ended."""
    figure, (left, right) = panels(1, 2.9, columns=2, share=False)
    J = seven.information(printed.TEST_VEHICLE, seven.seven_model)
    values = np.sort(np.linalg.eigvalsh(J))[::-1]
    known = values > 1e-9 * values[0]
    sd = 1 / np.sqrt(values[known])
    left.bar(np.arange(1, sd.size + 1), sd, color=OURS, width=0.6)
    left.set_yscale("log")
    left.yaxis.set_minor_formatter(NullFormatter())
    left.set_xticks(range(1, 8))
    for i in range(sd.size + 1, 8):
        left.text(i, sd.max(), "∞", ha="center", va="center", fontsize=16, color=PAPER)
    left.set_xlim(0.3, 7.7)
    label(left, "direction in ln p", "least sd [-]", "what ten seconds tell")
    names = [*seven.PARAMETERS, "K"]
    for shift, colour, fit in zip((-0.2, 0.2), (OURS, PAPER), two_fits(), strict=True):
        ratios = [fit.values[n] / printed.TEST_VEHICLE[n] for n in seven.PARAMETERS] + [stiffness(fit)]
        right.bar(
            np.arange(8) + shift,
            np.array(ratios) - 1,
            0.38,
            bottom=1,
            color=colour,
            label=f"residual {fit.misfit:.3f} of the noise",
        )
    right.axhline(1, color=INK, lw=0.8)
    right.set_xticks(range(8), names)
    label(right, y="fitted over true [-]", title="two fits of the same record")
    legend(right, "upper left")
    return figure
