"""A whole run: rows that are never missing, verdicts a drive can reach, laws that must hold."""

import dataclasses

import numpy as np
import pytest

from similitude.identification import identify
from similitude.identify_setup import edges
from similitude.log import read_log
from similitude.report.table import estimate_table
from similitude.status import STATUS
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import vehicle_prior
from similitude.verdict import LINEAR

from .log_text import csv_text, write
from .simulated_drive import (
    CAR,
    FINE,
    NOISE,
    drive,
    log_of,
    metres,
    spoilt,
    vehicle,
    wandering_steer,
    yaw_rate,
)
from .test_filter_run import setup_of


def truth_in_sd(run, K=CAR["K"]):
    """Error of ln K at the end, in sd."""
    return np.log(run.K.value / K) / run.trace.ln_K_std[-1]


# ---- rows -----------------------------------------------------------------------------------


def _jitter(log):
    steps = np.diff(log.t) * np.random.default_rng(0).uniform(0.4, 1.6, log.samples - 1)
    t = np.concatenate([[0.0], np.cumsum(steps)])
    return log_of(t, log.delta, log.r, log.U)


def _gap(log, row=400, seconds=7.0):
    t = log.t.copy()
    t[row:] += seconds
    return log_of(t, log.delta, log.r, log.U)


def _scattered(log, share=0.15):
    rng = np.random.default_rng(2)
    return spoilt(log, **{name: rng.random(log.samples) < share for name in ("delta", "r", "U")})


def _without(log, rows):
    return spoilt(log, delta=rows, r=rows, U=rows)


def _moving(log, U):
    return log_of(log.t, log.delta, log.r, U)


ODD_LOGS = {
    "as it should be": lambda log: log,
    "missing cells": _scattered,
    "missing first row": lambda log: spoilt(log, delta=0, r=0, U=0),
    "missing last rows": lambda log: _without(log, slice(-50, None)),
    "a stretch of nothing": lambda log: _without(log, slice(300, 600)),
    "nothing at all": lambda log: _without(log, slice(None)),
    "no yaw rate": lambda log: spoilt(log, r=slice(None)),
    "no speed": lambda log: spoilt(log, U=slice(None)),
    "a gap": _gap,
    "many gaps": lambda log: _gap(_gap(_gap(log, 200, 1.5), 500, 3.0), 800, 1e3),
    "jitter": _jitter,
    "standstill": lambda log: _moving(log, np.zeros(log.samples)),
    "reverse": lambda log: _moving(log, -log.U),
    "stop and go": lambda log: _moving(log, np.maximum(0, 25 * np.sin(log.t))),
    "ends at rest": lambda log: _moving(log, np.where(log.t < 8, log.U, 0.0)),
    "ends in reverse": lambda log: _moving(log, np.where(log.t < 8, log.U, -2.0)),
    "values that cannot be": lambda log: log_of(
        log.t, log.delta, np.where(np.arange(log.samples) % 97, log.r, 1e6), log.U
    ),
}  # fmt: skip
RATES = {"20 Hz": 20, "1 kHz": 1000, "5 Hz": 5}


def assert_rows_are_whole(run, log):
    trace = run.trace
    for field in dataclasses.fields(trace):
        column = getattr(trace, field.name)
        assert column.shape == (log.samples,), field.name
        if field.name not in ("r_measured", "innovation"):
            assert np.isfinite(column).all(), field.name
    assert np.all(trace.K > 0) and np.all(trace.ln_K_std > 0) and np.all(trace.innovation_std > 0)
    unused = np.isin(trace.status, [STATUS[n] for n in ("no_measurement", "too_slow", "bad_sample")])
    assert np.array_equal(np.isnan(trace.innovation), unused | np.isnan(log.r))
    assert np.all(np.diff(trace.information) >= 0)
    assert np.array_equal(trace.t, log.t)
    table = estimate_table(run)
    assert table.num_rows == log.samples
    for name in table.column_names:
        assert table[name].null_count == 0
        if name != "status":
            assert np.isfinite(table[name].to_numpy()).all(), name
    for number in (run.K.value, run.K.std, run.K.lo, run.K.hi, *run.pi3.values()):
        assert np.isfinite(number)
    for number in (*run.groups.values(), *run.nuisance.values()):
        assert np.isfinite(number.value) and number.std > 0
    for found in run.handling.values():
        assert np.isfinite([found["value"], found["std"], found["lo"], found["hi"]]).all()


@pytest.mark.parametrize("oddity", ODD_LOGS)
def test_one_whole_row_for_each_row_of_the_log(oddity):
    log = ODD_LOGS[oddity](drive(seconds=10))
    assert_rows_are_whole(identify(log, vehicle(m=Uncertain(1500.0, 30.0, "kg"))), log)


@pytest.mark.parametrize("rate", RATES)
def test_one_whole_row_at_any_rate_and_the_truth_within_three_sd(rate):
    log = drive(seconds=20, rate=RATES[rate])
    run = identify(log, vehicle())
    assert_rows_are_whole(run, log)
    assert abs(truth_in_sd(run)) < 3
    assert any("samples a second are few" in line for line in run.warnings) == (log.rate < 20)


def test_a_parked_car_is_no_crash_and_pi3_belongs_to_the_speed_it_is_printed_with():
    for U in (0.0, -3.0, 25.0):
        log = drive(seconds=5)
        log.U[:] = U
        run = identify(log, vehicle())
        assert run.pi3["value"] * run.pi3["at_speed"] ** 2 == pytest.approx(run.K.value)
        assert ("yaw_frequency" in run.handling) == (U > 0)
    assert run.pi3["at_speed"] == 25.0


# ---- verdicts that a drive reaches ------------------------------------------------------------


def reasoned(log, car=None):
    run = identify(log, car or vehicle())
    assert f"{100 * run.trace.ln_K_std[-1]:.3g} %" in run.reason or run.verdict not in (
        "identified", "weak", "not_excited",
    )  # fmt: skip
    return run.verdict, run


def test_identified_and_right():
    verdict, run = reasoned(drive())
    assert verdict == "identified"
    assert abs(truth_in_sd(run)) < 3
    assert run.K.lo < run.K.value < run.K.hi


def test_not_excited_at_a_crawl():
    verdict, run = reasoned(drive(U=2.0, rms=0.02))
    assert verdict == "not_excited"
    assert "too slow" in run.reason
    assert run.K.value == pytest.approx(run.groups["K"].prior_value)


@pytest.mark.parametrize("seed", range(4))
def test_never_identified_on_a_straight_road(seed):
    """0.03 mrad of steer move the yaw rate by a tenth of its noise."""
    verdict, run = reasoned(drive(rms=3e-5, seed=seed))
    assert verdict in ("not_excited", "weak")
    assert abs(truth_in_sd(run)) < 3


def test_until_a_drive_tells_the_scale_a_command_tells_less_than_a_measured_steer():
    _, commanded = reasoned(drive(seconds=20, rms=0.01, lag=0.08))
    _, measured = reasoned(drive(seconds=20, rms=0.01))
    assert commanded.trace.ln_K_std[-1] > measured.trace.ln_K_std[-1]
    assert abs(truth_in_sd(commanded)) < 3


def test_outside_model_when_all_was_learnt_beyond_the_linear_range():
    """One turn of 0.6 g with a little steering on top."""
    steer = 0.04 + wandering_steer(40, 0.004)
    speed, every = np.full(steer.size, 25.0), FINE // 100
    yaw = yaw_rate(steer, speed, 1 / FINE, **CAR)[::every]
    yaw += NOISE * np.random.default_rng(0).standard_normal(yaw.size)
    log = log_of(np.arange(yaw.size) / 100, steer[::every], yaw, speed[::every])
    assert reasoned(log)[0] == "outside_model"


@pytest.mark.parametrize("seed", range(3))
def test_what_is_driven_on_the_way_to_the_limit_tells_K(seed):
    """Half of the rows are beyond 0.3 g, and most is learnt from the others."""
    verdict, run = reasoned(drive(rms=0.04, band=(0.15, 0.8), seed=seed))
    assert np.mean(np.abs(run.trace.ay_kinematic) > LINEAR) > 0.4
    assert verdict == "identified" and abs(truth_in_sd(run)) < 3


def test_bad_data_when_a_quarter_of_the_cells_is_missing():
    log = drive()
    holed = spoilt(log, r=np.random.default_rng(0).random(log.samples) < 0.25)
    verdict, run = reasoned(holed)
    assert verdict == "bad_data"
    share = 100 * np.mean(np.isnan(holed.r))
    assert f"{share:.3g} %" in run.reason


def test_outside_population_when_K_is_five_times_the_average():
    verdict, run = reasoned(drive(K=700.0))
    assert verdict == "outside_population"
    assert f"{run.K.value / 145.68:.3g} times" in run.reason


def test_an_unknown_held_by_its_limit_is_named_and_one_that_is_free_is_not():
    done = setup_of(drive(seconds=10), vehicle_prior(vehicle())).run()
    sd = done.output("variance")[-1] ** 0.5

    def held_at(name, side, away):
        library, state = done.setup.library, done.state.copy()
        limit = done.config[library.index("config", f"{name}_{side}")]
        inward = away if side == "low" else -away
        moved = limit + inward if name == "pi1" else limit * np.exp(inward)
        state[library.index("state", name)] = moved
        return edges(dataclasses.replace(done, state=state))

    for side in ("low", "high"):
        assert held_at("K", side, 1.9 * sd) == ("K",)  # its interval reaches the limit
        assert held_at("K", side, 2.0 * sd) == ()
        for name, prior_sd in (("pi1", 0.03), ("eta", 0.13), ("rho", 0.09)):
            assert held_at(name, side, 0.05 * prior_sd) == (name,)
            assert held_at(name, side, 0.2 * prior_sd) == ()


# ---- laws -----------------------------------------------------------------------------------


def _speeding_up(t):
    return 15 + 15 * np.clip(t / 30, 0, 1)


def _braking(t):
    return np.where(t < 20, 30.0, np.maximum(8.0, 30 - 5 * (t - 20)))


@pytest.mark.parametrize("speed", [_speeding_up, _braking])
def test_a_change_of_speed_is_no_change_of_K(speed):
    """Eight cars: inside 2 sd has probability 0.954 each, so six of eight fail once in 300."""
    ends, rows = [], []
    for seed in range(8):
        run = identify(drive(U=speed, seconds=40, rms=0.005, seed=seed), vehicle())
        ends.append(abs(truth_in_sd(run)))
        late = run.trace.t > 10
        rows.append(np.abs(np.log(run.trace.K[late] / CAR["K"])) / run.trace.ln_K_std[late])
    assert sum(end < 2 for end in ends) >= 6
    assert max(ends) < 3.5
    assert np.mean(np.concatenate(rows) < 2) > 0.85


def test_the_unit_of_a_column_is_not_the_cars_business(tmp_path):
    log = drive(seconds=15)
    columns = np.column_stack([log.t, log.delta, log.r, log.U])
    ratio = 15.3
    variants = {
        "si": (columns, ("t [s]", "delta [rad]", "r [rad/s]", "U [m/s]")),
        "deg": (columns * [1e3, 180 / np.pi, 180 / np.pi, 3.6],
                ("t [ms]", "delta [deg]", "r [deg/s]", "U [km/h]")),
        "wheel": (columns * [1e6, ratio * 180 / np.pi, 1e3, 1 / 0.44704],
                  ("t [us]", "steering_wheel [deg]", "r [mrad/s]", "U [mph]")),
    }  # fmt: skip
    car = vehicle(steering_ratio=Uncertain(ratio, None, "-"))
    runs = {}
    for name, (rows, headers) in variants.items():
        path = write(tmp_path, csv_text(rows, headers=headers), f"{name}.csv")
        runs[name] = identify(read_log(path, vehicle=car), car)
    for name in ("deg", "wheel"):
        # conversions cost some 1e-16 a cell; the filter forgets rather than amplifies
        assert runs[name].K.value == pytest.approx(runs["si"].K.value, rel=1e-9)
        assert runs[name].trace.pi3 == pytest.approx(runs["si"].trace.pi3, rel=1e-9)
        assert runs[name].verdict == runs["si"].verdict


def test_a_model_car_is_a_small_car_in_a_quick_film():
    """Lengths times s and times times sqrt(s) with g as it is: pi3 stays, K is s times as large.

    The small population's K is proportional to L, so its prior scales by itself; sensor biases and
    averaging times are those of the sensor and stay, so agreement is statistical, not exact.
    """
    s = 0.14
    car = {"K": 1.22 * 9.80665 * 2.65, "eta": 1.6, "pi1": 0.45, "rho": 0.95}
    full = drive(seconds=40, U=12.0, **car, rms=0.02, noise=0.005)
    small = log_of(full.t * s**0.5, full.delta, full.r / s**0.5, full.U * s**0.5)
    runs = [
        identify(log, Vehicle("car", L=metres(L), population="small_cars_1to10"))
        for log, L in ((full, CAR["L"]), (small, CAR["L"] * s))
    ]
    pi3 = [run.pi3["value"] for run in runs]
    assert runs[1].groups["K"].prior_value == pytest.approx(s * runs[0].groups["K"].prior_value)
    assert abs(np.log(pi3[1] / pi3[0])) < 2 * np.hypot(*(run.trace.ln_K_std[-1] for run in runs))
    for run, K in zip(runs, (car["K"], s * car["K"]), strict=True):
        assert abs(truth_in_sd(run, K)) < 3


def test_turning_left_is_turning_right_and_the_clock_may_start_anywhere():
    log = drive(seconds=15)
    run = identify(log, vehicle())
    mirrored = identify(log_of(log.t, -log.delta, -log.r, log.U), vehicle())
    assert np.array_equal(mirrored.trace.K, run.trace.K)
    assert np.array_equal(mirrored.trace.r_predicted, -run.trace.r_predicted)
    later = identify(log_of(log.t + 1024.0, log.delta, log.r, log.U), vehicle())
    # dt loses 1e-13 s, and the fitted lag is rounded to 0.1 ms, which moves K by a thousandth at most
    assert later.K.value == pytest.approx(run.K.value, rel=1e-3)


# ---- what is said ---------------------------------------------------------------------------


def test_every_number_that_was_not_in_the_log_says_where_it_came_from():
    run = identify(drive(seconds=5), vehicle())
    needed = {"K", "pi1", "eta", "rho", "population", "L", "yaw_rate_noise", "steer_lag", "steer_scale_std"}
    assert needed <= run.assumed.keys()
    assert all(given.origin for given in run.assumed.values())
    assert "from the log" in run.assumed["yaw_rate_noise"].origin
    told = identify(drive(seconds=5), vehicle(yaw_rate_noise=Uncertain(0.003, None, "rad/s")))
    assert told.assumed["yaw_rate_noise"].value == 0.003
    assert told.assumed["yaw_rate_noise"].origin == "vehicle file"


def test_a_late_steer_is_said_and_widens_the_scale():
    run = identify(drive(seconds=60, rms=0.01, lag=0.08), vehicle())
    assert run.lag.chosen == pytest.approx(0.08, abs=0.01)
    assert run.assumed["steer_scale_std"].value == 0.20
    line = next(line for line in run.warnings if "command" in line)
    assert f"{1000 * run.lag.chosen:.0f} ms" in line and "20 %" in line
    assert any("steer scale trade" in line for line in run.warnings)


def test_warnings_of_the_log_come_first():
    log = dataclasses.replace(drive(seconds=5), warnings=("one", "two"))
    assert identify(log, vehicle()).warnings[:2] == ("one", "two")


def test_Caf_only_where_the_mass_is_known():
    assert identify(drive(seconds=5), vehicle()).Caf is None
    run = identify(drive(seconds=5), vehicle(m=Uncertain(1500.0, None, "kg")))
    assert run.Caf.value == pytest.approx(run.K.value * 1500 / CAR["L"])


def test_biases_of_the_sensors_are_found_and_do_not_move_K():
    log = drive(seconds=60)
    biased = log_of(log.t, log.delta + 0.004, log.r + 0.006, log.U)
    run, plain = identify(biased, vehicle()), identify(log, vehicle())
    assert abs(truth_in_sd(run)) < 3
    assert abs(np.log(run.K.value / plain.K.value)) < plain.trace.ln_K_std[-1]
    # At one speed only their sum shows: bias plus gain times offset. A minute's mean of the gusts,
    # 1 mrad that lasts 1.2 s, is 1 mrad sqrt(2.4/60) = 0.2 mrad of steer; three of these.
    gain = run.handling["yaw_rate_gain"]["value"]
    bias, offset = run.nuisance["yaw_bias"].value, run.nuisance["steer_offset"].value
    assert bias + gain * offset == pytest.approx(0.006 - gain * 0.004, abs=gain * 6e-4)


@pytest.mark.parametrize("rate", [10, 20, 100])
@pytest.mark.parametrize("seed", range(3))
def test_a_slow_log_of_a_fast_car_is_not_read_too_high(rate, seed):
    """K = 233 at 10 m/s: the yaw motion is over in 60 ms, sooner than a 10 Hz log has its next row."""
    log = drive(seconds=90, U=10.0, K=233.0, rms=0.008, band=(0.15, 1.0), rate=rate, seed=seed)
    run = identify(log, vehicle())
    assert abs(np.log(run.K.value / 233.0)) < 2.6 * run.K.std / run.K.value  # 99 % of honest intervals


@pytest.mark.parametrize("first", [np.nan, 0.0, -47.0])
def test_a_first_row_without_a_speed_costs_that_row_only(first):
    log = drive(seconds=12, rms=0.005)
    speed = log.U.copy()
    speed[0] = first
    whole, spoilt_one = identify(log, vehicle()), identify(dataclasses.replace(log, U=speed), vehicle())
    apart = np.abs(np.log(spoilt_one.trace.K / whole.trace.K)) / whole.trace.ln_K_std
    # two seconds in they differ by less than they know, ten seconds later by next to nothing
    assert apart[200:].max() < 1
    assert apart[-1] < 0.2
