"""Findings that need more than one signal or a vehicle: what the statistics of a log give away.

Invariant: nothing here refuses a log, and no finding is raised that rests on less than its own
interval.
"""

from __future__ import annotations

import numpy as np

from similitude.finding import Finding
from similitude.inspection.channels import Channel
from similitude.inspection.follow import Follow
from similitude.inspection.prospects import Prospects
from similitude.inspection.signals import Signals
from similitude.inspection.slow_relation import SlowRelation
from similitude.verdict import WORDS, is_usual

READ = 'docs/inspect.md, "What it finds by itself"'
SURE = 2.0  # sds
SCALE_SURE = 3.0  # sds: the relation is a static one
SCALE_OFF = 0.1  # of a steer scale: less is within what a wheelbase and a track leave open
COARSE = 0.08  # of the steer's sd: above, rounding no longer averages out over a drive
KMH = 3.6  # a speed in km/h taken for m/s makes the car turn so much less
AXES_ALIKE = 0.6  # correlation of a lateral acceleration with a change of speed: it is the other axis
AXES_OTHER = 0.3  # ... and with what turning the car asks for
SMOOTH = 0.3  # s
FEWEST_ROWS = 100


def find_cut_steer(channel: Channel) -> list[Finding]:
    """A steer that is held at its extremes: the true angle may go on, or it is a command."""
    share = channel.cut_low + channel.cut_high
    if share == 0:
        return []
    low, high = (channel.low, channel.cut_low), (channel.high, channel.cut_high)
    ends = [f"{value:.4g}" for value, cut in (low, high) if cut]
    return [Finding(
        "steer_cut", False,
        f"column '{channel.header}' is held at {' and '.join(ends)} {channel.unit or ''} for "
        f"{100 * share:.2g} % of the rows".replace("  ", " "),
        "it is a command that is limited, or a sensor at its end; the wheels may turn otherwise.",
        "--map delta=COLUMN   # a measured road wheel, where the file has one", READ,
        column=channel.header, value=share,
    )]  # fmt: skip


def find_coarse_steer(channel: Channel, moves: float) -> list[Finding]:
    """A steer whose readings are rounded to much of what it moves; ``moves`` its sd [file's unit]."""
    step = channel.resolution
    if step is None or step <= COARSE * moves:
        return []
    return [Finding(
        "steer_coarse", False,
        f"column '{channel.header}' comes in steps of {step:.2g} {channel.unit or ''}".rstrip()
        + f", {100 * step / moves:.2g} % of what it moves (one sd)",
        "the bus message has few digits; on simulated motorway drives K then read 5 to 15 % low.",
        "--map delta=COLUMN   # a finer one, where the file has one; or steer more", READ,
        column=channel.header, value=step / moves,
    )]  # fmt: skip


def find_late_steer(plan: Prospects, header: str) -> list[Finding]:
    """A steer that acts later than its column says, or after the yaw rate that it should cause."""
    scan = plan.scan
    if scan.early:
        return [Finding(
            "clocks_apart", False,
            f"the yaw rate comes about {1000 * scan.early:.0f} ms before column '{header}', which should "
            "cause it",
            "steer and yaw rate were logged by two clocks; move one of them.",
            f"log['t of steer [s]'] = log['t [s]'] - {scan.early:g}   # then interpolate", READ,
            column=header, value=-scan.early,
        )]  # fmt: skip
    if scan.origin != "scanned" or scan.total < SURE * scan.std or scan.total == 0:
        return []
    kind = "it is a command, whose scale is then uncertain by 20 %" if plan.commanded else (
        "a filter or a slow bus lies between the wheel and the log"
    )  # fmt: skip
    return [Finding(
        "late_steer", False,
        f"the wheels follow column '{header}' {1000 * scan.total:.0f} ± {1000 * scan.std:.0f} ms late",
        f"{kind}; measure the road wheel to do better.",
        f'steer_lag = "{1000 * scan.total:.0f} ms"', READ, column=header, value=scan.total,
    )]  # fmt: skip


def find_wrong_scale(slow: SlowRelation, wheelbase: float, header: str, *, at_wheel: bool) -> list[Finding]:
    """A road-wheel steer that turns the car more or less than its wheelbase allows."""
    if slow.length is None or slow.length < 0 or at_wheel:
        return []
    scale = wheelbase / slow.length
    if abs(np.log(scale)) < max(SCALE_SURE * slow.length_std, SCALE_OFF):
        return []
    kmh = abs(np.log(scale * KMH)) < max(SURE * slow.length_std, SCALE_OFF)
    return [Finding(
        "steer_scale", False,
        f"column '{header}' turns the car {scale:.2g} ± {scale * slow.length_std:.2g} times as much as its "
        f"wheelbase of {wheelbase:.3g} m asks for at low speed",
        "the speed is in km/h, or the angle in another unit or scaled by a guess; K is wrong with either."
        if kmh else
        "the angle is a command or was scaled by a guess, or the speed is in another unit; K is wrong with "
        "either.",
        "--fix speed_is_kmh" if kmh else
        f"log['{header}'] *= {scale:.2g}   # only if a measurement says so", READ,
        column=header, value=float(scale), fix="speed_is_kmh" if kmh else None,
    )]  # fmt: skip


def find_strange_car(plan: Prospects, header: str) -> list[Finding]:
    """A stiffness or a group no car of the population has: K and the scale of the steer trade."""
    if not is_usual(plan.K_away, plan.K_prior_std):
        return [Finding(
            "steer_scale", False,
            f"taken at its word, column '{header}' makes K {plan.K:.3g} m^2/s^2, {np.exp(plan.K_away):.2g} "
            "times the population's average and outside its spread",
            "the scale of the steer angle is doubtful: K and steer scale trade; calibrate the road wheel.",
            f"log['{header}'] *= FACTOR   # of a calibrated road wheel", READ,
            column=header, value=float(np.exp(plan.K_away)),
        )]  # fmt: skip
    if not plan.at_limit:
        return []
    which = " and ".join(WORDS.get(name, name) for name in plan.at_limit)
    return [Finding(
        "outside_population", False,
        f"taken at its word, the log has {which} at the edge of what the population allows",
        "the wheelbase, the steering ratio or the population is wrong.",
        'population = "small_cars"   # or another in the vehicle file', READ,
        value=float(len(plan.at_limit)),
    )]  # fmt: skip


def find_other_axis(signals: Signals, behind: Follow | None, header: str) -> list[Finding]:
    """A lateral acceleration that follows the speed instead of the yaw rate: the axes are exchanged."""
    if behind is None or signals.ay is None or signals.U is None or signals.r is None:
        return []
    half = max(1, round(SMOOTH / signals.step / 2))
    change = np.full(signals.U.size, np.nan)
    change[half:-half] = signals.U[2 * half :] - signals.U[: -2 * half]
    along, turning = _likeness(signals.ay, change, half), _likeness(signals.ay, signals.r * signals.U, half)
    if abs(along) < AXES_ALIKE or abs(turning) > AXES_OTHER:
        return []
    return [Finding(
        "ay_axis", False,
        f"column '{header}' follows the change of speed (correlation {along:.2f}) and not the turning of "
        f"the car (r U: {turning:.2f})",
        "it is the longitudinal acceleration, or the sensor is turned by 90 degrees.",
        "--map ay=COLUMN", READ, column=header, value=along,
    )]  # fmt: skip


def _likeness(x: np.ndarray, y: np.ndarray, half: int) -> float:
    """Correlation of means over `2 half + 1` rows, where both are there; 0 where that is hardly ever."""
    kernel = np.ones(2 * half + 1) / (2 * half + 1)
    both = np.isfinite(x) & np.isfinite(y)
    inside = np.convolve(both.astype(float), kernel, "same") > 0.99
    if np.count_nonzero(inside) < FEWEST_ROWS:
        return 0.0
    x, y = (np.convolve(np.where(both, one, 0.0), kernel, "same")[inside] for one in (x, y))
    spread = float(x.std() * y.std())
    return float(np.mean((x - x.mean()) * (y - y.mean())) / spread) if spread > 0 else 0.0
