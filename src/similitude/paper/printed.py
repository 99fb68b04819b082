"""What the paper prints: the numbers that are checked, each with its place.

    m mass [kg]   Iz yaw inertia [kg m^2]   U speed [m/s]   a, b CG to axles [m]   L = a + b
    Caf, Car axle cornering stiffness [N/rad]   K = Caf L/m [m^2/s^2]   k = pi4/pi3

Invariant: nothing here was computed by this package; what was is in the files of the claims.
"""

from __future__ import annotations

TEST_VEHICLE = {  # eq 4
    "m": 5.451,
    "Iz": 0.1615,
    "U": 4.0,
    "a": 0.1461,
    "b": 0.2191,
    "Caf": 65.0,
    "Car": 110.0,
}
WHEELBASE = 0.3652  # m, eq 4
DESIGN_SPEED = 3.0  # m/s, section 6
PI1, K, SLOPE, PI5 = 0.4431, 145.68, 1.0977, 0.2510  # averages, eq 18
SAMPLE_TIME = 1e-3  # s, section 5
T = 0.011  # dimensionless sample time, section 5
RANGE = (0.1, 1.4)  # of pi3, Figure 4
GAIN = (0.1732, 2.2871, 0.3275, 1.0179, 0.0722)  # eq 32
WEIGHTS = (0.03, 5.0, 0.02, 0.1, 0.001)  # eq 31
FORGETTING = 0.99995  # section 6
DEAD_ZONE = 0.1  # rad/s, section 5
CORNER = 45.0  # rad/s, section 6
HALVED = 0.5  # stiffness on the wet half over dry, section 6
DRY_ESTIMATE, OFFLINE = 0.4, 0.5  # of pi3, section 7
FULL_SIZE_SPEED = 63.0  # mph, section 6
SCALE = 1 / 7  # of the test vehicle, section 6
LINEAR_UP_TO = 0.3  # g, section 2
OPERATIONS = 10.0  # a sample, section 7
KALMAN_OPERATIONS = (1e4, 1e6)  # a sample, section 1
FLEET = 700  # vehicles behind eq 18
FIRST_FLEET = 30  # vehicles of the average before

MPH = 0.44704  # m/s
GRAVITY = 9.80665  # m/s^2


def groups_of(vehicle: dict[str, float]) -> dict[str, float]:
    """Pi groups of a vehicle by the letters of eq 17 [-].

    Parameters
    ----------
    vehicle : m, Iz, U, a, b, Caf, Car in SI units.
    """
    L = vehicle["a"] + vehicle["b"]
    per = L / (vehicle["m"] * vehicle["U"] ** 2)
    return {
        "pi1": vehicle["a"] / L,
        "pi2": vehicle["b"] / L,
        "pi3": vehicle["Caf"] * per,
        "pi4": vehicle["Car"] * per,
        "pi5": vehicle["Iz"] / (vehicle["m"] * L * L),
    }


def of_groups(pi1: float, pi3: float, k: float, pi5: float) -> dict[str, float]:
    """A vehicle with these groups, in the units in which m, L and U are one."""
    return {
        "m": 1.0,
        "Iz": pi5,
        "U": 1.0,
        "a": pi1,
        "b": 1.0 - pi1,
        "Caf": pi3,
        "Car": k * pi3,
    }
