"""A whole run of the batch fit: rows, verdicts, the same report as any estimator, real logs."""

import numpy as np
import pytest

from similitude.identification import identify
from similitude.log import read_log
from similitude.report.summary import json_line, summary
from similitude.vehicle_file import read_vehicle

from .simulated_drive import CAR, drive, vehicle
from .test_house import ROOT
from .test_identify_population import ODD_LOGS


@pytest.fixture(scope="module")
def run():
    return identify(drive(seconds=60, rms=0.008), vehicle(), estimator="batch")


def test_K_is_the_same_on_every_row(run):
    assert run.estimator == "batch"
    assert np.all(run.trace.K == run.K.value) and np.ptp(run.trace.ln_K_std) == 0
    assert run.K == run.batch.K
    assert run.verdict == "identified"
    assert abs(np.log(run.K.value / CAR["K"])) < 3 * run.trace.ln_K_std[0]


def test_the_report_has_what_every_report_has(run):
    record = summary(run)
    assert json_line(record)
    assert record["batch"]["value"] == record["K"]["value"]
    assert set(record["nuisance"]) == {"yaw_bias", "steer_offset", "steer_scale", "steer_lag"}
    assert record["prediction"]["ratio_to_batch"] == 1.0
    assert record["prediction"]["ratio_to_frozen"] < 1.0
    assert record["handling"]["understeer_gradient"]["lo"] < record["handling"]["understeer_gradient"]["hi"]


def test_the_filter_is_reported_beside_it(run):
    other = identify(run.log, vehicle())
    assert other.batch.K.value == pytest.approx(run.K.value, rel=1e-9)
    assert other.prediction["ratio_to_batch"] > 0.9
    assert other.K != other.batch.K


def test_a_straight_road_is_not_excited():
    run = identify(drive(seconds=60, rms=1e-5), vehicle(), estimator="batch")
    assert run.verdict == "not_excited"


@pytest.mark.parametrize("what", ODD_LOGS)
def test_odd_logs_give_finite_rows(what):
    run = identify(ODD_LOGS[what](drive(seconds=10)), vehicle(), estimator="batch")
    assert run.trace.K.size == run.log.samples
    for column in (run.trace.K, run.trace.ln_K_std, run.trace.pi3, run.trace.information):
        assert np.isfinite(column).all()
    json_line(summary(run))


@pytest.mark.parametrize(
    ("log", "car"),
    [
        ("rav4_straight", "rav4"),
        ("bmw_m8_double_lane_change", "bmw_m8"),
        *((f"f1tenth_ds{i}", "f1tenth") for i in range(1, 6)),
    ],
)
def test_real_logs(log, car):
    car = read_vehicle(ROOT / "data" / f"{car}.toml")
    read = read_log(ROOT / "data" / f"{log}.csv", vehicle=car)
    run = identify(read, car, estimator="batch")
    assert np.isfinite([run.K.value, run.K.std]).all()
    assert run.prediction["rms"]["batch"] < 1.1 * run.prediction["rms"]["frozen_averages"]
    assert run.batch.widened >= 1
