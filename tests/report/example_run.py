"""A made-up Run of a believable drive, for tests of the report alone; no estimator is involved."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np

from similitude.servo import Servo
from similitude.status import STATUS


def example_run(
    samples: int = 6000,
    *,
    verdict: str = "identified",
    seed: int = 1,
    with_mass: bool = True,
    scanned: bool = True,
    long_gap: bool = True,
    drop: float = 0.6,
    alarms: tuple = (),
):
    """Build the Run: K falls by `drop` half-way; slow at both ends; a gap; a hard corner."""
    random = np.random.default_rng(seed)
    t = np.arange(samples) / 100.0
    span = t[-1]
    if long_gap:
        t = np.where(t > 0.3 * span, t + 0.03 * span, t)
    part = t / t[-1]
    U = 25.0 * np.clip(np.minimum(part, 1 - part) * 14, 0.05, 1) * (1 + 0.1 * np.sin(5 * part))
    r = 0.12 * np.sin(2 * np.pi * 0.4 * t) * np.sin(2 * np.pi * t / (span / 3)) ** 2
    r[part < 0.08] *= 0.05
    hard = (part > 0.7) & (part < 0.76)
    r[hard] *= 2.2
    noise = 0.0026
    r_measured = r + noise * random.standard_normal(samples)
    innovation = r_measured - (r + 0.0006 * random.standard_normal(samples))
    status = np.full(samples, STATUS["ok"], np.int32)
    status[np.abs(r) < 0.004] = STATUS["not_excited"]
    status[U < 6] = STATUS["too_slow"]
    status[hard & (np.abs(r) > 0.12)] = STATUS["outside_linear"]
    lost = (part > 0.52) & (part < 0.545)
    status[lost] = STATUS["no_measurement"]
    status[random.integers(0, samples, 12)] = STATUS["no_measurement"]
    missing = status == STATUS["no_measurement"]
    r_measured[missing] = np.nan
    innovation[missing] = np.nan
    if long_gap:
        status[np.flatnonzero(np.diff(t) > 0.02 * span)[0] + 1] = STATUS["restarted"]

    learning = (r / noise) ** 2 * (status == STATUS["ok"]) * 0.004
    precision = 1 / 0.5**2 + np.cumsum(learning) * 3
    precision /= 1 + np.maximum(0, precision - 400) / 400
    ln_K_std = 1 / np.sqrt(precision)
    truth = np.where(part < 0.5, 118.0, 118.0 * drop)
    toward = 1 - np.exp(-np.cumsum(learning) / 4)
    wander = 0.6 * ln_K_std * np.sin(1.7 * np.sqrt(np.cumsum(learning)))
    lag_after = np.clip((part - 0.5) / 0.03, 0, 1)
    level = np.log(145.68) * (1 - toward) + toward * np.where(
        part < 0.5, np.log(118.0), np.log(118.0) * (1 - lag_after) + np.log(truth) * lag_after
    )
    K = np.exp(level + wander)
    pi3 = K / U**2

    trace = SimpleNamespace(
        t=t, K=K, ln_K_std=ln_K_std, pi3=pi3, pi3_std=pi3 * ln_K_std,
        r_measured=r_measured, r_predicted=r, innovation=innovation,
        innovation_std=np.full(samples, 1.05 * noise), information=3 * np.cumsum(learning),
        U=U, ay_kinematic=U * r, status=status,
    )  # fmt: skip
    lags = np.linspace(0.0, 0.2, 21)
    lag = SimpleNamespace(
        servo=Servo(0.045),
        lags=lags if scanned else np.zeros(0),
        cost=4e3 * (lags - 0.04) ** 2 * 25 if scanned else np.zeros(0),
        chosen=0.04,
        origin="scanned" if scanned else "vehicle file",
    )
    return SimpleNamespace(
        log=SimpleNamespace(
            name="ring_road", path=Path("logs/ring_road.csv"), samples=samples,
            duration=float(t[-1]), rate=100.0, t=t, warnings=(), fixes=(),
            delta=r * 2.69 / U, r=r_measured, U=U, ay=None,
            sources={"t": "t [s]", "delta": "steering_wheel [deg] / 15.3", "r": "yaw_rate [deg/s]",
                     "U": "speed [km/h] / 3.6"},
        ),
        vehicle=_vehicle(with_mass),
        estimator="population", trace=trace, verdict=verdict, reason=REASONS[verdict],
        K=_estimate(K[-1], ln_K_std[-1], "m^2/s^2"),
        pi3={"value": float(pi3[-1]), "std": float(pi3[-1] * ln_K_std[-1]), "at_speed": 25.0},
        groups=_groups(K[-1], ln_K_std[-1]), nuisance=_nuisance(), lag=lag, alarms=alarms,
        prediction={
            "horizon_s": 1.0, "predictions": 118, "unit": "rad/s",
            "rms": {"estimate": 0.0041, "frozen_averages": 0.0063}, "ratio_to_frozen": 0.65,
        },
        handling=_handling(),
        warnings=("a gap of 1.8 s at t = 18.0 s: the vehicle's motion was started anew there",
                  "12 samples (0.2 %) of r have no value: counted as no measurement"),
        assumed=_assumed(),
        batch=None, cross_check=None, memory=None,
        monitor={"armed_share": 0.62, "hours_between_false_alarms": 10.0},
        information={"interval": 9.1, "rate": 2.0, "seconds": None, "steer": 2.0,
                     "text": "K is known to +9 % (95 %); 2 times the steer would halve that in a minute"},
        time_scales={"tyre": {"K": 118.0, "std": 9.0, "drives": 3}, "road": {"factor": 0.6, "std": 0.05}},
        Caf=_estimate(K[-1] * 2010 / 2.69, ln_K_std[-1], "N/rad") if with_mass else None,
    )  # fmt: skip


REASONS = {
    "identified": "The drive narrowed K to ±5 %, a tenth of what the population alone says.",
    "weak": "K is known to ±22 %: better than the population's ±50 %, too wide to rely on.",
    "not_excited": "The steering moved too little: the log says less about the tyres than the "
    "population already did.",
    "outside_model": "62 % of the information came from corners above 0.3 g, where a linear tyre "
    "does not hold.",
    "outside_population": "Front/rear stiffness sits at the edge of what cars have.",
    "bad_data": "31 % of the samples were rejected.",
    "diverged": "The innovations grew until they no longer agree with their own deviation.",
}


def _estimate(value, ln_std, unit):
    return SimpleNamespace(
        value=float(value), std=float(value * ln_std), unit=unit,
        lo=float(value * np.exp(-1.96 * ln_std)), hi=float(value * np.exp(1.96 * ln_std)),
    )  # fmt: skip


def _vehicle(with_mass):
    def given(value, sd, unit):
        return SimpleNamespace(value=value, sd=sd, unit=unit)

    return SimpleNamespace(
        name="Estate 2.0", L=given(2.69, None, "m"), a=given(1.21, 0.03, "m"), b=None,
        m=given(2010.0, 50.0, "kg") if with_mass else None, Iz=None, Caf=None, Car=None,
        steering_ratio=given(15.3, None, "-"), steer_lag=None, yaw_rate_noise=None,
        population="passenger_cars", origins={"L": "vehicle file estate.toml"},
    )  # fmt: skip


def _groups(K, ln_K_std):
    def group(value, std, prior_value, prior_std, meaning):
        return SimpleNamespace(value=value, std=std, prior_value=prior_value,
                               prior_std=prior_std, meaning=meaning)  # fmt: skip

    return {
        "pi1": group(0.4461, 0.0181, 0.4498, 0.02, "a/L, centre of gravity behind the front axle"),
        "eta": group(1.395, 0.094, 1.42, 0.185, "rear/front cornering coefficient; > 1 understeers"),
        "rho": group(1.008, 0.084, 1.017, 0.092, "yaw inertia Iz/(m a b)"),
    }


def _nuisance():
    return {
        "yaw_bias": SimpleNamespace(value=-0.00213, std=0.00018, unit="rad/s"),
        "steer_offset": SimpleNamespace(value=0.0041, std=0.0011, unit="rad"),
        "disturbance": SimpleNamespace(value=0.0002, std=0.0007, unit="rad"),
    }


def _handling():
    def found(value, std, unit, meaning):
        return {"value": value, "std": std, "lo": value - 1.96 * std, "hi": value + 1.96 * std,
                "unit": unit, "meaning": meaning}  # fmt: skip

    return {
        "understeer_gradient": found(0.00312, 0.00041, "rad/(m/s^2)",
                                     "more steer for more lateral acceleration"),
        "characteristic_speed": found(29.4, 2.1, "m/s", "speed of the largest yaw-rate gain"),
        "yaw_rate_gain": found(4.71, 0.22, "1/s", "steady yaw rate per road-wheel angle"),
    }  # fmt: skip


def _assumed():
    def given(value, unit, origin):
        return SimpleNamespace(value=value, unit=unit, origin=origin)

    return {
        "population": given("passenger_cars", "-", "assumed: not named in the vehicle file"),
        "L": given(2.69, "m", "vehicle file estate.toml"),
        "a": given(1.21, "m", "vehicle file estate.toml"),
        "steering_ratio": given(15.3, "-", "vehicle file estate.toml"),
        "yaw_rate_noise": given(0.00262, "rad/s", "measured on the log itself, 1480 fresh samples"),
        "Iz": given(None, "kg m^2", "not given: left to the population"),
    }
