"""Whether a sampled model is linear in its unknown: the question of the paper's Figure 4.

    x(q+1) = F x(q) + G u(q)    exact for an input held over T (paper, eq 21)
    y/u = (b1 z^(n-1) + ... + bn) / (z^n + a1 z^(n-1) + ... + an)

Each coefficient is compared with the straight line that leaves its value at unknown = 0 along the tangent
there (paper, eq 22), as a share of what the unknown has changed it by. Where the line holds, a recursive
regression is enough; where it does not, a filter on the model itself is wanted.

Invariant: coefficients are exact up to rounding; only the line is an approximation.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.errors import UsageError
from similitude.reduction import Reduction

POINTS = 41  # of the unknown's range
SMALL = 1e-4  # of the range's upper end: where the tangent is taken
LINEAR = 0.1  # worst error up to which a regression is chosen; the paper's own case has 0.053
NOTHING = 1e-9  # change of a coefficient that counts as none
WIDE = 1.959964  # sds of a 95 % range


@dataclass(frozen=True, eq=False)
class Linearity:
    """Sampled coefficients over the range of the unknown.

    Parameters
    ----------
    unknown : str            its name.    at : (k,) its values [its unit].    T : time step [-]
    exact, line : name -> (k,) coefficient, and the straight line
    error : name -> worst |exact - line| over |exact - value at 0| [-]
    """

    unknown: str
    at: NDArray[np.float64]
    T: float
    exact: Mapping[str, NDArray[np.float64]]
    line: Mapping[str, NDArray[np.float64]]
    error: Mapping[str, float]

    @property
    def worst(self) -> float:
        """Worst error of all coefficients [-]."""
        return max(self.error.values())

    @property
    def estimator(self) -> str:
        """``regression`` where the line holds over the range, else ``population``."""
        return "regression" if self.worst <= LINEAR else "population"

    @property
    def text(self) -> str:
        """One line: range, worst error, and what follows."""
        name = max(self.error, key=self.error.get)
        return (
            f"{self.unknown} from {self.at[0]:.4g} to {self.at[-1]:.4g} at T = {self.T:.3g}: {name} is off "
            f"its line by {100 * self.worst:.2g} % at worst, so {self.estimator}"
        )


def sampled_linearity(
    reduction: Reduction,
    values: Mapping[str, float],
    *,
    step: float,
    spread: float | None = None,
    between: tuple[float, float] | None = None,
) -> Linearity:
    """Compare the sampled coefficients with a straight line in the first unknown.

    Parameters
    ----------
    reduction : Reduction    linear in states and input, one input.
    values : name -> value [SI] of every unknown (a population's means) and of every scale of the base.
    step : sample time [s].
    spread : sd of ln unknown; the range is then its 95 % interval about `values`.
    between : the range itself, instead.

    Returns
    -------
    Linearity

    Raises
    ------
    UsageError               neither or both of `spread` and `between`, or a value is missing.

    References
    ----------
    Brennan & Alleyne 2004, eqs 21-23 and Figure 4.
    """
    unknown = reduction.unknowns[0]
    if (spread is None) == (between is None):
        raise UsageError(
            f"the range of {unknown.name!r} was given {'twice' if spread is not None else 'not at all'}",
            usually="a population's sd of the logarithm is at hand: pass that, or two ends.",
            paste="sampled_linearity(reduction, values, step=0.001, spread=0.5)",
            read='docs/populations.md, "Linear once sampled"',
        )
    middle = values.get(unknown.name, 1.0)
    ends = between or (middle * np.exp(-WIDE * spread), middle * np.exp(WIDE * spread))
    at = np.linspace(*ends, POINTS)
    coefficients, T = _sampler(reduction, values, step)
    zero, small = coefficients(0.0), coefficients(SMALL * ends[1])
    exact = np.array([coefficients(x) for x in at])
    line = zero + np.outer(at, (small - zero) / (SMALL * ends[1]))
    n = (len(zero)) // 2
    names = [f"b{i + 1}" for i in range(n)] + [f"a{i + 1}" for i in range(n)]
    changed = np.abs(exact - zero).max(axis=0) > NOTHING
    error = np.max(np.abs(exact - line) / np.maximum(np.abs(exact - zero), 1e-300), axis=0)
    return Linearity(
        unknown.name,
        at,
        T,
        {name: exact[:, i] for i, name in enumerate(names)},
        {name: line[:, i] for i, name in enumerate(names)},
        {name: float(error[i]) for i, name in enumerate(names) if changed[i]},
    )


def _sampler(reduction: Reduction, values: Mapping[str, float], step: float):
    """Unknown -> coefficients (2 n,), and the dimensionless step."""
    groups, first = reduction.groups, reduction.unknowns[0]
    model = groups.model
    states = [q.symbol for q in model.states]
    f = sp.Matrix([groups.rates[q.name] for q in model.states])
    u = [model.inputs[0].symbol]
    y = sp.Matrix([groups.output_map[model.outputs[0].name]])
    names = [u.name for u in reduction.unknowns[1:]] + list(groups.base)
    lost = [n for n in names if n not in values]
    if lost:
        raise UsageError(
            f"sampling {model.name!r} needs a value of {', '.join(lost)}",
            usually="the means of the other unknowns and the scales of the base are all wanted.",
            paste=f"values={{..., {lost[0]!r}: 1.0}}",
            read='docs/populations.md, "Linear once sampled"',
        )
    known = {sp.Symbol(n, real=True): values[n] for n in names}
    substitution = {g.symbol: sp.sympify(reduction.substitution[g.name]).subs(known) for g in groups.groups}
    quiet = dict.fromkeys([*states, *u], 0)
    blocks = [sp.Matrix(m).subs(substitution).subs(quiet) for m in
              (f.jacobian(states), f.jacobian(u), y.jacobian(states))]  # fmt: skip
    numeric = sp.lambdify([first.symbol], blocks, "numpy")
    T = step / float(sp.sympify(groups.time_scale).subs(known))

    def coefficients(x: float) -> NDArray:
        A, B, C = (np.array(m, dtype=float) for m in numeric(x))
        return sampled_transfer(A, B, C, T)

    return coefficients, T


def sampled_transfer(A: NDArray, B: NDArray, C: NDArray, T: float) -> NDArray:
    """Transfer function of a linear model sampled with a held input.

    Parameters
    ----------
    A (n, n), B (n, 1), C (1, n) : the model [-].    T : step [-].

    Returns
    -------
    (2 n,)    numerator b1..bn and denominator a1..an.
    """
    from scipy.linalg import expm

    n = len(A)
    block = expm(np.block([[A * T, B * T], [np.zeros((1, n + 1))]]))
    F, G = block[:n, :n], block[:n, n:]
    a = np.poly(F)[1:]
    markov, b, power = [], [], G
    for _ in range(n):
        markov.append(float((C @ power)[0, 0]))
        power = F @ power
    for k in range(n):
        b.append(markov[k] + sum(a[j] * markov[k - 1 - j] for j in range(k)))
    return np.concatenate([b, a])
