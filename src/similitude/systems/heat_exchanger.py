"""A store heated through a counterflow heat exchanger (effectiveness and number of transfer units).

    T  temperature of the well mixed store [K]      Th  of the hot stream at its inlet [K]
    UA  conductance of the exchanger [W/K]          Ch, Cc  flow of heat capacity, hot, cold side [W/K]
    M  heat capacity of the store [J/K]             dT  a temperature difference to measure by [K]

    q = E (Th - T),   E = Ch Cc (1 - x)/(Ch - Cc x),   x = exp(-UA (1/Cc - 1/Ch))    [W/K]

which is effectiveness times the smaller flow whichever side that is; Ch and Cc differ. Temperatures are
differences from a common zero. Base Cc, M, dT: the groups are UA/Cc, the number of transfer units
of the cold side, and Ch/Cc; time is counted in M/Cc.
"""

from __future__ import annotations

import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.system import System

T, Th = sp.symbols("T Th", real=True)
UA, Ch, Cc, M = sp.symbols("UA Ch Cc M", real=True)

x = sp.exp(-UA * (1 / Cc - 1 / Ch))
q = Ch * Cc * (1 - x) / (Ch - Cc * x) * (Th - T)  # heat flow [W]

HEAT_EXCHANGER = Model(
    name="heat_exchanger",
    states=(Quantity("T", "K", "temperature of the store"),),
    inputs=(Quantity("Th", "K", "temperature of the hot stream"),),
    outputs=(Quantity("q", "W", "heat flow"),),
    parameters=(
        Quantity("Cc", "W/K", "flow of heat capacity, cold side"),
        Quantity("M", "J/K", "heat capacity of the store"),
        Quantity("dT", "K", "a temperature difference to measure by"),
        Quantity("UA", "W/K", "conductance of the exchanger"),
        Quantity("Ch", "W/K", "flow of heat capacity, hot side"),
    ),
    rates={"T": q / M},
    output_map={"q": q},
    source="Incropera & DeWitt, Fundamentals of Heat and Mass Transfer, chapter 11",
)

SYSTEM = System(
    HEAT_EXCHANGER,
    base=("Cc", "M", "dT"),
    values={
        "Cc": "835.6 W/K",  # water, 0.2 kg/s of 4178 J/(kg K)
        "M": "1.25 MJ/K",  # a store of about 300 L of water
        "dT": "70 K",
        "UA": "197.2 W/K",  # 38.1 W/(m^2 K) on a tube of 25 mm and 65.9 m
        "Ch": "213.1 W/K",  # oil, 0.1 kg/s of 2131 J/(kg K)
    },
    source="Incropera & DeWitt, Fundamentals of Heat and Mass Transfer, example 11.1 (oil cooled by water,"
    " 100 and 30 degC at the inlets, 8524 W); the store is of the run",
    inputs={"Th": "70 K"},
    duration="2 h",
    meanings={"UA": "number of transfer units of the cold side", "Ch": "hot over cold flow of heat capacity"},
)
