"""The content of a file decides its reader; what is no log is named."""

import os
import shutil

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from similitude.errors import LogError
from similitude.readers import open_table


def test_a_parquet_file_with_another_name_is_read_and_said(tmp_path):
    pq.write_table(pa.table({"t [s]": np.arange(3.0)}), tmp_path / "drive.csv")

    table = open_table(tmp_path / "drive.csv")

    assert table.headers == ("t [s]",)
    assert "is Parquet" in table.findings[0].what


def test_text_named_parquet_is_read_and_said(tmp_path):
    (tmp_path / "drive.parquet").write_text("t,r\n1,2\n")

    table = open_table(tmp_path / "drive.parquet")

    assert table.headers == ("t", "r")
    assert "is text" in table.findings[0].what


@pytest.mark.parametrize(
    ("raw", "what"),
    [
        (b"", "is empty"),
        (b"\r\n \n", "is empty"),
        (bytes(5000), "is empty"),
        (b"PK\x03\x04....", "ZIP archive or Excel workbook"),
        (b"\x1f\x8b....", "compressed with gzip"),
        (b"MDF     4.10", "an MDF measurement"),
        (b"\x89HDF\r\n\x1a\n", "an HDF5"),
        (b"abc\x00\x01\x02", "holds zero bytes"),
    ],
)
def test_what_is_no_log_is_named(tmp_path, raw, what):
    path = tmp_path / "drive.csv"
    path.write_bytes(raw)

    with pytest.raises(LogError, match=what) as caught:
        open_table(path)

    assert "drive.csv" in caught.value.what


def test_a_parquet_file_without_its_beginning_is_called_damaged(tmp_path):
    path = tmp_path / "drive.parquet"
    path.write_bytes(b"\x15\x00\x00\x00PAR1")

    with pytest.raises(LogError, match="damaged at its start"):
        open_table(path)


@pytest.mark.parametrize("name", ["none.csv", ".", "a\x00b"])
def test_what_cannot_be_opened_is_named(tmp_path, name):
    with pytest.raises(LogError, match="cannot be opened"):
        open_table(tmp_path / name)


def test_a_log_that_vanishes_between_two_reads_is_refused(tmp_path, monkeypatch):
    folder = tmp_path / "stick"
    folder.mkdir()
    (folder / "drive.csv").write_text("t,r\n1,2\n")
    monkeypatch.setattr("similitude.readers._refuse_foreign", lambda *_: shutil.rmtree(folder))

    with pytest.raises(LogError, match="cannot be read"):
        open_table(folder / "drive.csv")


def test_a_pipe_is_refused_instead_of_waited_for(tmp_path):
    os.mkfifo(tmp_path / "drive.csv")

    with pytest.raises(LogError, match="a pipe or a device"):
        open_table(tmp_path / "drive.csv")


def test_a_line_without_end_is_no_header(tmp_path):
    (tmp_path / "drive.csv").write_bytes(b"t [s]," * 200_000)

    with pytest.raises(LogError, match="1200000 characters"):
        open_table(tmp_path / "drive.csv")


def test_a_small_parquet_file_that_claims_too_many_cells_is_refused_unread(tmp_path, monkeypatch):
    pq.write_table(pa.table({"t [s]": np.zeros(1000)}), tmp_path / "drive.parquet")
    monkeypatch.setattr("similitude.readers.parquet.MOST_CELLS", 999)

    with pytest.raises(LogError, match="1000 rows of 1 columns"):
        open_table(tmp_path / "drive.parquet")
