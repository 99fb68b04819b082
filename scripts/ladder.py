"""Prints what each estimator of the ladder is worth on one bench (`make ladder`).

The paper's small car at 1 kHz and constant speed, its stiffness halved and restored every ten seconds;
steer a square wave or a sum of sines; forgetting 0.9995 a sample; noise of 0.5 and 2 deg/s; the frozen
groups the car's own or the paper's averages. Bias and sd of K over the last three seconds of each ten.
"""

from __future__ import annotations

import math

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.estimators.ladder_design import ladder_config
from similitude.estimators.paper_design import PAPER_GROUPS, paper_config
from similitude.filter_config import filter_config
from similitude.population import Prior
from similitude.program.library import shipped
from similitude.simulate import bicycle_response

RATE, SECONDS, HOLD, LAST = 1000, 80, 10, 3  # Hz, s, s between steps, s that are judged
MEMORY = 2.0  # s: forgetting 0.9995 at 1 kHz
L, M, IZ, A, CAF, CAR, U = 0.3652, 5.451, 0.1615, 0.1461, 65.0, 110.0, 4.0  # paper, section 2
K = CAF * L / M
OWN = {"pi1": A / L, "k": CAR / CAF, "pi5": IZ / (M * L * L)}
AVERAGE = {"pi1": PAPER_GROUPS["pi1"], "k": PAPER_GROUPS["pi4_slope"], "pi5": PAPER_GROUPS["pi5"]}
NAMES = ("paper", "band", "output_error", "robust", "population")
CELLS = (
    ("0.5 deg/s, own groups", 0.5, OWN),
    ("2 deg/s, own groups", 2.0, OWN),
    ("0.5 deg/s, averages", 0.5, AVERAGE),
)


def coordinates(groups: dict[str, float]) -> dict[str, float]:
    """pi1, eta and rho of pi1, k = pi4/pi3 and pi5."""
    p1, k, pi5 = groups["pi1"], groups["k"], groups["pi5"]
    return {"pi1": p1, "eta": k * (1 - p1) / p1, "rho": pi5 / (p1 * (1 - p1))}


def steers() -> dict[str, np.ndarray]:
    """0.1 rad of a 0.7 Hz square behind the paper's servo (5 Hz, 0.707), and of six sines; (n,) [rad]."""
    t = np.arange(RATE * SECONDS) / RATE
    square = 0.1 * np.where((0.7 * t) % 1 < 0.5, 1.0, -1.0)
    w, T, x, v = 2 * math.pi * 5, 1 / RATE, 0.0, 0.0
    behind = []
    for wanted in square.tolist():
        v += T * (w * w * (wanted - x) - 2 * 0.707 * w * v)
        x += T * v
        behind.append(x)
    phases = np.random.default_rng(0).uniform(0, 2 * np.pi, 6)
    waves = zip((0.3, 0.7, 1.1, 1.9, 3.1, 4.7), phases, strict=True)
    sines = 0.1 / math.sqrt(6) * sum(np.sin(2 * np.pi * f * t + p) for f, p in waves)
    return {"square": np.array(behind), "sines": sines}


def config(name: str, groups: dict[str, float], noise: float) -> np.ndarray:
    """Configuration of an estimator for the bench; K starts 20 % low."""
    library, own = shipped(f"bicycle_{name}"), coordinates(groups)
    prior = Prior(
        ("K", "pi1", "eta", "rho"),
        ("log", "linear", "log", "log"),
        np.array([0.8 * K, own["pi1"], own["eta"], own["rho"]]),
        np.diag(np.square([0.7, 0.04, 0.30, 0.15])),  # population of small cars
    )
    if name == "paper":
        slopes = {"pi1": groups["pi1"], "pi4_slope": groups["k"], "pi5": groups["pi5"]}
        forgetting = math.exp(-1 / RATE / MEMORY)
        return paper_config(
            library, sample_time=1 / RATE, L=L, speed=U, noise_std=noise, forgetting=forgetting, **slopes
        )
    if name == "population":
        return filter_config(library, prior, L=L, noise_std=noise, input_scale_sd=0.02)
    return ladder_config(library, prior, sample_time=1 / RATE, L=L, noise_std=noise, memory=MEMORY)


def measured(name: str, noise: float, groups: dict[str, float], drives: list[tuple]) -> list[float]:
    """Bias at full and at half stiffness and sd [%], over both steers; noise in deg/s."""
    library = shipped(f"bicycle_{name}")
    bias: dict[float, list[float]] = {1.0: [], 0.5: []}
    spread = []
    for i, (delta, r, scale, judged) in enumerate(drives):
        noisy = r + np.deg2rad(noise) * np.random.default_rng(10 + i).standard_normal(r.size)
        rows = np.column_stack([np.full(r.size, 1 / RATE), delta, np.full(r.size, U), noisy])
        made = config(name, groups, np.deg2rad(noise))
        outputs, _ = library.run(made, library.start(made), rows)
        for size, found in bias.items():
            error = outputs[judged & (scale == size), 0] / (K * size) - 1
            found.append(float(error.mean()))
            spread.append(float(error.std()))
    return [100 * float(np.mean(x)) for x in (bias[1.0], bias[0.5], spread)]


def main() -> None:
    """Measure every cell and print the table."""
    t = np.arange(RATE * SECONDS) / RATE
    scale = np.where((t // HOLD) % 2 == 0, 1.0, 0.5)
    judged = (t > 2 * HOLD) & (t % HOLD > HOLD - LAST)
    drives = []
    for delta in steers().values():
        r, _ = bicycle_response(t, delta, U, L=L, K=K * scale, **coordinates(OWN))
        drives.append((delta, r, scale, judged))
    table = Table(title="K: bias at full / half stiffness; sd [%], 1 kHz, square and sines")
    for title in ("estimator", *(cell[0] for cell in CELLS), "operations"):
        table.add_column(title, justify="left" if title == "estimator" else "right")
    for name in NAMES:
        cells = []
        for _, noise, groups in CELLS:
            full, half, sd = measured(name, noise, groups, drives)
            cells.append(f"{full:+.1f} / {half:+.1f}; {sd:.1f}" if sd < 100 else f"{full:+.0f} / {half:+.0f}")
        table.add_row(name, *cells, str(shipped(f"bicycle_{name}").layout.OPERATIONS))
    Console(width=110).print(table)


if __name__ == "__main__":
    main()
