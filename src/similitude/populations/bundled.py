"""The bundled tables as populations: which row belongs to which, what counts less, and why.

Invariant: every row of the tables is in exactly one population or named in `LEFT_OUT` with a reason.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np

from similitude.model import Model
from similitude.populations.table import PopulationTable, joined, read_population_table

COLUMNS = {"Iz": "Izz", "a*b": "ab", "a/L": "center_to_front_ratio"}
SOURCES = {
    "lvipd_204.csv": "NHTSA Light Vehicle Inertial Parameter Database (204 vehicles, 1971 to 1998)",
    "opendbc_specs.csv": "opendbc 7343a66 (199 production cars, MIT)",
    "vehicles_literature.csv": "13 vehicles of the literature, one source each",
}
CAR_BODIES = {"2S", "4S", "3H", "5H", "2C", "SW"}  # sedans, hatchbacks, coupes, wagons
# Pickups, vans, and sport utilities on a truck's scale among the platforms of opendbc.
TRUCKS = re.compile(
    r"RAM_|F_150|EXPEDITION|EXPLORER|RANGER|MAVERICK|BRONCO|SILVERADO|ESCALADE|YUKON|TRAVERSE|ACADIA|PACIFICA|"
    r"GRAND_CHEROKEE|ODYSSEY|RIDGELINE|PILOT|PASSPORT|STARIA|CARNIVAL|SANTA_CRUZ|CUSTIN|RIVIAN_R1|ALPHARD|"
    r"HIGHLANDER|SIENNA|CRAFTER|CADDY|TRANSPORTER|ATLAS|SHARAN|ASCENT|PALISADE"
)
VANS = {"VW Vanagon"}
SMALL = {"F1/10 car", "Brennan-Alleyne test vehicle"}
RACE = {"Dallara AV-21", "Ferrari 250 LM"}
SMALL_LENGTH = 0.32  # m, wheelbase of the F1/10 car, stated in its source column
# Relative sd of the literature's yaw inertias. Few were measured; two of the bundled logs contradict theirs
# by 20 to 30 %. Those of simulation scripts and of an optimisation are worth less.
INERTIA_SD = 0.10
DOUBTED = {"BMW M8": 0.3, "Stanford P1": 0.3, "BMW 5 series": 0.3}
LEFT_OUT = {name: "a race car" for name in RACE}


def bundled_tables(data: Path, model: Model) -> dict[str, PopulationTable]:
    """Read the bundled tables and sort their rows.

    Parameters
    ----------
    data : Path      folder of `lvipd_204.csv`, `opendbc_specs.csv`, `vehicles_literature.csv`.
    model : Model    the bicycle.

    Returns
    -------
    dict             "passenger_cars", "light_trucks" and "small_cars_1to10".
    """
    inertia, specs, literature = (
        read_population_table(data / name, model, columns=COLUMNS)
        for name in ("lvipd_204.csv", "opendbc_specs.csv", "vehicles_literature.csv")
    )
    specs = replace(specs, weight=copy_weights(specs))
    literature = replace(_doubted(literature), sources=("vehicles_literature.csv",) * len(literature))
    literature = _with_small_length(literature)
    is_car = np.array([label.split()[-1] in CAR_BODIES for label in inertia.labels])
    is_truck = np.array([TRUCKS.search(label) is not None for label in specs.labels])
    named = np.array(literature.labels)
    van, small, race = (np.isin(named, list(group)) for group in (VANS, SMALL, RACE))
    full_size = ~van & ~small & ~race
    return {
        "passenger_cars": joined(
            [inertia.rows(is_car), specs.rows(~is_truck), literature.rows(full_size)], name="passenger_cars"
        ),
        "light_trucks": joined(
            [inertia.rows(~is_car), specs.rows(is_truck), literature.rows(van)], name="light_trucks"
        ),
        "small_cars_1to10": replace(literature.rows(small), name="small_cars_1to10"),
    }


def copy_weights(specs: PopulationTable) -> np.ndarray:
    """Weights (n,): rows of one brand that share a/L, or mass and wheelbase, are one car written often."""
    ratio = specs.value[:, specs.names.index("a/L")]
    m, L = (specs.value[:, specs.names.index(n)] for n in ("m", "L"))
    brand = [label.split()[0] for label in specs.labels]
    keys = [
        (b, "a/L", round(x, 4)) if np.isfinite(x) else (b, round(mass, 1), round(length, 3))
        for b, x, mass, length in zip(brand, ratio, m, L, strict=True)
    ]
    count = Counter(keys)
    return np.array([1.0 / count[key] for key in keys])


def _doubted(literature: PopulationTable) -> PopulationTable:
    sd = literature.sd.copy()
    column = literature.names.index("Iz")
    for row, label in enumerate(literature.labels):
        sd[row, column] = DOUBTED.get(label, INERTIA_SD) * literature.value[row, column]
    return replace(literature, sd=sd)


def _with_small_length(literature: PopulationTable) -> PopulationTable:
    """The wheelbase of the F1/10 car, which its source states and no column holds."""
    length = np.full(len(literature), np.nan)
    length[literature.labels.index("F1/10 car")] = SMALL_LENGTH
    return replace(
        literature,
        products=(*literature.products, {"L": 1}),
        value=np.column_stack([literature.value, length]),
        sd=np.column_stack([literature.sd, np.full(len(literature), np.nan)]),
    )
