"""The prior of a named vehicle: its population, conditioned on what the vehicle file says.

    K = Caf L/m [m^2/s^2]    pi1 = a/L    eta = Car b/(Caf a)    rho = Iz/(m a b)

Means and covariance come from `similitude.populations.shipped`; what is known of the vehicle conditions
them: its mass and wheelbase where the population ties them to the unknowns, a as the centre of gravity,
Iz and the axle stiffnesses as one more measurement each.
"""

from __future__ import annotations

import math

import numpy as np

from similitude.errors import UsageError
from similitude.population import Prior
from similitude.populations.shipped import shipped_population
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

ONE_DRIVE = 0.5  # of a group's prior sd: surer of it one drive is not, as errors of the model look like it
NAMES = ("K", "pi1", "eta", "rho")
FILE_SD = 0.10  # of the logarithm of a stiffness ratio or an inertia whose sd was not stated
FILE_SD_PI1 = 0.02  # of a/L
ROUNDING = 1e-4  # of a mass or a wheelbase whose sd was not stated
ROAD_SD = 0.35  # of ln K: road, tyre and load against the day the stiffness was measured


def vehicle_prior(vehicle: Vehicle) -> Prior:
    """Prior of the four unknowns of the bicycle for a vehicle.

    Parameters
    ----------
    vehicle : Vehicle    with a wheelbase.

    Returns
    -------
    Prior                of K, pi1, eta and rho, with the origin of each.

    Raises
    ------
    UsageError           the wheelbase is not known.
    """
    L = wheelbase(vehicle)
    prior = _population(vehicle)
    if vehicle.a is not None:
        std = (vehicle.a.sd / L) if vehicle.a.sd else FILE_SD_PI1
        prior = prior.known("pi1", vehicle.a.value / L, std, "a / L of the vehicle file")
    if vehicle.m and vehicle.a and vehicle.b and vehicle.Iz:
        rho = vehicle.Iz.value / (vehicle.m.value * vehicle.a.value * vehicle.b.value)
        std = math.hypot(_stated(vehicle.Iz, FILE_SD), _stated(vehicle.m, 0.0))
        prior = prior.observe("rho", rho, std, "population and Iz/(m a b) of the vehicle file")
    if vehicle.Caf and vehicle.m:
        K = vehicle.Caf.value * L / vehicle.m.value
        own = math.hypot(_stated(vehicle.Caf, FILE_SD), _stated(vehicle.m, 0.0))
        std = math.hypot(own, ROAD_SD)
        prior = prior.observe("K", K, std, "population and Caf L/m of the vehicle file")
    if vehicle.Caf and vehicle.Car and vehicle.a and vehicle.b:
        eta = vehicle.Car.value * vehicle.b.value / (vehicle.Caf.value * vehicle.a.value)
        axle = FILE_SD / math.sqrt(2)  # two axles make the FILE_SD of their ratio
        std = math.hypot(_stated(vehicle.Caf, axle), _stated(vehicle.Car, axle))
        prior = prior.observe("eta", eta, std, "population and Car b/(Caf a) of the vehicle file")
    return prior


def wheelbase(vehicle: Vehicle) -> float:
    """The wheelbase L [m], without which nothing can be identified.

    Raises
    ------
    UsageError           the vehicle has none.
    """
    if vehicle.L is None:
        raise UsageError(
            f"vehicle {vehicle.name!r} has no wheelbase L [m]",
            usually="it was left out together with the mass; the mass cancels, L does not.",
            paste='L = "2.69 m"',
            read='docs/vehicle.md, "The vehicle file"',
        )
    return vehicle.L.value


def _stated(given: Uncertain, otherwise: float) -> float:
    """Relative sd of a value of the vehicle file, or ``otherwise`` where none was stated."""
    return given.sd / given.value if given.sd else otherwise


def _population(vehicle: Vehicle) -> Prior:
    """The population's prior of the unknowns for a vehicle of this mass and wheelbase."""
    prior = shipped_population(vehicle.population).of_length(vehicle.L.value)
    for name, given in (("m", vehicle.m), ("L", vehicle.L)):
        i = prior.names.index(name)
        if given is not None and np.any(np.delete(prior.covariance[i], i)):
            prior = prior.observe(name, given.value, max(_stated(given, 0.0), ROUNDING), "the vehicle file")
    return prior.of(NAMES)
