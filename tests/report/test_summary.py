import json
import math

import numpy as np
import pytest

from similitude.report.summary import json_line, json_page, summary

CONTRACT = {
    "schema", "log", "samples", "duration_s", "estimator", "verdict", "reason", "K", "pi3",
    "groups", "nuisance", "alarms", "prediction", "handling", "warnings", "assumed", "files",
}  # fmt: skip


def _refuse(token):
    raise AssertionError(f"{token} in strict JSON")


def test_every_key_of_the_contract_is_there_with_its_parts(example_run):
    record = json.loads(json_line(summary(example_run(500), {"plot": "a/plot.png"})))
    assert set(record) >= CONTRACT
    assert record["schema"] == 1
    assert set(record["K"]) == {"value", "std", "lo", "hi", "unit"}
    assert record["K"]["unit"] == "m^2/s^2"
    assert set(record["pi3"]) == {"value", "std", "at_speed"}
    assert all({"value", "std", "prior"} <= set(group) for group in record["groups"].values())
    assert all(set(found) == {"value", "std", "unit"} for found in record["nuisance"].values())
    assert all({"value", "from"} <= set(given) for given in record["assumed"].values())
    assert record["assumed"]["L"]["from"] == "vehicle file estate.toml"
    assert record["alarms"] == []
    assert record["files"] == {"plot": "a/plot.png"}
    assert record["prediction"]["horizon_s"] == 1.0


def test_one_log_is_one_line_of_ascii_even_with_strange_text(example_run):
    run = example_run(500)
    run.reason = "π3 fell\u2028and\nrose \N{ICE CUBE}"
    line = json_line(summary(run))
    assert line.isascii()
    assert len(line.splitlines()) == 1
    assert json.loads(line)["reason"] == run.reason


def test_the_file_and_the_line_hold_the_same_object(example_run):
    record = summary(example_run(500), {"plot": "π.png"})
    assert json.loads(json_line(record)) == json.loads(json_page(record)) == record


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, np.float64("nan"), np.float32("inf")])
def test_a_number_that_is_not_finite_is_null_wherever_it_sits(example_run, bad):
    run = example_run(500)
    run.K.std = bad
    run.groups["eta"].std = bad
    run.prediction["rms"]["estimate"] = bad
    run.handling["yaw_rate_gain"]["hi"] = bad
    run.pi3["std"] = bad
    run.lag.cost = np.array([1.0, float(bad), 2.0])
    run.assumed["L"].value = bad
    line = json_line(summary(run))
    record = json.loads(line, parse_constant=_refuse)
    assert record["K"]["std"] is None
    assert record["groups"]["eta"]["std"] is None
    assert record["prediction"]["rms"]["estimate"] is None
    assert record["handling"]["yaw_rate_gain"]["hi"] is None
    assert record["lag"]["cost"] == [1.0, None, 2.0]
    assert record["assumed"]["L"]["value"] is None


def test_numpy_numbers_and_truths_come_out_as_plain_ones(example_run):
    run = example_run(500)
    run.prediction = {"horizon_s": np.float32(1.0), "windows": np.int64(59), "fair": np.bool_(True)}
    assert summary(run)["prediction"] == {"horizon_s": 1.0, "windows": 59, "fair": True}


def test_without_mass_there_is_no_stiffness(example_run):
    assert summary(example_run(500, with_mass=False))["Caf"] is None
