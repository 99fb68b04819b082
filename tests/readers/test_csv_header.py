"""A header that is not in the first line, or in two: the command to paste writes the table that is meant."""

import subprocess

import numpy as np
import pytest

from similitude.errors import LogError
from similitude.log import read_log
from similitude.log_survey import survey

from ..log_text import HEADERS, csv_text, drive

TABLE = drive(250)
NAMES = [header.split(" [")[0] for header in HEADERS]
UNITS = [header.split("[")[1].rstrip("]") for header in HEADERS]
PLAIN = csv_text(TABLE)
BODY = PLAIN.split("\n", 1)[1]
LINE = ",".join(HEADERS)

TABLES = {
    "facts above": ("Logger: X-12\nDate: 2026-10-25\n\n" + PLAIN, "late_header"),
    "facts in two cells": ("Device;X12\nSerial;0815\n" + csv_text(TABLE, separator=";"), "late_header"),
    "facts as wide as the table": ('"Racing File",,,\n"Venue","x",,\n' + PLAIN, "late_header"),
    "facts and units": ("Logger X-12\n" + ",".join(NAMES) + "\n" + ",".join(UNITS) + "\n" + BODY,
                        "second_header"),
    "units below": (",".join(NAMES) + "\n" + ",".join(UNITS) + "\n" + BODY, "second_header"),
    "units in square brackets": (",".join(NAMES) + "\n" + ",".join(f"[{one}]" for one in UNITS) + "\n" + BODY,
                                 "second_header"),
    "units in round brackets": (",".join(NAMES) + "\n" + ",".join(f"({one})" for one in UNITS) + "\n" + BODY,
                                "second_header"),
    "semicolons": (";".join(NAMES) + "\n" + ";".join(UNITS) + "\n"
                   + csv_text(TABLE, separator=";", decimal=",").split("\n", 1)[1], "second_header"),
    "blanks": (csv_text(TABLE, separator=" "), "no_header"),
    "many blanks": (csv_text(TABLE, separator="    "), "no_header"),
    "colons": (csv_text(TABLE, separator=":"), "no_header"),
}  # fmt: skip


@pytest.mark.parametrize("kind", TABLES)
def test_the_command_that_is_proposed_writes_a_table_that_can_be_read(tmp_path, monkeypatch, kind):
    text, fault = TABLES[kind]
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a drive.csv").write_text(text)
    with pytest.raises(LogError) as refused:
        read_log("a drive.csv")

    assert refused.value.fault == fault
    subprocess.run(refused.value.paste, shell=True, check=True)
    log = read_log("table.csv")

    np.testing.assert_array_equal(np.column_stack([log.t, log.delta, log.r, log.U]), TABLE)


@pytest.mark.parametrize(
    "text",
    [
        LINE + "\nnan,nan,nan,nan\n" + BODY,
        LINE + ",note\n" + BODY.replace("\n", ",straight\n"),
        LINE + ",who,where,why\n" + BODY.replace("\n", ",a,b,c\n"),
        "# X-12\n" + PLAIN,
    ],
)
def test_a_header_in_the_first_line_is_let_alone(tmp_path, text):
    path = tmp_path / "drive.csv"
    path.write_text(text)

    try:
        read_log(path)
    except LogError as error:
        assert error.fault not in ("late_header", "second_header")


@pytest.mark.parametrize("kind", [kind for kind in TABLES if TABLES[kind][1] != "no_header"])
def test_who_only_looks_sees_the_table_that_is_meant(tmp_path, kind):
    text, fault = TABLES[kind]
    (tmp_path / "drive.csv").write_text(text)

    seen = survey(tmp_path / "drive.csv")

    assert [one.fault for one in seen.certain] == [fault]
    np.testing.assert_array_equal(
        np.column_stack([seen.values[name] for name in ("t", "delta", "r", "U")]), TABLE
    )
