"""What a vehicle file says narrows the population, each value by its own uncertainty."""

import dataclasses
import math

import numpy as np
import pytest

from similitude.errors import UsageError
from similitude.populations.shipped import shipped_names, shipped_population
from similitude.units import Uncertain
from similitude.vehicle_checks import POPULATIONS as CHECKED
from similitude.vehicle_file import Vehicle, read_vehicle
from similitude.vehicle_prior import NAMES, vehicle_prior

L, A, M, IZ, CAF, CAR = 2.7, 1.2, 1500.0, 2600.0, 80e3, 100e3


def value(x, sd=None):
    return Uncertain(x, sd, "-")


def car(**more):
    return Vehicle("car", L=value(L), **more)


def prior_of(**more):
    prior = vehicle_prior(car(**more))
    return dict(zip(NAMES, prior.mean, strict=True)), dict(zip(NAMES, prior.std, strict=True)), prior


def product(mean, sd, seen, seen_sd):
    """Two Gaussians of a logarithm: value and sd."""
    weight = 1 / sd**2 + 1 / seen_sd**2
    place = (math.log(mean) / sd**2 + math.log(seen) / seen_sd**2) / weight
    return math.exp(place), weight**-0.5


def test_the_populations_are_those_of_the_vehicle_file():
    assert set(shipped_names()) == CHECKED.keys()


def test_mass_and_wheelbase_condition_a_population_that_ties_them_to_the_groups():
    """In all_vehicles long cars have less inertia for m a b; in passenger_cars nothing is tied."""
    told = {"m": value(2500.0), "population": "all_vehicles"}
    short, long = (vehicle_prior(Vehicle("v", L=value(length), **told)) for length in (2.4, 3.4))
    rho = NAMES.index("rho")

    assert short.mean[rho] > 1.05 * long.mean[rho]
    assert short.std[rho] == pytest.approx(long.std[rho])
    assert prior_of(m=value(900.0))[0] == prior_of(m=value(2500.0))[0]


@pytest.mark.parametrize("name", sorted(CHECKED))
def test_every_population_gives_a_proper_prior(name):
    length = 0.3 if name == "small_cars_1to10" else 2.7
    prior = vehicle_prior(Vehicle("v", L=value(length), population=name))

    assert prior.names == NAMES and np.all(np.linalg.eigvalsh(prior.covariance) > 0)
    assert set(prior.origins.values()) <= {f"population {name}", "the vehicle file"}


def test_the_wheelbase_alone_leaves_the_population_as_published():
    mean, std, prior = prior_of()
    assert mean == {"K": 145.68, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}
    assert list(std.values()) == pytest.approx([0.5, 0.03, 0.13, 0.09])
    assert set(prior.origins.values()) == {"population passenger_cars"}


@pytest.mark.parametrize("length", [0.2, 0.3652, 0.5])
def test_small_cars_keep_K_over_g_L_so_any_size_is_the_same_car(length):
    prior = vehicle_prior(Vehicle("rc", L=value(length), population="small_cars_1to10"))
    assert prior.mean[0] / (9.80665 * length) == pytest.approx(1.22)


def test_the_small_population_holds_the_papers_test_vehicle():
    """m 5.451 kg, Iz 0.1615, a 0.1461, b 0.2191, Caf 65, Car 110 (Brennan & Alleyne 2004)."""
    prior = vehicle_prior(Vehicle("paper", L=value(0.3652), population="small_cars_1to10"))
    truth = [65 * 0.3652 / 5.451, 0.1461 / 0.3652, 110 * 0.2191 / (65 * 0.1461)]
    truth.append(0.1615 / (5.451 * 0.1461 * 0.2191))
    log = np.array([kind == "log" for kind in prior.kinds])
    away = np.where(log, np.log(truth / prior.mean), truth - prior.mean) / prior.std
    assert np.all(np.abs(away) < 2.5)


def test_a_and_b_of_the_file_replace_the_population():
    mean, std, prior = prior_of(a=value(A), b=value(L - A))
    assert mean["pi1"] == pytest.approx(A / L)
    assert std["pi1"] == pytest.approx(0.02)
    assert prior.origins["pi1"] == "a / L of the vehicle file"
    assert prior_of(a=value(A, 0.01), b=value(L - A))[1]["pi1"] == pytest.approx(0.01 / L)


def test_inertia_counts_as_one_more_measurement():
    known = {"a": value(A), "b": value(L - A), "m": value(M)}
    rho = IZ / (M * A * (L - A))
    for sd, seen in ((None, 0.10), (130.0, 130 / IZ)):
        mean, std, _ = prior_of(Iz=value(IZ, sd), **known)
        assert (mean["rho"], std["rho"]) == pytest.approx(product(1.017, 0.09, rho, seen))
    known["m"] = value(M, 300.0)
    mean, std, _ = prior_of(Iz=value(IZ), **known)
    assert std["rho"] == pytest.approx(product(1.017, 0.09, rho, math.hypot(0.10, 0.2))[1])


def test_stiffness_of_the_file_counts_with_the_road_of_the_day():
    for sd, own in ((None, 0.10), (4e3, 0.05)):
        mean, std, _ = prior_of(m=value(M), Caf=value(CAF, sd))
        seen = product(145.68, 0.5, CAF * L / M, math.hypot(own, 0.35))
        assert (mean["K"], std["K"]) == pytest.approx(seen)
        assert std["K"] > 0.25  # a file never settles what the drive is to find


def test_the_axles_ratio_counts_by_the_uncertainty_of_both():
    eta = CAR * (L - A) / (CAF * A)
    lengths = {"a": value(A), "b": value(L - A)}
    cases = (
        ((None, None), 0.10),
        ((8e3, 20e3), math.hypot(0.1, 0.2)),
        ((8e3, None), math.hypot(0.1, 0.1 / 2**0.5)),
    )
    for (front, rear), seen in cases:
        mean, std, _ = prior_of(Caf=value(CAF, front), Car=value(CAR, rear), **lengths)
        assert (mean["eta"], std["eta"]) == pytest.approx(product(1.42, 0.13, eta, seen))


def test_what_needs_a_value_that_is_missing_is_left_to_the_population():
    _, _, prior = prior_of(Iz=value(IZ), Caf=value(CAF), Car=value(CAR))
    assert set(prior.origins.values()) == {"population passenger_cars"}


def test_no_wheelbase_is_said_with_the_line_to_write():
    with pytest.raises(UsageError) as refused:
        vehicle_prior(dataclasses.replace(car(), L=None))
    assert "no wheelbase L" in refused.value.what
    assert refused.value.paste == 'L = "2.69 m"'


def test_a_file_narrows_and_never_widens(tmp_path):
    path = tmp_path / "car.toml"
    path.write_text(
        'a = "1.2 m"\nb = "1.5 m"\nm = "1500 ± 50 kg"\nIz = "2600 kg m^2"\n'
        'Caf = "80000 N/rad"\nCar = "100000 N/rad"\n'
    )
    prior = vehicle_prior(read_vehicle(path))
    assert np.all(prior.std < shipped_population("passenger_cars").prior.of(NAMES).std)
    assert np.all(np.linalg.eigvalsh(prior.covariance) > 0)
    assert all("vehicle file" in origin for origin in prior.origins.values())
