"""Claims of the paper's section 3: homogeneous functions and what they say of sensitivities.

Invariant: every row is computed twice, as printed and with the argument that the paper leaves out.
"""

from __future__ import annotations

import numpy as np
import sympy as sp

from similitude.paper import printed
from similitude.paper.bode import (
    PARAMETERS,
    dimension_row,
    row_sums,
    state_space_residual,
    step_response,
    transfer_function,
    z_coefficients,
)
from similitude.paper.claim import NOTHING, Claim, claim, identity_claim, number_claim

AT = 0.15  # s after the step, a time at which no sensitivity is small
FREQUENCY = 9.0j  # rad/s
YAW_RATE = np.array([0.0, 0.0, -1.0])  # dimension of yaw rate over steer


def invariance_claims() -> list[Claim]:
    """Eqs 5 to 16, in the paper's order."""
    _, S = step_response(printed.TEST_VEHICLE, AT)
    return [*examples(), *rows_of_13(S), *forms(), _one_from_others(S), _decoupled()]


def euler(f: sp.Expr, arguments: tuple[sp.Symbol, ...]) -> sp.Expr:
    """Σ x ∂f/∂x over f: the degree of a homogeneous function (eqs 5, 9 and 12)."""
    return sp.simplify(sum(x * f.diff(x) for x in arguments) / f)


def examples() -> list[Claim]:
    """The two examples with which the theorem is introduced."""
    x, y, S = sp.symbols("x1 x2 S", positive=True)
    return [
        number_claim(
            "eq5-degree",
            "eq 5",
            "7 x1² + 2 x2² is homogeneous of order 2",
            printed=2,
            ours=float(euler(7 * x**2 + 2 * y**2, (x, y))),
            tolerance=0,
        ),
        number_claim(
            "eq12-cube",
            "eqs 10-12",
            "a cube's volume obeys 3 V = S dV/dS",
            printed=3,
            ours=float(euler(S**3, (S,))),
            tolerance=0,
        ),
    ]


def rows_of_13(S: dict[str, complex]) -> list[Claim]:
    """The rows of mass, length and time for the yaw rate 0.15 s after a step of the steer."""
    full, bare = row_sums(S), row_sums(S, without=("t",))
    found = [
        number_claim(
            f"eq13-{base}",
            f"eq 13, {base} row",
            f"sensitivities weighted by {base} sum to 0",
            printed=0,
            ours=_tidy(bare[i].real),
            tolerance=NOTHING,
        )
        for i, base in enumerate(("mass", "length"))
    ]
    time = number_claim(
        "eq13-time",
        "eq 13, time row",
        "sensitivities of the yaw rate to the seven parameters, weighted by time, sum to +1",
        printed=1,
        ours=float(bare[2].real),
        tolerance=NOTHING,
        digits=5,
        why="Two misprints in one row: the left side is −1, and time is an argument of a time response. "
        f"With S_t the row sums to {_tidy(full[2].real):.0f}; the seven parameters alone to "
        f"{bare[2].real:.4f} "
        f"at {AT} s, another number at another time.",
    )
    signed = number_claim(
        "eq13-time-with-t",
        "eq 13, time row",
        "the same row with its sign and with S_t put right: −1",
        printed=-1,
        ours=_tidy(full[2].real),
        tolerance=NOTHING,
    )
    return [*found, time, signed]


def forms() -> list[Claim]:
    """The sentence after eq 15: the definition serves time, Laplace, state-space and discrete forms alike."""
    vehicle = printed.TEST_VEHICLE
    _, S_t = step_response(vehicle, AT)
    _, S_s = transfer_function(vehicle, FREQUENCY)
    z = z_coefficients(vehicle, 0.05)
    wanted = {"b1": YAW_RATE, "b2": YAW_RATE, "a1": 0 * YAW_RATE, "a2": 0 * YAW_RATE}

    def z_off(without: tuple[str, ...]) -> float:
        return max(np.abs(row_sums(S, without=without) - wanted[n]).max() for n, (_, S) in z.items())

    off = {
        "time": (
            "t",
            np.abs(row_sums(S_t, without=("t",)) - YAW_RATE).max(),
            np.abs(row_sums(S_t) - YAW_RATE).max(),
            "step response at 0.15 s",
        ),
        "laplace": (
            "s",
            np.abs(row_sums(S_s, without=("s",)) - YAW_RATE).max(),
            np.abs(row_sums(S_s) - YAW_RATE).max(),
            "G(s) at 9 rad/s",
        ),
        "z": ("the sample time Ts", z_off(("Ts",)), z_off(()), "b1, b2, a1, a2 at 50 ms"),
    }
    found = [
        claim(
            f"invariance-{name}",
            "eqs 15-16",
            f"the invariances hold in {name} form ({at})",
            printed=0,
            ours=float(bare),
            holds=bare <= NOTHING,
            under=full <= NOTHING,
            tolerance=NOTHING,
            condition=f"{extra} is counted among the arguments",
            why=f"Largest error of the three rows with the seven parameters alone; with {extra} it is "
            f"rounding.",
        )
        for name, (extra, bare, full, at) in off.items()
    ]
    entries, left = state_space_residual()
    found.append(
        identity_claim(
            "invariance-state-space",
            "eqs 2, 15-16",
            f"the invariances hold in state-space form (all {entries} entries of A and B that hold a "
            f"parameter)",
            float(left),
            why="Exact, in symbols; a matrix entry has no further argument.",
        )
    )
    return found


def solved(S: dict[str, complex], wanted: tuple[str, str, str]) -> np.ndarray:
    """Three sensitivities from all others by the three rows of eq 16, (3,) [-]."""
    given = {n: v for n, v in S.items() if n not in wanted}
    D = np.array([dimension_row(n) for n in wanted]).T
    return np.linalg.solve(D, YAW_RATE - row_sums(given).real)


def _one_from_others(S: dict[str, complex]) -> Claim:
    wanted = ("m", "Iz", "Caf")
    off = np.abs(solved(S, wanted) - [S[n] for n in wanted]).max()
    return identity_claim(
        "eq16-solve",
        "after eq 16",
        "each row gives one sensitivity from the others: three of seven (m, Iz, Caf) follow from the rest",
        float(off),
        why="With S_t among the given ones.",
    )


def _decoupled() -> Claim:
    """Groups have no units, so their rows are empty; and m, L, U alone change nothing."""
    vehicle, factors = printed.TEST_VEHICLE, {"m": 3.0, "U": 7.0, "L": 5.0}
    larger = dict(vehicle)
    powers = {
        "m": (1, 0, 0),
        "Iz": (1, 2, 0),
        "U": (0, 0, 1),
        "a": (0, 1, 0),
        "b": (0, 1, 0),
        "Caf": (1, -1, 2),
        "Car": (1, -1, 2),
    }
    for name in PARAMETERS:
        for base, power in zip(("m", "L", "U"), powers[name], strict=True):
            larger[name] *= factors[base] ** power
    stretched = AT * factors["L"] / factors["U"]
    one, _ = step_response(vehicle, AT)
    other, _ = step_response(larger, stretched)
    return identity_claim(
        "pi-theorem-decouples",
        "sections 3 and 4",
        "in groups the sensitivities are no longer coupled by units: m, L and U have left the model",
        other * factors["L"] / factors["U"] / one - 1,
        why="A car 3 times as heavy, 5 times as long and 7 times as fast, with equal groups, has the same "
        "dimensionless step response.",
    )


def _tidy(value: float) -> float:
    """A value that is a whole number but for rounding, as that number."""
    near = round(value)
    return float(near) if abs(value - near) <= NOTHING else float(value)
