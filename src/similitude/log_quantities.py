"""The quantities of a driving log: their words, units and the names they go by.

Invariant: no name belongs to two quantities; "steering angle", which does in practice, belongs to
none and must be mapped.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from similitude.dimension import ACCELERATION, FREQUENCY, SPEED, TIME, Dimension


@dataclass(frozen=True)
class Quantity:
    """A quantity a log may hold: its words, unit and the names it goes by."""

    words: str
    si: str
    dimension: Dimension
    is_angle: bool  # per radian: rad or rad/s
    aliases: frozenset[str]
    examples: str


def _aliases(text: str) -> frozenset[str]:
    return frozenset(text.split())


QUANTITIES = {
    "t": Quantity("time", "s", TIME, False, _aliases(
        "t time timestamp time_stamp elapsed_time t_rel times"), "s, ms"),
    "delta": Quantity("road wheel angle", "rad", Dimension.none, True, _aliases(
        "delta steer road_wheel_angle roadwheel_angle road_wheel front_wheel_angle "
        "wheel_angle delta_f delta_front rwa tire_angle tyre_angle"), "rad, deg, mrad"),
    "steering_wheel": Quantity("steering wheel angle", "deg", Dimension.none, True, _aliases(
        "steering_wheel steering_wheel_angle swa steeringwheel steeringwheelangle "
        "handwheel handwheel_angle hand_wheel_angle delta_sw delta_h sw_angle"), "deg, rad"),
    "r": Quantity("yaw rate", "rad/s", FREQUENCY, True, _aliases(
        "r yaw_rate yawrate yaw_velocity yawvel gyro_z gyroz wz w_z omega_z psi_dot psidot "
        "angular_velocity_z angular_rate_z"), "rad/s, deg/s"),
    "U": Quantity("speed", "m/s", SPEED, False, _aliases(
        "u vx v_x speed velocity vel vehicle_speed vehicle_velocity longitudinal_velocity "
        "longitudinal_speed long_vel ground_speed v_ego vego"), "m/s, km/h, mph"),
    "ay": Quantity("lateral acceleration", "m/s^2", ACCELERATION, False, _aliases(
        "ay a_y lateral_acceleration lateral_accel lat_acc latacc lat_accel acc_y accel_y "
        "acceleration_y accy"), "m/s^2, g"),
}  # fmt: skip

# At the steering wheel or at the road wheels? Both are in use, and they differ by a factor of 15.
AMBIGUOUS = _aliases("steering_angle steer_angle steering steeringangle steerangle str_angle")

STEER = {"delta", "steering_wheel"}


def split_header(header: str) -> tuple[str, str | None]:
    """Split ``"r [deg/s]"`` into name and unit; the unit is None where there are no brackets."""
    name, bracket, unit = header.strip().rpartition("[")
    if not bracket or not unit.endswith("]") or "]" in unit[:-1]:
        return header.strip(), None
    return name.strip(), unit[:-1].strip()


def normal_name(name: str) -> str:
    """Return a name as aliases are compared: "Yaw Rate", "yawRate" and "yaw-rate" are one."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name.strip())
    return re.sub(r"[\s\-.]+", "_", spaced).casefold()
