"""Sound simulated logs of many cars, and the ways to damage one, for rates of detection."""

from dataclasses import dataclass, replace

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from scipy.signal import butter, sosfilt

from similitude.log_survey import survey
from similitude.simulate import bicycle_response
from similitude.units import parse_uncertain
from similitude.vehicle_file import Vehicle

PLANT = 200  # Hz
NAMES = ("t", "delta", "r", "U", "ay")
UNITS = {"t": "s", "delta": "rad", "r": "rad/s", "U": "m/s", "ay": "m/s^2"}


@dataclass(frozen=True, eq=False)
class Drive:
    """Columns of one log in SI, the wheelbase of its car [m], and how it was driven."""

    columns: dict[str, np.ndarray]
    L: float
    speed: float
    rms: float


def sound_drives(count, *, seconds=30.0, seed=0):
    """Logs of cars drawn from the population, with any usual speed, steer, noise and rate.

    K, pi1, eta and rho spread as in the population of passenger cars; the steer wanders in one of
    four bands at 0.5 to 15 mrad rms; gyro noise 0.05 to 0.3 deg/s; 20 to 200 rows a second; the steer
    acts up to 0.1 s late.
    """
    rng = np.random.default_rng(seed)
    n = int(seconds * PLANT)
    t = np.arange(n) / PLANT
    L = rng.uniform(2.4, 3.1, count)
    speed = rng.uniform(8, 38, count)
    rms = np.exp(rng.uniform(np.log(5e-4), np.log(0.015), count)) * np.minimum(1, (12 / speed) ** 2 + 0.15)
    bands = [(0.05, 0.4), (0.1, 1.0), (0.15, 3.0), (0.5, 2.0)]
    steer = np.empty((count, n))
    for row in steer:
        sos = butter(2, bands[rng.integers(4)], "bandpass", fs=PLANT, output="sos")
        row[:] = sosfilt(sos, rng.standard_normal(n + 4000))[4000:]
    steer *= (rms / steer.std(axis=1))[:, None]
    groups = {
        "K": (145.7 * np.exp(0.4 * rng.standard_normal(count)))[:, None],
        "eta": 1.42 * np.exp(0.13 * rng.standard_normal(count)),
        "pi1": 0.443 + 0.03 * rng.standard_normal(count),
        "rho": 1.017 * np.exp(0.09 * rng.standard_normal(count)),
    }
    yaw, slip = bicycle_response(t, steer, speed[:, None], L=L, **groups)
    drives = []
    for one in range(count):
        every = int(rng.choice([1, 2, 4, 10]))
        late = int(rng.uniform(0, 0.1) * PLANT)
        said = np.roll(steer[one], -late)
        said[n - late :] = steer[one, -1]
        side = np.gradient(slip[one] * speed[one], t) + yaw[one] * speed[one]
        drives.append(_logged(t, said, yaw[one], speed[one], side, every, rng, L[one], rms[one]))
    return drives


def _logged(t, steer, yaw, speed, side, every, rng, L, rms):
    rows = slice(None, None, every)
    size = t[rows].size
    slow = 0.4 * np.cumsum(rng.standard_normal(size)) / np.sqrt(size)
    columns = {
        "t": t[rows],
        "delta": steer[rows] + rng.normal(0, 2e-3) + 2e-5 * rng.standard_normal(size),
        "r": yaw[rows] + rng.normal(0, 2e-3) + np.deg2rad(rng.uniform(0.05, 0.3)) * rng.standard_normal(size),
        "U": speed + slow + 0.03 * rng.standard_normal(size),
        "ay": 1.08 * side[rows] + 0.1 + 0.15 * rng.standard_normal(size),
    }
    return Drive(columns, L, speed, rms)


def coarse(drive, rng):
    """The same drive through a bus: rounded as cars round, some values held, and a gusty day."""
    return rounded(gusty(drive, rng), rng)


def gusty(drive, rng):
    """The same drive on a day with side wind."""
    columns = dict(drive.columns)
    t = columns["t"]
    rate = 1 / np.median(np.diff(t))
    sos = butter(2, [0.05, 0.5], "bandpass", fs=rate, output="sos")
    gusts = sosfilt(sos, rng.standard_normal(t.size))
    columns["r"] = columns["r"] + rng.uniform(0, 4e-3) * gusts / gusts.std()
    return replace(drive, columns=columns)


def rounded(drive, rng):
    """The same drive with values rounded as cars round, and some of them held."""
    columns = dict(drive.columns)
    t = columns["t"]
    rate = 1 / np.median(np.diff(t))
    steps = {
        "delta": rng.choice([1e-5, 1.2e-4, 6e-4]),
        "r": np.deg2rad(rng.choice([0.001, 0.01, 0.1, 0.24])),
        "U": rng.choice([1e-3, 0.01 / 3.6, 0.1 / 3.6, 0.5 / 3.6]),
        "ay": rng.choice([1e-3, 0.01, 0.1]),
    }
    for name, step in steps.items():
        columns[name] = np.round(columns[name] / step) * step
        every = int(rng.choice([1, 1, 2, 5])) if rate > 40 else 1
        columns[name] = columns[name][(np.arange(t.size) // every) * every]
    return replace(drive, columns=columns)


def look(drive, folder, *, with_ay=True, units=UNITS, names=NAMES):
    """The survey of a drive written to a file and read back."""
    path = write(drive, folder, with_ay=with_ay, units=units, names=names)
    return survey(path, vehicle=Vehicle("car", L=parse_uncertain(f"{drive.L:.4f} m")))


def write(drive, folder, *, with_ay=True, units=UNITS, names=NAMES):
    """The path of a Parquet file with the columns of a drive."""
    path = folder / "drive.parquet"
    kept = {
        f"{name} [{units[name]}]": column
        for name, column in drive.columns.items()
        if name in names and (with_ay or name != "ay")
    }
    pq.write_table(pa.table(kept), path)
    return path


def scaled(name, factor):
    """The fault of a column whose SI values are `factor` times the true ones."""

    def damage(drive, rng):
        return {**drive.columns, name: drive.columns[name] * factor}

    return damage


def nothing(drive, rng):
    """The drive as it is."""
    return dict(drive.columns)


def _somewhere(drive, rng, seconds):
    """Rows of so many seconds in which the car moves; fewer where it stops too often for that."""
    t = drive.columns["t"]
    length = int(seconds / np.median(np.diff(t)))
    for tried in range(1, 100_000):
        if tried % 1000 == 0:
            length = max(length * 4 // 5, 2)
        start = int(rng.integers(1, t.size - length - 1))
        if np.min(np.abs(drive.columns["U"][start : start + length])) > 0.5:
            return slice(start, start + length)
    raise ValueError("the car never moves")


def stuck(name, shortest=1, longest=5):
    """The fault of a sensor that repeats one value for so many seconds."""

    def damage(drive, rng):
        column = drive.columns[name].copy()
        rows = _somewhere(drive, rng, rng.uniform(shortest, longest))
        column[rows] = column[rows.start]
        return {**drive.columns, name: column}

    return damage


def interpolated(drive, rng):
    """A hole of 0.6 to 5 s in the yaw rate, filled in by a straight line."""
    column = drive.columns["r"].copy()
    rows = _somewhere(drive, rng, rng.uniform(0.6, 5))
    column[rows] = np.linspace(column[rows.start - 1], column[rows.stop], rows.stop - rows.start + 2)[1:-1]
    return {**drive.columns, "r": column}


def clipped(name):
    """A sensor that saturates at 40 to 80 % of what it should have shown."""

    def damage(drive, rng):
        column = drive.columns[name]
        middle, most = np.median(column), rng.uniform(0.4, 0.8) * np.ptp(column) / 2
        return {**drive.columns, name: np.clip(column, middle - most, middle + most)}

    return damage


def overflowing(name):
    """A sensor whose range, 50 to 90 % of what it should have shown, goes round."""

    def damage(drive, rng):
        column = drive.columns[name]
        middle, span = np.median(column), rng.uniform(0.5, 0.9) * np.ptp(column)
        return {**drive.columns, name: (column - middle + span / 2) % span - span / 2 + middle}

    return damage


def dead_banded(name):
    """A sensor that reads nothing below a tenth to half of its standard deviation."""

    def damage(drive, rng):
        column = drive.columns[name]
        least = rng.uniform(0.1, 0.5) * np.nanstd(column)
        return {**drive.columns, name: np.where(np.abs(column) < least, 0.0, column)}

    return damage


def dead_subtracted(name):
    """A sensor that takes a tenth to half of its standard deviation off every value."""

    def damage(drive, rng):
        column = drive.columns[name]
        least = rng.uniform(0.1, 0.5) * np.nanstd(column)
        return {**drive.columns, name: np.sign(column) * np.maximum(np.abs(column) - least, 0.0)}

    return damage


def spiked(name):
    """One to ten single values thrown off by half to three times the range."""

    def damage(drive, rng):
        column = drive.columns[name].copy()
        rows = rng.choice(np.arange(1, column.size - 1, 12), rng.integers(1, 11), replace=False)
        column[rows] += rng.choice([-1, 1], rows.size) * rng.uniform(0.5, 3) * (np.ptp(column) + 1e-3)
        return {**drive.columns, name: column}

    return damage


def wrapped(period):
    """A counter of time that starts anew once, after 5 to 25 s."""

    def damage(drive, rng):
        t = drive.columns["t"]
        return {**drive.columns, "t": (t + period - rng.uniform(5, 25)) % period}

    return damage


def restarted(drive, rng):
    """Two recordings end to end: time begins anew."""
    t = drive.columns["t"].copy()
    at = int(rng.uniform(0.2, 0.8) * t.size)
    t[at:] -= t[at]
    return {**drive.columns, "t": t}


def clock_set(drive, rng):
    """The clock is set ahead by two minutes to eleven days, or back by 0.3 to 300 s."""
    t = drive.columns["t"].copy()
    at = int(rng.uniform(0.2, 0.8) * t.size)
    t[at:] += np.exp(rng.uniform(np.log(120), np.log(1e6))) if rng.random() < 0.5 else -rng.uniform(0.3, 300)
    return {**drive.columns, "t": t}


def shuffled(drive, rng):
    """One row in ten changed places with the next."""
    t = drive.columns["t"].copy()
    for at in rng.choice(np.arange(0, t.size - 1, 2), t.size // 20, replace=False):
        t[at], t[at + 1] = t[at + 1], t[at]
    return {**drive.columns, "t": t}


def repeated(drive, rng):
    """One row in fifty written twice."""
    rows = np.sort(np.r_[np.arange(drive.columns["t"].size), rng.integers(0, drive.columns["t"].size, 30)])
    return {name: column[rows] for name, column in drive.columns.items()}


def one_wheel(drive, rng):
    """The speed of one wheel, 0.7 to 0.85 m off the middle."""
    half = rng.choice([-1, 1]) * rng.uniform(0.7, 0.85)
    return {**drive.columns, "U": drive.columns["U"] + half * drive.columns["r"]}


def joined(drive, rng):
    """Two drives end to end with their time made to run on: the second at another speed."""
    at = int(rng.uniform(0.2, 0.8) * drive.columns["t"].size)
    speed = drive.columns["U"].copy()
    speed[at:] += rng.choice([-1, 1]) * rng.uniform(3, 7)
    return {**drive.columns, "U": speed}


def zeroed(name):
    """A column that reads nothing for 1 to 5 s."""

    def damage(drive, rng):
        column = drive.columns[name].copy()
        column[_somewhere(drive, rng, rng.uniform(1, 5))] = 0.0
        return {**drive.columns, name: column}

    return damage


def late(name, least, most):
    """A column whose clock is so many seconds late, at either side of the log with its last value."""

    def damage(drive, rng):
        t = drive.columns["t"]
        then = t - rng.uniform(least, most)
        return {**drive.columns, name: np.interp(then, t, drive.columns[name])}

    return damage


def since_1970(drive, rng):
    """Time counted from 1970 on."""
    return {**drive.columns, "t": drive.columns["t"] + 1.7e9 + np.round(rng.uniform(0, 1e7), 2)}


def clock_nudged(drive, rng):
    """The clock is set by 0.05 to 60 s, ahead or back."""
    t = drive.columns["t"].copy()
    t[int(rng.uniform(0.2, 0.8) * t.size) :] += rng.choice([-1, 1]) * np.exp(rng.uniform(*np.log([0.05, 60])))
    return {**drive.columns, "t": t}


def lost(drive, rng):
    """Cells lost at random, up to a tenth of those of steer, yaw rate and speed."""
    share = rng.uniform(0.005, 0.1)
    return {
        name: np.where(rng.random(x.size) < share, np.nan, x) if name in ("delta", "r", "U") else x
        for name, x in drive.columns.items()
    }


def slower(name):
    """A column that has a cell in every second to fifth row only."""

    def damage(drive, rng):
        every = int(rng.integers(2, 6))
        there = np.arange(drive.columns["t"].size) % every == 0
        return {**drive.columns, name: np.where(there, drive.columns[name], np.nan)}

    return damage
