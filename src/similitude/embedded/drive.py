"""Samples for the self-test of an exported estimator: a short drive, then all that can go wrong.

Invariant: the rows are the same on every machine: no clock, no library whose last digit differs.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.configuration import find_numbers
from similitude.embedded.system import Source, find_source
from similitude.program.library import Library

CLEAN, AFTER = 96, 48  # samples before and after the faults
FED = 4  # fields of a sample that the monitor shares with its filter


def self_test_rows(source: Source, library: Library, config: NDArray, sample_time: float) -> NDArray:
    """Rows (n, sample fields) of the self-test, in SI units.

    Parameters
    ----------
    config : the flat configuration, of which the limits are read.
    sample_time : [s].
    """
    fed = source.estimator == "monitor"
    names = library.names("sample")
    taken = names[:FED] if fed else names  # the rest of a monitor's sample is what its filter hands out
    rows = _excited(library, config, sample_time, taken)
    rows = np.vstack([rows[:CLEAN], _faults(rows[CLEAN - 1], taken), rows[CLEAN:]])
    return monitored(rows, names) if fed else rows


def _limit(library: Library, config: NDArray, name: str, otherwise: float) -> float:
    if name not in library.names("config"):
        return otherwise
    return float(config[library.index("config", name)])


def _excited(library: Library, config: NDArray, sample_time: float, names: list[str]) -> NDArray:
    """A weave of input, and outputs of a first-order lag behind it with a little noise."""
    n = CLEAN + AFTER
    input_limit = _limit(library, config, "input_limit", 1.0)
    limits = {  # of what is measured: "measured" the first output, "NAME_measured" another
        k: _limit(library, config, f"{name.removesuffix('measured') or 'output_'}limit", 10.0)
        for k, name in enumerate(names)
        if name.endswith("measured")
    }
    signals = [k for k in range(2, len(names)) if k not in limits]
    signal_limit = _limit(library, config, "signal_limit", 1.0)
    rows = np.zeros((n, len(names)))
    seed, lagged = 1, 0.0
    for k in range(n):
        seed = (1103515245 * seed + 12345) % 2**31
        noise = seed / 2**31 - 0.5
        weave = _triangle(k / 29.0) + 0.5 * _triangle(k / 11.0)
        lagged += 0.25 * (weave - lagged)
        rows[k, 0] = sample_time
        rows[k, 1] = 0.03 * input_limit * weave
        rows[k, signals] = signal_limit * (0.1 + 0.04 * (k // 8) / (n / 8))
        for j, limit in limits.items():
            rows[k, j] = limit * (0.02 * lagged + 0.0003 * noise)
    return rows


def _triangle(x: float) -> float:
    """A triangle wave of period one between -1 and 1; exact arithmetic only."""
    x = x % 1.0
    return 4 * x - 1 if x < 0.5 else 3 - 4 * x


def _faults(last: NDArray, names: list[str]) -> NDArray:
    """Rows in which one field after another is missing, infinite, impossible or late."""
    rows = []
    for k in range(len(names)):
        for value in (np.nan, np.inf, -np.inf, 1e30, -1e30, 0.0):
            row = last.copy()
            row[k] = value
            rows.append(row)
    rows.append(np.full(len(names), np.nan))
    late = last.copy()
    late[0] = 30.0  # s: beyond every gap
    return np.vstack([*rows, late])


def monitored(rows: NDArray, names: list[str]) -> NDArray:
    """The monitor's rows: the filter's samples (n, 4), its status, and what it handed out.

    Parameters
    ----------
    names : of the fields of a monitor's sample.
    """
    source = find_source("bicycle", "population")
    library = source.library()
    config = find_numbers(source, vehicle=None, sample_time=None).values
    with np.errstate(all="ignore"):
        outputs, status = library.run(config, library.start(config), rows)
    handed = [outputs[:, library.index("output", name)] for name in names[FED + 1 :]]
    return np.column_stack([rows, status.astype(float), *handed])
