"""One fuzzed process: bytes become a log file, a Parquet table or a vehicle file, and are read.

Invariant: whatever the bytes, reading ends in a `Log`, a `Vehicle` or a `SimilitudeError` with its four
parts, within seconds, without a warning from a library and without more memory than the file explains.
"""

from __future__ import annotations

import os
import sys
import tempfile
import warnings
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["similitude"]):
    import similitude.log
    import similitude.log_survey
    import similitude.vehicle_file

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from similitude.errors import SimilitudeError
from similitude.log_fixes import FIXES
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

CAR = Vehicle("fuzzed", L=Uncertain(2.7, None, "m"), steering_ratio=Uncertain(15.0, None, "1"))
FOLDER = Path(tempfile.mkdtemp(prefix="similitude-fuzz-"))
TYPES = (pa.float64(), pa.float32(), pa.int64(), pa.int8(), pa.string(), pa.bool_(), pa.timestamp("us"))
NAMES = ("t [s]", "t [ms]", "delta [rad]", "steering_wheel [deg]", "r [rad/s]", "r [deg/s]", "U [m/s]")


def read_text(data: bytes) -> None:
    """The bytes are the file."""
    path = FOLDER / "log.csv"
    path.write_bytes(data)
    _read(path)


def read_parquet(data: bytes) -> None:
    """The bytes say what columns a Parquet table has; now and then they are the file, or spoil it."""
    given = atheris.FuzzedDataProvider(data)
    path = FOLDER / "log.parquet"
    if given.ConsumeIntInRange(0, 9) == 0:
        path.write_bytes(b"PAR1" + given.ConsumeBytes(given.remaining_bytes()))
        return _read(path)
    rows = given.ConsumeIntInRange(0, 60)
    arrays, names = [], []
    for _ in range(given.ConsumeIntInRange(0, 6)):
        known = given.ConsumeBool()
        names.append(given.PickValueInList(list(NAMES)) if known else given.ConsumeUnicodeNoSurrogates(20))
        arrays.append(_column(given, rows))
    pq.write_table(pa.Table.from_arrays(arrays, names=names), path)
    if given.ConsumeIntInRange(0, 3) == 0:
        whole = bytearray(path.read_bytes())
        for _ in range(given.ConsumeIntInRange(1, 8)):
            whole[given.ConsumeIntInRange(0, len(whole) - 1)] = given.ConsumeIntInRange(0, 255)
        path.write_bytes(bytes(whole[: given.ConsumeIntInRange(0, len(whole))]))
    _read(path)


def _column(given: atheris.FuzzedDataProvider, rows: int) -> pa.Array:
    """A column that is a ramp, a wave or noise, in any type, with some cells spoilt."""
    base = (np.arange(rows) * 0.01, np.sin(np.arange(rows)), np.arange(rows) % 7 - 3.0)
    values = base[given.ConsumeIntInRange(0, 2)] * 10.0 ** given.ConsumeIntInRange(-3, 9)
    for _ in range(given.ConsumeIntInRange(0, 4)):
        if rows:
            values[given.ConsumeIntInRange(0, rows - 1)] = given.ConsumeFloat()
    wanted = TYPES[given.ConsumeIntInRange(0, len(TYPES) - 1)]
    array = pa.array(values, from_pandas=True)
    if pa.types.is_timestamp(wanted):  # only whole numbers become a time
        array = array.cast(pa.int64(), safe=False)
    return array.cast(wanted, safe=False)


def read_signals(data: bytes) -> None:
    """The bytes spoil a drive that is long enough for all that judges signals, and every repair is made."""
    given = atheris.FuzzedDataProvider(data)
    rows = given.ConsumeIntInRange(100, 1200)
    t = np.arange(rows) * 10.0 ** given.ConsumeIntInRange(-3, 0)
    steer = 0.02 * np.sin(0.7 * t) + 0.01 * np.sin(2.9 * t)
    columns = {"t [s]": t, "delta [rad]": steer, "r [rad/s]": 4.0 * steer, "U [m/s]": 20.0 + np.cos(0.2 * t)}
    names = list(columns)
    for _ in range(given.ConsumeIntInRange(0, 12)):
        column = columns[given.PickValueInList(names)]
        first, last = sorted(given.ConsumeIntInRange(0, rows) for _ in range(2))
        _spoil(given, column[first:last])
    path = FOLDER / "signals.parquet"
    pq.write_table(pa.table(columns), path)
    _read(path)
    _must_end(lambda: similitude.log_survey.survey(path, vehicle=CAR, fixes=tuple(FIXES)))


def _spoil(given: atheris.FuzzedDataProvider, part: np.ndarray) -> None:
    """Hold, cut, round, shift, scale, empty or overwrite a stretch of a column, in place."""
    if not part.size:
        return
    size = given.ConsumeFloat() if given.ConsumeBool() else 10.0 ** given.ConsumeIntInRange(-6, 6)
    with np.errstate(all="ignore"):
        changed = (
            lambda: np.full(part.size, part[0]),
            lambda: np.clip(part, -abs(size), abs(size)),
            lambda: np.round(part / size) * size,
            lambda: part + size,
            lambda: part * size,
            lambda: np.where(
                np.arange(part.size) % (1 + int(np.nan_to_num(min(abs(size), 9.0)))), np.nan, part
            ),
            lambda: np.repeat(part[::5], 5)[: part.size],
            lambda: part[::-1].copy(),
            lambda: np.full(part.size, size),
        )
        part[:] = changed[given.ConsumeIntInRange(0, len(changed) - 1)]()


def read_vehicle(data: bytes) -> None:
    """The bytes are a vehicle file."""
    path = FOLDER / "car.toml"
    path.write_bytes(data)
    _must_end(lambda: similitude.vehicle_file.read_vehicle(path))


def _read(path: Path) -> None:
    _must_end(lambda: similitude.log.read_log(path, vehicle=CAR))
    _must_end(lambda: similitude.log_survey.survey(path))


def _must_end(action) -> None:
    """Run it; only an error of ours, complete in its four parts, may come out."""
    try:
        action()
    except SimilitudeError as error:
        for part in (error.what, error.usually, error.paste, error.read):
            assert part.strip(), f"a part is missing: {error!r}"
        assert "nvalid input" not in str(error)


TARGETS = {"text": read_text, "signals": read_signals, "parquet": read_parquet, "vehicle": read_vehicle}


def main() -> None:
    """`python -m fuzz.target text|signals|parquet|vehicle <options of libFuzzer>`."""
    warnings.simplefilter("error")
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    pa.set_cpu_count(1)
    atheris.Setup([sys.argv[0], *sys.argv[2:]], TARGETS[sys.argv[1]])
    atheris.Fuzz()


if __name__ == "__main__":
    main()
