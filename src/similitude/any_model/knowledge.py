"""Knowledge: what is known of one system's parameters before any log, as a Gaussian in their logarithms.

    p_i = sign_i exp(l_i),    l ~ N(mean, covariance)

A table of similar systems, values as text ("0.01 kg m^2 +- 30 %") and the values of a system file are
brought together: a stated value conditions the table, so what the table ties to it moves along.

Invariant: every parameter that is no signal has a mean; one with zero variance is known exactly; each knows
where it came from.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from similitude.errors import UnitError, UsageError, shown
from similitude.model import Model, Quantity
from similitude.populations.population import Population
from similitude.units import parse_quantity, parse_uncertain

READ = 'docs/estimator.md, "What is known beforehand"'
EXACT = 1e-9  # sd of a logarithm below which a value counts as exact
WIDEST = 1.5  # sd of a logarithm: a factor of 4.5 either way; more is no knowledge, and no straight line


@dataclass(frozen=True, eq=False)
class Knowledge:
    """Parameters that are no signals, with sign and logarithm.

    Parameters
    ----------
    names : (p,) parameters.    signs : (p,) 1 or -1.
    mean : (p,) of ln |p|, p in SI.    covariance : (p, p) of it.
    origins : name -> where from.
    """

    names: tuple[str, ...]
    signs: NDArray[np.float64]
    mean: NDArray[np.float64]
    covariance: NDArray[np.float64]
    origins: Mapping[str, str]

    @property
    def uncertain(self) -> tuple[str, ...]:
        """Parameters that are not known exactly."""
        sd = np.sqrt(np.diag(self.covariance))
        return tuple(n for n, s in zip(self.names, sd, strict=True) if s > EXACT)

    @property
    def values(self) -> dict[str, float]:
        """Median of each parameter [SI]."""
        return dict(zip(self.names, map(float, self.signs * np.exp(self.mean)), strict=True))

    def measuring(self, names: Sequence[str]) -> Knowledge:
        """The same with parameters that only measure: 1 SI unit each, exact."""
        if not names:
            return self
        p, more = len(self.names), len(names)
        covariance = np.zeros((p + more, p + more))
        covariance[:p, :p] = self.covariance
        return Knowledge(
            (*self.names, *names),
            np.append(self.signs, np.ones(more)),
            np.append(self.mean, np.zeros(more)),
            covariance,
            {**self.origins, **dict.fromkeys(names, "one SI unit, to measure by")},
        )

    def draw(self, systems: int, *, seed: int) -> dict[str, NDArray[np.float64]]:
        """Parameters of systems drawn from it, name -> (systems,) [SI]."""
        rng = np.random.default_rng(seed)
        values, vectors = np.linalg.eigh(self.covariance)
        root = vectors * np.sqrt(np.maximum(values, 0))
        logs = self.mean + rng.standard_normal((systems, len(self.names))) @ root.T
        drawn = self.signs * np.exp(logs)
        return {n: drawn[:, i] for i, n in enumerate(self.names)}


def gather_knowledge(
    model: Model,
    *,
    values: Mapping[str, float],
    prior: Mapping[str, str] | None = None,
    population: Population | None = None,
) -> Knowledge:
    """Bring together what is known of a system's parameters.

    Parameters
    ----------
    model : Model.
    values : parameter -> value [SI] of the system's file; taken as exact where nothing else is said.
    prior : parameter -> text with a unit and, where it is uncertain, a standard deviation:
        ``"0.01 kg m^2 +- 0.003 kg m^2"`` or ``"0.01 kg m^2 +- 30 %"``; without one it is exact.
    population : of similar systems, in place of `values` for the parameters that its table teaches.

    Returns
    -------
    Knowledge

    Raises
    ------
    UsageError    a name is no parameter, nothing is known of one, or a spread is no factor.
    UnitError     a text cannot be read.
    """
    prior = dict(prior or {})
    free = [q for q in model.parameters if q.name not in (*model.signals, *model.constraints)]
    names = tuple(q.name for q in free)
    strange = [n for n in prior if n not in names]
    if strange:
        raise UsageError(
            f"prior names {shown(strange[0])}, which is no free parameter of {model.name!r} "
            f"(there are {', '.join(names)})",
            usually="the name was misspelt, or is that of a signal, which each sample brings along.",
            paste=f"prior={{{names[0]!r}: '1 {free[0].unit} +- 30 %'}}",
            read=READ,
        )
    mean, covariance, signs = np.full(len(names), np.nan), np.zeros((len(names),) * 2), np.ones(len(names))
    origins: dict[str, str] = {}
    if population is not None:
        products = [{n: Fraction(1)} for n in names]
        mean, covariance = population.moments(products, predictive=True)
        taught = np.isfinite(mean) & np.isfinite(population.logs_of(products)).any(axis=0)
        mean = np.where(taught, mean, np.nan)
        covariance = np.where(np.outer(taught, taught), covariance, 0.0)
        origins = {n: population.table.name for i, n in enumerate(names) if np.isfinite(mean[i])}
    for i, q in enumerate(free):
        if q.name in prior:
            value, sd = _stated(q, prior[q.name])
            origin = "stated" if sd else "stated, exact"
        elif np.isfinite(mean[i]):
            continue
        elif q.name in values:
            value, sd, origin = values[q.name], 0.0, "the system's own value, taken as exact"
        elif q.value is not None:
            value, sd, origin = q.value, 0.0, "known to the model"
        else:
            raise _nothing_known(model, q)
        origins[q.name] = origin
        signs[i] = np.sign(value)
        mean, covariance = _condition(mean, covariance, i, float(np.log(abs(value))), sd)
    return Knowledge(names, signs, mean, covariance, origins)


def _condition(
    mean: NDArray, covariance: NDArray, i: int, value: float, sd: float
) -> tuple[NDArray, NDArray]:
    """State ln p_i: what the table ties to it moves along; its own entry is what was stated."""
    if not np.isfinite(mean[i]) or covariance[i, i] <= EXACT**2:
        mean = mean.copy()
        mean[i], covariance = value, covariance.copy()
        covariance[i, :] = covariance[:, i] = 0.0
        covariance[i, i] = sd**2
        return mean, covariance
    slope = covariance[:, i] / covariance[i, i]
    mean = np.where(np.isfinite(mean), mean + slope * (value - mean[i]), mean)
    rest = covariance - np.outer(slope, covariance[i])
    return mean, rest + sd**2 * np.outer(slope, slope)


def _stated(q: Quantity, text: str) -> tuple[float, float]:
    """Value [SI] and sd of its logarithm."""
    if not isinstance(text, str):
        raise UnitError(
            f"prior of {q.name!r} is {shown(text)}, which is no text with a unit",
            usually="a bare number was given, and nobody can tell in which unit.",
            paste=f"prior={{{q.name!r}: '{text} {q.unit} +- 30 %'}}",
            read=READ,
        )
    found = re.fullmatch(r"\s*(.*?)\s*(?:±|\+-|\+/-)\s*([\d.eE+-]+)\s*%\s*", text)
    try:
        if found:
            value, _ = parse_quantity(found.group(1), expect=q.dimension)
            sd = float(found.group(2)) / 100
        else:
            told = parse_uncertain(text, expect=q.dimension)
            value, sd = told.value, (told.sd or 0.0) / abs(told.value) if told.value else 0.0
    except UnitError as error:
        raise UnitError(
            f"prior of {q.name!r}: {error.what}",
            usually=error.usually,
            paste=f"prior={{{q.name!r}: '1 {q.unit} +- 30 %'}}",
            read=error.read,
        ) from None
    if value == 0 or not 0 <= sd <= WIDEST:
        raise UsageError(
            f"prior of {q.name!r}: {text!r} does not say its sign and its size within a factor",
            usually="zero or a spread beyond the value was given; unknowns are logarithms, so leave a "
            "term that may vanish out of the model, or state how small and how large it can be.",
            paste=f"prior={{{q.name!r}: '1 {q.unit} +- 50 %'}}",
            read=READ,
        )
    return value, sd


def _nothing_known(model: Model, q: Quantity) -> UsageError:
    return UsageError(
        f"nothing is known of parameter {q.name!r} [{q.unit}] of {model.name!r}",
        usually="a value, or a typical one with its spread, was forgotten; no prior is assumed silently.",
        paste=f"prior={{..., {q.name!r}: '1 {q.unit} +- 30 %'}}",
        read=READ,
    )


def names_of(quantities: Sequence[Quantity]) -> str:
    """Names with units, for messages."""
    return ", ".join(f"{q.name} [{q.unit}]" for q in quantities)
