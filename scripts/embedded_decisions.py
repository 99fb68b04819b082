"""Prints which decisions of each exported step are shown to MC/DC (`python scripts/embedded_decisions.py`).

A decision is the test of an `if` or of a choice between two values; its conditions are the comparisons in it.
A condition is shown where samples were seen with it true and with it false, each time so that turning
it over alone turns the decision (masking MC/DC). Counted on the Python twin, whose text has the C's decisions
and whose bits are the C's. Samples: the self-test's, a rough drive's, and single steps from states and
configurations of that drive with a few numbers of each scaled or set to zero, since a step must be right
from any state it is handed. What is left is printed; nothing says that it cannot be reached.
"""

from __future__ import annotations

import argparse
import ast
import sys
import types
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from tests.rough_drive import rough_drive

from similitude.embedded.configuration import find_numbers
from similitude.embedded.drive import self_test_rows
from similitude.embedded.system import SHIPPED, find_source
from similitude.program.library import Library

SAMPLES, SINGLE = 10_000, 40_000  # rows of the rough drive, single steps
LEFT = {"bicycle_robust": 2, "bicycle_monitor": 20}  # conditions not shown; more of them fails
PARTS = 400  # of the drive: a state is kept after each
FACTORS = (0.0, -1.0, 1e-6, 1e-3, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 1e3, 1e6)


class Watch(ast.NodeTransformer):
    """Puts a recorder in the place of every test; remembers each test's tree, text and line."""

    def __init__(self, tree: ast.AST) -> None:
        self.plain = {id(x): ast.unparse(x) for x in ast.walk(tree) if isinstance(x, ast.expr)}
        self.texts: list[list[str]] = []
        self.trees: list[ast.expr] = []
        self.leaves: list[list[ast.expr]] = []
        self.seen: list[set[tuple[bool, ...]]] = []

    def _test(self, test: ast.expr) -> ast.expr:
        leaves = _leaves(test)
        number = len(self.trees)
        self.texts.append([self.plain.get(id(x), "?") for x in leaves])
        self.trees.append(test)
        self.leaves.append(leaves)
        self.seen.append(set())
        values = ast.Tuple([ast.Call(ast.Name("bool", ast.Load()), [x], []) for x in leaves], ast.Load())
        return ast.Call(ast.Name("_record", ast.Load()), [ast.Constant(number), values], [])

    def visit_If(self, node: ast.If) -> ast.If:
        """The test of a guard."""
        self.generic_visit(node)
        node.test = self._test(node.test)
        return node

    def visit_IfExp(self, node: ast.IfExp) -> ast.IfExp:
        """The test of a choice between two values."""
        self.generic_visit(node)
        node.test = self._test(node.test)
        return node

    def record(self, number: int, values: tuple[bool, ...]) -> bool:
        """Remember what the conditions of a test were; its outcome."""
        self.seen[number].add(values)
        return outcome(self.trees[number], values)

    def unshown(self) -> list[tuple[int, str]]:
        """Line and text of every condition that is not shown, with the values it was never shown at."""
        missing = []
        for tree, leaves, texts, seen in zip(self.trees, self.leaves, self.texts, self.seen, strict=True):
            for i, leaf in enumerate(leaves):
                decisive = {
                    v[i] for v in seen if outcome(tree, v) != outcome(tree, (*v[:i], not v[i], *v[i + 1 :]))
                }
                if len(decisive) < 2:
                    never = " or ".join(str(x) for x in (True, False) if x not in decisive)
                    missing.append((leaf.lineno, f"{texts[i]}: never decisive as {never}"))
        return sorted(missing)


def _leaves(test: ast.expr) -> list[ast.expr]:
    if isinstance(test, ast.BoolOp):
        return [leaf for part in test.values for leaf in _leaves(part)]
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        return _leaves(test.operand)
    return [test]


def outcome(test: ast.expr, values: tuple[bool, ...]) -> bool:
    """The decision for given values of its conditions, in the order they are written."""
    left = iter(values)

    def walk(node: ast.expr) -> bool:
        if isinstance(node, ast.BoolOp):
            parts = [walk(part) for part in node.values]
            return all(parts) if isinstance(node.op, ast.And) else any(parts)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return not walk(node.operand)
        return next(left)

    return walk(test)


def watched(text: str, name: str) -> tuple[Watch, types.ModuleType]:
    """The twin with its step's tests recorded."""
    tree = ast.parse(text)
    watch = Watch(tree)
    for node in tree.body:
        if isinstance(node, ast.FunctionDef) and node.name == "step":
            watch.visit(node)
    layout = types.ModuleType(name)
    layout.__dict__["_record"] = watch.record
    exec(compile(ast.fix_missing_locations(tree), f"{name}.py", "exec"), layout.__dict__)
    return watch, layout


def singly(library: Library, config: np.ndarray, states: np.ndarray, rows: np.ndarray, steps: int) -> None:
    """Single steps from states and configurations with a few numbers changed."""
    rng = np.random.default_rng(0)
    usual = rows[np.isfinite(rows).all(axis=1)]
    for _ in range(steps):
        row = usual[rng.integers(len(usual))][None]
        told, state = config.copy(), states[rng.integers(len(states))].copy()
        for values, most in ((told, 3), (state, 5)):
            at = rng.integers(len(values), size=rng.integers(most))
            values[at] *= rng.choice(FACTORS, size=len(at))
        try:
            library.run(told, state, row)
        except ArithmeticError:  # a float of Python does not divide by zero; the tests before it were seen
            continue


def main() -> int:
    """Run every estimator's watched twin and print what was shown; 1 where more is left than is known."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--quick", action="store_true", help="a tenth of the rough drive, half the single steps"
    )
    parser.add_argument("--only", help="one estimator, such as bicycle_paper")
    asked = parser.parse_args()
    samples, single = (SAMPLES // 10, SINGLE // 2) if asked.quick else (SAMPLES, SINGLE)
    more = False
    for system, estimators in SHIPPED.items():
        for estimator in estimators:
            if asked.only not in (None, f"{system}_{estimator}"):
                continue
            source = find_source(system, estimator)
            numbers = find_numbers(source, vehicle=None, sample_time=None)
            watch, layout = watched(source.twin, source.name)
            rows = [self_test_rows(source, source.library(), numbers.values, numbers.sample_time)]
            if estimator != "monitor":
                even = estimator not in ("population", "small_population")
                rows.append(rough_drive(samples, 0, even=even))
            library = Library(source.name, layout, None)
            with np.errstate(all="ignore"):
                state = library.start(numbers.values)
                driven = np.vstack(rows)
                states = []
                for part in np.array_split(driven, PARTS):
                    library.run(numbers.values, state, part)
                    states.append(state.copy())
                singly(library, numbers.values, np.array(states), driven, single)
            conditions, missing = sum(map(len, watch.leaves)), watch.unshown()
            print(
                f"{source.name}: {len(watch.trees)} decisions, {conditions} conditions, "
                f"{conditions - len(missing)} shown"
            )
            for line, text in missing:
                print(f"  line {line}: {text}")
            more |= len(missing) > LEFT.get(source.name, 0)
    return int(more)


if __name__ == "__main__":
    sys.exit(main())
