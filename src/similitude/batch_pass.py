"""One pass of the population filter with its slow unknowns held at trial values.

Invariant: with the unknowns held, the generated step is the Kalman filter of what is linear given them
(v*, r*, disturbance, steer offset, yaw bias), so the innovations of a pass are those of the trial car;
nothing is simulated a second way.

    x  coordinates of a trial: ln K, pi1, ln eta, ln rho, ln steer scale, ln(steer lag + EARLIEST) [s]
    s  logarithms of the noise's and the disturbance's variance against nominal
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from similitude.filter_run import Pass, Setup
from similitude.population import Prior
from similitude.steer_lag import EARLIEST
from similitude.units import Uncertain

FROZEN = {"excitation_ratio": 1e30, "idle_drift": 0.0, "drift": 0.0}  # groups held, biases follow
HELD_SD = 1e-6  # of what is known: its uncertainty must not show in the innovations
COMMANDED_LAG = Uncertain(0.100, 0.080, "s")  # a servo besides
STATED_LAG_SD = 0.2  # of a lag, where the vehicle file gives none ...
LEAST_LAG_SD = 1e-4  # s ... and of one of nothing
FROM = EARLIEST * np.eye(6)[5]  # where each unknown is counted from, (6,)


def batch_prior(prior: Prior, *, steer_scale_sd: float, lag: Uncertain) -> Prior:
    """The population's prior with the scale of the steer angle and its lag beside it.

    Parameters
    ----------
    prior : of K, pi1, eta, rho.
    steer_scale_sd : sd of the logarithm of the scale [-].
    lag : typical steer lag and its sd [s]; without one a fifth of the lag.

    Returns
    -------
    Prior    of what is counted from `FROM`: its lag is behind `EARLIEST`. A steer in step with the gyro is
             then usual; of the logarithm of the lag itself it would be infinitely far away.
    """
    lag_sd = (lag.sd or max(STATED_LAG_SD * lag.value, LEAST_LAG_SD)) / (lag.value + EARLIEST)
    covariance = np.zeros((6, 6))
    covariance[:4, :4] = prior.covariance
    covariance[4, 4], covariance[5, 5] = steer_scale_sd**2, lag_sd**2
    return Prior(
        (*prior.names, "steer_scale", "steer_lag"),
        (*prior.kinds, "log", "log"),
        np.concatenate([prior.mean, [1.0, lag.value]]) + FROM,
        covariance,
        prior.origins,
    )


@dataclass(frozen=True, eq=False)
class FrozenFilter:
    """A filter to be run over one log for one trial car after another."""

    setup: Setup
    prior: Prior  # of the six coordinates, as `batch_prior` counts them

    def at_rate(self, rate: float) -> FrozenFilter:
        """The same over the log's means at so many rows a second [Hz]."""
        return replace(self, setup=self.setup.at_rate(rate))

    def coordinates(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Coordinates of values, (6,) each."""
        return self.prior.coordinates(values + FROM)

    @property
    def middle(self) -> NDArray[np.float64]:
        """Coordinates of the prior's mean, (6,)."""
        return self.prior.coordinates(self.prior.mean)

    def values(self, x: NDArray[np.float64]) -> dict[str, float]:
        """The unknowns by name [their units]."""
        return dict(zip(self.prior.names, (self.prior.values(x) - FROM).tolist(), strict=True))

    def rows(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Samples of the log as the trial car felt them, (n, 4)."""
        at = self.values(x)
        rows = self.setup.with_lag(at["steer_lag"], HELD_SD).samples()
        rows[:, 1] *= at["steer_scale"]
        return rows

    def ready(
        self,
        x: NDArray[np.float64],
        s: NDArray[np.float64],
        *,
        zero: tuple[float, float] = (0.0, 0.0),
        held: bool = False,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Configuration and state before the first row.

        Parameters
        ----------
        x, s : (6,) the trial car and (2,) the scales of noise and disturbance.
        zero : steer offset [rad] and yaw bias [rad/s] to begin with.
        held : whether they are certain; else they are followed.
        """
        library, at = self.setup.library, self.values(x)
        noise, disturbance = np.exp(s).tolist()
        config = _config(self.setup, noise, disturbance, held)
        state = library.start(config)
        put = {name: at[name] for name in self.setup.prior.names}
        put |= {"noise_scale": noise, "input_offset": zero[0], "output_bias": zero[1]}
        for name, value in put.items():
            state[library.index("state", name)] = value
        return config, state

    def run(
        self,
        x: NDArray[np.float64],
        s: NDArray[np.float64],
        *,
        rows: NDArray[np.float64] | None = None,
        measured: NDArray[np.float64] | None = None,
        zero: tuple[float, float] = (0.0, 0.0),
        held: bool = False,
    ) -> Pass:
        """A pass over the log, or over another yaw rate in its place; see `ready`."""
        config, state = self.ready(x, s, zero=zero, held=held)
        rows = self.rows(x) if rows is None else rows
        if measured is not None:
            rows = np.column_stack([rows[:, :3], measured])
        outputs, status = self.setup.library.run(config, state, rows)
        return Pass(self.setup, config, state, outputs, status)


@lru_cache(maxsize=8)
def _config(setup: Setup, noise: float, disturbance: float, held: bool) -> NDArray[np.float64]:
    """Configuration with the unknowns and the scales held; the trial car itself stands in the state."""
    certain = {"input_offset_sd": HELD_SD, "output_bias_sd": HELD_SD} if held else {}
    config = replace(setup, input_scale_sd=HELD_SD).config(
        **FROZEN,
        **certain,
        jump_drift=0.0,
        noise_scale_low=noise,
        noise_scale_high=noise,
        disturbance_scale_start=disturbance,
        disturbance_scale_low=disturbance,
        disturbance_scale_high=disturbance,
    )
    start = setup.library.index("config", "P_prior")
    n = sum(name.endswith("_prior") for name in setup.library.names("config"))
    config[start : start + n * (n + 1) // 2] = HELD_SD**2 * np.eye(n)[np.triu_indices(n)]
    config.setflags(write=False)  # it is handed out again
    return config
