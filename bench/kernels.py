"""The compiled loops that are weighed: generated ones and those of reference.c, ready to call.

Invariant: every loop is compiled by `similitude.program.compile` with the same flags, and writes
into arrays that are made beforehand, so that only its own work is timed.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bench.drives import CAR, NOISE, SMALL_CAR, Drive
from similitude.estimators.paper_design import paper_config
from similitude.filter_config import filter_config
from similitude.population import Prior
from similitude.program.compile import load_library
from similitude.program.library import Library, shipped

REFERENCE = Path(__file__).with_name("reference.c")
FORGETTING = 0.999
P_START = 1e3
# The order of `config` in reference.c, by the generated one's names.
PAPER_ORDER = (
    *("input_ratio", "K_per_theta"),
    *(f"poles_{section}_{i}" for section in (1, 2) for i in range(2)),
    *("theta_start", "normal_start", "normal_least", "forgetting", "dead_zone"),
    *("settle_samples", "noise_variance"),
    *("theta_low", "theta_limit", "variance_limit", "sample_time", "dt_room", "U_least"),
    *("input_limit", "output_limit", "output_jump", "signal_limit", "validity_limit"),
)
_POINTER, _LONG, _DOUBLE = ctypes.c_void_p, ctypes.c_long, ctypes.c_double


@dataclass(frozen=True, eq=False)
class Kernel:
    """A loop over ``samples`` samples; calling ``run`` fills ``result`` (and ``status``)."""

    samples: int
    run: Callable[[], None]
    result: NDArray[np.float64]
    status: NDArray[np.int32] | None = None


@cache
def reference() -> ctypes.CDLL:
    """The library of reference.c."""
    c = load_library(REFERENCE.read_text(encoding="utf-8"), name="bench_reference")
    c.reference_rls.argtypes = [_DOUBLE, _DOUBLE, _LONG, *[_POINTER] * 3]
    c.reference_paper.argtypes = [_POINTER, _LONG, *[_POINTER] * 3]
    c.reference_rls.restype = c.reference_paper.restype = None
    return c


def regression(n: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Regressor and observation, (n,) each, for a scalar least squares whose answer is 0.3."""
    rng = np.random.default_rng(1)
    phi = rng.standard_normal(n)
    return phi, 0.3 * phi + 0.1 * rng.standard_normal(n)


def rls_kernel(phi: NDArray[np.float64], y: NDArray[np.float64]) -> Kernel:
    """The textbook scalar recursive least squares."""
    n, theta = len(phi), np.zeros(len(phi))
    at = [x.ctypes.data for x in (phi, y, theta)]
    held = (phi, y)  # the addresses are only good while the arrays live
    call = reference().reference_rls
    return Kernel(n, lambda: (held, call(FORGETTING, P_START, n, *at)) and None, theta)


def population_config(library: Library) -> NDArray[np.float64]:
    """The population filter's configuration for the car of `road_drive`."""
    prior = Prior(
        ("K", "pi1", "eta", "rho"),
        ("log", "linear", "log", "log"),
        np.array([145.68, 0.4431, 1.42, 1.017]),
        np.diag(np.array([0.5, 0.03, 0.13, 0.09]) ** 2),
    )
    return filter_config(library, prior, L=CAR["L"], noise_std=NOISE, input_scale_sd=0.02)


def small_car_config(library: Library, drive: Drive) -> NDArray[np.float64]:
    """The paper's regression, its frozen groups true for the car of `square_drive`."""
    p1, p2 = SMALL_CAR["pi1"], 1 - SMALL_CAR["pi1"]
    return paper_config(
        library,
        sample_time=float(drive.t[1] - drive.t[0]),
        L=SMALL_CAR["L"],
        speed=float(np.nanmedian(drive.U)),
        noise_std=1e-3,
        pi1=p1,
        pi4_slope=SMALL_CAR["eta"] * p1 / p2,
        pi5=SMALL_CAR["rho"] * p1 * p2,
    )


def generated_kernel(name: str, config: NDArray[np.float64], drive: Drive) -> Kernel:
    """The batch loop of a shipped estimator, from its start."""
    library = shipped(name)
    begin, batch = getattr(library.c, f"{name}_init"), getattr(library.c, f"{name}_batch")
    state = np.zeros(len(library.names("state")))
    return _loop(
        lambda at, n: (
            begin(config.ctypes.data, state.ctypes.data),
            batch(config.ctypes.data, state.ctypes.data, n, *at),
        ),
        drive,
        len(library.layout.OUTPUT),
    )


def reference_paper_kernel(library: Library, config: NDArray[np.float64], drive: Drive) -> Kernel:
    """The hand-written loop, on the configuration of ``bicycle_paper``."""
    stated = dict(zip(library.names("config"), config.tolist(), strict=True))
    own = np.array([stated[name] for name in PAPER_ORDER])
    call = reference().reference_paper
    return _loop(lambda at, n: call(own.ctypes.data, n, *at), drive, len(library.layout.OUTPUT))


def _loop(call: Callable, drive: Drive, outputs: int) -> Kernel:
    samples = drive.samples()
    n = len(samples)
    result, status = np.zeros((n, outputs)), np.zeros(n, np.int32)

    def run() -> None:
        call([x.ctypes.data for x in (samples, result, status)], n)

    return Kernel(n, run, result, status)
