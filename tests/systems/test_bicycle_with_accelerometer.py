"""The output ay is kinematics, v' + U r at its place, whatever the tyres do."""

import sympy as sp

from similitude.systems.bicycle import U, r
from similitude.systems.bicycle_with_accelerometer import (
    BICYCLE_WITH_ACCELEROMETER,
    ahead,
    bicycle_with_accelerometer_groups,
    bicycle_with_accelerometer_reduction,
    small_accelerometer_reduction,
)
from similitude.systems.saturating_bicycle import saturating_bicycle_reduction

MODEL = BICYCLE_WITH_ACCELEROMETER


def test_it_feels_what_moves_it():
    at_its_place = MODEL.rates["v"] + U * r + ahead * MODEL.rates["r"]
    assert sp.expand(MODEL.output_map["ay"] - at_its_place) == 0


def test_one_group_more_than_with_saturating_tyres():
    groups = {
        g.name: {n: int(p) for n, p in g.exponents.items()}
        for g in bicycle_with_accelerometer_groups().groups
    }
    assert list(groups)[6:] == ["pi7"]
    assert groups["pi7"] == {"ahead": 1, "L": -1}


def test_the_place_is_counted_from_the_front_axle():
    """From there it is known; from the centre of gravity it is not."""
    reduction = bicycle_with_accelerometer_reduction()
    place, pi1 = sp.symbols("place pi1", real=True)
    assert reduction.substitution["pi7"] == pi1 - place
    plain = [u.name for u in saturating_bicycle_reduction().unknowns]
    assert [u.name for u in reduction.unknowns] == [*plain, "place"]


def test_the_small_one_has_linear_tyres_and_feels_the_same():
    reduction = small_accelerometer_reduction()
    assert [u.name for u in reduction.unknowns] == ["K", "pi1", "eta", "rho", "lead"]
    rates, lead = reduction.rates, sp.Symbol("lead", real=True)
    assert sp.simplify(reduction.output_map["ay"] - (rates["v"] + r + lead * rates["r"])) == 0
