"""Michaelis-Menten kinetics: an enzyme binds a substrate and lets a product go.

    s  substrate [mol/m^3]                     c  enzyme that holds substrate [mol/m^3]
    p  product [mol/m^3]                       feed  substrate that flows in [mol/(m^3 s)]
    e0  all enzyme, free and bound [mol/m^3]
    kon  binding [m^3/(mol s)]                 koff, kcat  release without, with product [1/s]

Base e0, kcat: time is then counted in turnovers of the enzyme.
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

s, c, p, feed = sp.symbols("s c p feed", real=True)
e0, kon, koff, kcat = sp.symbols("e0 kon koff kcat", real=True)

bound = kon * (e0 - c) * s  # mol/(m^3 s)

MICHAELIS_MENTEN = Model(
    name="michaelis_menten",
    states=(
        Quantity("s", "mol/m^3", "substrate"),
        Quantity("c", "mol/m^3", "enzyme that holds substrate"),
        Quantity("p", "mol/m^3", "product"),
    ),
    inputs=(Quantity("feed", "mol/(m^3 s)", "substrate that flows in"),),
    outputs=(Quantity("p", "mol/m^3", "product"),),
    parameters=(
        Quantity("e0", "mol/m^3", "all enzyme"),
        Quantity("kcat", "1/s", "release with product"),
        Quantity("kon", "m^3/(mol s)", "binding"),
        Quantity("koff", "1/s", "release without product"),
    ),
    rates={"s": feed - bound + koff * c, "c": bound - (koff + kcat) * c, "p": kcat * c},
    output_map={"p": p},
    source="Briggs & Haldane 1925, Biochemical Journal 19, 338",
)

SYSTEM = System(
    MICHAELIS_MENTEN,
    base=("e0", "kcat"),
    values={
        "e0": "5 umol/L",
        "kcat": "2000 1/s",
        "kon": "1e8 L/(mol s)",
        "koff": "3000 1/s",
    },
    source="penicillinase: kcat and Km = 50 umol/L from the tables of Berg, Tymoczko & Stryer,"
    " Biochemistry, chapter 8; kon is put at the limit of diffusion, which makes koff = kon Km - kcat;"
    " e0 and the start are of the run",
    inputs={"feed": "1 mmol/(L s)"},
    start={"s": "100 umol/L"},
    duration="30 ms",
    meanings={"kon": "binding within one turnover", "koff": "lost over successful bindings"},
)
