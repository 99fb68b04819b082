"""The driver that follows a path: optimal state feedback with integral action.

    x = [∫(y − ref), y − ref, ẏ, ψ, ψ̇],  u = −k x  [rad];  ẏ across the road [m/s]
    minimises ∫ x' diag(weights) x + effort u² dt

References
----------
Brennan & Alleyne 2004, eqs 1-3 (the model) and eqs 29-32 (the design).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.dimension import LENGTH, SPEED, TIME
from similitude.simulation.car import Car
from similitude.simulation.keys import ANGLE, NUMBER, Place, choice, key, refuse, table

STATES = 5
# Factors on the stiffness for which gains of a schedule are designed; in between they are
# interpolated over its logarithm.
SCHEDULED = np.geomspace(0.1, 4.0, 33).tolist()


@dataclass(frozen=True, kw_only=True)
class Path:
    """Where the driver wants to be across the road: a square wave, and points joined by lines.

    The two are added. Without points the line is y = 0.
    """

    square: float = key('"0.06 m"', LENGTH, "amplitude of a square wave", default=0.0, least=0)
    period: float = key('"5 s"', TIME, "its period", default=1.0, least=1e-2)
    until: float = key('"60 s"', TIME, "when it ends; it stays at zero then", default=np.inf)
    times: tuple = key('["60 s", "61 s"]', "numbers", "times of the points", default=(), each=TIME)
    offsets: tuple = key('["0 m", "0.45 m"]', "numbers", "their places", default=(), each=LENGTH)

    def at(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the wanted offset at times t (n,) [m]."""
        sign = np.where(np.mod(t, self.period) < self.period / 2, 1.0, -1.0)
        line = np.interp(t, self.times, self.offsets) if self.times else 0.0
        return self.square * sign * (t < self.until) + line


@dataclass(frozen=True, kw_only=True)
class Lqr:
    """A driver who steers by the state of the car; `schedule` says whose stiffness he believes.

    Parameters are those of the table: with ``schedule = "none"`` one gain, that of `design_stiffness`;
    with "truth" that of the stiffness under the front axle, with "estimate" that of the population
    filter which runs beside the drive, or of a function given to `run_scenario`.
    """

    weights: tuple = key("[0.03, 5, 0.02, 0.1, 0.001]", "numbers", "weights of the five states",
                         each=NUMBER)  # fmt: skip
    effort: float = key("1.0", NUMBER, "weight of the steer", least=1e-9)
    design_speed: float = key('"3 m/s"', SPEED, "speed the gain is designed for", least=0.1)
    design_stiffness: float = key("0.5", NUMBER, "factor on the stiffness that one gain is designed for",
                                  default=1.0, least=0.01, most=10)  # fmt: skip
    limit: float = key('"30 deg"', ANGLE, "largest command", least=1e-3, most=1.5)
    path: Path = table(Path, "where to drive", default=Path())
    feedback: str = choice("truth", "sensors", words="yaw rate he feels", default="truth")
    schedule: str = choice("none", "truth", "estimate", words="whose stiffness he believes", default="none")

    def check(self, place: Place) -> None:
        """Raise ScenarioError where weights or path do not fit together."""
        if len(self.weights) != STATES:
            refuse(
                place, "weights", f"weights has {len(self.weights)} numbers, and there are {STATES} states",
                usually="the integral of the offset was forgotten; it is the first.",
                paste="weights = [0.03, 5, 0.02, 0.1, 0.001]",
            )  # fmt: skip
        inside = place.within("path")
        if len(self.path.times) != len(self.path.offsets):
            refuse(
                inside, "times", f"{len(self.path.times)} times and {len(self.path.offsets)} offsets",
                usually="a point was added to one of the two lists.",
                paste='times = ["0 s", "2 s"]  with  offsets = ["0 m", "3.5 m"]',
            )  # fmt: skip
        if any(later <= one for one, later in zip(self.path.times, self.path.times[1:], strict=False)):
            refuse(
                inside, "times", "times do not increase",
                usually="two points were exchanged; a jump is two times a millisecond apart.",
                paste='times = ["60 s", "60.001 s"]',
            )  # fmt: skip


def path_matrices(car: Car, U: float, stiffness: float = 1.0) -> tuple[NDArray, NDArray]:
    """Return A (4, 4) and B (4,) of x = [y, ẏ, ψ, ψ̇] for one car.

    Parameters
    ----------
    car : Car          floats
    U : float          speed [m/s]
    stiffness : float  factor on both axles [-]

    References
    ----------
    Brennan & Alleyne 2004, eqs 1-3.
    """
    Cf, Cr = car.Caf * stiffness, car.Car * stiffness
    m, Iz, a, b = car.m, car.Iz, car.a, car.b
    turn = b * Cr - a * Cf
    A = np.array([
        [0, 1, 0, 0],
        [0, -(Cf + Cr) / (m * U), (Cf + Cr) / m, turn / (m * U)],
        [0, 0, 0, 1],
        [0, turn / (Iz * U), -turn / Iz, -(a * a * Cf + b * b * Cr) / (Iz * U)],
    ])  # fmt: skip
    return A, np.array([0, Cf / m, 0, a * Cf / Iz])


def lqr_gain(car: Car, driver: Lqr, *, stiffness: float = 1.0, U: float | None = None) -> NDArray[np.float64]:
    """Design the gain.

    Parameters
    ----------
    car : Car          floats
    driver : Lqr
    stiffness : float  factor on both axles for which it is designed [-]
    U : float          speed, that of the design when left out [m/s]

    Returns
    -------
    (5,) k of u = −k x: [rad/(m s), rad/m, rad s/m, 1, s]
    """
    from scipy.linalg import solve_continuous_are

    A, B = path_matrices(car, driver.design_speed if U is None else U, stiffness)
    with_integral = np.zeros((STATES, STATES))
    with_integral[0, 1] = 1.0
    with_integral[1:, 1:] = A
    entry = np.concatenate([[0.0], B])[:, None]
    cost = solve_continuous_are(with_integral, entry, np.diag(driver.weights), [[driver.effort]])
    return (entry.T @ cost)[0] / driver.effort


class Follower:
    """An `Lqr` at the wheel of one car or many; holds the integral of the offset.

    Parameters
    ----------
    driver : Lqr
    car : Car     the car as its designer knows it, floats
    t : (n,)      instants at which he steers [s]
    """

    def __init__(self, driver: Lqr, car: Car, t: NDArray[np.float64]) -> None:
        self.driver = driver
        self._wanted = driver.path.at(t).tolist()
        self._step = float(t[1] - t[0])
        self._integral: Any = 0.0
        self._k = lqr_gain(car, driver, stiffness=driver.design_stiffness).tolist()
        self._gains = None
        if driver.schedule != "none":
            self._gains = np.array([lqr_gain(car, driver, stiffness=x) for x in SCHEDULED]).T
            self._at_grid = self._gains.T.tolist()
            self._per_step = (len(SCHEDULED) - 1) / math.log(SCHEDULED[-1] / SCHEDULED[0])

    def wanted(self, tick: int) -> float:
        """Return the wanted offset [m]."""
        return self._wanted[tick]

    def command(self, tick: int, y: Any, y_dot: Any, psi: Any, r: Any, stiffness: Any = None) -> Any:
        """Return the commanded angle [rad]; once a tick.

        Parameters
        ----------
        tick : int
        y, y_dot, psi, r : float or (cars,)   offset [m], its rate [m/s], heading [rad], yaw rate [rad/s]
        stiffness : float or (cars,)          believed factor on the stiffness [-], where scheduled
        """
        k = self._k if stiffness is None else self._scheduled(stiffness)
        off = y - self._wanted[tick]
        u = -(k[0] * self._integral + k[1] * off + k[2] * y_dot + k[3] * psi + k[4] * r)
        most = self.driver.limit
        if isinstance(u, float):
            held = min(max(u, -most), most)
            windup = abs(u) > most
            self._integral += 0.0 if windup else off * self._step
            return held
        # At the limit the integral rests, or it would grow for as long as the limit lasts.
        self._integral = self._integral + np.where(abs(u) > most, 0.0, off * self._step)
        return np.clip(u, -most, most)

    def _scheduled(self, stiffness: Any) -> list[Any]:
        if np.ndim(stiffness):
            at = np.log(np.clip(stiffness, SCHEDULED[0], SCHEDULED[-1]))
            return [np.interp(at, np.log(SCHEDULED), row) for row in self._gains]
        # One car, at every step: the same line in floats, ten times faster.
        held = min(max(float(stiffness), SCHEDULED[0]), SCHEDULED[-1])
        place = math.log(held / SCHEDULED[0]) * self._per_step
        i = min(int(place), len(SCHEDULED) - 2)
        rest = place - i
        return [one + (other - one) * rest for one, other in zip(*self._at_grid[i : i + 2], strict=True)]
