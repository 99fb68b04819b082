"""The car that is driven: groups there and back, and how it is drawn."""

import numpy as np
import pytest

from similitude.simulation.car import Car, draw_car, generator
from similitude.units import Uncertain, parse_unit

STATED = {"m": (1500, 100), "Iz": (2600, None), "Caf": (82e3, 8e3), "Car": (98e3, None),
          "L": (2.7, None), "a": (1.2, None)}  # fmt: skip


def stated():
    return {name: Uncertain(value, sd, parse_unit("1")) for name, (value, sd) in STATED.items()}


def test_groups_there_and_back():
    car = Car(m=1500.0, Iz=2600.0, a=1.2, b=1.5, Caf=82e3, Car=98e3)
    again = Car.of_groups(L=car.L, K=car.K, m=car.m, **car.groups)

    for name in ("m", "Iz", "a", "b", "Caf", "Car"):
        assert getattr(again, name) == pytest.approx(getattr(car, name), rel=1e-14)


def test_what_is_certain_is_itself_and_what_is_not_has_its_spread():
    cars = draw_car(stated(), range(4000))

    assert (cars.Iz == 2600).all() and np.ptp(cars.b) == 0
    spread = np.log(cars.m / 1500)
    # standard error of a mean 1/√n, of a deviation 1/√(2n); four of them
    assert abs(spread.mean()) < 4 * (100 / 1500) / np.sqrt(4000)
    assert spread.std() == pytest.approx(100 / 1500, rel=4 / np.sqrt(8000))


def test_a_car_depends_on_its_seed_alone():
    alone, among = draw_car(stated(), [7]), draw_car(stated(), [3, 7])
    assert isinstance(alone.m, float) and alone.m == among.m[1] and alone.Caf == among.Caf[1]


def test_purposes_have_numbers_of_their_own():
    draws = {p: generator(1, p).random() for p in ("sensor r", "sensor U", "gusts")}
    assert len(set(draws.values())) == 3 and draws["gusts"] == generator(1, "gusts").random()


def test_the_fastest_rate_bounds_the_eigenvalues():
    from similitude.simulation.lqr import path_matrices

    car = Car(m=1500.0, Iz=2600.0, a=1.2, b=1.5, Caf=82e3, Car=98e3)
    for U in (2.0, 10.0, 40.0):
        A, _ = path_matrices(car, U)
        fastest = np.abs(np.linalg.eigvals(A).real).max()
        assert fastest <= car.fastest_rate(U)
