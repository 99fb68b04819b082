"""A log is the same physical drive however it is written down."""

import gc
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from similitude.errors import LogError, SimilitudeError
from similitude.log import read_log
from similitude.units import ACCELERATION, parse_uncertain, parse_unit
from similitude.vehicle_file import Vehicle

from .log_text import HEADERS, csv_text, drive, write

DATA = Path(__file__).parents[1] / "data"
REAL = ["bmw_m8_double_lane_change", "rav4_straight", *(f"f1tenth_ds{n}" for n in range(1, 6))]
CAR = Vehicle("car", L=parse_uncertain("2.7 m"), steering_ratio=parse_uncertain("15.3 1"))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("logs")


@pytest.mark.parametrize("name", REAL)
def test_real_logs_are_read_as_they_are(name):
    path = DATA / f"{name}.csv"
    raw = np.genfromtxt(path, delimiter=",", skip_header=1)
    units = [header.split("[")[1].rstrip("]\r\n") for header in open(path).readline().split(",")]

    log = read_log(path)

    assert log.samples == len(raw)
    expected = [ACCELERATION if unit == "g" else None for unit in units]
    factors = [parse_unit(u, expect=e).factor for u, e in zip(units, expected, strict=True)]
    for at, name in enumerate(["t", "delta", "r", "U", "ay"][: raw.shape[1]]):
        np.testing.assert_array_equal(getattr(log, name), raw[:, at] * factors[at])
    assert log.rate == pytest.approx(100.0 if "bmw" in path.name else 50.0, rel=1e-9)
    assert log.duration == log.t[-1] - log.t[0]


TIMES, ANGLES = ["s", "ms", "us", "min"], ["rad", "deg", "mrad", "°"]
RATES = ["rad/s", "deg/s", "mrad/s", "dps", "°/s"]
SPEEDS = ["m/s", "km/h", "mph", "kn", "ft/s"]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=40)
@given(
    st.tuples(*map(st.sampled_from, (TIMES, ANGLES, RATES, SPEEDS))),
    st.permutations(range(4)),
    st.sampled_from([",", ";", "\t"]),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from(["", "\ufeff"]),
)
def test_unit_order_separator_and_line_end_change_no_si_value(folder, units, order, separator, end, mark):
    columns = drive()
    written = columns / [parse_unit(unit).factor for unit in units]
    names = [f"{header.split()[0]} [{unit}]" for header, unit in zip(HEADERS, units, strict=True)]
    decimal = "," if separator != "," else "."
    text = csv_text(
        written[:, order],
        headers=[names[at] for at in order],
        separator=separator,
        decimal=decimal,
        end=end,
    )

    log = read_log(write(folder, mark + text))

    # one division, one printed and one multiplied rounding: 3 half ulps
    for name, column in zip(("t", "delta", "r", "U"), columns.T, strict=True):
        np.testing.assert_allclose(getattr(log, name), column, rtol=4e-16, atol=0)


def test_steering_wheel_is_divided_by_the_ratio_of_the_vehicle(folder):
    columns = drive()
    wheel = columns * [1, 15.3 * 180 / np.pi, 1, 1]
    headers = ("t [s]", "SWA [deg]", "yaw rate [rad/s]", "speed [m/s]")
    path = write(folder, csv_text(wheel, headers=headers))

    log = read_log(path, vehicle=CAR)

    np.testing.assert_allclose(log.delta, columns[:, 1], rtol=1e-15)
    assert log.sources["delta"] == "SWA [deg] / 15.3"
    with pytest.raises(LogError, match=r"'SWA \[deg\]'.*steering ratio is needed"):
        read_log(path)
    with pytest.raises(LogError, match="the vehicle file states none"):
        read_log(path, vehicle=Vehicle("car", L=CAR.L))


def test_a_mapped_column_is_taken_as_it_is(folder):
    headers = ("t [s]", "SWA [rad]", "r [rad/s]", "U [m/s]")
    path = write(folder, csv_text(drive(), headers=headers))

    log = read_log(path, mapping={"delta": "SWA"})

    np.testing.assert_array_equal(log.delta, drive()[:, 1])
    assert log.sources["delta"] == "SWA [rad] (--map)"


def test_missing_cells_and_infinities_are_nan_and_are_counted(folder):
    columns = drive()
    columns[5:9, 2] = np.nan
    columns[7, 3] = np.inf
    text = csv_text(columns).replace("nan", "")

    log = read_log(write(folder, text))

    assert np.flatnonzero(np.isnan(log.r)).tolist() == [5, 6, 7, 8]
    assert np.flatnonzero(np.isnan(log.U)).tolist() == [7]
    assert any("'r [rad/s]': 4 of 300" in said and "row 6" in said for said in log.warnings)


def test_a_stuck_lateral_acceleration_is_left_out_and_said(folder):
    columns = np.column_stack([drive(), np.full(300, 0.5)])
    path = write(folder, csv_text(columns, headers=(*HEADERS, "ay [g]")))

    log = read_log(path)

    assert log.ay is None
    assert "ay" not in log.sources
    assert any("not used" in said for said in log.warnings)


def test_the_first_warning_and_error_do_not_depend_on_the_run(folder):
    columns = drive()
    columns[3, 1:] = np.nan
    path = write(folder, csv_text(columns))

    said = [warning for warning in read_log(path).warnings if "missing" in warning]

    assert [text.split("'")[1] for text in said] == list(HEADERS[1:])


def test_ten_minutes_at_100_hz_are_read_and_checked_in_150_ms_of_the_processor(folder):
    path = write(folder, csv_text(drive(60_000)))
    read_log(path)
    times = []
    for _ in range(5):
        gc.collect()
        start = time.process_time()
        log = read_log(path, vehicle=CAR)
        times.append(time.process_time() - start)

    assert log.samples == 60_000
    assert min(times) < 0.150


# Fault injection: whatever happens to the bytes, a Log or an error in four parts.
damages = st.lists(
    st.tuples(
        st.sampled_from(["flip", "cut", "insert", "delete", "zero"]),
        st.floats(0, 1),
        st.binary(min_size=1, max_size=12),
    ),
    min_size=1,
    max_size=4,
)


def damaged(raw, damage):
    raw = bytearray(raw)
    for kind, place, junk in damage:
        # Cubed: header and first rows, where meaning is densest, are hit more often.
        at = int(place**3 * max(len(raw) - 1, 0))
        if kind == "flip":
            raw[at : at + len(junk)] = junk
        elif kind == "cut":
            del raw[at:]
        elif kind == "insert":
            raw[at:at] = junk
        elif kind == "delete":
            del raw[at : at + len(junk)]
        else:
            raw[at : at + len(junk)] = bytes(len(junk))
    return bytes(raw)


def read_or_refuse(path):
    try:
        log = read_log(path, vehicle=CAR)
    except SimilitudeError as error:
        assert all([error.what, error.usually, error.paste, error.read])
        assert len(str(error)) < 2000
        return
    assert np.all(np.diff(log.t) > 0)
    for column in (log.t, log.delta, log.r, log.U):
        assert column.dtype == np.float64
        assert column.shape == (log.samples,)
        assert not np.isinf(column).any()


@settings(max_examples=150, suppress_health_check=list(HealthCheck), deadline=None)
@given(damages)
def test_a_damaged_csv_gives_a_log_or_an_error_in_four_parts(folder, damage):
    raw = csv_text(drive(250)[:, :]).encode()

    read_or_refuse(write(folder, damaged(raw, damage), "damaged.csv"))


@pytest.fixture(scope="module")
def parquet_bytes(folder):
    import pyarrow as pa
    import pyarrow.parquet as pq

    path = folder / "sound.parquet"
    pq.write_table(pa.table(dict(zip(HEADERS, drive(250).T, strict=True))), path)
    return path.read_bytes()


@settings(max_examples=150, suppress_health_check=list(HealthCheck), deadline=None)
@given(damages, st.booleans())
def test_a_damaged_parquet_gives_a_log_or_an_error_in_four_parts(folder, parquet_bytes, damage, from_the_end):
    if from_the_end:  # the index of a Parquet file stands at its end
        raw = damaged(parquet_bytes[::-1], damage)[::-1]
    else:
        raw = damaged(parquet_bytes, damage)

    read_or_refuse(write(folder, raw, "damaged.parquet"))


@settings(max_examples=60, suppress_health_check=list(HealthCheck), deadline=None)
@given(st.binary(max_size=400), st.sampled_from(["csv", "parquet", "txt"]))
def test_any_bytes_at_all_give_an_error_in_four_parts(folder, raw, suffix):
    with pytest.raises(SimilitudeError):
        read_log(write(folder, raw, f"noise.{suffix}"))
