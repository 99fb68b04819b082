"""Bode (logarithmic) sensitivities of the bicycle by the paper's letters, from `similitude.invariances`.

    S_i = d ln y/d ln x_i   [-]        D S = d: one row a unit, of mass, length and time

y is the yaw rate after a step of the steer, the transfer function G(s), its sampled form G(z), or an
entry of A or B. What is computed here is nothing but which response, at which values.

References
----------
Brennan & Alleyne 2004, eqs 6-9 and eqs 13-16; with t, s or the sample time among the arguments, which
the paper leaves out.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.invariance.invariances import Invariances, euler_rows, invariances
from similitude.invariance.rows import Row
from similitude.systems.bicycle import BICYCLE

PARAMETERS = ("m", "Iz", "U", "a", "b", "Caf", "Car")  # L = a + b is no argument of its own
BASES = ("mass", "length", "time")
Sensitivities = dict[str, complex]


@lru_cache
def response(kind: str) -> Invariances:
    """The invariances of the yaw rate in a form: "time", "frequency" or "z"."""
    return invariances(BICYCLE, "r", kind, dimensions=BASES)


def rows(kind: str) -> list[Row]:
    """The rows of mass, length and time of `response`, in this order."""
    by_name = {row.dimension: row for row in response(kind).rows}
    return [by_name[base] for base in BASES]


def row_sums(kind: str, S: Mapping[str, complex], *, without: tuple[str, ...] = ()) -> NDArray[np.complex128]:
    """Left sides D S of the three rows (eq 16), (3,) [-].

    Parameters
    ----------
    kind : of `response`. S : sensitivity of each argument.
    without : arguments to leave out, as the paper does.
    """
    return np.array([row.left_side(S, leave_out=without) for row in rows(kind)])


def right_sides(kind: str) -> NDArray[np.float64]:
    """d of eq 16: exponents of mass, length and time of the output, (3,) [-]."""
    return np.array([float(row.rhs) for row in rows(kind)])


def exponents(kind: str, name: str) -> tuple[float, ...]:
    """Exponents of mass, length and time of an argument (eq 8): a column of D, (3,) [-]."""
    return tuple(float(row.coefficients.get(name, 0)) for row in rows(kind))


def step_response(vehicle: Mapping[str, float], t: float) -> tuple[float, Sensitivities]:
    """Yaw rate after a unit step of the steer [1/s] and its sensitivities, time among them.

    Parameters
    ----------
    vehicle : `PARAMETERS` in SI units. t : time since the step [s].
    """
    return _at("time", vehicle, delta=1.0, t=t)


def transfer_function(vehicle: Mapping[str, float], s: complex) -> tuple[complex, Sensitivities]:
    """G(s) of eq 4 and its sensitivities at a complex frequency s [rad/s], s among them."""
    return _at("frequency", vehicle, s=s)


def sampled_transfer(vehicle: Mapping[str, float], z: complex, Ts: float) -> tuple[complex, Sensitivities]:
    """G(z) of eq 21 for the dimensional yaw rate, and its sensitivities, sample time Ts [s] among them."""
    return _at("z", vehicle, z=z, Ts=Ts)


def _at(kind: str, vehicle: Mapping[str, float], **more: complex) -> tuple[complex, Sensitivities]:
    """Value and sensitivities; not those to the height of the step, which is no argument of the paper's."""
    found = response(kind)
    at = {**{n: vehicle[n] for n in PARAMETERS}, **more}
    S = found.sensitivities(at)
    return found.value(at), {n: S[n] for n in at if n != "delta"}


@lru_cache
def state_space() -> dict[tuple[int, int], sp.Expr]:
    """Entries of [A, B] of eq 2 that hold a parameter: (row, column) -> expression, from the shipped model.

    x = [y, ẏ, ψ, ψ̇] with ẏ = v + U ψ for small ψ; column 4 is B.
    """
    v, r, delta, U = (sp.Symbol(n, real=True) for n in ("v", "r", "delta", "U"))
    rate, heading = sp.symbols("rate heading", real=True)
    in_path = {v: rate - U * heading}
    rows = {1: BICYCLE.rates["v"] + U * r, 3: BICYCLE.rates["r"]}
    columns = {1: rate, 2: heading, 3: r, 4: delta}
    whole = {
        (i, j): sp.simplify(f.subs(in_path).diff(x)) for i, f in rows.items() for j, x in columns.items()
    }
    return {place: entry for place, entry in whole.items() if entry != 0}


def state_space_residuals() -> list[sp.Expr]:
    """What is left of the rows D S = d of every entry of A and B, proven in symbols: zeros."""
    known = [BICYCLE.quantity(n) for n in PARAMETERS]
    left = []
    for entry in state_space().values():
        left += euler_rows(entry, known).verify().values()
    return left
