"""Claims about range, groups and scales."""

import pytest

from similitude.paper.claims_groups import extremes, group_claims, similar_speed, test_vehicle_groups

from .pinned import check


def test_claims_are_the_pinned_ones():
    check("Model, groups, scale", group_claims())


def test_the_similar_speed_by_hand():
    """K/U² = Caf L/(m 4²)."""
    assert similar_speed() == pytest.approx((145.68 * 5.451 * 16 / (65 * 0.3652)) ** 0.5, rel=1e-9)


def test_the_groups_by_hand():
    found = test_vehicle_groups(3.0)
    assert found["pi3"] == pytest.approx(65 * 0.3652 / (5.451 * 9), rel=1e-9)
    assert found["pi5"] == pytest.approx(0.1615 / (5.451 * 0.3652**2), rel=1e-9)


def test_groups_of_order_one_while_driving():
    assert all(0.05 < low <= high < 20 for low, high in extremes().values())


test_vehicle_groups.__test__ = False
