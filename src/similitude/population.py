"""Prior: what a population of similar systems says about the unknowns before the first sample.

Invariant: means are values, the covariance is that of the coordinates (logarithms where ``kinds``
says so), and every entry knows where it came from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Prior:
    """Mean values (n,) and covariance (n, n) of the coordinates of n named unknowns."""

    names: tuple[str, ...]
    kinds: tuple[str, ...]  # "log" or "linear"
    mean: NDArray[np.float64]
    covariance: NDArray[np.float64]
    origins: Mapping[str, str] = field(default_factory=dict)

    @property
    def std(self) -> NDArray[np.float64]:
        """Standard deviations of the coordinates, (n,)."""
        return np.sqrt(np.diag(self.covariance))

    def coordinates(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Coordinates of values, (n,) each."""
        log = np.array([kind == "log" for kind in self.kinds])
        return np.where(log, np.log(np.where(log, values, 1.0)), values)

    def values(self, coordinates: NDArray[np.float64]) -> NDArray[np.float64]:
        """Values of coordinates, (n,) each."""
        log = np.array([kind == "log" for kind in self.kinds])
        return np.where(log, np.exp(np.where(log, coordinates, 0.0)), coordinates)

    def limits(self, widths: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Lowest and highest value (n,) each, at the given distance in coordinates (n,)."""
        log = np.array([kind == "log" for kind in self.kinds])
        low = np.where(log, self.mean * np.exp(-widths), self.mean - widths)
        high = np.where(log, self.mean * np.exp(widths), self.mean + widths)
        return low, high

    def observe(self, name: str, value: float, std: float, origin: str) -> Prior:
        """Condition on a measurement of one unknown.

        Parameters
        ----------
        name : an unknown of this prior.
        value : measured value [unit of the unknown].
        std : sd of the measurement in the coordinate (of the logarithm where it is one).
        origin : where the measurement came from, in words.
        """
        i = self.names.index(name)
        log = np.array([kind == "log" for kind in self.kinds])
        away = np.log(value / self.mean[i]) if log[i] else value - self.mean[i]
        column = self.covariance[:, i]
        gain = column / (column[i] + std**2)
        move = gain * away
        return replace(
            self,
            mean=np.where(log, self.mean * np.exp(np.where(log, move, 0)), self.mean + move),
            covariance=self.covariance - np.outer(gain, column),
            origins={**self.origins, name: origin},
        )

    def known(self, name: str, value: float, std: float, origin: str) -> Prior:
        """Put a better source in place of the population for one unknown.

        Parameters are those of `observe`; what the population ties to this unknown is cut.
        """
        i = self.names.index(name)
        mean, covariance = self.mean.copy(), self.covariance.copy()
        mean[i] = value
        covariance[i, :] = covariance[:, i] = 0.0
        covariance[i, i] = std**2
        return replace(self, mean=mean, covariance=covariance, origins={**self.origins, name: origin})

    def of(self, names: tuple[str, ...]) -> Prior:
        """The same of these unknowns alone, whatever the others are."""
        places = [self.names.index(name) for name in names]
        return Prior(
            tuple(names),
            tuple(self.kinds[i] for i in places),
            self.mean[places],
            self.covariance[np.ix_(places, places)],
            {name: self.origins[name] for name in names if name in self.origins},
        )

    def beside(
        self, name: str, kind: str, mean: float, std: float, origin: str, *, as_of: str | None = None
    ) -> Prior:
        """The same with one more unknown, independent of the others or off as one of them is.

        Parameters
        ----------
        name, kind : of the unknown, ``"log"`` or ``"linear"``.
        mean : its value [its unit]. std : sd of its coordinate.
        origin : where they came from, in words.
        as_of : the unknown whose error is in it, with ``std`` for what it has besides.
        """
        n = len(self.names)
        copied = np.eye(n)[[self.names.index(as_of)]] if as_of else np.zeros((1, n))
        rows = np.vstack([np.eye(n), copied])
        covariance = rows @ self.covariance @ rows.T
        covariance[n, n] += std**2
        return Prior(
            (*self.names, name),
            (*self.kinds, kind),
            np.append(self.mean, mean),
            covariance,
            {**self.origins, name: origin},
        )
