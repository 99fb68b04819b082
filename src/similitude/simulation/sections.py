"""The sections of a scenario that choose: timing, which plant, which driver.

Invariant: what a plant needs it asks for; a plant without height or track has no key for them.
"""

from __future__ import annotations

from dataclasses import dataclass

from similitude.dimension import FREQUENCY, LENGTH, TIME
from similitude.simulation.foreign import MODELS, VEHICLES
from similitude.simulation.keys import NUMBER, choice, key
from similitude.simulation.lqr import Lqr
from similitude.simulation.manoeuvres import MANOEUVRES


@dataclass(frozen=True, kw_only=True)
class Timing:
    """How long, in which steps, and how often the logger writes."""

    duration: float = key('"60 s"', TIME, "length of the drive", least=0.1, most=4e4)
    step: float = key('"2 ms"', TIME, "step of the integration", least=1e-5, most=0.05)
    log_rate: float = key('"100 Hz"', FREQUENCY, "rows a second", least=0.1, most=1e5)

    @property
    def rows_every(self) -> int:
        """Steps from one row of the log to the next [-]."""
        return round(1 / (self.log_rate * self.step))

    @property
    def ticks(self) -> int:
        """Number of instants [-]: the first, and the end of every step."""
        return round(self.duration / self.step) + 1


@dataclass(frozen=True, kw_only=True)
class Linear:
    """The linear bicycle."""


@dataclass(frozen=True, kw_only=True)
class Saturating:
    """One wheel an axle, tyres that saturate."""

    tyre: str = choice("cubic", "brush", words="onset of saturation")
    height: float = key('"0.55 m"', LENGTH, "centre of gravity above the road", default=0.0, least=0)


@dataclass(frozen=True, kw_only=True)
class TwoTrackKeys:
    """Four wheels."""

    tyre: str = choice("cubic", "brush", "linear", words="onset of saturation")
    height: float = key('"0.55 m"', LENGTH, "centre of gravity above the road", least=0)
    track: float = key('"1.55 m"', LENGTH, "distance of left and right wheels", least=1e-3)
    front_roll_share: float = key("0.55", NUMBER, "share of load transfer at the front", least=0, most=1)
    roll_time: float = key('"0.15 s"', TIME, "time constant of the roll", least=1e-3)
    load_sensitivity: float = key("0.2", NUMBER, "loss of stiffness with load", default=0.0, least=0, most=1)


@dataclass(frozen=True, kw_only=True)
class Commonroad:
    """A car of the package commonroad-vehicle-models."""

    model: str = choice(*MODELS, words="equations")
    vehicle: str = choice(*VEHICLES, words="parameters")


PLANTS = {"linear": Linear, "saturating": Saturating, "two_track": TwoTrackKeys, "commonroad": Commonroad}
DRIVERS = {**MANOEUVRES, "lqr": Lqr}
