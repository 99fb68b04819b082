"""What the state-variable-filter regression does with its sums: four unknowns, or one, or none.

    A, q   normal equations of y = a1 psi1 + a2 psi2 + a3 psi3 + a4 psi4, noise's own share taken out

Invariant: nothing is divided by a pivot that noise alone could have made.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from similitude.estimators import least_squares as ls
from similitude.estimators.elimination import eliminated
from similitude.estimators.held_sample import HALF, S
from similitude.estimators.ladder_fields import learnt_status
from similitude.estimators.second_order import SecondOrder
from similitude.program.ir import Assign, Statement, When
from similitude.program.symmetric import Symmetric

STAGES = 4
ORDER = (2, 3, 4, 1)  # of the regressors in the normal equations: what is asked for last
PLACES = tuple(sp.Rational(*p) for p in ((1, 2), (7, 10), (1, 1), (7, 5), (2, 1)))  # of where K started


def normal_matrix() -> Symmetric:
    """Symbols of A, (4, 4), in the order `ORDER`."""
    return Symmetric("A", STAGES)


def car_of(model: SecondOrder) -> tuple[sp.Expr, ...]:
    """a1 … a4 of the car that the frozen unknowns and K describe."""
    K = S(model.target)
    return K, K, K * S("stiffness"), K**2


def _noise(i: int, j: int) -> sp.Expr:
    """What noise of the output adds to the mean of psi_i psi_j, per variance."""
    to = {2: S("to_rate"), 3: S("to_output"), 4: S("to_pair")}
    rates = (i == 2) + (j == 2)
    moment = ("value", "value_rate", "rate")[rates]
    return to[i] * to[j] * S(f"noise_{moment}")


def learn(model: SecondOrder) -> list[Statement]:
    """Sums with forgetting; four unknowns where the sums carry them, else one, else none."""
    A, keep, variance = normal_matrix(), S("forgetting"), S("noise_variance")
    lines: list[Statement] = [Assign("weight", keep * S("weight") + 1)]
    for a, i in enumerate(ORDER):
        for b, j in enumerate(ORDER[a:], start=a):
            own = S(f"psi_{i}") * S(f"psi_{j}")
            if 1 not in (i, j):
                own = own - variance * _noise(i, j)
            lines.append(Assign(A.target(a, b), keep * A[a, b] + own))
    for a, i in enumerate(ORDER):
        moment = "noise_rate_change" if i == 2 else "noise_value_change"
        own = {2: S("to_rate"), 3: S("to_output"), 4: S("to_pair")}.get(i, 0) * S(moment) * variance
        lines.append(Assign(f"q_{a}", keep * S(f"q_{a}") + (S(f"psi_{i}") * S("y") + own)))
    yy = S("y") ** 2 - variance * S("noise_change")
    lines.append(Assign("yy", keep * S("yy") + yy))
    lines.append(Assign("noise_sum", variance * S("weight"), "the noise's share of the sums"))
    return [*lines, *_four(model), When(S("carried") < HALF, tuple(_one(model)), (), "the steer says less")]


def _four(model: SecondOrder) -> list[Statement]:
    """The unknown of the steer's rate of change, whatever the other three are."""
    K, A = S(model.target), normal_matrix()
    least = [
        sp.Max(S("pivot_least") * A[a, a], S("signal_least") * S("noise_sum") * _noise(i, i) if i != 1 else 0)
        for a, i in enumerate(ORDER)
    ]
    residual = S("y") - sp.Add(*(S(f"part_{a}") for a in range(STAGES)))
    then = (
        Assign(K.name, S("z_3") * S("inv_d_3")),
        *ls.keep_within(K.name),
        Assign("carried", sp.Integer(4)),
        Assign("unknowns", sp.Integer(4)),
        Assign("residual", residual),
        *ls.score(S("w_3"), S("residual")),
        *ls.scatter(S("w_3"), S("d_3"), K**2),
        *learnt_status(model),
    )
    q = [S(f"q_{a}") for a in range(STAGES)]
    return list(eliminated(A, q, [S(f"psi_{i}") for i in ORDER], least, then))


def _one(model: SecondOrder) -> list[Statement]:
    """One Gauss-Newton step along a(K) = e K + f K^2 of the car that the frozen unknowns describe.

    The cost is a quartic of K and may have two valleys, one of them next to nothing: where K stands in a
    worse place than one of `PLACES`, it goes on from there.
    """
    K, start, A = S(model.target), S(f"{model.target}_start"), normal_matrix()
    e = [{1: 1, 2: 1, 3: S("stiffness"), 4: 0}[i] for i in ORDER]
    f = [int(i == 4) for i in ORDER]

    def form(x: list, y: list) -> sp.Expr:
        return sp.Add(*(A[a, b] * x[a] * y[b] for a in range(STAGES) for b in range(STAGES)))

    q = [S(f"q_{a}") for a in range(STAGES)]
    sums = {"c2": form(e, e), "c3": form(e, f), "c4": form(f, f)}
    sums |= {"d1": sp.Add(*map(sp.Mul, e, q)), "d2": sp.Add(*map(sp.Mul, f, q))}
    c2, c3, c4, d1, d2 = map(S, sums)

    def cost(x: sp.Symbol) -> sp.Expr:
        return S("yy") + x * (x * (c2 - 2 * d2 + x * (2 * c3 + x * c4)) - 2 * d1)

    slow = S("to_output") * S("stiffness") + 2 * K * S("to_pair")
    noise = S("to_rate") * (S("to_rate") * S("noise_rate") + 2 * S("slow") * S("noise_value_rate"))
    psi = S("psi_1") + S("psi_2") + S("stiffness") * S("psi_3") + 2 * K * S("psi_4")
    enough = S("signal_least_one") * S("noise_sum") * S("noise_along")
    return [
        *(Assign(name, value) for name, value in sums.items()),
        Assign("lowest", cost(K)),
        *[line for i, place in enumerate(PLACES) for line in _look(i, K, place * start, cost)],
        Assign("slow", slow),
        Assign("noise_along", noise + S("slow") ** 2 * S("noise_value")),
        Assign("psi", psi),
        Assign("normal", c2 + 4 * K * (c3 + K * c4)),
        Assign("wanted", d1 - K * (c2 - 2 * d2 + K * (3 * c3 + 2 * K * c4))),
        When(sp.And(S("normal") > 0, S("normal") > enough), tuple(_step_one(model)), (), "more than noise"),
    ]


def _look(i: int, K: sp.Symbol, place: sp.Expr, cost: Callable[[sp.Symbol], sp.Expr]) -> list[Statement]:
    """Go to a place where the cost is lower, as an error of the input: K near nothing explains nothing."""
    there, value = S(f"place_{i}"), S(f"cost_{i}")
    go = (Assign(K.name, there), Assign("lowest", value))
    return [
        Assign(there.name, place),
        Assign(value.name, cost(there)),
        When(value * K**2 < S("lowest") * there**2, go, (), "another valley" if i == 0 else ""),
    ]


def _step_one(model: SecondOrder) -> list[Statement]:
    K = S(model.target)
    limit = S("move_limit") * K
    move = sp.Max(-limit, sp.Min(limit, S("wanted") / S("normal")))
    return [
        Assign(K.name, K + move),
        *ls.keep_within(K.name),
        Assign("unknowns", sp.Integer(1)),
        *ls.score(S("psi"), S("residual")),
        *ls.scatter(S("psi"), S("normal"), K**2),
        *learnt_status(model),
    ]
