"""A trajectory and its slopes in the logarithms of all arguments, integrated together.

    x' = f(x, a, t)         S' = (df/dx) S + df/d ln a         x(0), S(0) from the initial states

Invariant: the tolerance is 1e-12 of each state's own size, found by a rough run, so that what is read off
holds to 1e-9. Slopes are those of the differential equation, not differences of runs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.invariance.compiled import compiled, log_slope

ROUGH, FINE = 1e-6, 1e-12  # of a state's greatest size over the run [-]
MOST = {"LSODA": 50_000, "DOP853": 500_000}  # evaluations of the rates between two times; some seconds
STIFF = 2000.0  # fastest rate times duration [-] from which the implicit method is taken


@dataclass(frozen=True)
class Flow:
    """Equations ready to be integrated.

    Parameters
    ----------
    states : (n,) symbols.
    arguments : (m,) symbols; slopes are taken in their logarithms.
    time : the symbol of time.
    rates : (n,) d(state)/dt in the three above.
    initial : (n,) states at time zero, in the arguments.
    outputs : (p,) formulas read off along the way.
    """

    states: tuple[sp.Symbol, ...]
    arguments: tuple[sp.Symbol, ...]
    time: sp.Symbol
    rates: tuple[sp.Expr, ...]
    initial: tuple[sp.Expr, ...]
    outputs: tuple[sp.Expr, ...]

    def integrator(self):
        """Compile once; returns a function of (argument values (m,), times (k,), with_slopes)."""
        symbols = [*self.states, *self.arguments, self.time]
        f, g = self.rates, self.outputs
        jacobian = [sp.diff(e, x) for e in f for x in self.states]
        forcing = [log_slope(e, a) for e in f for a in self.arguments]
        rate = compiled(symbols, f)
        moved = compiled(symbols, [*f, *jacobian, *forcing])
        outer = [sp.diff(e, x) for e in g for x in (*self.states, self.time)]
        read = compiled(symbols, [*g, *outer, *(log_slope(e, a) for e in g for a in self.arguments)])
        start = compiled(
            self.arguments, [*self.initial, *(log_slope(e, a) for e in self.initial for a in self.arguments)]
        )
        return _Integrator(self, rate, moved, read, start)


class _Integrator:
    """The compiled functions of a Flow."""

    def __init__(self, flow: Flow, rate, moved, read, start) -> None:
        self.n, self.m, self.p = len(flow.states), len(flow.arguments), len(flow.outputs)
        self.rate, self.moved, self.read, self.start = rate, moved, read, start

    def __call__(
        self, values: Sequence[float], times: np.ndarray, *, with_slopes: bool = True
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """States (k, n), outputs (p, k) and their slopes (p, m + 1, k): in ln of each argument, of time."""
        times = np.asarray(times, dtype=float)
        order = np.unique(times)
        start = np.array(self.start(*values), dtype=float)
        state = self._run(values, order, start if with_slopes else start[: self.n], with_slopes)
        at = np.searchsorted(order, times)
        outputs = np.array([self._outputs(values, order[k], state[k], with_slopes) for k in at])
        return state[at][:, : self.n], outputs[:, :, 0].T, np.moveaxis(outputs[:, :, 1:], 0, -1)

    def _run(self, values, order: np.ndarray, start: np.ndarray, with_slopes: bool) -> np.ndarray:
        end = float(order[-1]) if len(order) else 0.0
        if end == 0.0:
            return np.tile(start, (len(order), 1))
        rough = _solve(self._plain(values), (0.0, end), start[: self.n], None, "LSODA", ROUGH, 1e-12)
        size = np.abs(rough.y).max(axis=1)
        size = np.where(size > 0, size, size.max() or 1.0)
        method = "LSODA" if self._pace(values, rough) * end > STIFF else "DOP853"
        floor = FINE * (np.concatenate([size, np.repeat(size, self.m)]) if with_slopes else size)
        rhs = self._augmented(values) if with_slopes else self._plain(values)
        found, now = [], start
        stops = np.concatenate([[0.0], order[order > 0]])
        for before, after in pairwise(stops):
            now = _solve(rhs, (before, after), now, None, method, FINE, floor).y[:, -1]
            found.append(now)
        return np.array([start, *found]) if order[0] == 0 else np.array(found)

    def _plain(self, values):
        return lambda t, x: np.array(self.rate(*x, *values, t), dtype=float)

    def _augmented(self, values):
        n, m = self.n, self.m

        def rhs(t: float, both: np.ndarray) -> np.ndarray:
            flat = np.array(self.moved(*both[:n], *values, t), dtype=float)
            jacobian, forcing = flat[n : n + n * n].reshape(n, n), flat[n + n * n :].reshape(n, m)
            slopes = jacobian @ both[n:].reshape(n, m) + forcing
            return np.concatenate([flat[:n], slopes.reshape(-1)])

        return rhs

    def _pace(self, values, rough) -> float:
        """The fastest rate of the linearised equations along a rough run [1/time]."""
        n, fastest = self.n, 0.0
        for k in range(0, rough.y.shape[1], max(1, rough.y.shape[1] // 10)):
            flat = np.array(self.moved(*rough.y[:, k], *values, rough.t[k]), dtype=float)
            jacobian = flat[n : n + n * n].reshape(n, n)
            if np.all(np.isfinite(jacobian)):
                fastest = max(fastest, float(np.abs(np.linalg.eigvals(jacobian)).max(initial=0.0)))
        return fastest

    def _outputs(self, values, t: float, both: np.ndarray, with_slopes: bool) -> np.ndarray:
        """(p, 1 + m + 1): each output, its slopes in ln of the arguments, and t dy/dt."""
        n, m, p = self.n, self.m, self.p
        x = both[:n]
        flat = np.array(self.read(*x, *values, t), dtype=float)
        y = flat[:p]
        outer = flat[p : p + p * (n + 1)].reshape(p, n + 1)
        direct = flat[p + p * (n + 1) :].reshape(p, m)
        if not with_slopes:
            return y[:, None]
        rate = np.array(self.rate(*x, *values, t), dtype=float)
        slopes = outer[:, :n] @ both[n:].reshape(n, m) + direct
        return np.column_stack([y, slopes, t * (outer[:, :n] @ rate + outer[:, n])])


def _solve(rhs, span, start, at, method: str, rtol: float, atol):
    from scipy.integrate import solve_ivp

    asked = [0]

    def counted(t: float, x: np.ndarray) -> np.ndarray:
        asked[0] += 1
        if asked[0] > MOST[method]:
            raise _lost(t, span[1], f"{MOST[method]} evaluations were not enough")
        return rhs(t, x)

    with np.errstate(all="ignore"):
        found = solve_ivp(counted, span, start, method=method, t_eval=at, rtol=rtol, atol=atol)
    if not found.success or not np.all(np.isfinite(found.y)):
        raise _lost(found.t[-1] if len(found.t) else span[0], span[1], found.message)
    return found


def _lost(reached: float, end: float, why: str) -> ModelError:
    return ModelError(
        f"the trajectory cannot be followed beyond {reached:.4g} of {end:.4g}: {why}",
        usually="A state runs away or leaves where its rate is a number (the root of a negative level).",
        paste="values = {..., 't': 0.1}   # a shorter time, or other initial states",
        read='docs/invariances.md, "Time responses"',
    )
