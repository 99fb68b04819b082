"""Claims of the paper's section 3: homogeneous functions and what they say of sensitivities.

Invariant: the rows are those of `similitude.invariances`; each is computed twice, as printed and with the
argument that the paper leaves out.
"""

from __future__ import annotations

import numpy as np
import sympy as sp

from similitude.invariance.invariances import euler_rows, invariances
from similitude.model import Quantity
from similitude.paper import printed
from similitude.paper.bode import (
    PARAMETERS,
    exponents,
    response,
    right_sides,
    row_sums,
    sampled_transfer,
    state_space_residuals,
    step_response,
    transfer_function,
)
from similitude.paper.claim import NOTHING, Claim, claim, identity_claim, number_claim
from similitude.rewriting.rewritten import rewrite
from similitude.systems.bicycle import BICYCLE

AT = 0.15  # s after the step, a time at which no sensitivity is small
FREQUENCY = 9.0j  # rad/s
SAMPLE, AROUND = 0.05, 0.3  # s, and rad a sample: z = exp(0.3 i)


def invariance_claims() -> list[Claim]:
    """Eqs 5 to 16, in the paper's order."""
    _, S = step_response(printed.TEST_VEHICLE, AT)
    return [*examples(), *rows_of_13(S), *forms(), _one_from_others(S), _decoupled()]


def degree(expression: str, *lengths: str) -> float:
    """The degree of a homogeneous function of lengths: Σ x ∂f/∂x over f (eqs 5 to 12)."""
    found = euler_rows(expression, [Quantity(name, "m") for name in lengths])
    (row,) = found.rows
    return float(sp.simplify(row.left_side(found.sensitivities())))


def examples() -> list[Claim]:
    """The two examples with which the theorem is introduced."""
    return [
        number_claim(
            "eq5-degree",
            "eq 5",
            "7 x1² + 2 x2² is homogeneous of order 2",
            printed=2,
            ours=degree("7*x1**2 + 2*x2**2", "x1", "x2"),
            tolerance=0,
        ),
        number_claim(
            "eq12-cube",
            "eqs 10-12",
            "a cube's volume obeys 3 V = S dV/dS",
            printed=3,
            ours=degree("S**3", "S"),
            tolerance=0,
        ),
    ]


def rows_of_13(S: dict[str, complex]) -> list[Claim]:
    """The rows of mass, length and time for the yaw rate 0.15 s after a step of the steer."""
    full, bare = row_sums("time", S), row_sums("time", S, without=("t",))
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
    vehicle, z = printed.TEST_VEHICLE, np.exp(1j * AROUND)
    _, S_t = step_response(vehicle, AT)
    _, S_s = transfer_function(vehicle, FREQUENCY)
    _, S_z = sampled_transfer(vehicle, z, SAMPLE)

    def off(kind: str, S: dict[str, complex], *without: str) -> float:
        return float(np.abs(row_sums(kind, S, without=without) - right_sides(kind)).max())

    forms = {
        "time": ("t", off("time", S_t, "t"), off("time", S_t), "step response at 0.15 s"),
        "laplace": ("s", off("frequency", S_s, "s"), off("frequency", S_s), "G(s) at 9 rad/s"),
        "z": ("the sample time Ts", off("z", S_z, "Ts"), off("z", S_z), "G(z) at 0.3 rad a sample of 50 ms"),
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
        for name, (extra, bare, full, at) in forms.items()
    ]
    left = state_space_residuals()
    found.append(
        identity_claim(
            "invariance-state-space",
            "eqs 2, 15-16",
            f"the invariances hold in state-space form (all {len(left) // 3} entries of A and B that hold a "
            f"parameter)",
            float(sum(map(sp.Abs, left))),
            why="Proven in symbols; a matrix entry has no further argument.",
        )
    )
    return found


def _one_from_others(S: dict[str, complex]) -> Claim:
    wanted = ("m", "Iz", "Caf")
    found = response("time").solve_for(wanted, {n: value for n, value in S.items() if n not in wanted})
    off = max(abs(found[n] - S[n]) for n in wanted)
    return identity_claim(
        "eq16-solve",
        "after eq 16",
        "each row gives one sensitivity from the others: three of seven (m, Iz, Caf) follow from the rest",
        float(off),
        why="With S_t among the given ones.",
    )


def _decoupled() -> Claim:
    """Groups have no units, so their rows are empty; and m, L, U alone change nothing."""
    vehicle = printed.TEST_VEHICLE
    mass, length, speed = 3.0, 5.0, 7.0
    unit = (mass, length, length / speed)  # of mass, length and time
    larger = {n: vehicle[n] * float(np.prod(np.power(unit, exponents("time", n)))) for n in PARAMETERS}
    one, _ = step_response(vehicle, AT)
    other, _ = step_response(larger, AT * length / speed)
    rewritten = rewrite(BICYCLE, base=("m", "L", "U")).model
    coupled = sum(not row.is_empty for row in invariances(rewritten).rows)
    return identity_claim(
        "pi-theorem-decouples",
        "sections 3 and 4",
        "in groups the sensitivities are no longer coupled by units: m, L and U have left the model",
        max(abs(other * length / speed / one - 1), coupled),
        why=f"Rows of the rewritten model that are not empty: {coupled}. A car 3 times as heavy, 5 times as "
        "long and 7 times as fast, with equal groups, has the same dimensionless step response.",
    )


def _tidy(value: float) -> float:
    """A value that is a whole number but for rounding, as that number."""
    near = round(value)
    return float(near) if abs(value - near) <= NOTHING else float(value)
