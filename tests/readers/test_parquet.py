"""Parquet logs: the same numbers as in CSV, any number type, and a cut file is refused."""

import datetime
import decimal

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from similitude.errors import LogError
from similitude.readers import open_table


@pytest.fixture
def write(tmp_path):
    def written(columns, name="drive.parquet"):
        path = tmp_path / name
        pq.write_table(pa.table(columns), path)
        return path

    return written


@pytest.mark.parametrize("kind", [pa.float64(), pa.float32(), pa.int8(), pa.uint32(), pa.decimal128(9, 2)])
def test_any_number_type_becomes_float64_with_nan_for_null(write, kind):
    values = [decimal.Decimal(1) if pa.types.is_decimal(kind) else 1, None, None]
    path = write({"t [s]": pa.array([0.0, 1.0, 2.0]), "r [deg/s]": pa.array(values, kind)})

    (column,) = open_table(path).load([1]).columns

    assert column.dtype == np.float64
    np.testing.assert_array_equal(column, [1.0, np.nan, np.nan])


def test_columns_are_taken_by_position_and_headers_keep_their_units(write):
    path = write({"note": ["a", "b"], "U [km/h]": [1.0, 2.0], "t [s]": [0.0, 0.1]})

    table = open_table(path)

    assert table.headers == ("note", "U [km/h]", "t [s]")
    np.testing.assert_array_equal(table.load([2, 1]).columns, [[0.0, 0.1], [1.0, 2.0]])


@pytest.mark.parametrize(
    ("values", "kind"), [(["a", "b"], "string"), ([datetime.time(12), datetime.time(13)], "time")]
)
def test_what_is_no_number_is_refused_with_column_and_type(write, values, kind):
    path = write({"t": values})

    with pytest.raises(LogError, match=f"column 't' of drive.parquet holds {kind}"):
        open_table(path).load([0])


def test_a_date_becomes_seconds_since_1970_and_is_known_as_a_clock(write):
    start = datetime.datetime(2024, 5, 1, 12, tzinfo=datetime.UTC)
    table = open_table(write({"t": [start, start + datetime.timedelta(seconds=0.25)], "r [deg/s]": [1, 2]}))

    assert [table.is_clock(position) for position in (0, 1)] == [True, False]
    assert table.load([0]).columns[0].tolist() == [1714564800.0, 1714564800.25]


@pytest.mark.parametrize("share", [0.1, 0.5, 0.99])
def test_a_cut_file_is_refused(write, share):
    path = write({"t [s]": np.arange(1000.0)})
    raw = path.read_bytes()
    path.write_bytes(raw[: int(share * len(raw))])

    with pytest.raises(LogError, match=r"drive\.parquet is cut off"):
        open_table(path)


def test_a_damaged_page_is_refused(write):
    path = write({"t [s]": np.random.default_rng(0).normal(size=1000)})
    raw = bytearray(path.read_bytes())
    raw[4:200] = bytes(196)
    path.write_bytes(raw)

    with pytest.raises(LogError, match="damaged Parquet"):
        open_table(path).load([0])
