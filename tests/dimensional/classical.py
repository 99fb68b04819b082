"""Classical cases with the answers of the textbooks: variables, base, groups, and who says so."""

from fractions import Fraction
from typing import NamedTuple

HALF = Fraction(1, 2)


class Case(NamedTuple):
    """``groups`` are those of the base, in the order of the remaining variables; ``known`` are famous
    products that have to lie in their span."""

    variables: dict[str, str]
    base: list[str]
    groups: list[dict]
    known: list[dict]


CASES = {
    "pipe flow": Case(
        {"dp": "Pa", "L": "m", "D": "m", "V": "m/s", "rho": "kg/m^3", "mu": "Pa s", "eps": "mm"},
        ["rho", "V", "D"],
        [
            {"dp": 1, "rho": -1, "V": -2},
            {"L": 1, "D": -1},
            {"mu": 1, "rho": -1, "V": -1, "D": -1},
            {"eps": 1, "D": -1},
        ],
        [{"rho": 1, "V": 1, "D": 1, "mu": -1}, {"dp": 1, "D": 1, "L": -1, "rho": -1, "V": -2}],
    ),
    "drag of a sphere": Case(
        {"F": "N", "D": "m", "V": "m/s", "rho": "kg/m^3", "mu": "Pa s"},
        ["D", "V", "rho"],
        [{"F": 1, "D": -2, "V": -2, "rho": -1}, {"mu": 1, "D": -1, "V": -1, "rho": -1}],
        [{"F": 1, "rho": 1, "mu": -2}],
    ),
    "pendulum": Case(
        {"T": "s", "l": "m", "g": "m/s^2", "angle": "rad"},
        ["l", "g"],
        [{"T": 1, "l": -HALF, "g": HALF}, {"angle": 1}],
        [{"T": 2, "l": -1, "g": 1}],
    ),
    "blast wave": Case(
        {"R": "m", "t": "s", "E": "J", "rho": "kg/m^3"},
        ["t", "E", "rho"],
        [{"R": 1, "t": Fraction(-2, 5), "E": Fraction(-1, 5), "rho": Fraction(1, 5)}],
        [{"R": 5, "t": -2, "E": -1, "rho": 1}],
    ),
    "heat transfer in a tube": Case(
        {
            "h": "W/(m^2 K)",
            "D": "m",
            "V": "m/s",
            "rho": "kg/m^3",
            "mu": "kg/(m s)",
            "cp": "J/(kg K)",
            "k": "W/(m K)",
        },
        ["D", "rho", "mu", "k"],
        [
            {"h": 1, "D": 1, "k": -1},
            {"V": 1, "D": 1, "rho": 1, "mu": -1},
            {"cp": 1, "mu": 1, "k": -1},
        ],
        [{"h": 1, "rho": -1, "V": -1, "cp": -1}],  # Stanton = Nu/(Re Pr)
    ),
    "heat exchanger": Case(
        {"q": "W", "UA": "W/K", "Ch": "W/K", "Cc": "W/K", "dT": "K"},
        ["Cc", "dT"],
        [{"q": 1, "Cc": -1, "dT": -1}, {"UA": 1, "Cc": -1}, {"Ch": 1, "Cc": -1}],
        [{"UA": 1, "Ch": -1}],
    ),
    "DC motor": Case(
        {"R": "ohm", "L": "H", "K": "N m/A", "J": "kg m^2", "b": "N m s/rad", "t": "s"},
        ["R", "K", "J"],
        [
            {"L": 1, "R": -2, "K": 2, "J": -1},
            {"b": 1, "R": 1, "K": -2},
            {"t": 1, "R": -1, "K": 2, "J": -1},
        ],
        [{"J": 1, "R": 2, "L": -1, "K": -2}],
    ),
    "resistance of a ship": Case(
        {"R": "N", "rho": "kg/m^3", "V": "kn", "L": "ft", "g": "m/s^2", "nu": "m^2/s"},
        ["rho", "V", "L"],
        [
            {"R": 1, "rho": -1, "V": -2, "L": -2},
            {"g": 1, "V": -2, "L": 1},
            {"nu": 1, "V": -1, "L": -1},
        ],
        [{"V": 2, "g": -1, "L": -1}],  # Froude squared
    ),
    "RC circuit": Case(
        {"v": "V", "V0": "V", "R": "ohm", "C": "F", "t": "s"},
        ["V0", "R", "C"],
        [{"v": 1, "V0": -1}, {"t": 1, "R": -1, "C": -1}],
        [],
    ),
    "RLC circuit": Case(
        {"R": "ohm", "L": "H", "C": "F"},
        ["L", "C"],
        [{"R": 1, "L": -HALF, "C": HALF}],
        [{"R": 2, "C": 1, "L": -1}],
    ),
    "deflection of a beam": Case(
        {"w": "m", "P": "N", "l": "m", "E": "Pa", "I": "m^4"},
        ["E", "l"],
        [{"w": 1, "l": -1}, {"P": 1, "E": -1, "l": -2}, {"I": 1, "l": -4}],
        [{"w": 1, "E": 1, "I": 1, "P": -1, "l": -3}],
    ),
    "natural convection": Case(
        {"beta": "1/K", "dT": "K", "g": "m/s^2", "L": "m", "nu": "m^2/s", "alpha": "m^2/s"},
        ["dT", "L", "nu"],
        [{"beta": 1, "dT": 1}, {"g": 1, "L": 3, "nu": -2}, {"alpha": 1, "nu": -1}],
        [{"g": 1, "beta": 1, "dT": 1, "L": 3, "nu": -1, "alpha": -1}],  # Rayleigh
    ),
    "capillary rise": Case(
        {"h": "m", "r": "m", "sigma": "N/m", "rho": "kg/m^3", "g": "m/s^2", "theta": "deg"},
        ["r", "rho", "g"],
        [{"h": 1, "r": -1}, {"sigma": 1, "r": -2, "rho": -1, "g": -1}, {"theta": 1}],
        [{"h": 1, "rho": 1, "g": 1, "r": 1, "sigma": -1}],
    ),
    "pump": Case(
        {"gH": "m^2/s^2", "Q": "m^3/s", "n": "1/s", "D": "m", "P": "W", "rho": "kg/m^3"},
        ["n", "D", "rho"],
        [
            {"gH": 1, "n": -2, "D": -2},
            {"Q": 1, "n": -1, "D": -3},
            {"P": 1, "n": -3, "D": -5, "rho": -1},
        ],
        [{"n": 4, "Q": 2, "gH": -3}],  # specific speed, to the fourth
    ),
    "orbit": Case(
        {"T": "day", "a": "km", "G": "m^3/(kg s^2)", "M": "kg"},
        ["a", "G", "M"],
        [{"T": 1, "a": Fraction(-3, 2), "G": HALF, "M": HALF}],
        [{"T": 2, "a": -3, "G": 1, "M": 1}],  # Kepler's third law
    ),
    "vibrating string": Case(
        {"f": "Hz", "l": "m", "tension": "N", "line": "kg/m"},
        ["l", "tension", "line"],
        [{"f": 1, "l": 1, "tension": -HALF, "line": HALF}],
        [],
    ),
    "bicycle": Case(
        {"m": "kg", "L": "m", "U": "m/s", "a": "m", "b": "m", "Caf": "N/rad", "Car": "N/rad", "Iz": "kg m^2"},
        ["m", "L", "U"],
        [
            {"a": 1, "L": -1},
            {"b": 1, "L": -1},
            {"Caf": 1, "m": -1, "L": 1, "U": -2},
            {"Car": 1, "m": -1, "L": 1, "U": -2},
            {"Iz": 1, "m": -1, "L": -2},
        ],
        [],
    ),
    "Planck": Case(
        {"lp": "m", "hbar": "J s", "G": "m^3/(kg s^2)", "c": "m/s"},
        ["hbar", "G", "c"],
        [{"lp": 1, "hbar": -HALF, "G": -HALF, "c": Fraction(3, 2)}],
        [],
    ),
    "fine structure": Case(
        {"e": "C", "eps0": "F/m", "hbar": "J s", "c": "m/s"},
        ["eps0", "hbar", "c"],
        [{"e": 1, "eps0": -HALF, "hbar": -HALF, "c": -HALF}],
        [{"e": 2, "eps0": -1, "hbar": -1, "c": -1}],
    ),
    "enzyme": Case(
        {"k1": "m^3/(mol s)", "km": "1/s", "k2": "1/s", "e0": "mol/m^3", "s0": "mol/m^3"},
        ["k2", "s0"],
        [{"k1": 1, "k2": -1, "s0": 1}, {"km": 1, "k2": -1}, {"e0": 1, "s0": -1}],
        [{"e0": 1, "k1": 1, "km": -1}],
    ),
}
