"""A regression of the ladder over a log, and again with what it takes for granted changed.

An estimator that freezes groups knows nothing of what they cost, and its scatter holds neither that nor
a wrong steer scale, lag or noise. Each is found by a further pass of the same C: with the groups moved
along the axes of the population's covariance, the steer scaled, the lag moved, the noise's share left in,
and over the yaw rate that the assumed car itself would have had along this steer (what the regression's
form leaves out). The passes cost a fraction of a microsecond a row each.

Invariant: every row's interval is the root sum of squares of that row's own differences.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from similitude.estimators.ladder_design import ladder_config
from similitude.filter_run import Setup, side_by_side
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.steer_lag import LagScan

LADDER = ("band", "output_error", "robust")
NOISE_DOUBT = 0.5  # of the noise's variance: its sd is known to about a quarter
WORDS = {
    "scatter": "the scatter of the regression",
    "frozen": "groups frozen at the population's averages",
    "steer_scale": "the scale of the steer angle",
    "steer_lag": "the steer lag",
    "noise": "the yaw rate's noise, known to a quarter",
    "form": "what the regression's form leaves out",
}


@dataclass(frozen=True, eq=False)
class Rung:
    """One regression of the ladder set up on a log; ``prior`` holds the frozen groups at its mean."""

    setup: Setup
    library: Library
    prior: Prior
    changes: Mapping[str, float] = field(default_factory=dict)
    steer_factor: float = 1.0
    compensated: bool = True

    @property
    def sample_time(self) -> float:
        """Median step of the log [s]."""
        return self.setup.log.usual_step

    def samples(self) -> NDArray[np.float64]:
        """Rows for the step, (n, 4)."""
        rows = self.setup.samples()
        rows[:, 1] *= self.steer_factor
        return rows

    def run(self, rows: NDArray[np.float64] | None = None) -> RungPass:
        """One pass over the whole log, or over other rows (n, 4)."""
        config = ladder_config(
            self.library,
            self.prior,
            sample_time=self.sample_time,
            L=self.setup.L,
            noise_std=self.setup.noise_std,
            compensated=self.compensated,
            **self.changes,
        )
        state = self.library.start(config)
        outputs, status = self.library.run(config, state, self.samples() if rows is None else rows)
        return RungPass(self, outputs, status)

    def at(self, frozen: NDArray[np.float64]) -> Rung:
        """The same with the frozen groups' coordinates moved by so much, (3,)."""
        x = self.prior.coordinates(self.prior.mean)
        moved = self.prior.values(x + np.concatenate([[0.0], frozen]))
        return replace(self, prior=replace(self.prior, mean=moved))

    def at_lag(self, lag: float) -> Rung:
        """The same with another steer lag [s]."""
        return replace(self, setup=self.setup.with_lag(max(lag, 0.0), self.setup.input_scale_sd))


@dataclass(frozen=True, eq=False)
class RungPass:
    """Outputs (n, fields) and status (n,) of a pass."""

    rung: Rung
    outputs: NDArray[np.float64]
    status: NDArray[np.int32]

    def output(self, name: str) -> NDArray[np.float64]:
        """One output over the log, (n,)."""
        return self.outputs[:, self.rung.library.index("output", name)]

    @property
    def ln_K(self) -> NDArray[np.float64]:
        """Logarithm of the estimate, (n,)."""
        return np.log(self.output("estimate"))


def rung(name: str, setup: Setup, prior: Prior) -> Rung:
    """The shipped bicycle estimator ``band``, ``output_error`` or ``robust`` on a log."""
    return Rung(setup, shipped(f"bicycle_{name}"), prior)


def doubts(done: RungPass, scan: LagScan) -> dict[str, NDArray[np.float64]]:
    """What each row's ln K may be wrong by, as sds (n,) under the names of `WORDS`.

    Parameters
    ----------
    done : RungPass    the pass whose estimate is reported.
    scan : LagScan     whose sd, where the lag was scanned, is the lag's.
    """
    one = done.rung
    pairs = {f"frozen {i}": (one.at(axis), one.at(-axis)) for i, axis in enumerate(axes(one.prior))}
    scale = 1.0 + one.setup.input_scale_sd
    pairs["steer_scale"] = (replace(one, steer_factor=scale), replace(one, steer_factor=1 / scale))
    if scan.std > 0:
        pairs["steer_lag"] = (one.at_lag(scan.chosen + scan.std), one.at_lag(scan.chosen - scan.std))
    ends = side_by_side([lambda each=each: each.run().ln_K for pair in pairs.values() for each in pair])
    halves = {name: np.abs(ends[2 * i] - ends[2 * i + 1]) / 2 for i, name in enumerate(pairs)}
    frozen = np.sqrt(sum(halves[name] ** 2 for name in halves if name.startswith("frozen")))
    found = {"scatter": np.sqrt(done.output("variance")), "frozen": frozen}
    found |= {name: halves[name] for name in ("steer_scale", "steer_lag") if name in halves}
    if one.library.name != "bicycle_output_error":
        found["noise"] = NOISE_DOUBT * np.abs(done.ln_K - replace(one, compensated=False).run().ln_K)
        found["form"] = np.abs(form_error(done))
    return found


def form_error(done: RungPass) -> NDArray[np.float64]:
    """ln of what the regression reads over what is true, (n,), on the assumed car along this very steer.

    The yaw rate is that of the output-error model without its pull: its implicit step is the car.
    """
    one, K = done.rung, float(done.output("estimate")[-1])
    rows = one.samples()
    blind = rows.copy()
    blind[:, 3] = np.nan
    car = replace(one, library=shipped("bicycle_output_error"), changes={"K_start": K})
    rows[:, 3] = car.run(blind).output("predicted")
    start = {**one.changes, "K_start": K}
    return replace(one, changes=start, compensated=False).run(rows).ln_K - np.log(K)


def axes(prior: Prior) -> NDArray[np.float64]:
    """Principal axes of the frozen groups' covariance, each one sd long, (3, 3) by rows."""
    values, vectors = np.linalg.eigh(prior.covariance[1:, 1:])
    return (vectors * np.sqrt(np.maximum(values, 0.0))).T
