"""Prints what the bundled real logs say, log by log (`make real-logs`); half a minute on two cores.

Prediction one second ahead against average cars, K of the whole log and of its halves, interval widths
against the whole-log fit's, and K before and after every visit beyond 0.3 g. No log has a known truth:
what can be asked is that they predict, that they do not contradict themselves, and that they say so.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.identify_population import identify_population
from similitude.log import Log, read_log
from similitude.run import Run
from similitude.vehicle_file import read_vehicle
from similitude.verdict import LINEAR

DATA = Path(__file__).parents[1] / "data"
LOGS = {
    "rav4_straight": "rav4",
    "bmw_m8_double_lane_change": "bmw_m8",
    **{f"f1tenth_ds{i}": "f1tenth" for i in range(1, 6)},
}
AFTER = 2.0  # s after a visit, and the pause that parts two
LONG = 0.3  # s of a visit


@dataclass(frozen=True, eq=False)
class RealLog:
    """A population run over a log and over its halves."""

    whole: Run
    first: Run
    second: Run

    @property
    def halves_apart(self) -> float:
        """Between the halves' ln K, over the sum of their 95 % half-widths; above 1 they do not meet."""
        a, b = self.first, self.second
        widths = 1.96 * (a.trace.ln_K_std[-1] + b.trace.ln_K_std[-1])
        return float(abs(np.log(a.K.value / b.K.value)) / widths)

    @property
    def visits(self) -> list[float]:
        """Changes of ln K over each visit beyond 0.3 g, in sds of before and after together."""
        t, ln_K, sd = self.whole.trace.t, np.log(self.whole.trace.K), self.whole.trace.ln_K_std
        beyond = np.flatnonzero(np.abs(self.whole.trace.ay_kinematic) > LINEAR)
        moved = []
        for visit in np.split(beyond, np.flatnonzero(np.diff(t[beyond]) > AFTER) + 1):
            if not visit.size or not visit[0] or t[visit[-1]] - t[visit[0]] < LONG:
                continue
            before, after = visit[0] - 1, int(np.searchsorted(t, t[visit[-1]] + AFTER))
            if after < t.size:
                moved.append(float((ln_K[after] - ln_K[before]) / np.hypot(sd[before], sd[after])))
        return moved


def half(log: Log, second: bool) -> Log:
    """The rows of one half of the time."""
    rows = (log.t > 0.5 * (log.t[0] + log.t[-1])) == second
    ay = None if log.ay is None else log.ay[rows]
    return replace(log, t=log.t[rows], delta=log.delta[rows], r=log.r[rows], U=log.U[rows], ay=ay)


def examined(name: str) -> RealLog:
    """Run a bundled log and its halves."""
    vehicle, log = read_vehicle(DATA / f"{LOGS[name]}.toml"), read_log(DATA / f"{name}.csv")
    parts = (log, half(log, False), half(log, True))
    return RealLog(*(identify_population(part, vehicle) for part in parts))


def main() -> None:
    """Run every log and print the tables."""
    ahead = Table(title="Yaw rate one second ahead: rms error in deg/s, and over that of the average car")
    for title in ("log", "estimate", "average car", "with the log's lag", "whole-log fit", "ratio", "strict"):
        ahead.add_column(title, justify="left" if title == "log" else "right")
    found = Table(title="K, and whether a log contradicts itself")
    for title in (
        "log",
        "verdict",
        "K",
        "width / fit's",
        "halves",
        "their fits",
        "apart",
        "beyond 0.3 g",
        "moved by visits",
    ):
        found.add_column(title, justify="left" if title in ("log", "verdict") else "right")
    ratios = []
    for name in LOGS:
        one = examined(name)
        run, p = one.whole, one.whole.prediction
        ratios.append((p["ratio_to_frozen"], p["ratio_to_averages_with_lag"]))
        errors = [
            np.rad2deg(p["rms"][x]) for x in ("estimate", "frozen_averages", "averages_with_lag", "batch")
        ]
        ahead.add_row(name, *(f"{x:.2f}" for x in errors), *(f"{x:.2f}" for x in ratios[-1]))
        width = run.trace.ln_K_std[-1] / (run.batch.K.std / run.batch.K.value)
        beyond = np.mean(np.abs(run.trace.ay_kinematic) > LINEAR)
        found.add_row(
            name,
            run.verdict,
            f"{run.K.value:.3g} ± {100 * run.trace.ln_K_std[-1]:.0f} %",
            f"{width:.2f}",
            f"{one.first.K.value:.3g}, {one.second.K.value:.3g}",
            f"{one.first.batch.K.value:.3g}, {one.second.batch.K.value:.3g}",
            f"{one.halves_apart:.2f}",
            f"{100 * beyond:.0f} %",
            " ".join(f"{z:+.1f}" for z in one.visits),
        )
    geometric = np.exp(np.mean(np.log(ratios), axis=0))
    ahead.add_row("geometric mean", *[""] * 4, *(f"{x:.2f}" for x in geometric))
    console = Console(width=132)
    console.print(ahead)
    console.print(found)
    console.print("apart: over the sum of both 95 % half-widths; moved: ln K before and 2 s after, in sd")


if __name__ == "__main__":
    main()
