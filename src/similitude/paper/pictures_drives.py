"""Figures 5 and 7 as the paper draws them, and the same drives with the population filter.

Invariant: lines are drawn from every 20th row at most, so that a picture does not depend on how a
renderer thins sixty thousand points.
"""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from similitude.paper.canvas import DARK, INK, LIGHT, MUTED, OURS, PAPER, TRUTH, WET, label, legend, panels
from similitude.paper.claims_figure_5 import CHANGES, FITTING, filter_reads, least_sd, paper_reads
from similitude.paper.claims_figure_7 import belt_filter, belt_paper
from similitude.paper.claims_figure_7 import least_sd as belt_least_sd
from similitude.paper.drives import Drive, belt, belt_scheduled, square

THIN = slice(None, None, 20)


def _place(axes: Axes, drive: Drive) -> None:
    axes.plot(drive.t[THIN], drive.wanted[THIN], color=MUTED, lw=0.9, ls=(0, (2, 2)), label="wanted")
    axes.plot(drive.t[THIN], drive.y[THIN], color=OURS, lw=1.1, label="driven")
    label(axes, y="y [m]")


def _yaw(axes: Axes, drive: Drive) -> None:
    axes.plot(drive.t[THIN], drive.r[THIN], color=OURS, lw=0.8)
    label(axes, y="yaw rate [rad/s]")


def figure_5() -> Figure:
    """Position, yaw rate and the paper's estimate; dashed where the stiffness changes."""
    figure, (top, middle, bottom) = panels(3, 5.6)
    drive = square()
    _place(top, drive)
    top.set_ylim(-0.11, 0.15)
    legend(top, "upper right", 2)
    _yaw(middle, drive)
    bottom.plot(drive.t[THIN], drive.pi3[THIN], color=TRUTH, lw=1.1, label="true")
    bottom.plot(
        drive.t[THIN], paper_reads()[THIN], color=PAPER, lw=1.4, label="the paper's estimate, λ = 0.99995"
    )
    bottom.plot(
        drive.t[THIN],
        paper_reads(FITTING)[THIN],
        color=PAPER,
        lw=0.9,
        ls=(0, (4, 2)),
        label=f"the same with λ = {FITTING}",
    )
    bottom.set_ylim(0, 0.42)
    label(bottom, "t [s]", "π3 [-]")
    legend(bottom, "upper right", 3)
    for axes in (top, middle, bottom):
        for at in CHANGES:
            axes.axvline(at, color=DARK, lw=0.8, ls="--")
    bottom.set_xlim(0, 60)
    return figure


def figure_7() -> Figure:
    """The treadmill: position with the edge, yaw rate, and the paper's estimate with its off-line value."""
    figure, (top, middle, bottom) = panels(3, 5.6)
    drive = belt()
    _place(top, drive)
    _wet_half(top)
    legend(top, "upper left", 2)
    _yaw(middle, drive)
    bottom.plot(drive.t[THIN], drive.pi3[THIN], color=TRUTH, lw=1.0, label="true, mean of the front wheels")
    bottom.plot(
        drive.t[THIN], belt_paper()[THIN], color=PAPER, lw=1.4, label="the paper's estimate, perfect sensor"
    )
    bottom.axhline(drive.pi3[0], color=MUTED, lw=0.9, ls="--", label="from the printed parameters, dry")
    bottom.set_ylim(0, 0.75)
    label(bottom, "t [s]", "π3 [-]")
    legend(bottom, "upper left", 2)
    bottom.set_xlim(0, 110)
    _story((top, middle, bottom))
    return figure


def _wet_half(axes: Axes) -> None:
    edge = next(s.y_from for s in belt().scenario.road.surface)
    low, high = axes.get_ylim()
    axes.axhspan(edge, max(high, edge + 0.3), color=WET, zorder=0)
    axes.axhline(edge, color=MUTED, lw=0.9, ls=":")
    axes.set_ylim(low, max(high, edge + 0.3))
    axes.text(108, edge + 0.02, "wet half", fontsize=8.5, color=MUTED, ha="right", va="bottom")


def _story(panel: tuple[Axes, ...]) -> None:
    for axes in panel:
        axes.axvspan(70, 83, color=LIGHT, alpha=0.35, lw=0, zorder=0)
    panel[1].text(76.5, panel[1].get_ylim()[1] * 0.9, "hydroplaning", fontsize=8.5, color=MUTED, ha="center")


def today_5() -> Figure:
    """Figure 5's drive with a gyro: the filter with its interval, and its sd beside the bound."""
    figure, (top, bottom) = panels(2, 4.4)
    drive = square()
    K, sd = filter_reads()
    per = 1 / drive.U**2
    top.fill_between(
        drive.t[THIN],
        (K * np.exp(-1.96 * sd) * per)[THIN],
        (K * np.exp(1.96 * sd) * per)[THIN],
        color=OURS,
        alpha=0.2,
        lw=0,
        label="95 % interval",
    )
    top.plot(drive.t[THIN], (K * per)[THIN], color=OURS, lw=1.3, label="population filter, gyro 0.1 deg/s")
    top.plot(drive.t[THIN], drive.pi3[THIN], color=TRUTH, lw=1.0, label="true")
    top.plot(drive.t[THIN], paper_reads()[THIN], color=PAPER, lw=1.0, label="the paper's, perfect sensor")
    top.set_ylim(0, 0.45)
    label(top, y="π3 [-]")
    legend(top, "upper right", 4)
    error = np.abs(np.log(K / drive.K))
    bottom.semilogy(drive.t[THIN], error[THIN], color=LIGHT, lw=0.8, label="|error of ln K|")
    bottom.semilogy(drive.t[THIN], sd[THIN], color=OURS, lw=1.3, label="the filter's sd")
    bottom.semilogy(
        drive.t[THIN], least_sd()[THIN], color=INK, lw=1.1, ls="--", label="posterior Cramér–Rao bound"
    )
    bottom.set_ylim(2e-3, 1.5)
    label(bottom, "t [s]", "of ln K [-]")
    legend(bottom, "upper right", 3)
    bottom.set_xlim(0, 60)
    return figure


def today_7() -> Figure:
    """Figure 7's drive with the fixed gain and with the gain that follows the running filter."""
    figure, axes = panels(5, 8.2)
    fixed, follows = belt(), belt_scheduled()
    axes[0].plot(fixed.t[THIN], fixed.wanted[THIN], color=MUTED, lw=0.9, ls=(0, (2, 2)), label="wanted")
    for drive, colour, name in ((fixed, PAPER, "fixed gain"), (follows, OURS, "gain follows the estimate")):
        axes[0].plot(drive.t[THIN], drive.y[THIN], color=colour, lw=1.1, label=name)
        axes[1].plot(drive.t[THIN], np.degrees(drive.beta[THIN]), color=colour, lw=0.9)
        axes[2].plot(drive.t[THIN], drive.r[THIN], color=colour, lw=0.8)
    _wet_half(axes[0])
    label(axes[0], y="y [m]")
    legend(axes[0], "upper left", 3)
    label(axes[1], y="sideslip [deg]")
    label(axes[2], y="yaw rate [rad/s]")
    K, sd = belt_filter()
    per = 1 / fixed.U**2
    axes[3].fill_between(
        fixed.t[THIN],
        (K * np.exp(-1.96 * sd) * per)[THIN],
        (K * np.exp(1.96 * sd) * per)[THIN],
        color=OURS,
        alpha=0.2,
        lw=0,
    )
    axes[3].plot(
        fixed.t[THIN], (K * per)[THIN], color=OURS, lw=1.2, label="population filter, gyro 0.1 deg/s"
    )
    axes[3].plot(fixed.t[THIN], fixed.pi3[THIN], color=TRUTH, lw=0.9, label="true, mean of the front wheels")
    axes[3].set_ylim(0, 0.5)
    label(axes[3], y="π3 [-]")
    legend(axes[3], "upper left", 2)
    axes[4].semilogy(
        fixed.t[THIN], np.abs(np.log(K / fixed.K))[THIN], color=LIGHT, lw=0.8, label="|error of ln K|"
    )
    axes[4].semilogy(fixed.t[THIN], sd[THIN], color=OURS, lw=1.3, label="the filter's sd")
    axes[4].semilogy(
        fixed.t[THIN], belt_least_sd()[THIN], color=INK, lw=1.1, ls="--", label="bound, smooth belt"
    )
    axes[4].set_ylim(1e-3, 5)
    label(axes[4], "t [s]", "of ln K [-]")
    legend(axes[4], "upper left", 3)
    axes[4].set_xlim(0, 110)
    for one in axes:
        one.axvspan(70, 83, color=LIGHT, alpha=0.35, lw=0, zorder=0)
    return figure
