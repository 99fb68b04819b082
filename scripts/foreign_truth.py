"""Prints which K the yaw rate of the foreign cars holds, in the benchmark's drives (`make foreign-truth`).

The linear bicycle with the car's own pi1 and rho is fitted to the yaw rate before the change, along the steer
at the wheels, by least squares in ln K, ln eta and the bias of the gyro, no prior. The table holds ln K less
that of the slope of the tyres, which is the truth of the benchmark: the least and the most of a cell's cars.
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table
from scipy.optimize import least_squares
from scipy.signal import cont2discrete, lfilter, ss2tf

from similitude.benchmark.cells import CHANGE_AT, cells
from similitude.benchmark.drives import Drive, Truth, drives
from similitude.benchmark.kept_drives import foreign_version
from similitude.benchmark.running import SEED

BEGIN = 3.0  # s: what the car did before the drive is forgotten
STEP = 0.01  # s, of the benchmark's rows


def main() -> None:
    """Fit every foreign drive and print a line a cell."""
    if foreign_version() is None:
        sys.exit("commonroad-vehicle-models is missing: pip install 'similitude[plants]'")
    table = Table(title="K in the yaw rate, against the slope of the tyres")
    for name in ("cell", "least", "most"):
        table.add_column(name, justify="left" if name == "cell" else "right")
    for cell in cells(quick=False, foreign=True, part="table"):
        if cell.is_foreign:
            off = [fitted(*one) for one in drives(cell, SEED)]
            table.add_row(cell.name, *(f"{100 * x:+.0f} %" for x in (min(off), max(off))))
    Console(width=100).print(table)


def fitted(drive: Drive, truth: Truth) -> float:
    """Return ln K of the bicycle nearest to the yaw rate, less that of the slope."""
    rows = (drive.t > BEGIN) & (drive.t < CHANGE_AT)
    speed = float(np.mean(drive.U[rows]))
    start = np.array([np.log(truth.K[0]), np.log(truth.groups["eta"]), 0.0])

    def left(x: NDArray[np.float64]) -> NDArray[np.float64]:
        K, eta = np.exp(x[:2])
        return (yaw_rate(truth, K, eta, drive.L, speed) + x[2] - drive.r)[rows]

    return float(least_squares(left, start, method="lm", x_scale=[0.1, 0.1, 1e-3]).x[0] - start[0])


def yaw_rate(truth: Truth, K: float, eta: float, L: float, U: float) -> NDArray[np.float64]:
    """Yaw rate (n,) [rad/s] of the linear bicycle of unit mass, from the steer at the wheels."""
    a = truth.groups["pi1"] * L
    b, front = L - a, K / L
    rear, inertia = front * eta * a / b, truth.groups["rho"] * a * (L - a)
    both, turn = front + rear, a * front - b * rear
    turned = -(a * a * front + b * b * rear) / inertia / U
    A = np.array([[-both / U, -turn / U - U], [-turn / inertia / U, turned]])
    B, C, D = np.array([[front], [a * front / inertia]]), np.array([[0.0, 1.0]]), np.zeros((1, 1))
    above, below = ss2tf(*cont2discrete((A, B, C, D), STEP, method="foh")[:4])
    return lfilter(above[0], below, truth.delta)


if __name__ == "__main__":
    main()
