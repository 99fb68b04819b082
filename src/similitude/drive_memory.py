"""From one drive to the next: what a state keeps of a drive, and how it is taken up again.

A log that goes on where the last one stopped (its first time stamp within a second after the last) is
taken up exactly. Otherwise time has passed: dynamics start anew, and the tyre constant and the gyro's
bias may have changed, so their variances grow.

Invariant: a state that was aged is never surer than before, and never less sure than the population.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.change_alarm import Watch
from similitude.filter_config import DESIGN
from similitude.filter_run import Pass, Setup
from similitude.monitor_config import DESIGN as MONITOR
from similitude.program.library import Library, shipped
from similitude.saved_state import SavedState, StateError, fits
from similitude.servo import Servo
from similitude.time_scales import DAY, DRIFT, TimeScales
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import ONE_DRIVE

PARKED = 600.0  # s: after ten minutes people and load may be others, and the tyres are cold
PARKED_STD = 0.10  # of ln K that comes with it, and with the first minutes of a stop
BIAS_STD = 0.5e-3  # rad/s: a gyro's bias from one switch-on to the next
EPOCH = 1e5  # s: a later time stamp is a clock's, not a time into the drive
AFTER_A_STOP = 2 * DESIGN["gap"]  # s: enough for the dynamics to start anew
TAIL = 0.5  # s of steer kept, longer than any lag
SERVO_TAIL = 25.0  # time constants of a servo, which has forgotten what was before them


@dataclass(frozen=True, eq=False)
class TakenUp:
    """A state ready for the next drive; ``elapsed`` since the last [s], None where no clock tells."""

    filter: NDArray[np.float64]
    monitor: NDArray[np.float64]
    elapsed: float | None
    continues: bool
    state: SavedState

    @property
    def told(self) -> str:
        """How it was taken up, for the list of what was assumed."""
        if self.continues:
            return "state file: the log goes on where the last one stopped"
        if self.elapsed is None:
            return "state file, aged by a day: the clocks of the two logs do not say how long it was"
        return f"state file, aged by the {self.elapsed:.0f} s between the logs"

    @property
    def idle(self) -> float:
        """Time that passed, or is assumed to have [s]."""
        return DAY if self.elapsed is None else self.elapsed


def remember(vehicle: Vehicle, done: Pass, seen: Watch, scales: TimeScales, lag_std: float) -> SavedState:
    """The state after a drive; ``lag_std`` the sd of ln K that its steer lag adds [-]."""
    setup, log = done.setup, done.setup.log
    late = (log.t > log.t[-1] - TAIL - SERVO_TAIL * setup.servo.constant) & np.isfinite(log.delta)
    return SavedState(
        made_for=made_for(vehicle, setup),
        settings={
            "yaw_rate_noise": float(setup.noise_std),
            "steer_scale_std": float(setup.input_scale_sd),
            "steer_lag": float(setup.lag),
            **_servo(setup.servo),
            "ln_K_std_of_lag": float(lag_std),
        },
        clock=float(log.t[-1]),
        tail={"t": log.t[late].tolist(), "delta": log.delta[late].tolist()},
        filter=done.state.tolist(),
        monitor=seen.state.tolist(),
        tyre=scales.kept,
    )


def _servo(servo: Servo) -> dict[str, float]:
    """Its settings; a slew without limit is left out, as a file holds no infinity."""
    slew = {} if np.isinf(servo.slew) else {"steer_servo_slew": float(servo.slew)}
    return {"steer_servo": float(servo.constant)} | slew


def made_for(vehicle: Vehicle, setup: Setup) -> dict[str, Any]:
    """What must be the same for a state to be used again."""
    prior = setup.prior
    ratio = getattr(vehicle, "steering_ratio", None)
    return {
        "vehicle": vehicle.name,
        "estimator": "population",
        "program": _program(setup.library),
        "monitor program": _program(shipped("bicycle_monitor")),
        "L [m]": float(setup.L),
        "population": str(vehicle.population),
        "population mean": [float(x) for x in prior.mean],
        "population covariance": prior.covariance.ravel().tolist(),
        "steering ratio": None if ratio is None else float(ratio.value),
        "units": " ".join(f"{name} [{unit}]" for name, unit, _, _ in setup.library.layout.STATE),
    }


def _program(library: Library) -> str:
    """Name of a program and a digest of its C."""
    source = Path(library.layout.__file__).with_suffix(".c").read_bytes()
    return f"{library.name} {hashlib.sha256(source).hexdigest()[:16]}"


def take_up(state: SavedState, vehicle: Vehicle, setup: Setup) -> TakenUp:
    """Make a state ready for a drive.

    Raises
    ------
    StateError    it was saved for something else, or after this drive.
    """
    fits(state, made_for(vehicle, setup))
    _sizes_or_raise(state, setup.library)
    start = float(setup.log.t[0])
    elapsed: float | None = start - state.clock
    if elapsed <= 0 and min(start, state.clock) > EPOCH:
        raise StateError(
            f"the state was saved at t = {state.clock:.3f} s, this log begins {-elapsed:.3f} s before that",
            usually="logs were given out of order, or this drive is in the state already.",
            paste="similitude identify monday.csv tuesday.csv --state car.json   # in the order of driving",
            read='docs/state.md, "When a state is refused"',
        )
    if elapsed <= 0:
        elapsed = None
    kept, watched = np.array(state.filter), np.array(state.monitor)
    continues = elapsed is not None and elapsed <= DESIGN["gap"]
    if not continues:
        _age(kept, setup, DAY if elapsed is None else elapsed)
        heard = shipped("bicycle_monitor").index("state", "heard")
        again = MONITOR["heard_least"] - MONITOR["heard_again"]
        watched[heard] = min(watched[heard], again)
    return TakenUp(kept, watched, elapsed, continues, state)


def _sizes_or_raise(state: SavedState, library: Library) -> None:
    monitor = shipped("bicycle_monitor")
    sizes = (len(state.filter), len(state.monitor))
    wanted = (len(library.names("state")), len(monitor.names("state")))
    if sizes != wanted or (state.tyre and set(state.tyre) != {"ln_K", "std", "drives", "least_std"}):
        raise StateError(
            f"the state has {sizes[0]} and {sizes[1]} reals where {wanted[0]} and {wanted[1]} are needed",
            usually="it was put together by another program.",
            paste="similitude identify log.csv --state new.json   # starts from the population",
            read='docs/state.md, "When a state is refused"',
        )


def _age(state: NDArray[np.float64], setup: Setup, elapsed: float) -> None:
    """Let the variances of K and bias grow with time; no drive is sure of the other groups."""
    library = setup.library
    names = list(library.layout.COORDINATES)
    first, n = library.index("state", "P"), len(names)
    parked = elapsed >= PARKED

    def place(name: str) -> int:
        i = names.index(name)
        return first + i * n - i * (i - 1) // 2

    K, bias = place(names[3]), place("output_bias")
    prior = float(setup.prior.covariance[0, 0])
    added = min(DESIGN["drift"] * elapsed, PARKED_STD**2) + DRIFT * elapsed
    state[K] = max(state[K], min(state[K] + added, prior))
    most = DESIGN["output_bias_sd"] ** 2
    for name, std in zip(setup.prior.names[1:], setup.prior.std[1:], strict=True):
        state[place(name)] = max(state[place(name)], float(ONE_DRIVE * std) ** 2)
    added = DESIGN["bias_drift"] * elapsed + (BIAS_STD**2 if parked else 0.0)
    state[bias] = max(state[bias], min(state[bias] + added, most))


def in_line(setup: Setup, taken: TakenUp | None) -> Setup:
    """The setup of a drive that takes up a state: its first step, and the steer before it."""
    if taken is None:
        return setup
    if not taken.continues:
        return replace(setup, first_step=AFTER_A_STOP)
    tail = (np.array(taken.state.tail["t"]), np.array(taken.state.tail["delta"]))
    return replace(setup, first_step=taken.elapsed, tail=tail)
