"""Population: groups of rows that say them, moments of all, bootstrap of rows that are alike."""

from fractions import Fraction

import numpy as np
import pytest

from similitude.populations.population import populate, read_population
from similitude.systems.bicycle import bicycle_groups

from .drawn import axles, independent, table_of

GROUPS = bicycle_groups()
AB = {"a": Fraction(1), "b": Fraction(1)}


def test_groups_of_rows_are_those_of_the_model():
    values = independent(20, 0)
    population = populate(GROUPS, table_of(values), at={"U": 15.0})
    for row, logs in zip(values, population.logs, strict=True):
        m, L, a, Iz, Caf, Car = row
        car = {"m": m, "L": L, "a": a, "b": L - a, "Iz": Iz, "Caf": Caf, "Car": Car, "U": 15.0}
        assert np.exp(logs) == pytest.approx(list(GROUPS.value(car).values()))


def test_a_row_says_only_what_follows_from_it():
    values = independent(30, 1)
    values[0, 1] = np.nan  # no wheelbase
    values[1, 2] = np.nan  # no centre of gravity
    known = np.isfinite(populate(GROUPS, table_of(values)).logs)

    assert known[0].tolist() == [False] * 5
    assert known[1].tolist() == [False, False, True, True, True]
    assert known[2:].all()


def test_a_b_with_a_share_gives_the_wheelbase_where_it_can():
    values = independent(10, 2)
    L, a = values[:, 1], values[:, 2]
    table = table_of(np.column_stack([a, L - a]), ("a", "b"))
    assert np.exp(populate(GROUPS, table).logs[:, :2]) == pytest.approx(np.column_stack([a / L, 1 - a / L]))


def test_group_moments_are_those_of_the_logs():
    population = populate(GROUPS, table_of(axles(400, 3, scatter=0.1)))
    mean, covariance = population.group_moments
    seen = population.logs

    assert mean == pytest.approx(seen.mean(axis=0), abs=0.02)
    assert np.sqrt(np.diag(covariance)) == pytest.approx(seen.std(axis=0), rel=0.12)
    correlation = covariance[2, 3] / np.sqrt(covariance[2, 2] * covariance[3, 3])
    assert correlation == pytest.approx(np.corrcoef(seen[:, 2], seen[:, 3])[0, 1], abs=0.05)


def test_what_no_row_teaches_has_no_moments():
    mean, covariance = populate(GROUPS, table_of(independent(40, 4)[:, :3], ("m", "L", "a"))).group_moments
    assert np.isfinite(mean).tolist() == [True, True, False, False, False]
    assert np.isnan(covariance[2]).all() and np.isfinite(covariance[:2, :2]).all()


@pytest.mark.slow
def test_bootstrap_intervals_hold_the_mean_and_shrink_with_rows():
    wide, narrow = (populate(GROUPS, table_of(independent(n, 5))).intervals(25)[0][2] for n in (25, 225))
    assert wide[0] < 5.1 < wide[1] and 1.5 < np.ptp(wide) / np.ptp(narrow) < 6  # 3, and a factor for 25 draws


def test_a_resampled_table_keeps_rows_that_few_know():
    values = independent(100, 6)
    values[4:, 4:] = np.nan
    population = populate(GROUPS, table_of(values))
    for seed in range(5):
        assert np.isfinite(population.resampled(seed).table.value[:, 4]).sum() == 4


def test_files_are_read_into_one_population(tmp_path):
    (tmp_path / "a.csv").write_text("m [kg],L [m]\n1500,2.7\n1400,2.6\n")
    (tmp_path / "b.csv").write_text("m [kg],a [m],b [m]\n1300,1.1,1.4\n")
    population = read_population([tmp_path / "a.csv", tmp_path / "b.csv"], GROUPS)

    assert len(population.table) == 3 and population.table.stratum.tolist() == [0, 0, 1]
