"""What an equation asks of a scaling, held against expanded monomials and known functions."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.lattice import canonical, kernel, saturated
from similitude.symmetry.relations import Relations, constraint_rows

x, y, z, n = sp.symbols("x y z n", real=True)
VARIABLES = (x, y, z, n)


def weights(*invariant):
    """Basis of the scalings of x, y, z, n that leave expressions as they are."""
    relations = Relations()
    for e in invariant:
        relations.keep(e)
    rows = constraint_rows(relations, VARIABLES)
    return saturated([row[:4] for row in kernel(rows, 4 + len(relations.spare))], 4)


def by_monomials(*invariant):
    """The same for rational expressions, from numerators and denominators in lowest terms."""
    rows = []
    for e in invariant:
        parts = sp.fraction(sp.cancel(e))
        monomials = [m for part in parts for m in sp.Poly(part, *VARIABLES).monoms()]
        heads = [sp.Poly(part, *VARIABLES).monoms()[0] for part in parts]
        rows += [[a - b for a, b in zip(m, heads[0], strict=True)]
                 for m in sp.Poly(parts[0], *VARIABLES).monoms()]  # fmt: skip
        rows += [[a - b for a, b in zip(m, heads[0], strict=True)]
                 for m in sp.Poly(parts[1], *VARIABLES).monoms()]  # fmt: skip
        assert monomials
    return kernel(rows, 4)


@pytest.mark.parametrize(
    "e",
    [x / y + y / x, x * y**2 / (x * y**2 + z), (x + y) * (x - y) / (z**2 + x * y), (x + x * y) / (z + z * y),
     x / (y + z) + y / (x + z), (x**2 - y**2) / (x - y) / z, x * n / (y * z)],
    ids=str,
)  # fmt: skip
def test_random_points_ask_what_monomials_ask(e):
    assert weights(e) == by_monomials(e)


def test_a_common_factor_hides_nothing():
    # y cancels, so it is free; without cancelling it looks as if y + 1 forbade it
    assert weights(x * (y + 1) / (z * (y + 1))) == canonical([[1, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], 4)


@pytest.mark.parametrize(
    ("e", "left"),
    [
        (sp.sin(x / y) * z / n, [[1, 1, 0, 0], [0, 0, 1, 1]]),
        (sp.exp(-x * y) * sp.tanh(z), [[1, -1, 0, 0], [0, 0, 0, 1]]),
        (sp.sqrt(x) / y, [[2, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        (sp.sqrt(x + y) / z, [[2, 2, 1, 0], [0, 0, 0, 1]]),
        (x**n / (x**n + y**n), [[1, 1, 0, 0], [0, 0, 1, 0]]),
        (x ** (n + 1) / (z * y**n), [[1, 1, 1, 0]]),
        (sp.Abs(x) / y, [[1, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        (sp.Max(x, 0) / y + sp.Min(x, z) / y, [[1, 1, 1, 0], [0, 0, 0, 1]]),
        (sp.sign(x) * y / z, [[1, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 1]]),
        (sp.atan2(x, y) * z, [[1, 1, 0, 0], [0, 0, 0, 1]]),
        (sp.Piecewise((x, x < y), (y, True)) / z, [[1, 1, 1, 0], [0, 0, 0, 1]]),
        (sp.pi * x / y + sp.sqrt(2), [[1, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        (sp.Float("0.1") * x / y, [[1, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        (sp.Function("f")(x / y) * z / n, [[1, 1, 0, 0], [0, 0, 1, 1]]),
        (x ** sp.Float("1.8") / y, [[5, 9, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        ((x / y) ** (2 * n / 3) * z, [[1, 1, 0, 0]]),
        (sp.log(x / y) * z / n, [[1, 1, 0, 0], [0, 0, 1, 1]]),
        ((sp.log(x) - sp.log(y)) * z / n, [[1, 1, 0, 0], [0, 0, 1, 1]]),
        (sp.log(x) - 2 * sp.log(y), [[2, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        (sp.log(x + y) - sp.log(z), [[1, 1, 1, 0], [0, 0, 0, 1]]),
        (sp.log(x) * y, [[0, 0, 1, 0], [0, 0, 0, 1]]),
        (sp.sin(sp.log(x) - sp.log(y)) + sp.exp(z), [[1, 1, 0, 0], [0, 0, 0, 1]]),
    ],
    ids=str,
)
def test_what_functions_ask_of_their_arguments(e, left):
    assert weights(e) == canonical(left, 4)


def test_what_has_no_scaling_is_named():
    with pytest.raises(ModelError, match="Derivative"):
        Relations().keep(sp.Derivative(sp.Function("f")(x), x))
    with pytest.raises(ModelError, match="singular wherever"):
        weights(1 / (x * (y + z) - x * y - x * z))
    with pytest.raises(ModelError, match="zoo"):
        weights(x / sp.Integer(0))
