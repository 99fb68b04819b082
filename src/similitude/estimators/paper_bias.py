"""What sensor noise does to the paper's regression, predicted before its number is printed.

Regressor and target hold the same noisy yaw rate. With white noise of sd sigma on it, coloured by
the high-pass (rho_i the autocorrelation of its impulse response at lag i), and S = mean phi^2 of
the noise-free signals,

    pi3^ -> (pi3 S + m2 (3 rho0 - 4 rho1 + rho2) sigma^2) / (S + 2 m2^2 (rho0 - rho1) sigma^2)

Without a filter rho = (1, 0, 0): 3 m2 sigma^2 and 2 m2^2 sigma^2.
Invariant: the noise's share is taken out of the measured mean square before it is used as S.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from similitude.estimators.paper_design import high_pass_biquad, section_gain
from similitude.program.library import Library

WHITE = (1.0, 0.0, 0.0)  # autocorrelation of unfiltered noise


@dataclass(frozen=True)
class NoiseBias:
    """The predicted bias of the regression.

    ``pi3`` the value it is predicted for, ``reads`` what the regression tends to, ``relative`` =
    reads/pi3 - 1; ``noise_share`` of the measured mean square of the regressor that is noise [-];
    ``noise_std`` of the yaw rate [rad/s].
    """

    pi3: float
    reads: float
    relative: float
    noise_share: float
    noise_std: float

    @property
    def text(self) -> str:
        """One sentence for people, to stand before the regression's number."""
        return (
            f"with {np.degrees(self.noise_std):.2g} deg/s of yaw-rate noise this regression reads "
            f"pi3 = {self.reads:.3g} for a true {self.pi3:.3g} ({100 * self.relative:+.0f} %); "
            f"{100 * self.noise_share:.0f} % of its regressor's power is noise"
        )


def autocorrelation(biquads: ArrayLike, lags: int = 3) -> NDArray[np.float64]:
    """Autocorrelation of the filter's impulse response, (lags,) [-].

    Parameters
    ----------
    biquads : (2, 5) sections b0, b1, b2, a1, a2.
    """
    from scipy.signal import sosfilt

    sections = np.insert(np.asarray(biquads, dtype=float).reshape(-1, 5), 3, 1.0, axis=1)
    poles = np.concatenate([np.roots(row[3:]) for row in sections])
    length = int(40.0 / -np.log(max(np.abs(poles).max(), 0.01))) + 64  # e^-40 is beyond double precision
    impulse = np.zeros(length)
    impulse[0] = 1.0
    response = sosfilt(sections, impulse)
    return np.array([response[i:] @ response[: length - i] for i in range(lags)])


def noise_bias(
    *,
    pi3: float,
    m2: float,
    noise_std: float,
    mean_square: float,
    rho: Sequence[float] | NDArray[np.float64] = WHITE,
    star: float = 1.0,
) -> NoiseBias:
    """The value the regression tends to under white yaw-rate noise.

    Parameters
    ----------
    pi3 : the true value to predict for [-].
    m2 : slope of eq 22 at the log's T [-].
    noise_std : white noise of the yaw rate a sample [rad/s].
    mean_square : mean phi^2 as measured, noise included [-].
    rho : autocorrelation of the high-pass at lags 0, 1, 2.
    star : L/U, dimensionless per physical yaw rate [s].

    Returns
    -------
    NoiseBias    where nothing but noise is measured, the limit that noise alone leads to.
    """
    variance = (noise_std * star) ** 2
    target = m2 * (3 * rho[0] - 4 * rho[1] + rho[2]) * variance
    regressor = 2 * m2**2 * (rho[0] - rho[1]) * variance
    signal = max(mean_square - regressor, 0.0)
    total = signal + regressor
    reads = (pi3 * signal + target) / total if total > 0 else pi3
    share = regressor / total if total > 0 else 0.0
    return NoiseBias(pi3, reads, reads / pi3 - 1.0, share, noise_std)


def predicted_bias(
    library: Library,
    config: NDArray[np.float64],
    state: NDArray[np.float64],
    *,
    L: float,
    noise_std: float,
    pi3: float,
) -> NoiseBias:
    """The bias at the end of a run, from the regressor the estimator itself has seen.

    It keeps the weighted sum of phi^2 and of the weights, in physical units per theta and without the
    filter's gain; mean phi^2 of the dimensionless, filtered signals follows from their ratio.

    Parameters
    ----------
    library, config, state : the estimator and its state after at least one update.
    L : wheelbase [m].
    noise_std : white noise of the yaw rate a sample [rad/s].
    pi3 : the value to predict for, at the last usable speed [-].
    """

    def value(struct: str, name: str) -> float:
        return float((config if struct == "config" else state)[library.index(struct, name)])

    poles = [config[library.index("config", f"poles_{k}") :][:2] for k in (1, 2)]
    sections = np.array([high_pass_biquad(*pair) for pair in poles])
    U = value("state", "last_U")
    updates = value("state", "weight") - 1.0  # one is the sensor's own noise, for the start
    m2 = U / value("config", "K_per_theta")  # theta is (a1 + 2) U, and K is pi3 U^2
    per_pi3 = section_gain(sections) * L * m2  # dimensionless filtered output of a unit of pi3 per phi
    return noise_bias(
        pi3=pi3,
        m2=m2,
        noise_std=noise_std,
        mean_square=per_pi3**2 * value("state", "normal") / updates if updates > 0 else 0.0,
        rho=autocorrelation(sections),
        star=L / U,
    )
