"""Does the yaw rate answer the steer as a car's does, and the lateral acceleration the yaw rate?

Invariant: no value is changed. A relation counts only where two signals are alike beyond chance,
and its slope is known between the two regressions (of either signal on the other), which hold the
true one whichever of the two carries the noise.

    delta road wheel angle [rad];  r yaw rate [rad/s];  U speed [m/s];  L wheelbase [m]
    gain r / (U delta / L) [-], 1 for a car on rails;  Froude number U^2/(g L) [-]
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding
from similitude.log_columns import Column, column_of, split_header

GRAVITY = 9.80665  # m/s^2
BIN = 0.05  # s; yaw motion is slower than 10 Hz, and a mean of a bin has less noise
MOST_BINS = 2_000_000
EARLIEST, LATEST = -2, 8  # bins by which r may come after the steer: -0.1 s to 0.4 s
SLOWEST = 0.6  # sqrt(g L); below, a car answers like one on rails and turns by parking
LARGE_STEER = 0.03  # rad; an offset of the steer no longer matters, and the mean may count
ALIKE = 0.5  # correlation from which the two regressions are within a factor of four
BEYOND_CHANCE = 5.0  # sd of Fisher's z of unrelated signals with the same spectra
SMOOTH = 0.5  # correlation of the steer with itself a bin later; below, it is mostly noise
MIRRORED = 0.97  # correlation at which even a sine, whose phase may be chance, is worth a word
MOSTLY_BACKWARD = 0.9  # of the moving rows; a drive in reverse gear is short
SIGN_MARGIN = 0.25  # by which one sign must be more alike than the other; both fit a fast sine

# The gain of a car that understeers is 1/(1 + F/F0) at Froude number F. Over the populations F0 lies
# above 5, and a steer that is a command may reach the wheels at 0.67, or be logged at that. Oversteer
# raises the gain, on the road never above 3.
LEAST_FROUDE = 5.0
LEAST_SHARE = 0.67
LARGEST_GAIN = 1.5
TYPICAL_FROUDE = 25.0
UNEXPLAINED = 2.5  # a single fault explains the gain within this factor, or none does
NEAR, NEAR_SPEED = 0.1, 0.35  # of the logarithm, within which faults explain a gain equally well
USUAL_SIDE = 0.15  # g; rms of the lateral acceleration of a drive that is to show something
CERTAIN = 2.0  # times below, and 4 times above these bounds, that no car and no noise explains

READ = 'docs/logs.md, "Faults of units and signs"'


@dataclass(frozen=True)
class Relation:
    """How one signal follows another.

    Parameters
    ----------
    same, opposite : float   largest correlation of either sign over the delays [-]
    low, high : float        slope by the two regressions, where `same` is largest, or `opposite`
    most : float             slope that no noise can hide: all of the effect's size, against the part
                             of the cause's that is not white noise
    chance : float           sd of Fisher's z of unrelated signals of these spectra [-]
    """

    same: float
    opposite: float
    low: float
    high: float
    most: float
    chance: float

    @property
    def slope(self) -> float:
        """Middle of the two slopes, in the logarithm."""
        return float(np.sqrt(self.low * self.high))

    @property
    def counts(self) -> bool:
        """Whether the signals are alike beyond chance, with either sign."""
        return self.is_alike(ALIKE)

    def is_alike(self, least: float) -> bool:
        """Whether the correlation, of either sign, is at least so large and beyond chance."""
        alike = min(max(self.same, self.opposite), 1 - 1e-12)
        return alike >= least and float(np.arctanh(alike)) >= BEYOND_CHANCE * self.chance

    @property
    def is_mirrored(self) -> bool:
        """Whether each is the other's mirror image, alike at no delay: said even of a slalom's sine."""
        return self.opposite >= MIRRORED and self.same < 0

    @property
    def is_turned(self) -> bool:
        """Whether the sign is opposite, and no delay makes it look the same."""
        return self.counts and self.opposite - self.same >= SIGN_MARGIN


def check_response(
    values: Mapping[str, np.ndarray],
    columns: Mapping[str, Column],
    *,
    wheelbase: float | None,
    file: str,
) -> list[Finding]:
    """Compare steer, yaw rate, speed and lateral acceleration with each other.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI: "t", "delta", "r", "U" and optionally "ay"; NaN
                                              where missing
    columns : mapping of str to Column        where they come from
    wheelbase : float or None                 L [m]; without it only signs and ay are compared
    file : str                                name of the file

    Returns
    -------
    list of Finding   certain: a sign turned round; a gain that no car has; U r against ay.
                      likely: the same, less clearly
    """
    moving = np.abs(values["U"]) > SLOWEST * np.sqrt(GRAVITY * (wheelbase or 1.0))
    if np.count_nonzero(moving) < 2:
        return []
    found = []
    with_ay = _acceleration(values, moving)
    if with_ay is not None:
        found += _judge_acceleration(with_ay, columns, file)
        if any(one.certain for one in found):
            return found  # yaw rate or speed is wrong; against the steer it would be wrong again
    asked = np.where(moving, values["U"] * values["delta"] / (wheelbase or 1.0), np.nan)
    steered = np.isfinite(asked)
    if not steered.any():
        return found
    relation = relate(values["t"], asked, values["r"], level_counts=False)
    steer = float(np.sqrt(np.mean(values["delta"][steered] ** 2)))
    if steer > LARGE_STEER and (relation is None or not relation.counts):
        relation = relate(values["t"], asked, values["r"], level_counts=True)  # driven in a circle
    if relation is None:
        return found
    if relation.opposite > relation.same and (relation.counts or relation.is_mirrored):
        backward = float(np.mean(values["U"][moving] < 0)) > MOSTLY_BACKWARD
        found.append(_sign(relation, columns, file, backward=backward))
    elif wheelbase is not None:
        froude = float(np.nanmean(np.where(moving, values["U"], np.nan) ** 2)) / (GRAVITY * wheelbase)
        found += _judge_gain(relation, froude, columns, file, steer=_wandering(values["delta"], moving))
    return found


def relate(t: np.ndarray, cause: np.ndarray, effect: np.ndarray, *, level_counts: bool) -> Relation | None:
    """How the effect follows the cause within the delays; None where there is too little of both.

    Parameters
    ----------
    t, cause, effect : (n,) float64   rising time [s] and two signals, NaN where missing
    level_counts : bool               False where the means may be offsets, and are taken out
    """
    x, y = _binned(t, cause, effect)
    known = np.isfinite(x) & np.isfinite(y)
    if np.count_nonzero(known) < 40:
        return None
    if not level_counts:
        x, y = x - x[known].mean(), y - y[known].mean()
    best = [_likeness(x, y, delay) for delay in range(EARLIEST, LATEST + 1)]
    best = [one for one in best if one is not None]
    if not best:
        return None
    same, opposite = max(best), min(best)
    likeness, ratio = max(same, opposite, key=lambda one: abs(one[0]))
    alike = max(abs(likeness), 1e-9)
    chance = _chance(np.where(known, x, 0.0), np.where(known, y, 0.0))
    low, high = float(alike * ratio), float(ratio / alike)
    return Relation(float(same[0]), float(-opposite[0]), low, high, _most(x, y), chance)


def _most(x: np.ndarray, y: np.ndarray) -> float:
    """Largest slope of y on x: y is at least the slope times the part of x that is no white noise."""
    known = np.isfinite(x) & np.isfinite(y)
    follows = known[1:] & known[:-1]
    power = float(np.mean(x[known] ** 2))
    smooth = float(np.mean(x[1:][follows] * x[:-1][follows])) if follows.any() else 0.0
    if not smooth > SMOOTH * power:
        return np.inf
    return float(np.sqrt(np.mean(y[known] ** 2) / smooth))


def _binned(t: np.ndarray, *signals: np.ndarray) -> list[np.ndarray]:
    usual = float(np.median(np.diff(t)))
    width = max(BIN, usual, (t[-1] - t[0]) / MOST_BINS)
    at = ((t - t[0]) / width + 0.25 * min(usual / width, 1.0)).astype(int)
    means = []
    for signal in signals:
        known = np.isfinite(signal)
        count = np.bincount(at[known], minlength=at[-1] + 1)
        total = np.bincount(at[known], signal[known], minlength=at[-1] + 1)
        means.append(np.where(count > 0, total / np.maximum(count, 1), np.nan))
    return means


def _likeness(x: np.ndarray, y: np.ndarray, delay: int) -> tuple[float, float] | None:
    """Correlation and ratio of sizes, y taken `delay` bins after x."""
    x = x[max(0, -delay) : x.size - max(0, delay)]
    y = y[max(0, delay) : y.size - max(0, -delay)]
    known = np.isfinite(x) & np.isfinite(y)
    if np.count_nonzero(known) < 40:
        return None
    x, y = x[known], y[known]
    powers = float(x @ x), float(y @ y)
    if min(powers) <= 0:
        return None
    return float(x @ y) / np.sqrt(powers[0] * powers[1]), float(np.sqrt(powers[1] / powers[0]))


def _chance(x: np.ndarray, y: np.ndarray) -> float:
    """Sd of Fisher's z of two unrelated signals with the spectra of x and y (Bartlett 1946)."""
    size = 2 ** int(np.ceil(np.log2(2 * x.size)))
    own = [np.fft.irfft(np.abs(np.fft.rfft(one, size)) ** 2, size) for one in (x, y)]
    product = float(np.sum(own[0] * own[1])) / max(float(own[0][0] * own[1][0]), 1e-300)
    independent = x.size / max(product, 1.0)
    return float(1 / np.sqrt(max(independent - 3, 1.0)))


def _sign(relation: Relation, columns: Mapping[str, Column], file: str, *, backward: bool = False) -> Finding:
    if backward:
        speed = columns["U"].header
        return Finding(
            "speed_sign", relation.is_turned,
            f"column {shown(speed)} of {file} is negative, and the car turns to the side of its steer as it "
            f"does when it drives forward (correlation of r and U delta {-relation.opposite:.2f})",
            "the speed is counted the other way round.",
            "--fix flip_speed_sign", READ, column=speed, value=-relation.opposite, fix="flip_speed_sign",
        )  # fmt: skip
    steer, rate = (shown(column_of(name, columns).header) for name in ("delta", "r"))
    return Finding(
        "steer_sign", relation.is_turned,
        f"columns {steer} and {rate} of {file} have opposite signs: their correlation is "
        f"{-relation.opposite:.2f}, and {relation.same:.2f} at best within {LATEST * BIN:.1f} s",
        "one sensor counts to the left and the other to the right, or the driver only met gusts.",
        "--fix flip_steer_sign", READ, column=column_of("delta", columns).header,
        value=-relation.opposite, fix="flip_steer_sign",
    )  # fmt: skip


def _wandering(steer: np.ndarray, moving: np.ndarray) -> float:
    """Rms of the steer about its mean while the car moves [rad]."""
    known = steer[moving & np.isfinite(steer)]
    return float(known.std()) if known.size else 0.0


def _judge_gain(
    relation: Relation, froude: float, columns: Mapping[str, Column], file: str, *, steer: float
) -> list[Finding]:
    least = LEAST_SHARE / (1 + froude / LEAST_FROUDE)
    high = min(relation.high, relation.most) if relation.counts else relation.most
    large = relation.low / LARGEST_GAIN if relation.counts else 0.0
    small = least / high
    beyond = max(large, small)
    if beyond <= 1:
        return []
    slope = min(relation.slope, relation.most)
    usually, paste, fix = _explain(slope, froude, columns, steer * froude / USUAL_SIDE)
    rate = column_of("r", columns).header
    bound = f"at most {LARGEST_GAIN:g}" if large > small else f"at least {least:.2g} at this speed"
    return [Finding(
        "steer_against_yaw", bool(max(large / 2, small) > CERTAIN),
        f"column {shown(rate)} of {file} is {slope:.3g} times U delta / L, the yaw rate of a "
        f"car on rails; a car has {bound}",
        usually, paste, READ, column=rate, value=slope, fix=fix,
    )]  # fmt: skip


def _explain(
    slope: float, froude: float, columns: Mapping[str, Column], likely: float
) -> tuple[str, str, str | None]:
    """The single fault that makes the gain of a usual car this one: words, line to paste, repair.

    A steer too large by 57 and a yaw rate too small by 57 look alike; that one goes first under which
    the steer is nearest to what drivers steer at this speed: ``likely`` is its size over that.
    """
    rate, steer, speed = (column_of(name, columns) for name in ("r", "delta", "U"))
    name = split_header(steer.header)[0]
    degree = np.pi / 180
    faults = []
    if not np.isclose(rate.unit.factor, degree):
        faults.append(
            (rate.unit.factor / degree, f"{shown(rate.header)} is in deg/s", "yaw_rate_is_deg_per_s")
        )
    if not np.isclose(rate.unit.factor, 1.0):
        faults.append((rate.unit.factor, f"{shown(rate.header)} is in rad/s", "yaw_rate_is_rad_per_s"))
    if not np.isclose(steer.unit.factor, degree):
        faults.append((degree / steer.unit.factor, f"{shown(steer.header)} is in deg", "steer_is_deg"))
    if not np.isclose(steer.unit.factor, 1.0):
        faults.append((1 / steer.unit.factor, f"{shown(steer.header)} is in rad", "steer_is_rad"))
    for factor, words, repair in _other_speeds(speed):  # at another speed, a car answers otherwise
        other = (1 + froude / TYPICAL_FROUDE) / (1 + froude / factor**2 / TYPICAL_FROUDE)
        faults.append((other / factor, words, repair))
    if "delta" in columns:
        faults.append((1 / 15.0, f"{shown(steer.header)} is the angle of the steering wheel",
                       f'--map "steering_wheel={name}"'))  # fmt: skip
    else:
        faults.append((15.0, f"{shown(steer.header)} is that of the road wheel already",
                       f'--map "delta={name}"'))  # fmt: skip
    beyond = slope * (1 + froude / TYPICAL_FROUDE)  # times what a usual car has at this speed
    distances = sorted((abs(np.log(beyond / one[0])), one[1], one[2]) for one in faults)
    if distances[0][0] > np.log(UNEXPLAINED):
        return "the wheelbase, the steering ratio or a unit is wrong.", 'L = "2.69 m"', None
    order = [repair for _, _, repair in SPEEDS]  # the frequent ones first
    best = distances[0]
    near = [
        one for one in distances if one[0] < best[0] + (NEAR_SPEED if {one[2], best[2]} <= {*order} else NEAR)
    ]
    in_rad = {"steer_is_deg": degree / steer.unit.factor, "steer_is_rad": 1 / steer.unit.factor}
    near.sort(key=lambda one: (abs(np.log(max(likely, 1e-9) * in_rad.get(one[2], 1.0))),
                               order.index(one[2]) if one[2] in order else 0))  # fmt: skip
    words = ", or ".join(one[1] for one in near)
    repair = near[0][2]
    if repair.startswith("--map"):
        return f"{words}; or the wheelbase is wrong.", repair, None
    return f"{words}; or the wheelbase is wrong.", f"--fix {repair}", repair


# Units of speed that are taken for each other: (SI value, unit, repair)
SPEEDS = (
    (1 / 3.6, "km/h", "speed_is_kmh"),
    (1.0, "m/s", "speed_is_m_per_s"),
    (0.44704, "mph", "speed_is_mph"),
    (1852 / 3600, "knots", "speed_is_knots"),
)


def _other_speeds(speed: Column) -> list[tuple[float, str, str]]:
    """By how much the speed is too large were it in another unit than its header says, words, repair."""
    return [
        (speed.unit.factor / size, f"{shown(speed.header)} is in {unit}", repair)
        for size, unit, repair in SPEEDS
        if not np.isclose(size, speed.unit.factor)
    ]


def _acceleration(values: Mapping[str, np.ndarray], moving: np.ndarray) -> Relation | None:
    if "ay" not in values:
        return None
    turning = np.where(moving, values["U"] * values["r"], np.nan)
    if not float(np.nanmean(turning**2)) > 0:
        return None
    return relate(values["t"], turning, values["ay"], level_counts=False)


# ay is U r and the change of lateral speed, read by a sensor that rolls with the body: 0.8 to 1.25, and
# more where quick steering at low speed makes the two less alike.
LEAST_AY, MOST_AY, MOST_ALIKE_AY = 0.7, 1.45, 1.33
ALIKE_AY = 0.9
UNEXPLAINED_AY = 1.5
CERTAIN_AY = 0.54, 1.88  # so that 3.6 is certain, and a sensor far off the centre of gravity is not


def _judge_acceleration(relation: Relation, columns: Mapping[str, Column], file: str) -> list[Finding]:
    header = columns["ay"].header
    beyond_chance = relation.is_alike(ALIKE_AY)
    if not beyond_chance and not relation.same >= max(MIRRORED, relation.opposite):
        return []  # a slalom's sine may be alike by chance, and is still compared in size
    if relation.opposite > relation.same:
        return [Finding(
            "ay_sign", False,
            f"column {shown(header)} and U r have opposite signs (correlation {-relation.opposite:.2f})",
            "the axes of SAE and ISO are mixed; ay is not used to identify.",
            '--map "ay=COLUMN"', READ, column=header, value=-relation.opposite,
        )]  # fmt: skip
    most = MOST_ALIKE_AY if relation.same >= MIRRORED else MOST_AY
    beyond = max(relation.low / most, LEAST_AY / relation.high)
    if beyond <= 1:
        return []
    guess, paste, fix = _explain_ay(1 / relation.slope, columns)
    certain = relation.high < CERTAIN_AY[0] or relation.low > CERTAIN_AY[1]
    return [Finding(
        "ay_against_yaw", beyond_chance and bool(certain) and fix is not None,
        f"column {shown(header)} of {file} is {relation.slope:.3g} times U r; {LEAST_AY:g} to {most:g} "
        "is what a car has", guess, paste, READ, column=header, value=relation.slope, fix=fix,
    )]  # fmt: skip


def _explain_ay(factor: float, columns: Mapping[str, Column]) -> tuple[str, str, str | None]:
    """The single fault that makes U r too large by this factor against ay."""
    rate, speed, side = (columns[name] for name in ("r", "U", "ay"))
    degree = np.pi / 180
    faults = [
        (1 / degree * rate.unit.factor, f"{shown(rate.header)} is in deg/s", "yaw_rate_is_deg_per_s"),
        (rate.unit.factor, f"{shown(rate.header)} is in rad/s", "yaw_rate_is_rad_per_s"),
        *_other_speeds(speed),
        (GRAVITY / side.unit.factor, f"{shown(side.header)} is in g", None),
        (1 / side.unit.factor, f"{shown(side.header)} is in m/s^2", None),
    ]
    distance, words, repair = min(
        (abs(np.log(factor / one[0])), one[1], one[2] or "")
        for one in faults
        if abs(np.log(one[0])) > 0.1  # the header says so already
    )
    if distance > np.log(UNEXPLAINED_AY):
        return "the units of the three do not fit, or the sensor has another axis.", '--map "ay=COLUMN"', None
    if not repair:
        return f"{words}; ay is not used to identify.", f"{split_header(side.header)[0]} [g]", None
    return f"{words}.", f"--fix {repair}", repair
