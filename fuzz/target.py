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


TARGETS = {"text": read_text, "parquet": read_parquet, "vehicle": read_vehicle}


def main() -> None:
    """`python -m fuzz.target text|parquet|vehicle <options of libFuzzer>`."""
    warnings.simplefilter("error")
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    pa.set_cpu_count(1)
    atheris.Setup([sys.argv[0], *sys.argv[2:]], TARGETS[sys.argv[1]])
    atheris.Fuzz()


if __name__ == "__main__":
    main()
