"""The rivals: what is published, or what a user would take from a shelf, each as an entrant."""

from __future__ import annotations

from importlib.util import find_spec

from similitude.benchmark.entrant import Entrant
from similitude.benchmark.kalman_rivals import dual_ekf, nine_state
from similitude.benchmark.regression_rivals import padasip, window


def rivals() -> list[Entrant]:
    """Return the rivals whose packages are installed."""
    found = [
        Entrant("nine_state", "openpilot's published equations and tuning, at 20 Hz", nine_state),
        Entrant("dual_ekf", "one extended Kalman filter for the motion, one for K, at 20 Hz", dual_ekf),
        Entrant("window", "least squares over ten seconds, at 20 Hz", window),
    ]
    if find_spec("padasip"):
        found.append(Entrant("padasip", "that package's recursive least squares, at 20 Hz", padasip))
    return found
