"""Numbers of the sampled regression: the model at the median as matrices over one sample, and its slopes.

Invariant: coefficients are exact up to rounding (matrix exponential in 50 digits where it matters); only
their straight line in the unknown is an approximation, and how far it is off is told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.any_model.fewest_unknowns import FewestUnknowns
from similitude.any_model.filter_numbers import LIMIT_SD, ROOM, Doubts
from similitude.any_model.trial import Trial
from similitude.population import Prior
from similitude.program.library import Library
from similitude.reduction import Reduction
from similitude.sampled_linearity import LINEAR

RANGE = 2.0  # sds of the unknown over which the sampled coefficients are to be straight
SETTLE = 5.0  # times that the output keeps to itself, after a gap


@dataclass(frozen=True, eq=False)
class SampledModel:
    """The model over one sample, input straight in between: x+ = F x + g0 u + g1 u+, y = C x + D u."""

    F: NDArray[np.float64]
    g0: NDArray[np.float64]
    g1: NDArray[np.float64]
    C: NDArray[np.float64]
    D: float

    @property
    def denominator(self) -> NDArray[np.float64]:
        """a1 .. an of the characteristic polynomial."""
        return np.poly(self.F)[1:]

    @property
    def coefficients(self) -> NDArray[np.float64]:
        """Numerator b0 .. bn and denominator a1 .. an of the sampled transfer function."""
        a, n = self.denominator, len(self.F)
        markov, x = [self.C @ self.g1 + self.D], self.F @ self.g1 + self.g0
        for _ in range(n):
            markov.append(self.C @ x)
            x = self.F @ x
        full = np.concatenate([[1.0], a])
        b = [sum(full[j] * markov[k - j] for j in range(k + 1)) for k in range(n + 1)]
        return np.concatenate([b, a])


def sampler(fewest: FewestUnknowns, reduction: Reduction, step: float) -> Callable[[NDArray], SampledModel]:
    """Unknowns (q,) in the order of the reduction -> the sampled model in SI.

    Parameters
    ----------
    fewest : FewestUnknowns.    reduction : linear, no signals.    step : [s].
    """
    from scipy.linalg import expm

    model = reduction.groups.model
    x, u = [q.symbol for q in model.states], model.inputs[0].symbol
    number = {sp.Symbol(n, real=True): v for n, v in fewest.units.items()}
    quiet = dict.fromkeys([*x, u], 0)
    f = sp.Matrix([reduction.rates[q.name] for q in model.states])
    y = sp.Matrix([reduction.output_map[model.outputs[0].name]])
    parts = [m.subs(quiet).subs(number) for m in
             (f.jacobian(x), f.jacobian([u]), y.jacobian(x), y.jacobian([u]))]  # fmt: skip
    numeric = sp.lambdify([one.symbol for one in reduction.unknowns], parts, "numpy")
    T = step / fewest.units["time_unit"]
    into = fewest.units[f"{model.inputs[0].name}_unit"]
    out = fewest.units[f"{model.outputs[0].name}_unit"]

    def sampled(values: NDArray) -> SampledModel:
        A, B, C, D = (np.array(m, dtype=float) for m in numeric(*values))
        n = len(A)
        block = np.zeros((n + 2, n + 2))
        block[:n, :n], block[:n, n], block[n, n + 1] = A * T, B[:, 0] * T / into, 1.0
        E = expm(block)
        return SampledModel(
            E[:n, :n], E[:n, n] - E[:n, n + 1], E[:n, n + 1], out * C[0], out * D[0, 0] / into
        )

    return sampled


@dataclass(frozen=True)
class Straightness:
    """How far sampled coefficients leave their straight line over `RANGE` sds, as a share of their change."""

    worst: float

    @property
    def is_straight(self) -> bool:
        """Whether a regression may be used."""
        return self.worst <= LINEAR


def straightness(fewest: FewestUnknowns, reduction: Reduction, prior: Prior, step: float) -> Straightness:
    """Compare the sampled coefficients with their chord over the prior's range of the first unknown.

    Parameters
    ----------
    reduction, prior : of the same order.    step : [s].
    """
    sampled = sampler(fewest, reduction, step)
    d = np.linspace(np.exp(-RANGE * prior.std[0]), np.exp(RANGE * prior.std[0]), 15) - 1
    exact = np.array([sampled(_moved(prior, one)).coefficients for one in d])
    middle = sampled(prior.mean).coefficients
    slope = (d @ (exact - middle)) / (d @ d)
    change = np.abs(exact - middle).max(axis=0)
    off = np.abs(exact - middle - np.outer(d, slope)).max(axis=0)
    moving = change > 1e-6 * change.max(initial=0.0)
    return Straightness(float((off[moving] / change[moving]).max(initial=0.0)))


def _moved(prior: Prior, d: float) -> NDArray:
    values = prior.mean.copy()
    values[0] *= 1 + d
    return values


def regression_numbers(
    library: Library,
    fewest: FewestUnknowns,
    reduction: Reduction,
    prior: Prior,
    trial: Trial,
    doubts: Doubts,
    *,
    frozen: float,
    bend: float,
) -> tuple[np.ndarray, dict[str, tuple[float, str, str]]]:
    """The flat configuration, and what was taken from where.

    Parameters
    ----------
    library : the compiled regression.    prior : in the order of the reduction.
    frozen : sd of the unknown's logarithm that the frozen unknowns leave open [-].
    bend : how far the sampled coefficients leave their straight line, as a share of their change [-].
    """
    model, step = reduction.groups.model, trial.step
    sampled, sd = sampler(fewest, reduction, step), prior.std[0]
    middle, up, down = (sampled(_moved(prior, d)) for d in (0.0, sd, -sd / (1 + sd)))
    width = sd + sd / (1 + sd)
    into, read = _denominator_filter(middle, (up.denominator - down.denominator) / width)
    bias = doubts.output_bias if doubts.output_bias is not None else doubts.noise
    drift = doubts.drift or 0.0
    unit = model.outputs[0].unit
    values = {
        "sample_time": step,
        "F": middle.F.ravel(),
        "G_then": middle.g0,
        "G_now": middle.g1,
        "C": middle.C,
        "D": middle.D,
        "F_slope": (up.F - down.F).ravel() / width,
        "G_then_slope": (up.g0 - down.g0) / width,
        "G_now_slope": (up.g1 - down.g1) / width,
        "C_slope": (up.C - down.C) / width,
        "D_slope": (up.D - down.D) / width,
        "A_into": into,
        "A_out": read,
        f"{prior.names[0]}_prior": prior.mean[0],
        "prior_information": sd**-2,
        "bias_information": bias**-2,
        "frozen_variance": frozen**2,
        "bend": bend,
        "d_low": np.exp(-LIMIT_SD * sd) - 1,
        "d_high": np.exp(LIMIT_SD * sd) - 1,
        "noise_variance": doubts.noise**2,
        "forgetting": 1 - max(1e-7, min(0.01, step * drift**2 / sd**2 if drift else 0.0)),
        "settle": SETTLE * trial.slowest / step,
        "input_limit": ROOM * float(np.abs(trial.u).max()),
        "output_limit": ROOM * (float(np.abs(trial.output).max()) + 5 * doubts.noise + 5 * bias),
    }
    assumed = {
        "noise": (doubts.noise, unit, "stated"),
        "output_bias": (bias, unit, "stated" if doubts.output_bias else "taken: as large as the noise"),
        "frozen": (frozen, "-", "sd of the unknown from those that are frozen"),
        "bend": (bend, "-", "share by which the sampled coefficients leave their straight line"),
        "drift": (drift, "1/sqrt(s)", "stated" if doubts.drift else "taken: the system does not change"),
    }
    return library.config(values), assumed


def _denominator_filter(middle: SampledModel, change: NDArray) -> tuple[NDArray, NDArray]:
    """A1/A0 = sum of change_k z^-k over A0 as c (zI - F)^-1 g with w read before it is moved."""
    import mpmath

    n = len(middle.F)
    with mpmath.workdps(60):
        F = mpmath.matrix(middle.F.tolist())
        a = [mpmath.mpf(1), *_characteristic(F)]
        g = mpmath.matrix([mpmath.mpf(v) for v in _irregular(n)])
        markov = []
        for k in range(n):  # long division of the change by A0
            markov.append(mpmath.mpf(float(change[k])) - sum(a[j] * markov[k - j] for j in range(1, k + 1)))
        columns, x = mpmath.matrix(n, n), g
        for k in range(n):
            for i in range(n):
                columns[k, i] = x[i]
            x = F * x
        read = mpmath.lu_solve(columns, mpmath.matrix(markov))
        return _irregular(n), np.array([float(v) for v in read])


def _irregular(n: int) -> NDArray:
    """An input that reaches every mode of any transition but contrived ones."""
    return 1 + 0.37 * np.arange(n)


def _characteristic(F) -> list:
    """a1 .. an by Faddeev and LeVerrier, in mpmath's digits."""
    import mpmath

    n = F.rows
    M, found = mpmath.eye(n), []
    for k in range(1, n + 1):
        product = F * M
        c = -sum(product[i, i] for i in range(n)) / k
        found.append(c)
        M = product + c * mpmath.eye(n)
    return found
