"""Pi groups of named variables: the dimensionless products of their powers, exactly.

    Pi = x_1^e_1 ... x_n^e_n    with  D e = 0,   D the dimension matrix (d, n), e rational

Invariant: every group returned cancels exactly in every base dimension, and together they are a basis
of all that do: n - rank(D) of them (Buckingham's theorem).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache

from similitude.dimensional.base_faults import base_names, base_solutions
from similitude.dimensional.exact_span import Column, smallest_integers
from similitude.dimensional.matrix import DimensionMatrix, dimension_matrix
from similitude.units import Dimension, Unit

_ONE = Fraction(1)
_fraction = lru_cache(maxsize=4096)(Fraction)  # the same few exponents come again and again


def pi_groups(
    variables: Mapping[str, str | Unit | Dimension],
    base: Sequence[str] | None = None,
    angle: bool = False,
) -> list[dict[str, Fraction]]:
    """Dimensionless products of powers of the variables.

    Parameters
    ----------
    variables : name -> unit, such as ``{"F": "N", "rho": "kg/m^3", "V": "m/s", "D": "m"}``.
    base : repeating variables, whose dimensions are independent and reach all others; they may occur in
        every group. Left out: no variable is preferred.
    angle : whether the radian is a base dimension; otherwise an angle has no dimension.

    Returns
    -------
    list of dict   exponents [-] by name, zeros left out. With a base one group for each remaining
        variable in the order given, that variable first and with exponent 1, then the base's in the
        base's order. Without, one group for each variable whose dimension those before it can make up,
        in the order given: smallest integers, the first positive, names in the order given. Empty where
        no product is dimensionless.

    Raises
    ------
    UnitError     a unit cannot be read.
    ModelError    the base names a variable twice or one that is not there, is dependent, or does not
        reach a variable.

    References
    ----------
    Buckingham 1914, Phys. Rev. 4, 345; Bareiss 1968, Math. Comp. 22, 565.

    Examples
    --------
    >>> drag = {"F": "N", "rho": "kg/m^3", "V": "m/s", "D": "m", "mu": "Pa s"}
    >>> for group in pi_groups(drag, base=["rho", "V", "D"]):
    ...     print({name: str(exponent) for name, exponent in group.items()})
    {'F': '1', 'rho': '-1', 'V': '-2', 'D': '-2'}
    {'mu': '1', 'rho': '-1', 'V': '-1', 'D': '-1'}
    """
    matrix = dimension_matrix(variables, angle=angle)
    if base is None:
        return _without_base(matrix)
    named = base_names(matrix, base)
    solved = base_solutions(matrix, named)
    groups = []
    for name, column in zip(matrix.names, matrix.columns, strict=True):
        if name not in named:
            numerators, over = solved[column]
            group = {name: _ONE}
            for own, x in zip(named, numerators, strict=True):
                if x:
                    group[own] = _fraction(-x, over)
            groups.append(group)
    return groups


def _without_base(matrix: DimensionMatrix) -> list[dict[str, Fraction]]:
    places, span = matrix.leading
    pivots = [matrix.names[place] for place in places]
    known: dict[Column, tuple[int, ...]] = {}
    groups = []
    for place, (name, column) in enumerate(zip(matrix.names, matrix.columns, strict=True)):
        if place in places:
            continue
        if column not in known:
            numerators, over = span.solve(column)
            known[column] = smallest_integers((*numerators, -over))
        made_of = zip((*pivots, name), known[column], strict=True)
        groups.append({own: _fraction(x, 1) for own, x in made_of if x})
    return groups
