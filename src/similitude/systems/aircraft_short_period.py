"""The short period of an aircraft: angle of attack and pitch rate from the elevator.

    alpha  angle of attack from trim [rad]      q  pitch rate [rad/s]      de  elevator [rad]
    rho  density of the air [kg/m^3]            V  airspeed [m/s]
    S  wing area [m^2]                          c  mean chord [m]
    m  mass [kg]                                Iy  pitch inertia [kg m^2]
    CLa, CLde  lift by angle of attack, elevator [1/rad]
    Cma, Cmq, Cmad, Cmde  pitching moment by alpha, q c/2V, alpha' c/2V, elevator [1/rad]

Airspeed is held and alpha is small. Base rho, V, c: time is then counted in c/V, mass in rho c^3.
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

alpha, q, de = sp.symbols("alpha q de", real=True)
rho, V, S, c, m, Iy = sp.symbols("rho V S c m Iy", real=True)
CLa, CLde, Cma, Cmq, Cmad, Cmde = sp.symbols("CLa CLde Cma Cmq Cmad Cmde", real=True)

pressure = rho * V**2 / 2  # Pa
turned = q - pressure * S / (m * V) * (CLa * alpha + CLde * de)  # rate of alpha [rad/s]
moment = Cma * alpha + Cmde * de + c / (2 * V) * (Cmq * q + Cmad * turned)  # coefficient [-]

AIRCRAFT_SHORT_PERIOD = Model(
    name="aircraft_short_period",
    states=(Quantity("alpha", "rad", "angle of attack"), Quantity("q", "rad/s", "pitch rate")),
    inputs=(Quantity("de", "rad", "elevator angle"),),
    outputs=(Quantity("q", "rad/s", "pitch rate"),),
    parameters=(
        Quantity("rho", "kg/m^3", "density of the air"),
        Quantity("V", "m/s", "airspeed"),
        Quantity("c", "m", "mean chord"),
        Quantity("S", "m^2", "wing area"),
        Quantity("m", "kg", "mass"),
        Quantity("Iy", "kg m^2", "pitch inertia"),
        Quantity("CLa", "1/rad", "lift by angle of attack"),
        Quantity("CLde", "1/rad", "lift by elevator"),
        Quantity("Cma", "1/rad", "moment by angle of attack"),
        Quantity("Cmq", "1/rad", "moment by pitch rate"),
        Quantity("Cmad", "1/rad", "moment by the rate of the angle of attack"),
        Quantity("Cmde", "1/rad", "moment by elevator"),
    ),
    rates={"alpha": turned, "q": pressure * S * c / Iy * moment},
    output_map={"q": q},
    signals=("V",),
    source="Nelson, Flight Stability and Automatic Control, 2nd ed., section 4.5",
)

SYSTEM = System(
    AIRCRAFT_SHORT_PERIOD,
    base=("rho", "V", "c"),
    values={
        "rho": "1.225 kg/m^3",  # sea level
        "V": "176 ft/s",
        "c": "5.7 ft",
        "S": "184 ft^2",
        "m": "2750 lb",
        "Iy": "3000 slug ft^2",
        "CLa": "4.44 1/rad",
        "CLde": "0.355 1/rad",
        "Cma": "-0.683 1/rad",
        "Cmq": "-9.96 1/rad",
        "Cmad": "-4.36 1/rad",
        "Cmde": "-0.923 1/rad",
    },
    source="Nelson, Flight Stability and Automatic Control, 2nd ed., appendix B: NAVION",
    inputs={"de": "-1 deg"},
    duration="4 s",
    meanings={
        "S": "wing area over chord squared",
        "m": "mass of the aircraft over that of a chord's cube of air",
        "Iy": "pitch inertia over that of a chord's cube of air",
        "CLa": "lift slope",
        "CLde": "lift of the elevator",
        "Cma": "static stability",
        "Cmq": "pitch damping",
        "Cmad": "damping by the lag of the downwash",
        "Cmde": "power of the elevator",
    },
)
