"""The Gaussian of a population against moments of complete tables, and of tables with holes."""

from fractions import Fraction

import numpy as np
import pytest

from similitude.populations.coordinates import coordinates_of
from similitude.populations.gaussian import FEWEST, fit_gaussian
from similitude.populations.table import joined
from similitude.systems.bicycle import bicycle_groups

from .drawn import axles, independent, table_of

GROUPS = bicycle_groups()
SPACE = coordinates_of(GROUPS)
AB = {"a": Fraction(1), "b": Fraction(1)}


def coordinates(values):
    m, L, a, Iz, Caf, Car = values.T
    return {
        "ln m": np.log(m), "ln L": np.log(L), "logit a/L": np.log(a / (L - a)),
        "ln pi3": np.log(Caf * L / m), "ln pi4": np.log(Car * L / m), "ln pi5": np.log(Iz / (m * L**2)),
    }  # fmt: skip


def test_a_complete_normal_table_gives_its_sample_moments():
    """Of 400 normal rows of six coordinates one lies beyond 3.5 sds and ten beyond the 97.5 % of a row: cut
    down, they move a mean by less than half its standard error, and cost an sd 3 % at most."""
    values = axles(400, 1, scatter=0.1)
    fit, n = fit_gaussian(table_of(values), SPACE), 400
    z = np.column_stack([coordinates(values)[name] for name in SPACE.names])

    assert np.all(np.abs(fit.mean - z.mean(axis=0)) < 0.5 * z.std(axis=0) / np.sqrt(n))
    assert np.sqrt(np.diag(fit.covariance)) == pytest.approx(z.std(axis=0), rel=2 / np.sqrt(2 * n) + 0.03)
    assert np.all((fit.count > n - 4) & (fit.count <= n))  # a row screened out teaches nothing
    np.testing.assert_allclose(fit.rows, z, atol=1e-3)


def test_a_tenth_of_wrong_rows_hardly_moves_it():
    values = independent(300, 2)
    clean = fit_gaussian(table_of(values), SPACE)
    values[:30, 4] *= 8.0
    dirty = fit_gaussian(table_of(values), SPACE)
    k = SPACE.names.index("ln pi3")
    sd = np.sqrt(clean.covariance[k, k])

    assert abs(dirty.mean[k] - clean.mean[k]) < 0.3 * sd  # the plain mean moves by half an sd
    assert np.sqrt(dirty.covariance[k, k]) < 1.4 * sd  # the plain sd grows to 1.9


def test_half_the_rows_without_stiffness_leave_its_mean_where_the_others_put_it():
    values = axles(200, 3)
    known = values.copy()
    known[::2, 4:] = np.nan
    fit = fit_gaussian(table_of(known), SPACE)
    k = SPACE.names.index("ln pi3")
    seen = coordinates(values[1::2])["ln pi3"]

    assert abs(fit.mean[k] - seen.mean()) < 2.5 * seen.std() / np.sqrt(100)
    assert fit.count[k] == pytest.approx(100, rel=0.02)
    assert len(fit.rows) == 200 and np.isfinite(fit.rows).all()


def test_rows_that_know_a_b_but_not_L_say_what_they_know():
    """ab = L^2 pi1 pi2: the inertia ratio Iz/(m a b) comes out, a/L is held at one half and says so."""
    values = axles(300, 4)
    m, L, a, Iz, *_ = values.T
    short = table_of(np.column_stack([m, a * (L - a), Iz]), ("m", AB, "Iz"))
    fit = fit_gaussian(short, SPACE)
    share, length, inertia = (SPACE.names.index(n) for n in ("logit a/L", "ln L", "ln pi5"))

    assert fit.count[share] == 0 and fit.count[length] > 299
    assert np.exp(fit.mean[inertia]) == pytest.approx(1.02 / 4, rel=0.01)
    assert np.exp(fit.mean[length]) == pytest.approx(np.exp(np.log(L).mean()), rel=0.02)


def test_two_tables_of_other_sizes_do_not_invent_a_centre_of_gravity():
    """Vans that know a b beside cars that know a and L: a/L is what the cars say."""
    cars, vans = independent(150, 5), independent(150, 6)
    vans[:, 1:3] *= 1.5
    product = vans[:, 2] * (vans[:, 1] - vans[:, 2])
    table = joined(
        [table_of(cars), table_of(np.column_stack([vans[:, 0], product, vans[:, 3]]), ("m", AB, "Iz"))],
        name="x",
    )
    fit = fit_gaussian(table, SPACE)
    share = SPACE.names.index("logit a/L")
    seen = coordinates(cars)["logit a/L"]

    assert abs(fit.mean[share] - seen.mean()) < 3 * seen.std() / np.sqrt(150)
    assert np.sqrt(fit.covariance[share, share]) == pytest.approx(seen.std(), rel=0.2)


def test_a_stated_sd_is_taken_out_of_the_spread():
    values = independent(300, 7)
    noisy = values.copy()
    noisy[:, 3] *= np.exp(0.3 * np.random.default_rng(1).standard_normal(300))
    table = table_of(noisy)
    table.sd[:, 3] = 0.3 * noisy[:, 3]
    k = SPACE.names.index("ln pi5")
    told, silent = (fit_gaussian(t, SPACE).covariance[k, k] ** 0.5 for t in (table, table_of(noisy)))
    true = coordinates(values)["ln pi5"].std()

    assert told == pytest.approx(true, rel=0.15) and silent > 1.15 * told


def test_a_weight_of_a_half_on_two_copies_is_one_row():
    values = independent(60, 8)
    doubled = table_of(np.vstack([values, values]))
    doubled.weight[:] = 0.5
    one, two = fit_gaussian(table_of(values), SPACE), fit_gaussian(doubled, SPACE)

    np.testing.assert_allclose(one.mean, two.mean, atol=2e-3)
    np.testing.assert_allclose(one.covariance, two.covariance, atol=2e-3)


def test_few_rows_predict_wider_than_they_scatter():
    fit = fit_gaussian(table_of(independent(6, 9)), SPACE)
    ratio = np.sqrt(np.diag(fit.predictive) / np.diag(fit.covariance))

    assert ratio == pytest.approx(np.sqrt(7 / 6 * 5 / 3), rel=0.01)
    assert FEWEST < 2


def test_fit_of_one_row_is_finite():
    fit = fit_gaussian(table_of(independent(1, 0)), SPACE)
    assert np.isfinite(fit.mean).all() and np.isfinite(fit.covariance).all()
