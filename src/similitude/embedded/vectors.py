"""What an exported estimator must answer, word for word: computed by the twin, not by the C.

Invariant: the expected bits come from another language than the one they test. In single precision
every literal and every operation of the twin is NumPy's float32, as the C's is ``float``.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

TYPES = {"float": np.float32, "double": np.float64}
WORDS = {"float": np.uint32, "double": np.uint64, "fixed": np.uint32}


@dataclass(frozen=True, eq=False)
class Vectors:
    """Rows and what follows from them, as words of the real: status (n,), the rest (n, fields)."""

    samples: NDArray
    status: NDArray[np.int32]
    outputs: NDArray
    state: NDArray  # after the last row, (state,)

    @property
    def words(self) -> int:
        """Words that a self-test compares."""
        return int(self.status.size + self.outputs.size + self.state.size)


class _Literals(ast.NodeTransformer):
    """Every number of the twin becomes one of the wanted type."""

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        """Wrap a floating-point literal."""
        if not isinstance(node.value, float):
            return node
        return ast.Call(ast.Name("_real", ast.Load()), [node], [])


def twin_in(text: str, real: str) -> tuple[Callable, Callable]:
    """``init`` and ``step`` of a twin's text, computing in ``float`` or ``double``."""
    tree = ast.parse(text)
    tree.body = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    tree = ast.fix_missing_locations(_Literals().visit(tree))
    names: dict[str, Any] = {"_real": TYPES[real]}
    exec(compile(tree, "twin", "exec"), names)
    return names["init"], names["step"]


def expected(text: str, real: str, config: NDArray, rows: NDArray) -> Vectors:
    """Run the twin over rows.

    Parameters
    ----------
    text : of the twin.
    real : ``float`` or ``double``.
    config : (fields,) in SI units; rounded to the real.
    rows : (n, sample fields), rounded likewise.
    """
    kind = TYPES[real]
    init, step = twin_in(text, real)
    with np.errstate(all="ignore"):
        samples = rows.astype(kind)
        flat = list(config.astype(kind))
        state = init(flat)
        status, outputs = np.empty(len(rows), np.int32), []
        for k, row in enumerate(samples):
            status[k], answer = step(flat, state, list(row))
            outputs.append(answer)
    word = WORDS[real]
    return Vectors(
        _bits(samples, word), status, _bits(np.array(outputs, kind), word), _bits(np.array(state, kind), word)
    )


def _bits(values: NDArray, word: type) -> NDArray:
    """The words of reals; every NaN as the one quiet NaN, as samples may hold it."""
    plain = values.copy()
    plain[np.isnan(plain)] = np.nan
    return plain.view(word)
