"""Relations: what was planted is found, what was not is not, and pi1 + pi2 = 1 is never entered."""

import numpy as np
import pytest

from similitude.populations.population import populate
from similitude.populations.relations import relate
from similitude.systems.bicycle import bicycle_groups

from .drawn import axles, independent, planted, table_of

GROUPS = bicycle_groups()


def relations_of(values):
    return relate(populate(GROUPS, table_of(values)))


@pytest.mark.slow
def test_a_planted_slope_is_found_with_its_interval_and_alone():
    """All of 8 tables: at a power of 0.9 a miss is likelier than not, and power is above 0.99."""
    for seed in range(8):
        relations = relations_of(planted(150, seed))
        (one,) = relations.discoveries
        assert set(one.groups) == {"pi3", "pi4"} and one.kind == "line"
        assert one.coefficients["slope"] == pytest.approx(1.0977, rel=0.02)
        assert one.interval[0] < one.coefficients["slope"] < one.interval[1]
        assert one.out_of_sample == pytest.approx(0.033, rel=0.4)


@pytest.mark.slow
def test_independent_parameters_keep_to_nothing_but_the_wheelbase():
    """`make populations` runs 200 tables; here six, of which one may err at a rate of 1 %."""
    false = 0
    for seed in range(6):
        relations = relations_of(independent(150, seed))
        assert [one.text for one in relations.constraints] == ["pi1 + pi2 = 1"]
        false += len(relations.discoveries) > 0
    assert false <= 1


def test_what_the_paper_missed_is_found_where_cars_are_built_so():
    """eta = pi4 pi2/(pi3 pi1), a product that none of its parts explains."""
    relations = relations_of(axles(150, 0))
    eta = relations.of("pi1", "pi2", "pi3", "pi4")

    assert eta.found and eta.coefficients["constant"] == pytest.approx(1.5, rel=0.02)
    assert eta.text.startswith("pi2 pi4/(pi1 pi3)")
    pair = relations.of("pi3", "pi4")
    assert pair is None or eta.out_of_sample < 0.7 * pair.out_of_sample


def test_the_names_of_groups_and_the_order_of_rows_do_not_matter():
    values = planted(80, 3)
    one, other = relations_of(values), relations_of(values[::-1])

    assert [r.groups for r in one] == [r.groups for r in other]
    assert one.of("pi3", "pi4").coefficients["slope"] == pytest.approx(
        other.of("pi3", "pi4").coefficients["slope"], rel=0.01
    )


def test_copies_of_a_row_prove_nothing():
    values = np.repeat(independent(5, 1), 30, axis=0)
    assert relations_of(values).discoveries == ()


def test_nearly_empty_tables_have_no_relations():
    assert len(relations_of(independent(2, 0))) == 0
    half = planted(40, 5)
    half[3:, 4:] = np.nan
    assert relations_of(half).of("pi3", "pi4") is None


def test_one_planted_and_one_independent_table():
    (one,) = relations_of(planted(150, 100)).discoveries
    assert set(one.groups) == {"pi3", "pi4"} and one.interval[0] <= 1.0977 <= one.interval[1]
    assert relations_of(independent(150, 100)).discoveries == ()
