"""Text in cells: a repair where it costs little, a command where a whole column is written otherwise."""

import subprocess

import numpy as np
import pytest

from similitude.errors import LogError
from similitude.log import read_log

from ..log_text import HEADERS, csv_text, drive

TABLE = drive(2200)
IN_MS = ("t [ms]", *HEADERS[1:])


def _rows(cells, separator, headers=IN_MS):
    """Rows whose time is written by `cells`, with a decimal comma where columns are parted otherwise."""
    plain = csv_text(TABLE, separator=separator, decimal="." if separator == "," else ",").splitlines()[1:]
    return "\n".join([separator.join(headers), *(
        separator.join([cell, *row.split(separator)[1:]]) for cell, row in zip(cells, plain, strict=True)
    )]) + "\n"  # fmt: skip


MS = [f"{1000 * t:,.1f}" for t in TABLE[:, 0]]
WHOLE = {
    "English thousands": _rows([f'"{one}"' for one in MS], ","),
    "German thousands": _rows([one.translate(str.maketrans(",.", ".,")) for one in MS], ";"),
    "units in the cells": _rows([f"{1000 * t:.1f} ms" for t in TABLE[:, 0]], ","),
}


@pytest.mark.parametrize("kind", WHOLE)
def test_the_command_for_a_whole_column_writes_numbers(tmp_path, monkeypatch, kind):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "drive.csv").write_text(WHOLE[kind])
    with pytest.raises(LogError) as refused:
        read_log("drive.csv")

    assert refused.value.fault == "text_in_cell" and "--fix" not in refused.value.paste
    subprocess.run(refused.value.paste, shell=True, check=True)
    log = read_log("table.csv")

    np.testing.assert_allclose(log.t, TABLE[:, 0], atol=1e-4)
    np.testing.assert_array_equal(log.r, TABLE[:, 2])


def test_text_in_few_cells_may_be_left_empty_and_text_in_all_of_them_may_not(tmp_path):
    few = csv_text(TABLE).replace("\n0.5,", "\n?!,")
    every = csv_text(TABLE).replace(",-", ",0x")
    for text, repairable in ((few, True), (every, False)):
        path = tmp_path / "drive.csv"
        path.write_text(text)
        with pytest.raises(LogError) as refused:
            read_log(path)
        assert refused.value.fault == "text_in_cell"
        assert (refused.value.paste == "--fix blank_text") is repairable


def test_the_minus_of_typesetters_is_a_minus(tmp_path):
    path = tmp_path / "drive.csv"
    path.write_text(csv_text(TABLE).replace("-", "\N{MINUS SIGN}"), encoding="utf-8")

    np.testing.assert_array_equal(read_log(path).r, TABLE[:, 2])


def test_a_date_that_changes_in_the_order_of_a_country_is_refused(tmp_path):
    path = tmp_path / "drive.csv"
    days = ["03.04.2026 23:59:59.50" if k < 50 else "04.04.2026 00:00:00.50" for k in range(len(TABLE))]
    path.write_text(_rows(days, ";", ("time", *HEADERS[1:])))

    with pytest.raises(LogError, match="2 dates") as refused:
        read_log(path)

    assert refused.value.fault == "date_order"
