"""The record of a population: promised keys, strict JSON, nothing invented."""

import json

import numpy as np
import pytest

from similitude.populations.population import populate
from similitude.populations.portrait import portrait_record, portray
from similitude.systems.bicycle import bicycle_groups

from .drawn import planted, table_of


@pytest.fixture(scope="module")
def record():
    values = planted(60, 0)
    values[:, 3] = np.nan
    return portrait_record(portray(populate(bicycle_groups(), table_of(values)), draws=5))


def test_the_record_keeps_its_contract(record):
    assert json.loads(json.dumps(record, allow_nan=False))["rows"] == 60
    assert {"n", "mean_log", "sd_log", "skew_raw", "skew_log"} <= record["groups"]["pi3"].keys()
    assert {"kind", "groups", "coefficients", "interval", "out_of_sample"} <= record["relations"][0].keys()
    assert [one["kind"] for one in record["relations"]] == ["constraint", "line"]


def test_what_nobody_taught_is_null(record):
    assert record["groups"]["pi5"]["mean_log"] is None and record["groups"]["pi5"]["n"] == 0
    matrix, names = record["covariance_log"]["matrix"], record["covariance_log"]["names"]
    assert all(x is None for x in matrix[names.index("pi5")])
    assert matrix[2][2] == pytest.approx(record["groups"]["pi3"]["sd_log"] ** 2)


def test_notes_name_what_was_held_and_where_groups_stand(record):
    assert any("pi5 is told by no row" in note for note in record["notes"])
    assert any("U = 1" in note for note in record["notes"])
