"""A survey never raises for a fault of the file, and keeps what could be read."""

import numpy as np
import pytest

from similitude.errors import LogError, UsageError
from similitude.log import read_log
from similitude.log_survey import survey

from .log_text import HEADERS, csv_text, drive, write


def faults(seen):
    return [one.fault for one in seen.findings if one.certain]


def test_a_sound_log_has_no_finding_and_all_columns(tmp_path):
    seen = survey(write(tmp_path, csv_text(drive())))

    assert seen.findings == ()
    assert seen.headers == HEADERS
    assert {name: column.header for name, column in seen.columns.items()} == dict(
        zip(("t", "delta", "r", "U"), HEADERS, strict=True)
    )
    np.testing.assert_array_equal(seen.values["r"], drive()[:, 2])


def test_every_fault_is_found_and_the_log_refused_with_the_first(tmp_path):
    columns = drive()
    columns[:, 2] *= 1000  # a yaw rate beyond any car's
    columns[:, 0] = 0.0  # and a clock that stood
    path = write(tmp_path, csv_text(columns))

    seen = survey(path)

    assert faults(seen) == ["time_stands", "impossible_unit"]
    assert seen.values["U"].size == 300
    with pytest.raises(LogError) as caught:
        read_log(path)
    assert caught.value.fault == "time_stands"


def test_a_column_without_a_unit_leaves_the_others(tmp_path):
    seen = survey(write(tmp_path, csv_text(drive(), headers=(*HEADERS[:2], "r", HEADERS[3]))))

    assert faults(seen) == ["no_unit"]
    assert seen.values.keys() == {"t", "delta", "U"}


def test_text_in_a_cell_leaves_the_rest_of_the_column(tmp_path):
    text = csv_text(drive()).replace("\n0.02,", "\nlost,", 1)
    seen = survey(write(tmp_path, text))

    assert faults(seen)[0] == "text_in_cell"
    assert np.count_nonzero(np.isnan(seen.values["t"])) == 1
    assert seen.findings[0].fix == "blank_text"


def test_a_file_that_is_no_log_is_a_finding(tmp_path):
    seen = survey(write(tmp_path, b"PK\x03\x04 and so on", "drive.xlsx"))

    assert faults(seen) == ["foreign_format"]
    assert seen.columns == seen.values == {}


def test_a_call_that_cannot_be_carried_out_raises(tmp_path):
    path = write(tmp_path, csv_text(drive()))

    with pytest.raises(UsageError, match="no quantity"):
        survey(path, mapping={"SWA": "delta"})
    with pytest.raises(UsageError, match="is no repair") as caught:
        survey(path, fixes=["sort_times"])
    assert caught.value.paste == "--fix sort_time"


@pytest.mark.parametrize("fault", ["fill_value", "impossible_unit"])
def test_a_lateral_acceleration_that_cannot_be_is_left_out_and_said(tmp_path, fault):
    columns = np.column_stack([drive(), np.sin(np.arange(300.0))])
    columns[20:60:9, 4] = -9999
    if fault == "impossible_unit":
        columns[:, 4] = 100 * np.sin(np.arange(300.0)) * np.linspace(1, 2, 300)
    path = write(tmp_path, csv_text(columns, headers=(*HEADERS, "ay [m/s^2]")))

    log = read_log(path)

    (found,) = log.findings
    assert (found.fault, found.certain) == (fault, False) and "ay is not used" in found.what
    assert log.ay is None
    if fault == "fill_value":
        mended = read_log(path, fixes=[found.fix])
        assert mended.findings[0].fault == "cells_missing" and np.isnan(mended.ay).sum() == 5
