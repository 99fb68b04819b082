"""Prints which decisions of each exported step are shown to MC/DC (`python scripts/embedded_decisions.py`).

A decision is the test of an `if` or of a choice between two values; its conditions are the comparisons in it.
A condition is shown where samples were seen with it true and with it false, each time so that turning
it over alone turns the decision (masking MC/DC). Counted on the Python twin, whose text has the C's decisions
and whose bits are the C's. Samples: the self-test's, a rough drive's (for the monitor one on which K changes,
too), and single steps from states, configurations and samples of those drives with a few numbers of each
scaled or set to zero, since a step must be right from any state it is handed; where something is seen that
was rare, more is changed from there on. What is left is printed, and fails.
"""

from __future__ import annotations

import argparse
import ast
import sys
import types
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from tests.rough_drive import rough_drive
from tests.simulated_drive import CAR, drive

from similitude.embedded.configuration import find_numbers
from similitude.embedded.drive import monitored, self_test_rows
from similitude.embedded.system import SHIPPED, find_source
from similitude.program.library import Library

SAMPLES, SINGLE = 10_000, 40_000  # rows of the rough drive, single steps at most
SOME = 500  # of them, between two looks at what is left
CHANGED = 3, 5, 2  # numbers of a configuration, a state and a sample that are changed, fewer than
EVERY, FEW = 50, 5  # of how many rows a state is kept; and where something is seen for the first few times
FACTORS = np.array([0.0, -1.0, 1e-6, 1e-3, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 1e3, 1e6])


class Watch(ast.NodeTransformer):
    """Puts a recorder in the place of every test; remembers each test's tree, text and line."""

    def __init__(self, tree: ast.AST) -> None:
        self.plain = {id(x): ast.unparse(x) for x in ast.walk(tree) if isinstance(x, ast.expr)}
        self.texts: list[list[str]] = []
        self.trees: list[ast.expr] = []
        self.leaves: list[list[ast.expr]] = []
        self.seen: list[Counter[tuple[bool, ...]]] = []
        self.rare = False  # whether something was seen that had been seen a few times at most

    def _test(self, test: ast.expr) -> ast.expr:
        leaves = _leaves(test)
        number = len(self.trees)
        self.texts.append([self.plain.get(id(x), "?") for x in leaves])
        self.trees.append(test)
        self.leaves.append(leaves)
        self.seen.append(Counter())
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
        self.seen[number][values] += 1
        self.rare |= self.seen[number][values] <= FEW
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


@cache
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


def driven(library: Library, watch: Watch, config: np.ndarray, rows: np.ndarray) -> list[tuple]:
    """Steps over a drive; what some of them started from, and all in which something rare is seen."""
    state, kept = library.start(config), []
    for i, row in enumerate(rows):
        before, watch.rare = (config, state.copy(), row), False
        library.run(config, state, row[None])
        if watch.rare or i % EVERY == 0:
            kept.append(before)
    return kept


def singly(library: Library, watch: Watch, kept: list[tuple], steps: int) -> None:
    """Single steps from what was kept with a few numbers changed; what shows something rare is kept, too.

    They end where nothing is left to be shown: what was shown stays so.
    """
    rng = np.random.default_rng(0)
    for step in range(steps):
        if step % SOME == 0 and not watch.unshown():
            return
        changed = tuple(values.copy() for values in kept[rng.integers(len(kept))])
        for values, most in zip(changed, CHANGED, strict=True):
            at = rng.integers(len(values), size=rng.integers(most))
            values[at] *= FACTORS[rng.integers(len(FACTORS), size=len(at))]
        told, state, row = changed
        watch.rare = False
        try:
            library.run(told, state.copy(), row[None])
        except ArithmeticError:  # a float of Python does not divide by zero; the tests before it were seen
            continue
        if watch.rare:
            kept.append(changed)


def drive_of(estimator: str, names: list[str]) -> np.ndarray:
    """Rows (n, fields of a sample) of a rough drive; for the monitor one on which K changes besides."""
    even = estimator not in ("population", "small_population", "monitor")
    rough = rough_drive(SAMPLES, 0, even=even)
    if estimator == "monitor":
        return monitored(np.vstack([changing_drive(), rough]), names)
    with np.errstate(over="ignore"):  # a lateral acceleration, with its own faults
        more = [rough[:, 2] * np.roll(rough[:, 3], 40 + k) for k in range(len(names) - rough.shape[1])]
    return np.column_stack([rough, *more])


def changing_drive() -> np.ndarray:
    """Rows (n, 4) of a filter's samples of a drive whose K is halved twice and grows twice."""
    parts = [
        drive(seconds=seconds, rms=0.01, U=22.0, seed=seed, K=factor * CAR["K"])
        for seed, (seconds, factor) in enumerate([(40, 1.0), (20, 0.5), (20, 0.25), (20, 1.0), (20, 1.5)])
    ]
    columns = [np.concatenate([getattr(part, name) for part in parts]) for name in ("delta", "U", "r")]
    return np.column_stack([np.full(columns[0].size, 0.01), *columns])


def shown(system: str, estimator: str) -> list[str]:
    """What was shown of one estimator, and a line for each condition that was not."""
    source = find_source(system, estimator)
    numbers = find_numbers(source, vehicle=None, sample_time=None)
    watch, layout = watched(source.twin, source.name)
    library = Library(source.name, layout, None)
    rows = self_test_rows(source, source.library(), numbers.values, numbers.sample_time)
    rows = np.vstack([rows, drive_of(estimator, library.names("sample"))])
    with np.errstate(all="ignore"):
        singly(library, watch, driven(library, watch, numbers.values, rows), SINGLE)
    conditions, missing = sum(map(len, watch.leaves)), watch.unshown()
    head = f"{source.name}: {len(watch.trees)} decisions, {conditions} conditions"
    return [
        f"{head}, {conditions - len(missing)} shown",
        *(f"  line {line}: {text}" for line, text in missing),
    ]


def main() -> int:
    """Print what was shown of every estimator; 1 where something is left."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", help="one estimator, such as bicycle_paper")
    asked = parser.parse_args()
    every = [(system, estimator) for system, estimators in SHIPPED.items() for estimator in estimators]
    wanted = [each for each in every if asked.only in (None, "_".join(each))]
    left = 0
    with ProcessPoolExecutor() as pool:
        for lines in pool.map(shown, *zip(*wanted, strict=True)):
            print(*lines, sep="\n", flush=True)
            left += len(lines) - 1
    return int(left > 0)


if __name__ == "__main__":
    sys.exit(main())
