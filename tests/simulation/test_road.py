"""The road: surfaces in time and place, wind with its statistics, kerbs, bank."""

import numpy as np
import pytest

from similitude.simulation.arithmetic import ARRAYS, FLOATS
from similitude.simulation.car import GRAVITY, generator
from similitude.simulation.plant import Output, Push
from similitude.simulation.road import (
    Gusts,
    Kerbs,
    Knot,
    Patch,
    Road,
    feel,
    gust_force,
    kerb_force,
    stiffness_under_axle,
    surface_at,
    surface_under_axle,
    wander,
)

T = np.arange(0, 60, 0.01)


def felt(**road):
    return feel(Road(**road), T, front=1.2, seeds=[1])


def test_a_surface_in_time_comes_again():
    road = felt(friction=0.9, surface=(Patch(begin=10.0, end=20.0, every=20.0, stiffness=0.5),))

    halved = (np.mod(T, 20) >= 10) & (np.mod(T, 20) < 20)
    np.testing.assert_array_equal(road.stiffness, np.where(halved, 0.5, 1.0))
    assert (road.friction == 0.9).all()  # not said, not changed
    assert all(patches == () for patches in road.patches)


def test_of_two_surfaces_the_later_wins():
    road = felt(surface=(Patch(friction=0.5), Patch(friction=0.2, begin=30.0)))
    assert set(road.friction[T < 30]) == {0.5} and set(road.friction[T >= 30]) == {0.2}


def test_a_surface_with_a_place_waits_for_the_wheel():
    patch = Patch(friction=0.3, y_from=0.5, x_to=100.0, side="left", begin=5.0)
    road = felt(surface=(patch,))
    assert road.patches[0] == () and road.patches[-1] == (patch,) and (road.friction == 1).all()

    push = Push(0, 20, 0, 0, 0, 0, 0.8, 1.0, (patch,))
    assert surface_at(push, 10.0, 0.6, "left", FLOATS) == (0.8, 0.3)
    for place in ((10.0, 0.4, "left"), (101.0, 0.6, "left"), (10.0, 0.6, "right")):
        assert surface_at(push, *place, FLOATS) == (0.8, 1.0)
    _, many = surface_at(push, np.array([10.0, 10.0]), np.array([0.6, 0.4]), "left", ARRAYS)
    assert many.tolist() == [0.3, 1.0]


def test_the_truth_of_an_axle_is_the_mean_of_its_wheels():
    road = Road(surface=(Patch(stiffness=0.5, y_from=0.0, begin=0.0),))
    found = felt(surface=road.surface)
    still = np.zeros(T.size)

    stiffness, friction = surface_under_axle(road, found, T, still, still, still, ahead=1.2, half_track=0.7)
    assert set(stiffness) == {0.75} and set(friction) == {1.0}


def test_the_bank_pulls_with_its_share_of_gravity():
    road = felt(bank=(Knot(at=0.0, angle=0.0), Knot(at=10.0, angle=0.1)))
    assert road.pull[500] == pytest.approx(GRAVITY * np.sin(0.05)) and road.pull[-1] == pytest.approx(
        GRAVITY * np.sin(0.1)
    )


def test_wind_has_its_size_and_memory():
    gusts, t = Gusts(force=300.0, correlation=0.5, ahead=0.2), np.arange(0, 4000, 0.05)
    force = gust_force(gusts, t, 3)

    independent = 4000 / (2 * 0.5)  # integral of the squared correlation is the correlation time
    assert force.std() == pytest.approx(300, rel=4 / np.sqrt(2 * independent))
    lagged = np.corrcoef(force[:-10], force[10:])[0, 1]
    assert lagged == pytest.approx(np.exp(-1), abs=4 / np.sqrt(independent))
    road = feel(Road(gusts=gusts), T, front=1.2, seeds=[3])
    np.testing.assert_allclose(road.moment, 0.2 * road.force)


def test_a_wander_starts_as_it_goes_on():
    first = [wander(T[:5], 2.0, generator(seed, "x"))[0] for seed in range(400)]
    assert np.std(first) == pytest.approx(1, rel=4 / np.sqrt(800))


def test_kerbs_come_at_their_rate_and_push_at_the_front():
    kerbs, t = Kerbs(every=5.0, force=2000.0, duration=0.05), np.arange(0, 2000, 0.005)
    force = kerb_force(kerbs, t, 1)

    hits = np.count_nonzero((force[1:] != 0) & (force[:-1] == 0))
    assert hits == pytest.approx(2000 / 5, abs=4 * np.sqrt(2000 / 5))
    assert 0.95 * 2000 <= np.abs(force).max() <= 2 * 2000
    assert abs(np.sign(force).sum()) < 0.3 * np.count_nonzero(force)
    road = feel(Road(kerbs=kerbs), T, front=1.2, seeds=[1])
    np.testing.assert_allclose(road.moment, 1.2 * road.force)


def test_each_seed_has_its_own_wind_whoever_else_drives():
    road = Road(gusts=Gusts(force=300.0, correlation=1.0))
    together = feel(road, T, front=np.array([1.2, 1.3]), seeds=[4, 5])
    alone = feel(road, T, front=1.3, seeds=[5])
    np.testing.assert_array_equal(together.force[:, 1], alone.force)


def test_what_a_driver_may_believe_is_what_the_truth_says():
    """At every instant alike, with wheels on both sides of an edge and the surface coming and going."""
    surface = (
        Patch(stiffness=0.5, y_from=0.3),
        Patch(stiffness=0.1, y_from=0.3, begin=20.0, end=40.0, side="left"),
    )
    road, found = Road(surface=surface), felt(surface=surface)
    rng = np.random.default_rng(4)
    x, y, psi = rng.uniform(0, 9, T.size), rng.uniform(0, 0.6, T.size), rng.uniform(-0.5, 0.5, T.size)
    truth, _ = surface_under_axle(road, found, T, x, y, psi, ahead=0.15, half_track=0.1)
    said = [
        stiffness_under_axle(
            Push(0, 4, 0, 0, 0, 0, found.stiffness[i], 1.0, found.patches[i]),
            Output(x[i], y[i], psi[i], 0, 0, 4, 0, 0),
            ahead=0.15, half_track=0.1, on=FLOATS,
        )
        for i in range(0, T.size, 7)
    ]  # fmt: skip
    np.testing.assert_allclose(said, truth[::7], rtol=1e-12)
    assert len(set(np.round(truth, 6))) >= 4
