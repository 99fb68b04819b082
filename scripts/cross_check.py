"""Prints how often the cross-check rings, on sound cars and on errors of the structure (`make cross-check`).

Cars of the reference experiment, a minute each; the table of docs/estimators.md; two minutes on two cores.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich.console import Console
from rich.table import Table
from tests.montecarlo.experiment import NOISE, Fleet, fleet, log_of_car

from similitude.cross_check import cross_check
from similitude.identify_setup import prepare
from similitude.log import Log
from similitude.run import CrossCheck
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

GRAVITY = 9.80665  # m/s^2
NO_LAG = Uncertain(0.0, None, "s")
STEPS = 4  # of the saturating plant in a row


def checked(log: Log, L: float, **known: Uncertain) -> CrossCheck | None:
    """The cross-check of one log of a car of which the wheelbase [m] is known."""
    ready = prepare(log, Vehicle("car", L=Uncertain(float(L), None, "m"), **known))
    return cross_check(ready, ready.setup.run())


def late(log: Log, rows: int) -> Log:
    """The log of a steer that acts so many rows after its column says so."""
    return replace(log, delta=np.r_[log.delta[rows:], np.full(rows, log.delta[-1])])


def scaled(log: Log, factor: float) -> Log:
    """The log of a steer angle written down so many times as large."""
    return replace(log, delta=log.delta * factor)


def saturated(cars: Fleet, i: int, rms: float) -> Log:
    """The car on tyres F = C a/sqrt(1 + (C a/mu Fz)^2), mu 1, driven to so many m/s^2 rms of a linear car."""
    log, unknown = log_of_car(cars, i), cars.unknowns(i)
    U, L, p1 = float(cars.U[i]), float(cars.L[i]), unknown["pi1"]
    p2, front, grip = 1 - p1, unknown["K"] / U**2, GRAVITY * L / U**2
    rear, inertia = front * unknown["eta"] * p1 / p2, unknown["rho"] * p1 * p2
    steer = log.delta * rms / np.std(U * log.r)
    h, v, r, yaw = (log.t[1] - log.t[0]) * U / L / STEPS, 0.0, 0.0, [0.0]

    def force(C: float, a: float, most: float) -> float:
        return C * a / math.sqrt(1 + (C * a / most) ** 2)

    def rates(v: float, r: float, d: float) -> tuple[float, float]:
        f, b = force(front, d - v - p1 * r, grip * p2), force(rear, p2 * r - v, grip * p1)
        return f + b - r, (p1 * f - p2 * b) / inertia

    for now, then in zip(steer[:-1].tolist(), steer[1:].tolist(), strict=True):
        for k in range(STEPS):
            d = now + (then - now) * (k + 0.5) / STEPS
            dv, dr = rates(v, r, d)
            dv, dr = rates(v + h / 2 * dv, r + h / 2 * dr, d)
            v, r = v + h * dv, r + h * dr
        yaw.append(r * U / L)
    noise = NOISE * np.random.default_rng(i).standard_normal(len(yaw))
    return replace(log, delta=steer, r=np.array(yaw) + noise)


def main() -> None:
    """Score every kind of log at both steers and print the table."""
    table = Table(title="Cross-check: share of the checked logs in which it rang")
    for title in ("log", "steer", "checked", "rang", "rms of d/sd", "of d0/sd"):
        table.add_column(title, justify="left" if title == "log" else "right")
    for rms in (3e-3, 10e-3):
        sound = [fleet(seed, cars=120, duration=60.0, steer_rms=rms, halve=False) for seed in (21, 41)]
        few = fleet(21, cars=40, duration=60.0, steer_rms=rms, halve=False)
        halved = fleet(22, cars=40, duration=60.0, step=30.0, steer_rms=rms)
        row(table, "sound", rms, sound, lambda c, i: checked(log_of_car(c, i), c.L[i]))
        row(table, "stiffness halved at 30 s", rms, [halved], lambda c, i: checked(log_of_car(c, i), c.L[i]))
        row(
            table,
            "100 ms late, scanned",
            rms,
            [few],
            lambda c, i: checked(late(log_of_car(c, i), 10), c.L[i]),
        )
        for rows in (3, 10):
            stated = {"steer_lag": NO_LAG}
            row(
                table, f"{10 * rows} ms late, file says none", rms, [few],
                lambda c, i, rows=rows, s=stated: checked(late(log_of_car(c, i), rows), c.L[i], **s),
            )  # fmt: skip
        for factor in (1.3, 1 / 1.3):
            row(
                table, f"steer scale x {factor:.2f}", rms, [few],
                lambda c, i, f=factor: checked(scaled(log_of_car(c, i), f), c.L[i]),
            )  # fmt: skip
    hard = fleet(21, cars=12, duration=60.0, steer_rms=10e-3, halve=False)
    for rms in (2.0, 4.0, 6.0):
        name = f"saturating tyres, {rms:g} m/s^2 rms"
        row(table, name, 10e-3, [hard], lambda c, i, a=rms: checked(saturated(c, i, a), c.L[i]))
    Console(width=110).print(table)


def row(
    table: Table, name: str, rms: float, fleets: list[Fleet], check: Callable[[Fleet, int], CrossCheck | None]
) -> None:
    """One line of the table."""
    found = [check(cars, i) for cars in fleets for i in range(len(cars.L))]
    said = [one for one in found if one is not None]
    rang = np.mean([one.structure_error for one in said]) if said else 0.0
    spreads = [
        np.sqrt(np.mean([(getattr(one, d) / getattr(one, sd)) ** 2 for one in said])) if said else 0.0
        for d, sd in (("apart", "std"), ("average_apart", "average_std"))
    ]
    table.add_row(
        name, f"{1000 * rms:g} mrad", f"{len(said)} of {len(found)}", f"{100 * rang:.1f} %",
        *(f"{x:.2f}" for x in spreads),
    )  # fmt: skip


if __name__ == "__main__":
    main()
