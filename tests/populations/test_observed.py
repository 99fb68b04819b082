"""Groups that only the columns give: Iz/(m a b) of a table without wheelbases."""

from fractions import Fraction

import numpy as np

from similitude.populations.observed import observed_groups
from similitude.populations.population import populate
from similitude.systems.bicycle import bicycle_groups

from .drawn import axles, table_of

AB = {"a": Fraction(1), "b": Fraction(1)}


def test_the_inertia_ratio_is_found_where_no_row_knows_its_wheelbase():
    m, L, a, Iz, *_ = axles(30, 0).T
    table = table_of(np.column_stack([m, a * (L - a), Iz]), ("m", AB, "Iz"))
    (product,) = observed_groups(populate(bicycle_groups(), table)).values()

    assert {n: abs(p) for n, p in product.items()} == {"Iz": 1, "m": 1, "a": 1, "b": 1}
    assert product["Iz"] == -product["m"] == -product["a"]


def test_a_table_that_gives_the_groups_needs_no_others():
    assert observed_groups(populate(bicycle_groups(), table_of(axles(30, 0)))) == {}
