"""The bicycle with saturating tyres on a banked road in the wind, lateral acceleration measured besides.

    v' = (Ff + Fr)/m - U r + bank + push       r' = (a Ff - b Fr)/Iz
    ay = (Ff + Fr)/m + push + ahead r'         what an accelerometer feels: it is blind to the bank

    bank   lateral part of gravity on a banked road [m/s^2]      push   force of the wind per mass [m/s^2]
    ahead  accelerometer ahead of the centre of gravity [m]

All other letters are those of `similitude.systems.saturating_bicycle`. Side force is tyres and wind as they
are, so what yaw rate alone cannot tell apart (K, eta, sideslip) shows; how well hangs on knowing its place.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from similitude.groups import Groups, reparameterize
from similitude.model import Quantity
from similitude.reduction import Reduction, Unknown
from similitude.systems import bicycle
from similitude.systems.bicycle import BICYCLE, Iz, L, U, a, b, bicycle_reduction, m
from similitude.systems.saturating_bicycle import (
    SATURATING_BICYCLE,
    Ff,
    Fr,
    saturating_bicycle_reduction,
)

ahead, bank, push, place, lead = sp.symbols("ahead bank push place lead", real=True)
pi1 = sp.Symbol("pi1", real=True)

BICYCLE_WITH_ACCELEROMETER = replace(
    SATURATING_BICYCLE,
    name="bicycle_with_accelerometer",
    parameters=(
        *SATURATING_BICYCLE.parameters,
        Quantity("ahead", "m", "accelerometer ahead of the centre of gravity"),
        Quantity("bank", "m/s^2", "lateral part of gravity on a banked road"),
        Quantity("push", "m/s^2", "force of the wind per mass"),
    ),
    outputs=(*SATURATING_BICYCLE.outputs, Quantity("ay", "m/s^2", "lateral acceleration")),
    rates={**SATURATING_BICYCLE.rates, "v": SATURATING_BICYCLE.rates["v"] + bank + push},
    output_map={
        **SATURATING_BICYCLE.output_map,
        "ay": (Ff + Fr) / m + push + ahead * (a * Ff - b * Fr) / Iz,
    },
    source="Brennan & Alleyne 2004, eqs 1-4, with saturating tyres, bank and wind",
)


def bicycle_with_accelerometer_groups() -> Groups:
    """The groups of the saturating bicycle and those of the accelerometer's place, bank and wind."""
    return reparameterize(BICYCLE_WITH_ACCELEROMETER, base=("m", "L", "U"))


def bicycle_with_accelerometer_reduction() -> Reduction:
    """The unknowns of the saturating bicycle, the accelerometer's place, and what pushes the car sideways."""
    plain = saturating_bicycle_reduction()
    return Reduction(
        groups=bicycle_with_accelerometer_groups(),
        unknowns=(
            *plain.unknowns,
            Unknown("place", "-", "linear", "estimate", "accelerometer behind the front axle over L"),
            Unknown("bank", "m/s^2", "linear", "wander", "lateral part of gravity on a banked road"),
            Unknown("push", "m/s^2", "linear", "wander", "force of the wind per mass"),
        ),
        substitution={
            **plain.substitution,
            "pi7": pi1 - place,
            "pi8": bank * L / U**2,
            "pi9": push * L / U**2,
        },
        live=plain.live,
    )


LINEAR_WITH_ACCELEROMETER = replace(
    BICYCLE,
    name="bicycle_with_accelerometer",
    parameters=(*BICYCLE.parameters, Quantity("ahead", "m", "accelerometer ahead of the centre of gravity")),
    outputs=(*BICYCLE.outputs, Quantity("ay", "m/s^2", "lateral acceleration")),
    output_map={
        **BICYCLE.output_map,
        "ay": (bicycle.Ff + bicycle.Fr) / m + ahead * (a * bicycle.Ff - b * bicycle.Fr) / Iz,
    },
)


def small_accelerometer_reduction() -> Reduction:
    """The same for small parts: linear tyres, and the bias of ay stands for what bank and wind do to it."""
    plain = bicycle_reduction()
    return Reduction(
        groups=reparameterize(LINEAR_WITH_ACCELEROMETER, base=("m", "L", "U")),
        unknowns=(
            *plain.unknowns,
            Unknown("lead", "-", "linear", "consider", "accelerometer ahead of the centre of gravity over L"),
        ),
        substitution={**plain.substitution, "pi6": lead},
        live=plain.live,
    )
