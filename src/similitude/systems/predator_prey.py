"""Predator and prey after Lotka and Volterra, both hunted alike.

    x  prey [-]                     y  predators [-]; numbers of animals, or of anything that is counted
    h  hunting effort [1/s]
    a  growth of the prey alone [1/s]          d  death of predators without prey [1/s]
    b  prey lost to each predator [1/s]        e  predators gained from each prey [1/s]

Counts have no unit, so units remove time alone: base a, groups b/a, d/a, e/a. That b and e can be put
to one by counting in other numbers is a symmetry of the equations, not of the units.
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

x, y, h = sp.symbols("x y h", real=True)
a, b, d, e = sp.symbols("a b d e", real=True)

PREDATOR_PREY = Model(
    name="predator_prey",
    states=(Quantity("x", "1", "prey"), Quantity("y", "1", "predators")),
    inputs=(Quantity("h", "1/s", "hunting effort"),),
    outputs=(Quantity("x", "1", "prey"), Quantity("y", "1", "predators")),
    parameters=(
        Quantity("a", "1/s", "growth of the prey alone"),
        Quantity("b", "1/s", "prey lost to each predator"),
        Quantity("d", "1/s", "death of predators without prey"),
        Quantity("e", "1/s", "predators gained from each prey"),
    ),
    rates={"x": (a - h) * x - b * x * y, "y": e * x * y - (d + h) * y},
    output_map={"x": x, "y": y},
    source="Volterra 1926, Nature 118, 558",
)

SYSTEM = System(
    PREDATOR_PREY,
    base=("a",),
    values={"a": "0.55 1/year", "b": "0.028 1/year", "d": "0.80 1/year", "e": "0.024 1/year"},
    source="hares and lynxes, thousands of pelts: Carpenter 2018, Predator-Prey Population Dynamics,"
    " case study of the Stan project, posterior means",
    inputs={"h": "0.05 1/year"},
    start={"x": "34", "y": "5.9"},
    duration="20 year",
    meanings={
        "b": "prey lost to each predator while the prey would grow e-fold",
        "d": "death of the predators against growth of the prey",
        "e": "predators gained from each prey in the same time",
    },
)
