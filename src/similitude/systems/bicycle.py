"""The bicycle model of a car's yaw dynamics: the system of the paper and the first one shipped.

    v  lateral speed at the centre of gravity [m/s]      r  yaw rate [rad/s]
    delta  road-wheel steer angle [rad]                  U  forward speed [m/s]
    m  mass [kg]    Iz  yaw inertia [kg m^2]             a, b  centre of gravity to front, rear axle [m]
    L = a + b  wheelbase [m]                             Caf, Car  axle cornering stiffness [N/rad]

Positive to the same side everywhere (SAE or ISO, as the log has it).
"""

from __future__ import annotations

import sympy as sp

from similitude.groups import Groups, reparameterize
from similitude.model import Model, Quantity
from similitude.reduction import Reduction, Unknown
from similitude.systems.system import System

v, r, delta = sp.symbols("v r delta", real=True)
m, L, U, a, b, Caf, Car, Iz = sp.symbols("m L U a b Caf Car Iz", real=True)

alpha_f = delta - (v + a * r) / U  # front slip angle [rad]
alpha_r = (b * r - v) / U  # rear slip angle [rad]
Ff = Caf * alpha_f  # front lateral force [N]
Fr = Car * alpha_r  # rear lateral force [N]

BICYCLE = Model(
    name="bicycle",
    states=(Quantity("v", "m/s", "lateral speed"), Quantity("r", "rad/s", "yaw rate")),
    inputs=(Quantity("delta", "rad", "road-wheel steer angle"),),
    outputs=(Quantity("r", "rad/s", "yaw rate"),),
    parameters=(
        Quantity("m", "kg", "mass"),
        Quantity("L", "m", "wheelbase"),
        Quantity("U", "m/s", "forward speed"),
        Quantity("a", "m", "centre of gravity to front axle"),
        Quantity("b", "m", "centre of gravity to rear axle"),
        Quantity("Caf", "N/rad", "front axle cornering stiffness"),
        Quantity("Car", "N/rad", "rear axle cornering stiffness"),
        Quantity("Iz", "kg m^2", "yaw inertia"),
    ),
    rates={"v": (Ff + Fr) / m - U * r, "r": (a * Ff - b * Fr) / Iz},
    output_map={"r": r},
    constraints={"b": L - a},
    signals=("U",),
    validity=(U * r, Quantity("ay", "m/s^2", "lateral acceleration")),
    source="Brennan & Alleyne 2004, eqs 1-4",
)


def bicycle_groups() -> Groups:
    """The paper's five groups, base m, L, U (eq 17), and the model rewritten in them (eq 19)."""
    return reparameterize(BICYCLE, base=("m", "L", "U"))


def bicycle_reduction() -> Reduction:
    """Four unknowns in place of the five groups.

    K = pi3 U^2 does not depend on speed; eta = pi4 pi2/(pi3 pi1) and rho = pi5/(pi1 pi2) cluster
    better over cars than pi4/pi3 and pi5 do.
    """
    K, pi1, eta, rho = sp.symbols("K pi1 eta rho", real=True)
    pi2 = 1 - pi1
    return Reduction(
        groups=bicycle_groups(),
        unknowns=(
            Unknown(
                "K",
                "m^2/s^2",
                "log",
                "identify",
                "Caf L/m, front cornering stiffness per mass and length",
            ),
            Unknown("pi1", "-", "linear", "seldom", "a/L, position of the centre of gravity"),
            Unknown(
                "eta",
                "-",
                "log",
                "estimate",
                "rear over front cornering coefficient; > 1 understeers",
            ),
            Unknown("rho", "-", "log", "estimate", "Iz/(m a b), yaw inertia ratio"),
        ),
        substitution={
            "pi1": pi1,
            "pi2": pi2,
            "pi3": K / U**2,
            "pi4": K / U**2 * eta * pi1 / pi2,
            "pi5": rho * pi1 * pi2,
        },
        live=(U > 0) & (10 * U * U > sp.Symbol("K_prior", real=True)),
    )


MEANINGS = {
    "a": "place of the centre of gravity between the axles",
    "b": "the same from the rear: b/L = 1 - a/L",
    "Caf": "front cornering stiffness against the force of a turn, m U^2/L",
    "Car": "rear cornering stiffness against the same",
    "Iz": "yaw inertia over that of the whole mass at the wheelbase",
}

SYSTEM = System(
    BICYCLE,
    base=("m", "L", "U"),
    values={
        "m": "5.451 kg",
        "L": "0.3652 m",
        "U": "4 m/s",
        "a": "0.1461 m",
        "Caf": "65 N/rad",
        "Car": "110 N/rad",
        "Iz": "0.1615 kg m^2",
    },
    source="Brennan & Alleyne 2004, the scale test vehicle",
    inputs={"delta": "2 deg"},
    duration="2 s",
    meanings=MEANINGS,
)
