"""The bicycle with saturating tyres, its lateral acceleration measured besides.

    ay = (Ff + Fr)/m + ahead r'         what an accelerometer feels

    ahead  accelerometer ahead of the centre of gravity [m]

All other letters are those of `similitude.systems.saturating_bicycle`. Side force is the tyres', so what yaw
rate alone cannot tell apart (K, eta, sideslip) shows; how well hangs on knowing its place. A leaning road,
which it does not feel, and the wind are no unknowns of the model: they move the bias and the disturbance.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from similitude.groups import Groups, reparameterize
from similitude.model import Model, Quantity
from similitude.reduction import Reduction, Unknown
from similitude.systems import bicycle
from similitude.systems.bicycle import BICYCLE, Iz, a, b, bicycle_reduction, m
from similitude.systems.saturating_bicycle import (
    SATURATING_BICYCLE,
    Ff,
    Fr,
    saturating_bicycle_reduction,
)

ahead, place, lead = sp.symbols("ahead place lead", real=True)
pi1 = sp.Symbol("pi1", real=True)


def _measured(model: Model, front: sp.Expr, rear: sp.Expr) -> Model:
    """A model of those side forces of its axles [N] with an accelerometer in it."""
    place = Quantity("ahead", "m", "accelerometer ahead of the centre of gravity")
    return replace(
        model,
        name="bicycle_with_accelerometer",
        parameters=(*model.parameters, place),
        outputs=(*model.outputs, Quantity("ay", "m/s^2", "lateral acceleration")),
        output_map={**model.output_map, "ay": (front + rear) / m + ahead * (a * front - b * rear) / Iz},
    )


BICYCLE_WITH_ACCELEROMETER = _measured(SATURATING_BICYCLE, Ff, Fr)
LINEAR_WITH_ACCELEROMETER = _measured(BICYCLE, bicycle.Ff, bicycle.Fr)


def bicycle_with_accelerometer_groups() -> Groups:
    """The groups of the saturating bicycle and that of the accelerometer's place."""
    return reparameterize(BICYCLE_WITH_ACCELEROMETER, base=("m", "L", "U"))


def bicycle_with_accelerometer_reduction() -> Reduction:
    """The unknowns of the saturating bicycle, and the accelerometer's place."""
    plain = saturating_bicycle_reduction()
    return Reduction(
        groups=bicycle_with_accelerometer_groups(),
        unknowns=(
            *plain.unknowns,
            Unknown("place", "-", "linear", "estimate", "accelerometer behind the front axle over L"),
        ),
        substitution={**plain.substitution, "pi7": pi1 - place},
        live=plain.live,
    )


def small_accelerometer_reduction() -> Reduction:
    """The same for small parts: linear tyres, and the place as one ahead of the centre of gravity."""
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
