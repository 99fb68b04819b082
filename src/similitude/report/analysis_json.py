"""An Analysis as one JSON object, for other programs.

    system, dimension_matrix, groups [{name, exponents}], invariances [{dimension, coefficients, rhs,
    residual}], symmetries {count, invariants}, rewritten, identifiable

Invariant: strict JSON on one line. Exponents are whole numbers, or text such as "1/2" where they are not;
formulas are text that the product reads back. Keys are added over time, never renamed while `SCHEMA` stays.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import sympy as sp

from similitude.dimensional.base_check import product_text
from similitude.report.summary import json_line, plain_values

if TYPE_CHECKING:
    from similitude.analysis.analysis import Analysis
    from similitude.symmetry.identifiability import Identifiability

SCHEMA = 1


def analysis_record(found: Analysis) -> dict[str, Any]:
    """Gather an analysis in plain Python values.

    Parameters
    ----------
    found : Analysis

    Returns
    -------
    dict    only dict, list, str, int, float, bool and None
    """
    record = {
        "schema": SCHEMA,
        "system": found.model.name,
        "source": found.model.source,
        "base": list(found.base),
        "base_from": found.base_origin,
        "quantities": _quantities(found),
        "dimension_matrix": {
            "dimensions": list(found.matrix.rows),
            "variables": list(found.matrix.names),
            "exponents": [
                [_number(column[i]) for column in found.matrix.columns] for i in range(len(found.matrix.rows))
            ],
        },
        "groups": [
            {
                "name": group.name,
                "exponents": _exponents(group.exponents),
                "formula": product_text(group.exponents),
                "parameter": group.parameter or None,
                "meaning": group.meaning,
            }
            for group in found.groups
        ],
        "invariances": [
            {
                "output": row.output,
                "dimension": row.dimension,
                "coefficients": _exponents(row.coefficients),
                "rhs": _number(row.rhs),
                "residual": row.residual,
            }
            for row in found.invariances
        ],
        "symmetries": _symmetries(found),
        "rewritten": _rewritten(found),
        "identifiable": {
            **_seen(found.seen),
            "signals_held": None if found.steady is None else _seen(found.steady),
        },
    }
    return plain_values(record)


def analysis_line(found: Analysis) -> str:
    """The record on one line of ASCII."""
    return json_line(analysis_record(found))


def _quantities(found: Analysis) -> list[dict[str, Any]]:
    model = found.model
    roles = (
        ("state", model.states),
        ("input", model.inputs),
        ("output", model.outputs),
        ("parameter", model.parameters),
    )
    return [
        {"name": q.name, "role": role, "unit": q.unit, "meaning": q.meaning}
        for role, quantities in roles
        for q in quantities
    ]


def _symmetries(found: Analysis) -> dict[str, Any]:
    return {
        "count": found.scalings.count,
        "units": found.units,
        "scalings": [dict(row) for row in found.scalings.weights],
        "beyond_units": [dict(row) for row in found.beyond],
        "invariants": [_exponents(group) for group in found.scalings.invariants],
        "verified": bool(found.check),
        "missed": found.check.missed,
    }


def _rewritten(found: Analysis) -> dict[str, Any] | None:
    if found.rewritten is None:
        return {"why_not": found.why}
    groups, proof = found.rewritten.groups, found.equivalence
    model = found.model
    signals = [q.name for kind in (model.states, model.inputs, model.outputs) for q in kind]
    return {
        "base": list(groups.base),
        "time_scale": sp.sstr(groups.time_scale),
        "scales": {name: sp.sstr(groups.scale[name]) for name in dict.fromkeys(signals)},
        "rates": {name: sp.sstr(rate) for name, rate in groups.rates.items()},
        "outputs": {name: sp.sstr(e) for name, e in groups.output_map.items()},
        "same_model": proof.holds,
        "left_out": {name: sp.sstr(e) for name, e in found.rewritten.left_out.items()},
        "rows_left": found.rows_after,
        "constraints": {name: sp.sstr(e) for name, e in groups.constraints.items()},
    }


def _seen(seen: Identifiability) -> dict[str, Any]:
    return {
        "outputs": list(seen.outputs),
        "known": list(seen.known),
        "parameters": list(seen.parameters),
        "determined": seen.determined,
        "seen": [_exponents(monomial) for monomial in seen.seen],
        "unseen": [dict(direction) for direction in seen.unseen],
        "unseen_sums": [dict(direction) for direction in seen.shifts],
        "unseen_curved": seen.curved,
        "involved": list(seen.involved),
        "hidden_states": list(seen.hidden_states),
    }


def _exponents(exponents: Mapping[str, Fraction]) -> dict[str, int | str]:
    return {name: _number(power) for name, power in exponents.items()}


def _number(value: Fraction | int) -> int | str:
    exact = Fraction(value)
    return exact.numerator if exact.denominator == 1 else str(exact)
