"""Slopes of outputs by parameters and starts: rows of d(y_0, y_1, ...)/d(p, x(0)) at random points.

    x(t) = sum x_k t^k,  x_(k+1) = f_k/(k + 1),  y(t) = sum y_k t^k       order by order, slopes carried along

Orders are added while they bring a new row, points while they bring a new direction.

Invariant: inputs and varying parameters are random polynomials without slopes; nothing else moves by itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.arithmetic import BadPoint, Digits, Floats, Modular, Series
from similitude.symmetry.equations import Equations
from similitude.symmetry.row_space import null_vectors, reduced
from similitude.symmetry.tape import Tape

PATIENCE = 2  # orders without a new direction, after which there is none
SPARE = 3  # points more than there are directions, at most
TRIES = 40


@dataclass(frozen=True)
class OutputSlopes:
    """How to find the slopes of outputs: a tape of rates and outputs, in that order, and who is what.

    ``free``: parameters with slopes; ``varying``: parameters that change in time; ``outputs``: how many.
    """

    tape: Tape
    equations: Equations
    free: tuple[str, ...]
    varying: tuple[str, ...]
    outputs: int

    @property
    def columns(self) -> tuple[str, ...]:
        """Names whose slopes are carried: parameters, then starts."""
        return (*self.free, *self.equations.states)

    def sensitivities(self, seed: int) -> tuple[np.ndarray, np.ndarray]:
        """Reduced rows of J in logarithms and in plain values, at one random point."""
        for attempt in range(TRIES):
            try:
                return self._at(np.random.default_rng([seed, attempt]))
            except BadPoint:
                continue
        raise ModelError(
            f"the rates of {', '.join(self.equations.states)} are singular wherever they were tried",
            usually="A root or a logarithm is taken of what is negative for states and parameters near one.",
            paste="sqrt(abs(x))   # where the sign may change",
            read='docs/symmetries.md, "What the outputs cannot see"',
        )

    def _at(self, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        field = Modular() if self.tape.rational else Digits()
        choices = {}
        if self.tape.rational and self.tape.branches:  # decided among real numbers, kept among residues
            Series(self.tape, Floats(), self._start(rng, Floats())[0], choices).advance()
        symbols, values = self._start(rng, field)
        series = Series(self.tape, field, symbols, choices)
        states, rows, rank, idle = self.equations.states, [], 0, 0
        basis = np.zeros((0, len(values)), dtype=field.dtype)
        for order in range(len(values) + PATIENCE):
            found = series.advance()
            for name, rate in zip(states, found[: len(states)], strict=True):
                share = field.number(sp.Rational(1, order + 1))
                symbols[name].append(field.wrap(rate * share))
            rows = [field.wrap(y[1:] * values) for y in found[len(states) :]]
            basis = reduced(np.array([*basis, *rows], dtype=field.dtype).reshape(-1, len(values)))[0]
            idle = idle + 1 if len(basis) == rank else 0
            rank = len(basis)
            if idle == PATIENCE or rank == len(values):
                break
        return basis, field.wrap(basis * field.inverse(values))

    def _start(self, rng: np.random.Generator, field) -> tuple[dict[str, list[np.ndarray]], np.ndarray]:
        """Series of every symbol: parameters and starts with their slopes, inputs as random polynomials."""
        columns, orders = self.columns, len(self.columns) + PATIENCE + 1
        values = field.draw(rng, len(columns))
        width = 1 + len(columns)
        symbols: dict[str, list[np.ndarray]] = {}
        for k, name in enumerate(columns):
            first = np.zeros(width, dtype=field.dtype)
            first[0], first[1 + k] = values[k], 1
            symbols[name] = [first]
        moving = (*self.equations.signals, *self.varying)
        for name in (*moving, *(n for n in self.equations.parameters if n not in (*self.free, *moving))):
            coefficients = field.draw(rng, orders if name in moving else 1)
            symbols[name] = [np.array([c, *[0] * (width - 1)], dtype=field.dtype) for c in coefficients]
        now = np.array([[c, *[0] * (width - 1)] for c in (field.draw(rng, 1)[0], 1)], dtype=field.dtype)
        symbols[self.equations.time] = list(now)
        return symbols, values


@dataclass(frozen=True)
class SlopeRows:
    """Reduced rows over enough points: sensitivities in two kinds, and the directions they miss."""

    logarithmic: np.ndarray  # (., p + n)
    plain: np.ndarray
    turning: np.ndarray  # (., p) null vectors of all points
    first: np.ndarray  # null vectors of the first point, (., p + n)

    @property
    def ranks(self) -> tuple[int, int, int]:
        """What no further point may change; sums matter only where powers do not explain everything."""
        unseen = self.logarithmic.shape[1] - len(self.logarithmic)
        is_curved = len(self.turning) > unseen
        return len(self.logarithmic), len(self.turning), len(self.plain) if is_curved else 0


def gather(plan: OutputSlopes) -> SlopeRows:
    """Points are added until one of them brings nothing new."""
    p, width = len(plan.free), len(plan.columns)
    rows = None
    for seed in range(width + SPARE):
        logarithmic, plain = plan.sensitivities(seed)
        missed = null_vectors(logarithmic)
        if rows is None:
            rows = SlopeRows(logarithmic, plain, reduced(missed[:, :p])[0], missed)
            continue
        more = SlopeRows(
            _together(rows.logarithmic, logarithmic),
            _together(rows.plain, plain),
            _together(rows.turning, missed[:, :p]),
            rows.first,
        )
        if more.ranks == rows.ranks:
            break
        rows = more
    return rows


def _together(rows: np.ndarray, more: np.ndarray) -> np.ndarray:
    return reduced(np.concatenate([rows, more]))[0]
