"""The bicycle with tyres that saturate: the linear bicycle at small slip, a greatest force beyond.

    F = N s(C alpha/N)    force of an axle whose slip angle is alpha and cornering stiffness C [N]
    N = grip m b/L, grip m a/L    greatest force of the front, rear axle [N]
    grip = mu g           greatest lateral acceleration [m/s^2]
    s                     `similitude.saturation`: linear, cubic onset, at most one

All other letters are those of `similitude.systems.bicycle`.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from similitude.groups import Groups, reparameterize
from similitude.model import Model, Quantity
from similitude.reduction import Reduction, Unknown
from similitude.saturation import Saturation
from similitude.systems import bicycle
from similitude.systems.bicycle import (
    BICYCLE,
    Caf,
    Car,
    Iz,
    L,
    U,
    a,
    alpha_f,
    alpha_r,
    b,
    bicycle_reduction,
    m,
    r,
)
from similitude.systems.system import System

grip = sp.Symbol("grip", real=True)

Nf = grip * m * b / L  # greatest force of the front axle [N]
Nr = grip * m * a / L  # of the rear axle [N]
Ff = Nf * Saturation(Caf * alpha_f / Nf)  # front lateral force [N]
Fr = Nr * Saturation(Car * alpha_r / Nr)  # rear lateral force [N]

SATURATING_BICYCLE: Model = replace(
    BICYCLE,
    name="saturating_bicycle",
    parameters=(*BICYCLE.parameters, Quantity("grip", "m/s^2", "greatest lateral acceleration")),
    rates={"v": (Ff + Fr) / m - U * r, "r": (a * Ff - b * Fr) / Iz},
    source="Brennan & Alleyne 2004, eqs 1-4, with saturating tyres",
)


def saturating_bicycle_groups() -> Groups:
    """The paper's five groups and pi6 = grip L/U^2, base m, L, U."""
    return reparameterize(SATURATING_BICYCLE, base=("m", "L", "U"))


def saturating_bicycle_reduction() -> Reduction:
    """The unknowns of the linear bicycle, and the grip."""
    linear = bicycle_reduction()
    return Reduction(
        groups=saturating_bicycle_groups(),
        unknowns=(
            *linear.unknowns,
            Unknown("grip", "m/s^2", "log", "beyond", "mu g, greatest lateral acceleration"),
        ),
        substitution={**linear.substitution, "pi6": grip * L / U**2},
        live=linear.live,
    )


SYSTEM = System(
    SATURATING_BICYCLE,
    base=("m", "L", "U"),
    values={**bicycle.SYSTEM.values, "grip": "0.9 gn"},
    source="Brennan & Alleyne 2004, the scale test vehicle; the grip is that of rubber on a dry road",
    inputs={"delta": "10 deg"},
    duration="2 s",
    meanings={**bicycle.MEANINGS, "grip": "greatest lateral acceleration against U^2/L"},
)
