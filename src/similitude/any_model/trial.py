"""A trial on the desk: the median system along the drive that is planned, and how its output moves.

Invariant: slopes are central differences of the dimensional plant along the shortest change of the parameters
that moves one unknown, so they check the reduction: the output depends on the unknowns alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.any_model.fewest_unknowns import FewestUnknowns
from similitude.any_model.plant import Response, respond
from similitude.model import Model

DIFFERENCE = 1e-3  # of a logarithm, each way: its square is the relative error of a slope


@dataclass(frozen=True, eq=False)
class Trial:
    """The median system's response.

    Parameters
    ----------
    u : (n,) input [SI].    step : [s].
    states : (n, states), output : (n,) [SI].
    slopes : (n, q) d output / d ln unknown [SI of the output].
    slowest : slowest time constant about the start [s].
    """

    u: NDArray[np.float64]
    step: float
    states: NDArray[np.float64]
    output: NDArray[np.float64]
    slopes: NDArray[np.float64]
    slowest: float


def try_drive(
    model: Model, fewest: FewestUnknowns, u: NDArray, step: float, *, start: dict[str, float]
) -> Trial:
    """Drive the median system and its neighbours along an input.

    Parameters
    ----------
    model : Model      with one input and one output.
    fewest : FewestUnknowns.
    u : (n,) input [SI].    step : [s].    start : state -> value [SI].

    Returns
    -------
    Trial
    """
    q = len(fewest.prior.names)
    S, E = fewest.knowledge.covariance, fewest.exponents
    path = np.linalg.solve(E @ S @ E.T, E @ S)  # (q, p): E path' = one
    logs = fewest.knowledge.mean + DIFFERENCE * np.vstack([0 * path[:1], path, -path])
    drawn = fewest.knowledge.signs * np.exp(logs)
    values = {n: drawn[:, i] for i, n in enumerate(fewest.knowledge.names)} | dict(fewest.signals)
    response: Response = respond(model, values, u, step, start=start)
    slopes = (response.output[1 : q + 1] - response.output[q + 1 :]).T / (2 * DIFFERENCE)
    return Trial(u, step, response.states[0], response.output[0], slopes, _slowest(response, u, step))


def _slowest(response: Response, u: NDArray, step: float) -> float:
    """Time the output keeps to itself: its autocorrelation's first fall below 1/e [s]."""
    y = response.output[0] - response.output[0].mean()
    if not y.any():
        return step
    size = 1 << (2 * len(y)).bit_length()
    spectrum = np.abs(np.fft.rfft(y, size)) ** 2
    correlation = np.fft.irfft(spectrum)[: len(y)]
    below = np.flatnonzero(correlation < correlation[0] / np.e)
    return step * float(below[0] if below.size else len(y))
