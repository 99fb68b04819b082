"""Paper, section 3: explicit invariance of the yaw-rate step response, with and without time."""

import numpy as np
import pytest
from scipy.linalg import expm

from similitude.systems.bicycle import BICYCLE
from similitude.units import parse_unit

CAR = {"m": 5.451, "Iz": 0.1615, "U": 4.0, "a": 0.1461, "b": 0.2191, "Caf": 65.0, "Car": 110.0}
AT = {**CAR, "t": 0.15}  # s
STEP = 1e-3  # of a logarithm; the sixth-order difference below is then good to 1e-13


def yaw_rate(p) -> float:
    """Yaw rate at time t after a unit step of the steer angle, [rad/s] per rad."""
    front, rear, m, Iz, U, a, b = (p[n] for n in ("Caf", "Car", "m", "Iz", "U", "a", "b"))
    block = np.zeros((3, 3))
    block[0] = [-(front + rear) / (m * U), (b * rear - a * front) / (m * U) - U, front / m]
    yaw = -(a * a * front + b * b * rear) / (Iz * U)
    block[1] = [(b * rear - a * front) / (Iz * U), yaw, a * front / Iz]
    return expm(block * p["t"])[1, 2]


def sensitivity(name: str) -> float:
    """d ln(yaw rate)/d ln(argument), central differences of sixth order."""
    weights = {1: 45, 2: -9, 3: 1}
    total = 0.0
    for k, weight in weights.items():
        up, down = (yaw_rate({**AT, name: AT[name] * np.exp(s * k * STEP)}) for s in (1, -1))
        total += weight * (np.log(up) - np.log(down))
    return total / (60 * STEP)


S = {name: sensitivity(name) for name in AT}


def exponent(name: str, base: str) -> float:
    """The dimension matrix, from the units of the model; time has one of its own."""
    dimension = parse_unit("s").dimension if name == "t" else BICYCLE.quantity(name).dimension
    return float(dimension.exponents.get(base, 0))


@pytest.mark.parametrize(("base", "expected"), [("mass", 0), ("length", 0), ("time", -1)])
def test_each_unit_gives_one_row(base, expected):
    """Yaw rate per radian has dimension 1/time; a, b are the lengths, L is their sum."""
    assert float(BICYCLE.quantity("r").dimension.exponents.get(base, 0)) == expected
    assert sum(exponent(n, base) * S[n] for n in AT) == pytest.approx(expected, abs=1e-9)


def test_the_time_row_by_its_letters():
    row = S["t"] - S["U"] - 2 * S["Caf"] - 2 * S["Car"]
    assert {n: exponent(n, "time") for n in ("t", "U", "Caf", "Car")} == {
        "t": 1,
        "U": -1,
        "Caf": -2,
        "Car": -2,
    }

    assert row == pytest.approx(-1, abs=1e-9)
    assert row - S["t"] == pytest.approx(-1.3063, abs=5e-5)  # erratum of eq 13


def test_three_of_the_seven_parameters_follow_from_the_other_four():
    given, wanted = ("U", "a", "b", "Car", "t"), ("m", "Iz", "Caf")
    bases, right = ("mass", "length", "time"), np.array([0.0, 0.0, -1.0])
    D = {n: np.array([exponent(n, base) for base in bases]) for n in AT}
    rest = right - sum(D[n] * S[n] for n in given)
    found = np.linalg.solve(np.stack([D[n] for n in wanted], axis=1), rest)

    assert found == pytest.approx([S[n] for n in wanted], abs=1e-9)
