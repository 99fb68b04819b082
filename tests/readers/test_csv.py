"""CSV as loggers and spreadsheets write it; what is broken is refused with row and column."""

import numpy as np
import pytest

from similitude.errors import LogError
from similitude.readers import open_table

HEADER = "t [s],r [deg/s],U [m/s],note\n"
ROWS = "".join(f"{0.01 * k:.2f},{k % 7 - 3}.5,20,a\n" for k in range(30))


@pytest.fixture
def load(tmp_path):
    def loaded(text, positions=(0, 1)):
        path = tmp_path / "drive.csv"
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        return open_table(path).load(positions)

    return loaded


def test_columns_come_in_the_order_asked_for_with_nan_where_missing(load):
    loaded = load("a,b,c\n1,,x\n 2 ,NaN,y\n3, n/a,z\n4,5e-1,\n", (1, 0))

    np.testing.assert_array_equal(loaded.columns[0], [np.nan, np.nan, np.nan, 0.5])
    np.testing.assert_array_equal(loaded.columns[1], [1, 2, 3, 4])
    assert loaded.findings == ()


@pytest.mark.parametrize(
    "raw",
    [
        "a;b\n1,5;2\n-3,25;4\n",
        "a\tb\n1,5\t2\n-3,25\t4\n",
        "a;b\r\n1.5;2\r\n-3.25;4\r\n",
        '"a","b"\n"1.5","2"\n"-3.25","4"\n',
        "\ufeffa,b\n1.5,2\n-3.25,4",
        "sep=;\na;b\n1.5;2\n\n-3.25;4\n",
        "# logged by hand\n\n# a car\na,b\n1.5,2\n-3.25,4\n",
        "# a [1],b [1]\n1.5,2\n-3.25,4\n",
        "a,b\n1.5,2,\n-3.25,4,\n",
        "a,b,\n1.5,2,\n-3.25,4,\n",
        "a|b\r1.5|2\r-3.25|4\r",
        "a,b\n1.5,2\n-3.25,4\n".encode("utf-16"),
        "\N{DEGREE SIGN},b\n+1.5,2\n-3.25,4\n".encode("latin-1"),
    ],
)
def test_one_table_in_many_dialects(load, raw):
    loaded = load(raw, (0, 1))

    np.testing.assert_array_equal(loaded.columns, [[1.5, -3.25], [2, 4]])


def test_text_in_an_unused_column_is_no_fault(load):
    assert load(HEADER + ROWS).columns[0].size == 30


@pytest.mark.parametrize("cut", range(1, 9))
def test_a_last_row_that_was_cut_off_is_dropped_or_whole(load, cut):
    """A cut row either lacks a cell or a digit; what is kept is what the file says."""
    loaded = load("t,r\n0.01,1.5\n0.02,2.5\n0.03,3.5e-2\n"[: -cut - 1])

    assert loaded.columns[0].size in (2, 3)


def test_a_last_row_with_fewer_cells_is_dropped_and_said(load):
    loaded = load(HEADER + ROWS + "0.30,1.5")

    assert loaded.columns[0].size == 30
    assert "last row has 2 of 4 cells and was dropped" in loaded.findings[0].what


def test_a_last_number_that_was_cut_off_is_dropped_and_said(load):
    loaded = load("t,r\n0.01,1.5\n0.02,2.5\n0.03,3.5e-")

    assert loaded.columns[0].tolist() == [0.01, 0.02]
    assert "cut off" in loaded.findings[0].what


REFUSED = {
    "a word": (
        HEADER + ROWS.replace("0.05,2.5", "0.05,off"), r"'r \[deg/s\]' .*data row 6: 'off'", "--fix",
    ),
    "a unit row": ("t,r\ns,deg/s\n0.01,1\n", "line 2 of drive.csv is a second header", "(echo 't [s]"),
    "a word, decimal comma": ("t;r\n0,01;1\n0,02;x\n", "'r'.*data row 2: 'x'", "--fix"),
    "both decimal signs": (
        "t;r\n0,01;1\n0.02;2\n",
        "'0.02' in column 't', data row 2 and '0,01' in column 't', data row 1", "sed",
    ),
    "decimal comma and comma": ("t,r\n0,01,1,5\n0,02,1,5\n", "row 1 .*4 cells.*header 2", "t;r"),
    "a short row inside": ("t,r\n0.01,1\n0.02\n0.03,1\n", "data row 2 .* has 1 cells", "t,r"),
    "a long row at the end": ("t,r\n0.01,1\n0.02,2,3\n", "data row 2 .* has 3 cells", "t,r"),
    "no rows": ("t,r\n", "a header but no rows", ""),
    "no header": ("0.01,1.5\n0.02,2.5\n", "begins with numbers", "t [s]"),
    "blanks between": ("t [s] r [deg/s]\n0.01 1\n", "no comma, semicolon or tab", "sed -E"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_a_broken_table_is_refused_with_row_column_and_value(load, case):
    text, what, paste = REFUSED[case]

    with pytest.raises(LogError, match=what) as caught:
        load(text)

    assert "drive.csv" in caught.value.what
    assert caught.value.paste.startswith(paste)
    assert all([caught.value.usually, caught.value.read])


def test_dates_are_read_as_seconds_beside_numbers(tmp_path):
    path = tmp_path / "drive.csv"
    path.write_text("time;r\n2024-05-01T12:00:00,25Z;1,5\n2024-05-01T12:00:00,50Z;2,5\n")
    table = open_table(path)

    assert [table.is_clock(position) for position in (0, 1)] == [True, False]
    np.testing.assert_array_equal(table.load([0, 1]).columns, [[1714564800.25, 1714564800.5], [1.5, 2.5]])


def test_a_header_that_stands_again_is_known_and_can_be_blanked(load, tmp_path):
    joined = "t,r\n0.01,1\n0.02,2\nt,r\n0.01,1\n"
    with pytest.raises(LogError, match="the header stands there again") as caught:
        load(joined)

    assert caught.value.fault == "header_again"
    loaded = open_table(tmp_path / "drive.csv").load([0, 1], blanked=["header_again"])
    np.testing.assert_array_equal(loaded.columns[0], [0.01, 0.02, np.nan, 0.01])


@pytest.mark.parametrize(("cell", "paste"), [("1,234.5", "python3 -c"), ("#REF!", "--fix blank_text")])
def test_text_in_a_cell_is_named_with_its_row_and_left_out_on_request(load, tmp_path, cell, paste):
    with pytest.raises(LogError, match=f"data row 2: '{cell}' is no number") as caught:
        load(f't,r\n0.01,1\n0.02,"{cell}"\n0.03,3\n')

    assert caught.value.fault == "text_in_cell" and caught.value.paste.startswith(paste)
    loaded = open_table(tmp_path / "drive.csv").load([1], blanked=["text_in_cell"])
    np.testing.assert_array_equal(loaded.columns[0], [1, np.nan, 3])
    assert loaded.findings[0].value == 1
