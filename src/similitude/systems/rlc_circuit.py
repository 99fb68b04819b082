"""Resistor, coil and capacitor in series at a voltage source.

    i  current [A]               vc  voltage of the capacitor [V]       u  source voltage [V]
    R  resistance [ohm]          L  inductance [H]                      C  capacitance [F]
    V  a voltage to measure by [V]; R, L and C alone make ratios of volts to amperes, and times

Base L, C, V: time is then counted in sqrt(L C), and the one group is R sqrt(C/L).
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

i, vc, u = sp.symbols("i vc u", real=True)
R, L, C = sp.symbols("R L C", real=True)

RLC_CIRCUIT = Model(
    name="rlc_circuit",
    states=(Quantity("i", "A", "current"), Quantity("vc", "V", "voltage of the capacitor")),
    inputs=(Quantity("u", "V", "source voltage"),),
    outputs=(Quantity("vc", "V", "voltage of the capacitor"),),
    parameters=(
        Quantity("L", "H", "inductance"),
        Quantity("C", "F", "capacitance"),
        Quantity("V", "V", "a voltage to measure by"),
        Quantity("R", "ohm", "resistance"),
    ),
    rates={"i": (u - R * i - vc) / L, "vc": i / C},
    output_map={"vc": vc},
    source="Nilsson & Riedel, Electric Circuits, chapter 8",
)

SYSTEM = System(
    RLC_CIRCUIT,
    base=("L", "C", "V"),
    values={"L": "100 mH", "C": "0.4 uF", "V": "48 V", "R": "280 ohm"},
    source="Nilsson & Riedel, Electric Circuits, chapter 8, the series step response",
    inputs={"u": "48 V"},
    duration="3 ms",
    meanings={"R": "twice the damping ratio, R sqrt(C/L)"},
)
