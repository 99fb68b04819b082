"""The estimate at every sample as a Parquet table, the contract other programs rely on.

Invariant: one row for each row of the log, no null and no NaN, and the columns below in this order.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np
import pyarrow
import pyarrow.parquet

from similitude.status import STATUS

if TYPE_CHECKING:
    from similitude.run import Run

Z95 = 1.96  # half-width of a 95 % interval in standard deviations [-]
WIDEST = 300.0  # exponent at which an interval ends: exp(300) = 1e130 stands for "anything"


def estimate_table(run: Run) -> pyarrow.Table:
    """Tabulate K, its interval, pi3 and the status over the log.

    Math: K_std = K sd(ln K),  K_lo, K_hi = K exp(-+1.96 sd(ln K)),  Caf = K m / L.

    Parameters
    ----------
    run : Run
        A finished identification of n samples.

    Returns
    -------
    pyarrow.Table
        (n,) rows: `t [s]`, `K [m^2/s^2]`, `K_std [m^2/s^2]`, `K_lo [m^2/s^2]`, `K_hi [m^2/s^2]`,
        `pi3 [-]`, `pi3_std [-]`, `Caf [N/rad]` when the vehicle's m and L are known, `status`.
    """
    trace = run.trace
    half_width = np.minimum(Z95 * trace.ln_K_std, WIDEST)
    columns = {
        "t [s]": trace.t,
        "K [m^2/s^2]": trace.K,
        "K_std [m^2/s^2]": trace.K * trace.ln_K_std,
        "K_lo [m^2/s^2]": trace.K * np.exp(-half_width),
        "K_hi [m^2/s^2]": trace.K * np.exp(half_width),
        "pi3 [-]": trace.pi3,
        "pi3_std [-]": trace.pi3_std,
    }
    if run.vehicle.m is not None and run.vehicle.L is not None:
        columns["Caf [N/rad]"] = trace.K * (run.vehicle.m.value / run.vehicle.L.value)
    arrays = {name: pyarrow.array(np.asarray(y, np.float64)) for name, y in columns.items()}
    return pyarrow.table({**arrays, "status": _status_names(trace.status)})


def write_estimate(run: Run, path: str | os.PathLike[str]) -> None:
    """Write the estimate table as Parquet.

    Parameters
    ----------
    run : Run
        A finished identification.
    path : path
        File to create or replace.

    Raises
    ------
    OSError
        The file cannot be written.
    """
    pyarrow.parquet.write_table(estimate_table(run), path, compression="snappy", use_dictionary=["status"])


def _status_names(codes: np.ndarray) -> pyarrow.Array:
    """Names of (n,) status codes; plain strings, so that any reader compares them directly."""
    names = [f"code_{code}" for code in range(max(STATUS.values()) + 1)]
    for name, code in STATUS.items():
        names[code] = name
    return pyarrow.array(np.array(names, object)[np.asarray(codes)], pyarrow.string())
