"""Pi groups by this package and by others that install from the package index, on the same cases.

Every tool is handed dimensions that it needs not read any more; each side's answer is compared with
the null space before it is timed (`tests/bench`).

pint, buckinghampy, nodimo    as they are published; nodimo is given the base, it works by bases
SymPy                         `Matrix.nullspace` of the dimension matrix, which PyNondimensionalizer calls on
                              a file; `DomainMatrix.nullspace` is the faster of its two
PyDASA                        is left out: it takes ten inputs at most

Invariant: the cases are fixed by a seed, and every variable's dimension is one that physics has.
"""

from __future__ import annotations

import importlib.util
import random
import warnings
from collections.abc import Callable, Mapping

from similitude.dimensional.matrix import dimension_matrix
from similitude.dimensional.pi_groups import pi_groups
from similitude.units import Dimension, parse_unit

SIZES = (7, 40, 200)
SLOWEST = {"nodimo": 40}  # most variables it is asked for: at 200 it takes minutes
BASE = ("x0", "x1", "x2", "x3", "x4")
UNITS = (
    *("kg", "m", "s", "A", "K", "N", "Pa", "m/s", "kg/m^3", "Pa s", "W", "J/K", "V", "ohm", "m^2/s", "1"),
    *("rad/s", "W/(m K)", "W/(m^2 K)", "J/(kg K)", "H", "F", "T", "N/m", "1/K", "m^3/s", "kg m^2", "m/s^2"),
)


def variables(count: int) -> dict[str, Dimension]:
    """Dimensions of so many variables, the first of them a base."""
    rng = random.Random(count)
    units = [UNITS[i] if i < len(BASE) else rng.choice(UNITS) for i in range(count)]
    return {f"x{i}": parse_unit(unit).dimension for i, unit in enumerate(units)}


def actions(count: int) -> dict[str, Callable[[], object]]:
    """Ways to the Pi groups of `variables(count)`, by the name of their tool; only those installed."""
    of = variables(count)
    found: dict[str, Callable[[], object]] = {
        "similitude, base given": lambda: pi_groups(of, BASE),
        "similitude": lambda: pi_groups(of),
        **_sympy(of),
    }
    for name, make in (("pint", _pint), ("buckinghampy", _buckinghampy), ("nodimo", _nodimo)):
        if importlib.util.find_spec(name) and count <= SLOWEST.get(name, count):
            found[name] = make(of)
    return found


def _sympy(of: Mapping[str, Dimension]) -> dict[str, Callable[[], object]]:
    import sympy as sp
    from sympy.polys.matrices import DomainMatrix

    columns = dimension_matrix(of, angle=False).columns
    matrix = sp.Matrix([[sp.Rational(x.numerator, x.denominator) for x in c] for c in columns]).T
    domain = DomainMatrix.from_Matrix(matrix).to_field()
    return {"SymPy, Matrix": matrix.nullspace, "SymPy, DomainMatrix": domain.nullspace}


def _pint(of: Mapping[str, Dimension]) -> Callable[[], object]:
    import pint
    from pint.util import UnitsContainer

    read = {
        name: UnitsContainer({f"[{base}]": int(x) for base, x in d.exponents.items()})
        for name, d in of.items()
    }
    return lambda: pint.pi_theorem(read)


def _buckinghampy(of: Mapping[str, Dimension]) -> Callable[[], object]:
    from buckinghampy.buckingham import find_nondimensional_numbers
    from buckinghampy.parameters import Parameter

    read = [Parameter(name, {base: int(x) for base, x in d.exponents.items()}) for name, d in of.items()]
    return lambda: find_nondimensional_numbers(read)


def _nodimo(of: Mapping[str, Dimension]) -> Callable[[], object]:
    import nodimo

    read = [
        nodimo.Quantity(name, scaling=name in BASE, **{base: int(x) for base, x in d.exponents.items()})
        for name, d in of.items()
    ]

    def run() -> object:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # it says which quantities are dimensionless
            return nodimo.Model(*read)

    return run
