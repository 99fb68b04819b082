"""A shipped scenario with everything random and everything between driver and wheels taken out."""

from similitude.simulation.scenario import read_scenario

LINEAR = {"kind": "linear"}
SATURATING = {"kind": "saturating", "tyre": "cubic"}
TWO_TRACK = {
    "kind": "two_track", "tyre": "cubic", "height": "0.55 m", "track": "1.55 m", "front_roll_share": 0.55,
    "roll_time": "0.15 s",
}  # fmt: skip
CAR = {
    "L": "2.7 m",
    "a": "1.2 m",
    "m": "1500 kg",
    "Iz": "2600 kg m^2",
    "Caf": "82 kN/rad",
    "Car": "98 kN/rad",
}


def quiet(plant=LINEAR, **changes):
    """The slalom with a sure car, perfect sensors and no actuator; dots in keys are written __."""
    clean = {"plant": plant, "vehicle": CAR, "actuator": {}, "sensors": {}, "run.duration": "10 s"}
    return read_scenario("slalom", changes=clean | {k.replace("__", "."): v for k, v in changes.items()})
