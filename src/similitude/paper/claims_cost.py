"""Claims about the number of operations a sample, counted in the generated code.

Invariant: an operation is one + − * / of the scalar twin, which does those of the C in the same order;
where a guard chooses, the dearer branch counts.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Collection

from similitude.filter_run import LINEAR, POPULATION
from similitude.paper import printed
from similitude.paper.claim import Claim, claim
from similitude.program.library import shipped

RECURSION = ("residual", "normal", "moved")  # the unnumbered lines after eq 27
REGRESSOR = ("y", "phi")  # eq 26
HIGH_PASS = tuple(  # section 6: the Bessel filter of both signals, as two sections each
    f"{signal}_{name}"
    for signal in ("input", "output")
    for name in ("step", "bend", "1_now", "bend_1", "1", "2_now", "2")
)


def cost_claims() -> list[Claim]:
    """Ten operations, and 10⁴ to 10⁶."""
    return [_ten(), _kalman()]


def operations(name: str, targets: Collection[str] | None = None) -> int:
    """Number of + − * / of an estimator's step.

    Parameters
    ----------
    name : a shipped estimator. targets : only assignments to these; all statements when left out.
    """
    source = inspect.getsource(shipped(name).layout.step)
    return _of(ast.parse(source).body[0].body, targets)


def _of(statements: list[ast.stmt], targets: Collection[str] | None) -> int:
    total = 0
    for statement in statements:
        if isinstance(statement, ast.If):
            inside = max(_of(statement.body, targets), _of(statement.orelse, targets))
            total += inside + (_binary(statement.test) if targets is None else 0)
        elif isinstance(statement, ast.Assign) and _is_wanted(statement, targets):
            total += _binary(statement.value)
    return total


def _is_wanted(statement: ast.Assign, targets: Collection[str] | None) -> bool:
    if targets is None:
        return True
    named = {t.id for t in statement.targets if isinstance(t, ast.Name)}
    read = {node.id for node in ast.walk(statement.value) if isinstance(node, ast.Name)}
    return bool(named & set(targets)) and "ratio" not in read  # that is the change of speed


def _binary(node: ast.AST) -> int:
    return sum(isinstance(x, ast.BinOp) for x in ast.walk(node))


def counted() -> dict[str, int]:
    """Operations of each part of the paper's estimator, of the whole, and of the population filters."""
    return {
        "recursion": operations("bicycle_paper", RECURSION),
        "regressor": operations("bicycle_paper", REGRESSOR),
        "high-pass": operations("bicycle_paper", HIGH_PASS),
        "paper": operations("bicycle_paper"),
        "linear filter": operations(LINEAR),
        "filter": operations(POPULATION),
    }


def _ten() -> Claim:
    n = counted()
    method = n["recursion"] + n["regressor"] + n["high-pass"]
    return claim(
        "sec7-ten-operations",
        "section 7",
        "the algorithm needs on the order of 10 floating-point operations a sample",
        printed=printed.OPERATIONS,
        ours=[n["recursion"], method, n["paper"]],
        holds=method <= 3 * printed.OPERATIONS,
        under=n["recursion"] <= 1.5 * printed.OPERATIONS,
        tolerance="within a factor of three",
        unit="operations",
        condition="the recursive least squares alone is meant",
        why=f"Counted in the generated code: recursion {n['recursion']}, regressor {n['regressor']}, the "
        f"Bessel filters of both signals {n['high-pass']}; with gates, changes of speed and the report of "
        f"its outputs the whole has {n['paper']}.",
    )


def _kalman() -> Claim:
    n, low = counted(), printed.KALMAN_OPERATIONS[0]
    return claim(
        "sec1-kalman-cost",
        "sections 1 and 7",
        "methods with a Kalman filter need 10⁴ to 10⁶ computations a sample",
        printed=list(printed.KALMAN_OPERATIONS),
        ours=[n["linear filter"], n["filter"]],
        holds=n["filter"] >= low,
        tolerance="at least 10⁴",
        unit="operations",
        why="Two Kalman filters with population priors, counted in the generated code: ten states with "
        "linear tyres, "
        f"eleven with saturating ones. {low / n['filter']:.0f} times less than the least the paper quotes, "
        f"{n['filter'] / n['paper']:.0f} times its own whole step.",
    )
