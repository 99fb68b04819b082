"""Responses that are formulas: any function of quantities."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp

from similitude.homogeneity.measure import Measure
from similitude.invariance.compiled import compiled, log_slope
from similitude.invariance.response import Certificate, Response


def explicit_response(
    formula: sp.Expr,
    measures: Mapping[str, Measure],
    output: Measure,
    kind: str,
    about: str,
) -> Response:
    """The response that a formula is.

    Parameters
    ----------
    formula : in symbols ``Symbol(name, real=True)``, or with other assumptions for a complex variable.
    measures : name -> measure of everything that may occur; what does not occur is no argument.
    output : measure of the formula.
    kind, about : as `Response` has them.
    """
    by_name = {symbol.name: symbol for symbol in formula.free_symbols}
    names = [name for name in measures if name in by_name]
    symbols = [by_name[name] for name in names]
    functions = []

    def evaluate(values: Mapping[str, float]) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        if not functions:
            functions.append(compiled(symbols, [formula, *(log_slope(formula, x) for x in symbols)]))
        y, *moved = np.broadcast_arrays(*functions[0](*(values[name] for name in names)))
        return y, dict(zip(names, moved, strict=True))

    return Response(
        kind=kind,
        about=about,
        arguments={name: measures[name] for name in names},
        output=output,
        symbols={symbol: measures[name] for name, symbol in by_name.items()},
        certificates=(Certificate(about, formula, output),),
        evaluate=evaluate,
        formula=formula,
    )
