"""Claims of the paper's sections 2, 4 and 6 about the model's range, its groups and its scales.

Invariant: the groups come from the shipped model, never from a formula written here.
"""

from __future__ import annotations

import math

from similitude.paper import printed
from similitude.paper.bode import step_response
from similitude.paper.claim import Claim, claim, identity_claim, number_claim
from similitude.systems.bicycle import BICYCLE, bicycle_groups
from similitude.units import parse_unit

SPEEDS = (10.0, 40.0)  # m/s, from town to motorway
DRY, ICE = 0.8, 0.3  # peak friction
SMALL_ERROR = 0.10  # of a tyre force: what "a good approximation" is taken to mean


def group_claims() -> list[Claim]:
    """Range of the linear model, eq 17, the unit of time, similarity of the scale vehicle."""
    return [
        _linear_range(),
        _similar(),
        _five_groups(),
        _traverse_time(),
        _full_size_speed(),
        _offline(),
        _order_one(),
    ]


def test_vehicle_groups(U: float) -> dict[str, float]:
    """Groups of the paper's vehicle at a speed [m/s] from the shipped model [-]."""
    values = {**printed.TEST_VEHICLE, "U": U, "L": printed.WHEELBASE}
    return bicycle_groups().value(values)


def similar_speed() -> float:
    """Speed at which the average car has the pi3 of the test vehicle at 4 m/s [m/s]."""
    return math.sqrt(printed.K / test_vehicle_groups(printed.TEST_VEHICLE["U"])["pi3"])


def _excess_slip(friction: float) -> float:
    """Slip at 0.3 g over that of a linear tyre, minus one, of a tyre F = Cα/√(1 + (Cα/μF_z)²) [-]."""
    used = printed.LINEAR_UP_TO / friction
    return 1 / math.sqrt(1 - used * used) - 1 if used < 1 else math.inf


def _linear_range() -> Claim:
    dry, ice = _excess_slip(DRY), _excess_slip(ICE)
    return claim(
        "linear-range",
        "section 2",
        "the linear model is good while accelerations stay below 0.3 g",
        printed=printed.LINEAR_UP_TO,
        ours=ice if math.isfinite(ice) else "no such force",
        holds=ice <= SMALL_ERROR,
        under=dry <= SMALL_ERROR,
        tolerance=SMALL_ERROR,
        unit="g",
        condition=f"the road is dry (peak friction {DRY}: {100 * dry:.1f} % more slip at 0.3 g)",
        why=f"Judged by the slip of a tyre with cubic onset of saturation against the linear one. With peak "
        f"friction {ICE} the tyres cannot hold 0.3 g at all, and this paper is about such roads.",
    )


def _similar() -> Claim:
    small = {**printed.TEST_VEHICLE}
    g = printed.groups_of(small)
    scaled = printed.of_groups(g["pi1"], g["pi3"], g["pi4"] / g["pi3"], g["pi5"])
    t = 2.0  # dimensionless
    one = step_response(small, t * printed.WHEELBASE / small["U"])[0] * printed.WHEELBASE / small["U"]
    return identity_claim(
        "eq17-groups",
        "eqs 17 and 19",
        "five groups describe the yaw dynamics: a car of unit mass, length and speed with them answers alike",
        step_response(scaled, t)[0] / one - 1,
    )


def _five_groups() -> Claim:
    groups = bicycle_groups()
    free = len(groups.groups) - len(groups.constraints)
    return number_claim(
        "sec4-five-parameters",
        "section 4",
        "in dimensionless form the model consists of five parameters",
        printed=5,
        ours=free,
        tolerance=0,
        conditioned=len(groups.groups),
        condition="π1 and π2 count as two, though π2 = 1 − π1",
        why="Four are free; as many as the transfer function has coefficients.",
    )


def _traverse_time() -> Claim:
    of = {n: parse_unit(BICYCLE.quantity(n).unit).dimension.exponents for n in ("U", "L")}
    as_printed = float(of["U"].get("time", 0) - of["L"].get("time", 0))
    return number_claim(
        "sec4-traverse-time",
        "section 4",
        "the time to traverse the vehicle length is U/L",
        printed=1,
        ours=as_printed,
        tolerance=0,
        unit="power of time",
        why="U/L is a rate. The time is L/U, as the rest of the paper has it.",
    )


def _full_size_speed() -> Claim:
    ours = similar_speed() / printed.MPH
    same_time = printed.TEST_VEHICLE["U"] / printed.SCALE / printed.MPH
    return number_claim(
        "sec6-full-size-speed",
        "section 6",
        "the test vehicle at 4 m/s correlates well with an average car at 63 mph",
        printed=printed.FULL_SIZE_SPEED,
        ours=ours,
        tolerance=2.0,
        unit="mph",
        digits=3,
        why=f"Equal π3 with the paper's own average K is at {ours:.1f} mph. Only L/U is equal at "
        f"{same_time:.1f} mph (scale 1/7): there π3 of the average car is "
        f"{printed.K / (same_time * printed.MPH) ** 2:.3f}, of the test vehicle "
        f"{test_vehicle_groups(4.0)['pi3']:.3f}. Elsewhere the paper says 65 mph.",
    )


def _offline() -> Claim:
    at_4, at_3 = (test_vehicle_groups(U)["pi3"] for U in (4.0, printed.DESIGN_SPEED))
    return number_claim(
        "fig7-offline-value",
        "section 7, Figure 7",
        "the off-line value of π3 on the dry belt is about 0.5",
        printed=printed.OFFLINE,
        ours=at_4,
        tolerance=0.05,
        why=f"The printed parameters give {at_4:.3f} at the stated 4 m/s; they give {at_3:.3f} at 3 m/s, the "
        "design speed of the controller. Both lie within the ± 50 % that the paper allows the value.",
    )


def extremes() -> dict[str, tuple[float, float]]:
    """Least and greatest value of each group of the average car over `SPEEDS` [-]."""
    pi3 = [printed.K / U**2 for U in SPEEDS]
    return {
        "pi1": (printed.PI1,) * 2,
        "pi2": (1 - printed.PI1,) * 2,
        "pi3": (min(pi3), max(pi3)),
        "pi4": (printed.SLOPE * min(pi3), printed.SLOPE * max(pi3)),
        "pi5": (printed.PI5,) * 2,
    }


def _order_one() -> Claim:
    low, high = (
        f(x)
        for f, x in ((min, [v[0] for v in extremes().values()]), (max, [v[1] for v in extremes().values()]))
    )
    parking = printed.K / 1.0**2
    within = 0.05 < low and high < 20
    return claim(
        "sec4-order-one",
        "section 4",
        "groups are of order one, not 10⁶ or 10⁻⁶",
        printed="about 1",
        ours=[low, high],
        holds=bool(within and parking < 20),
        under=bool(within),
        tolerance="between 1/20 and 20",
        condition="the car is driven, not parked: 10 to 40 m/s here",
        why=f"π3 and π4 carry 1/U²: at 1 m/s π3 is {parking:.0f}, and at standstill there is none.",
    )
