"""A permanent-magnet DC motor with its load: current and speed from voltage and load torque.

    i  armature current [A]                  w  speed of the shaft [rad/s]
    u  terminal voltage [V]                  M  load torque [N m]
    R  armature resistance [ohm]             L  armature inductance [H]
    K  torque constant [N m/A], which is the voltage constant [V s/rad] too
    J  inertia of rotor and load [kg m^2]    b  viscous friction [N m s/rad]

Base R, K, J: time is then counted in J R/K^2, the mechanical time constant.
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

i, w, u, M = sp.symbols("i w u M", real=True)
R, L, K, J, b = sp.symbols("R L K J b", real=True)

DC_MOTOR = Model(
    name="dc_motor",
    states=(Quantity("i", "A", "armature current"), Quantity("w", "rad/s", "speed")),
    inputs=(Quantity("u", "V", "terminal voltage"), Quantity("M", "N m", "load torque")),
    outputs=(Quantity("w", "rad/s", "speed"),),
    parameters=(
        Quantity("R", "ohm", "armature resistance"),
        Quantity("K", "N m/A", "torque and voltage constant"),
        Quantity("J", "kg m^2", "inertia"),
        Quantity("L", "H", "armature inductance"),
        Quantity("b", "N m s/rad", "viscous friction"),
    ),
    rates={"i": (u - R * i - K * w) / L, "w": (K * i - b * w - M) / J},
    output_map={"w": w},
    source="Franklin, Powell & Emami-Naeini, Feedback Control of Dynamic Systems, 'DC motor'",
)

SYSTEM = System(
    DC_MOTOR,
    base=("R", "K", "J"),
    values={
        "R": "1 ohm",
        "K": "0.01 N m/A",
        "J": "0.01 kg m^2",
        "L": "0.5 H",
        "b": "0.1 N m s/rad",
    },
    source="Control Tutorials for MATLAB and Simulink (University of Michigan), DC Motor Speed",
    inputs={"u": "1 V"},
    duration="3 s",
    meanings={
        "L": "electrical over mechanical time constant",
        "b": "friction against the brake of the motor's own voltage",
    },
    table={
        "DC Motor Position, same source": {
            "R": "4 ohm",
            "K": "0.0274 N m/A",
            "J": "3.2284e-6 kg m^2",
            "L": "2.75e-6 H",
            "b": "3.5077e-6 N m s/rad",
        }
    },
)
