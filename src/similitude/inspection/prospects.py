"""What a drive can show, before it is used: the filter run over the same drive of an average car.

The car is the population's average, its yaw rate the filter's own step without measurements along
the measured steer and speed, with the noise and the disturbance that this log has. The filter then
says how sure it becomes. Longer drives and larger steer are the same experiment with more of it.

Invariant: nothing is simulated a second way, and the sd includes everything that is not known
besides (balance, inertia, steer scale, offset, bias, disturbance), since it is the filter's own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from similitude.filter_config import DESIGN
from similitude.filter_run import POPULATION, Pass, Setup
from similitude.finding import Finding
from similitude.identify_setup import edges, prepare, whole_log
from similitude.log import Log
from similitude.prediction import FROZEN
from similitude.program.library import shipped
from similitude.speed_unit_doubt import speed_unit_doubts
from similitude.steer_lag import LagScan
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import NAMES
from similitude.verdict import IDENTIFIED_STD, LINEAR, PRIOR_SHARE, is_usual

OTHERS = ("input_offset", "output_bias")
MORE = (2.0, 4.0, 8.0, 16.0)  # times as much steer, or as long
HALF = 0.5  # of the sd: what is asked for
DRIVES = 3  # draws of gusts and noise that a prediction is the mean of
MOST_ROWS = 2_000_000  # of a longer drive that is tried
GENTLE = 99.0  # percentile of lateral acceleration that must stay in the linear range
STEER_KNOWN = 1e-3  # sd of the scale of a steer angle that was calibrated
CALIBRATED = 0.8  # of the sd: a calibrated steer angle is worth naming


@dataclass(frozen=True)
class Prospect:
    """One unknown: sd of its coordinate before the drive and after it (of ln K, ln eta, ...)."""

    before: float
    after: float

    @property
    def word(self) -> str:
        """``shown``, ``a little`` or ``not shown``: half of the sd, a fifth of it, or less taken off."""
        share = self.after / self.before
        return "shown" if share <= PRIOR_SHARE else "a little" if share <= CALIBRATED else "not shown"


@dataclass(frozen=True, eq=False)
class Prospects:
    """What the drive can show.

    Parameters
    ----------
    unknowns : dict          name -> Prospect, for K, pi1, eta, rho, steer offset and yaw bias
    verdict : str            ``identified``, ``weak`` or ``not_excited``, as `identify` would say of K
    goal : float             sd of ln K that is half of the predicted one
    steer_times, long_times : float or None   the least of `MORE` that reaches the goal, else None
    longest : float          of `MORE` that was tried: a very long log is not made longer
    is_linear : bool         an average car stays below 0.3 g on this drive
    steer_limit : bool       twice the steer would already leave the linear range
    known_scale : float      sd of ln K if the scale of the steer angle were known
    too_slow : float         share of the rows too slow for tyres to show [-]
    scan : LagScan           lag of the steer
    commanded : bool         the steer is so late that it is a command
    K : float                that the log itself gives, as far as it goes [m^2/s^2]
    K_prior, K_prior_std     of the population [m^2/s^2] and of ln K
    information : (n,)       gained about K along the log, cumulative [-]
    at_limit : tuple of str  groups that the limits of the population hold at the end of the log
    odd_speed : tuple        findings: a unit of the speed that explains the log far better
    """

    unknowns: dict[str, Prospect]
    verdict: str
    goal: float
    steer_times: float | None
    long_times: float | None
    longest: float
    is_linear: bool
    steer_limit: bool
    known_scale: float
    too_slow: float
    scan: LagScan
    commanded: bool
    K: float
    K_prior: float
    K_prior_std: float
    information: NDArray[np.float64]
    at_limit: tuple[str, ...] = ()
    odd_speed: tuple[Finding, ...] = ()

    @property
    def is_outside(self) -> bool:
        """Whether K or a group ends outside the population, as `identify` would say whatever was learnt."""
        return bool(self.at_limit) or not is_usual(self.K_away, self.K_prior_std)

    @property
    def K_away(self) -> float:
        """Logarithm of K over the population's [-]."""
        return float(np.log(self.K / self.K_prior))

    @property
    def K_std(self) -> float:
        """Predicted sd of ln K."""
        return self.unknowns["K"].after


def prospects(log: Log, vehicle: Vehicle) -> Prospects | None:
    """Predict what a log can show; None where no C compiler makes that quick enough.

    Parameters
    ----------
    log : Log            as `identify` would get it
    vehicle : Vehicle    with a wheelbase
    """
    if shipped(POPULATION).c is None:
        return None
    ready = prepare(log, vehicle)
    prior, setup = ready.prior, ready.setup
    done = setup.run()
    drive = _drive(setup, done)
    base, own = drive.predict(), _spread(done)
    # The log's own car may answer less than the average one: then its own sd counts.
    worse = max(1.0, own["K"] / base["K"])
    known = {name: float(s) for name, s in zip(NAMES, prior.std, strict=True)}
    known |= {name: DESIGN[f"{name}_sd"] for name in OTHERS}
    unknowns = {
        name: Prospect(before, min(max(base[name], own[name]), before)) for name, before in known.items()
    }
    goal = HALF * base["K"]
    gentle = [times for times in MORE if drive.is_linear(times)]
    short = [times for times in MORE if times * log.samples <= MOST_ROWS]
    calibrated = _drive(replace(setup, input_scale_sd=STEER_KNOWN), done).predict()["K"]
    verdict = _verdict(unknowns["K"])
    return Prospects(
        unknowns=unknowns,
        verdict=verdict,
        goal=worse * goal,
        steer_times=_least(gentle, lambda times: drive.predict(steer=times)["K"], goal),
        long_times=_least(short, lambda times: drive.predict(long=int(times))["K"], goal),
        longest=max(short, default=1.0),
        is_linear=drive.is_linear(1.0),
        steer_limit=not drive.is_linear(MORE[0]),
        known_scale=min(worse * calibrated, unknowns["K"].after),
        too_slow=float(np.mean(done.status == setup.library.layout.STATUS["too_slow"])),
        scan=ready.scan,
        commanded=ready.commanded,
        K=done.value("K"),
        K_prior=float(prior.mean[0]),
        K_prior_std=float(prior.std[0]),
        information=done.output("information_gained"),
        at_limit=edges(done),
        odd_speed=() if verdict == "not_excited" else speed_unit_doubts(ready, whole_log(ready, done)),
    )


def _drive(setup: Setup, done: Pass) -> _Drive:
    """The drive with the noise and the disturbance that a pass over the log itself arrived at."""
    return _Drive(
        setup,
        setup.samples(),
        noise=setup.noise_std * float(np.sqrt(done.value("noise_scale"))),
        gust=DESIGN["disturbance_floor"] * float(np.sqrt(done.value("disturbance_scale"))),
    )


def _least(times: list[float], std: Callable[[float], float], goal: float) -> float | None:
    """The first of some multiples with which the goal is reached."""
    return next((one for one in times if std(one) <= goal), None)


def _spread(done: Pass) -> dict[str, float]:
    """Sd of the coordinate of every unknown at the end of a pass."""
    names = [*NAMES, *OTHERS]
    return dict(zip(names, np.sqrt(np.diag(done.covariance(names))).tolist(), strict=True))


def _verdict(K: Prospect) -> str:
    if K.after > PRIOR_SHARE * K.before:
        return "not_excited"
    return "identified" if K.after <= IDENTIFIED_STD else "weak"


@dataclass(frozen=True, eq=False)
class _Drive:
    """The measured drive as an average car would have answered it.

    ``noise`` sd of the yaw rate a sample [rad/s];  ``gust`` sd of the disturbance [rad].
    """

    setup: Setup
    samples: NDArray[np.float64]
    noise: float
    gust: float

    def predict(self, *, steer: float = 1.0, long: int = 1) -> dict[str, float]:
        """Sd of every coordinate after the drive with so many times the steer, so many times over."""
        samples = np.tile(self._steered(steer), (long, 1))
        drives = [self._once(samples.copy(), np.random.default_rng(seed)) for seed in range(DRIVES)]
        return {name: float(np.mean([one[name] for one in drives])) for name in drives[0]}

    def _once(self, samples: NDArray[np.float64], rng: np.random.Generator) -> dict[str, float]:
        """The same with one draw of gusts and noise."""
        acting = samples.copy()
        acting[:, 1] += self._gusts(samples[:, 0], rng)
        answer = self._answer(acting)
        rows = np.isfinite(samples[:, 3])
        samples[rows, 3] = (answer + self.noise * rng.standard_normal(len(samples)))[rows]
        library, config = self.setup.library, self.setup.config()
        state = library.start(config)
        outputs, status = library.run(config, state, samples)
        return _spread(Pass(self.setup, config, state, outputs, status))

    def is_linear(self, steer: float) -> bool:
        """Whether an average car stays in the linear range with so many times the steer."""
        samples = self._steered(steer)
        sideways = np.abs(self._answer(samples) * samples[:, 2])
        return float(np.nanpercentile(sideways, GENTLE)) <= LINEAR

    def _steered(self, times: float) -> NDArray[np.float64]:
        samples = self.samples.copy()
        straight = np.nanmedian(samples[:, 1])
        samples[:, 1] = straight + times * (samples[:, 1] - straight)
        return samples

    def _answer(self, samples: NDArray[np.float64]) -> NDArray[np.float64]:
        """Yaw rate of the average car, (n,) [rad/s]."""
        blind = samples.copy()
        blind[:, 3] = np.nan
        library, config = self.setup.library, self.setup.config(**FROZEN)
        state = library.start(config)
        state[library.index("state", "started")] = 1.0  # no measurement will come that would say so
        outputs, _ = library.run(config, state, blind)
        return outputs[:, library.index("output", "predicted")]

    def _gusts(self, dt: NDArray[np.float64], rng: np.random.Generator) -> NDArray[np.float64]:
        """Equivalent steer of wind and road, (n,) [rad]: straight between knots as far apart as it lasts."""
        lasts = 1 / DESIGN["disturbance_rate"]
        t = np.cumsum(np.where(np.isfinite(dt), dt, 0.0))
        knots = np.arange(t[0], t[-1] + 2 * lasts, lasts)
        size = self.gust * np.sqrt(1.5)  # a straight line between two knots has two thirds of their variance
        return np.interp(t, knots, size * rng.standard_normal(knots.size))
