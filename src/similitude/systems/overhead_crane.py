"""An overhead crane: a load that swings on a rope below a trolley which a force drives.

    x  position of the trolley [m]        v  its speed [m/s]
    th  angle of the rope, from down [rad]        w  its rate [rad/s]
    F  driving force [N]                  M  mass of the trolley [kg]
    m  mass of the load [kg]              L  length of the rope [m]
    g  gravity [m/s^2]                    b  friction of the trolley [N s/m]

The load hangs at x + L sin(th); the rope is light and stays tight.
Base M, L, g: time is then counted in sqrt(L/g).
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

x, v, th, w, F = sp.symbols("x v th w F", real=True)
M, m, L, g, b = sp.symbols("M m L g b", real=True)

moved = (F - b * v + m * sp.sin(th) * (L * w**2 + g * sp.cos(th))) / (M + m * sp.sin(th) ** 2)  # m/s^2

OVERHEAD_CRANE = Model(
    name="overhead_crane",
    states=(
        Quantity("x", "m", "position of the trolley"),
        Quantity("v", "m/s", "speed of the trolley"),
        Quantity("th", "rad", "angle of the rope"),
        Quantity("w", "rad/s", "rate of the rope's angle"),
    ),
    inputs=(Quantity("F", "N", "driving force"),),
    outputs=(Quantity("load", "m", "position of the load"),),
    parameters=(
        Quantity("M", "kg", "mass of the trolley"),
        Quantity("L", "m", "length of the rope"),
        Quantity("g", "m/s^2", "gravity"),
        Quantity("m", "kg", "mass of the load"),
        Quantity("b", "N s/m", "friction of the trolley"),
    ),
    rates={"x": v, "v": moved, "th": w, "w": -(moved * sp.cos(th) + g * sp.sin(th)) / L},
    output_map={"load": x + L * sp.sin(th)},
    source="Franklin, Powell & Emami-Naeini, Feedback Control of Dynamic Systems, 'hanging crane'",
)

SYSTEM = System(
    OVERHEAD_CRANE,
    base=("M", "L", "g"),
    values={"M": "0.5 kg", "L": "0.3 m", "g": "9.8 m/s^2", "m": "0.2 kg", "b": "0.1 N s/m"},
    source="Control Tutorials for MATLAB and Simulink (University of Michigan), Inverted Pendulum:"
    " its cart and pendulum, hung downwards, the rod's own inertia left out",
    inputs={"F": "0.5 N"},
    start={"th": "10 deg"},
    duration="4 s",
    meanings={"m": "load over trolley", "b": "friction within one swing"},
)
