"""The reference Monte-Carlo experiment: cars drawn from the population, stiffness halved on the way.

60 cars; L U(2.3, 3.2) m, U constant U(15, 35) m/s, pi1 N(0.4431, 0.025), ln k N(ln 1.0977, 0.12),
ln pi5 N(ln 0.251, 0.08), ln K N(ln 145.68, 0.2); 100 Hz; steer = white noise through a second-order
Butterworth band-pass 0.15-1.0 Hz scaled to a given rms, rounded to 0.1 deg/15; yaw rate + white
0.15 deg/s; the filter's prior is the drawn population.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.signal import butter, sosfilt

from similitude.filter_run import population_setup
from similitude.identify_population import edges, trace_of
from similitude.log import Log
from similitude.population import Prior
from similitude.simulate import bicycle_response
from similitude.verdict import evidence, verdict

RATE = 100.0  # Hz
TYRES_GIVE_WAY = 7.0  # m/s^2: a linear plant beyond it is no car, and none is right about its K
NOISE = np.deg2rad(0.15)  # rad/s
STEER_STEP = np.deg2rad(0.1) / 15  # rad
PI1, PI1_SD = 0.4431, 0.025
K_RATIO, LN_K_RATIO_SD = 1.0977, 0.12  # pi4/pi3
PI5, LN_PI5_SD = 0.251, 0.08
K, LN_K_SD = 145.68, 0.2


@dataclass(frozen=True)
class Fleet:
    """Simulated cars; arrays (cars, n) except t (n,) and L, U (cars,)."""

    t: np.ndarray
    steer: np.ndarray
    yaw_rate: np.ndarray
    K: np.ndarray
    L: np.ndarray
    U: np.ndarray
    groups: dict  # pi1, eta, rho: (cars,) each

    def unknowns(self, i):
        """K at the start, pi1, eta and rho of one car."""
        return {"K": float(self.K[i, 0]), **{name: float(x[i]) for name, x in self.groups.items()}}


def fleet(seed, *, cars=60, duration=120.0, steer_rms=3e-3, step=60.0, ln_k=None, halve=True, rounded=True):
    """Draw and simulate cars; ``ln_k`` fixes their k that many sd away from the population's.

    The steer is logged as it is where it is not ``rounded``.
    """
    rng = np.random.default_rng(seed)
    n = int(duration * RATE)
    t = np.arange(n) / RATE
    L, U = rng.uniform(2.3, 3.2, cars), rng.uniform(15, 35, cars)
    pi1 = rng.normal(PI1, PI1_SD, cars)
    k = K_RATIO * np.exp(rng.normal(0, LN_K_RATIO_SD, cars))
    if ln_k is not None:
        k = np.full(cars, K_RATIO * np.exp(ln_k * LN_K_RATIO_SD))
    pi5 = PI5 * np.exp(rng.normal(0, LN_PI5_SD, cars))
    stiffness = np.repeat(K * np.exp(rng.normal(0, LN_K_SD, cars))[:, None], n, axis=1)
    if halve:
        stiffness[:, t >= step] *= 0.5
    sos = butter(2, [0.15, 1.0], "bandpass", fs=RATE, output="sos")
    steer = sosfilt(sos, rng.standard_normal((cars, n + 2000)))[:, 2000:]
    steer *= steer_rms / steer.std(axis=1, keepdims=True)
    columns = {"pi1": pi1, "eta": k * (1 - pi1) / pi1, "rho": pi5 / (pi1 * (1 - pi1))}
    shaped = {name: value[:, None] for name, value in columns.items()}
    r, _ = bicycle_response(t, steer, U[:, None], L=L[:, None], K=stiffness, **shaped)
    logged = np.round(steer / STEER_STEP) * STEER_STEP if rounded else steer
    return Fleet(t, logged, r + NOISE * rng.standard_normal(r.shape), stiffness, L, U, columns)


def log_of_car(cars, i):
    """What one car's logger wrote."""
    return Log(
        name=f"car {i}", path=Path("car.csv"), t=cars.t, delta=cars.steer[i], r=cars.yaw_rate[i],
        U=np.full(len(cars.t), cars.U[i]), ay=None, sources={},
    )  # fmt: skip


def drawn_prior():
    """The drawn population in the filter's coordinates: k and pi5 independent of pi1."""
    p2 = 1 - PI1
    jacobian = np.eye(4)  # of (ln K, pi1, ln eta, ln rho) in (ln K, pi1, ln k, ln pi5)
    jacobian[2, 1] = -1 / (PI1 * p2)
    jacobian[3, 1] = -(1 / PI1 - 1 / p2)
    drawn = np.diag(np.square([LN_K_SD, PI1_SD, LN_K_RATIO_SD, LN_PI5_SD]))
    return Prior(
        ("K", "pi1", "eta", "rho"),
        ("log", "linear", "log", "log"),
        np.array([K, PI1, K_RATIO * p2 / PI1, PI5 / (PI1 * p2)]),
        jacobian @ drawn @ jacobian.T,
    )


@dataclass(frozen=True)
class Score:
    """Over cars: rms of ln K over the last 20 s before and after the step, coverage, delays."""

    rms: float  # median over cars, both windows together
    coverage: float  # share of all car-seconds after 10 s
    coverage_median: float  # median over cars
    half_way: float  # s, median
    within_15: float  # s, median: for good
    identified: float  # share of cars with that verdict
    wrong: int  # identified and off by more than twice the 15 % that identified stands for


def score(cars: Fleet, *, step=60.0, noise_factor=1.0, L_factor=1.0, **changes) -> Score:
    """Run the population filter over every car.

    ``noise_factor`` multiplies the assumed variance of the yaw rate, ``L_factor`` the wheelbase the
    filter is told; ``changes`` replaces design constants.
    """
    prior = drawn_prior()
    rows = []
    for i in range(len(cars.L)):
        setup = population_setup(
            log_of_car(cars, i),
            prior,
            L=cars.L[i] * L_factor,
            noise_std=NOISE * np.sqrt(noise_factor),
            input_scale_sd=0.02,
        )
        done = setup.run(**changes)
        # K is Caf L/m: a filter told another wheelbase means the same stiffness by K times that
        error = np.log(done.output("estimate") / (cars.K[i] * L_factor))
        sd = np.sqrt(done.output("variance"))
        trace = trace_of(done, done.output("estimate"), sd)
        code, _ = verdict(evidence(setup.log, trace, prior, at_limit=edges(done)))
        real = np.abs(cars.yaw_rate[i] * cars.U[i]).max() < TYRES_GIVE_WAY
        rows.append([*_car(cars.t, error, sd, step, code == "identified"), real])
    columns = np.array(rows, dtype=float).T
    return Score(
        float(np.median(columns[0])),
        float(np.mean(columns[1])),
        float(np.median(columns[1])),
        *np.median(columns[2:4], axis=1),
        float(np.mean(columns[4])),
        int(np.sum(columns[4] * columns[6] * (np.abs(columns[5]) > 0.3))),
    )


def _car(t, error, sd, step, identified):
    after, end = t >= step, t[-1]
    windows = ((t >= step - 20) & ~after) | (t > end - 20)
    rms = np.sqrt(np.mean(np.square(error[windows])))
    covered = np.mean((np.abs(error) < 1.96 * sd)[t > 10])
    late = error[after]  # ln of estimate over the halved truth: half-way is ln(0.75/0.5)
    hit = np.flatnonzero(late < np.log(1.5))
    off = np.flatnonzero(np.abs(np.exp(late) - 1) > 0.15)
    dt = t[1] - t[0]
    return [
        rms,
        covered,
        hit[0] * dt if hit.size else np.inf,
        (off[-1] + 1) * dt if off.size else 0.0,
        identified,
        error[-1],
    ]
