"""A quarter car: body and wheel above one another on spring, damper and tyre.

    zs, vs  height [m] and speed [m/s] of the body       zu, vu  of the wheel, from rest
    zr  height of the road [m]                           az  acceleration of the body [m/s^2]
    ms  mass on the spring [kg]                          mu  mass of the wheel [kg]
    ks  stiffness of the spring [N/m]                    cs  damper [N s/m]
    kt  stiffness of the tyre [N/m]

    span  a length to measure the motion by [m]; it only scales, since the equations are linear

The tyre does not lift and has no damping. Base ms, ks, span: time is then counted in sqrt(ms/ks).
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

zs, vs, zu, vu, zr = sp.symbols("zs vs zu vu zr", real=True)
ms, mu, ks, cs, kt = sp.symbols("ms mu ks cs kt", real=True)

strut = ks * (zu - zs) + cs * (vu - vs)  # upward force on the body [N]

QUARTER_CAR = Model(
    name="quarter_car",
    states=(
        Quantity("zs", "m", "height of the body"),
        Quantity("vs", "m/s", "speed of the body"),
        Quantity("zu", "m", "height of the wheel"),
        Quantity("vu", "m/s", "speed of the wheel"),
    ),
    inputs=(Quantity("zr", "m", "height of the road"),),
    outputs=(Quantity("az", "m/s^2", "acceleration of the body"),),
    parameters=(
        Quantity("ms", "kg", "mass on the spring"),
        Quantity("ks", "N/m", "stiffness of the spring"),
        Quantity("span", "m", "a length to measure the motion by"),
        Quantity("mu", "kg", "mass of the wheel"),
        Quantity("cs", "N s/m", "damper"),
        Quantity("kt", "N/m", "stiffness of the tyre"),
    ),
    rates={"zs": vs, "vs": strut / ms, "zu": vu, "vu": (kt * (zr - zu) - strut) / mu},
    output_map={"az": strut / ms},
    source="Rajamani, Vehicle Dynamics and Control, 2nd ed., chapter 10",
)

SYSTEM = System(
    QUARTER_CAR,
    base=("ms", "ks", "span"),
    values={
        "ms": "290 kg",
        "ks": "16812 N/m",
        "span": "0.05 m",  # the step of the run
        "mu": "59 kg",
        "cs": "1000 N s/m",
        "kt": "190000 N/m",
    },
    source="Lin & Kanellakopoulos 1997, IEEE Control Systems Magazine 17(3), 45-59",
    inputs={"zr": "0.05 m"},
    duration="2 s",
    meanings={
        "mu": "wheel over body",
        "cs": "twice the damping ratio of the body",
        "kt": "tyre over spring",
    },
    table={
        "bus, Control Tutorials for MATLAB and Simulink, its tyre damping left out": {
            "ms": "2500 kg",
            "ks": "80000 N/m",
            "mu": "320 kg",
            "cs": "350 N s/m",
            "kt": "500000 N/m",
        }
    },
)
