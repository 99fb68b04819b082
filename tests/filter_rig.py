"""Bench for population filters: any reduction becomes a library, with a configuration to run it on."""

import ctypes
import types
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from similitude.estimators.population_filter import population_filter
from similitude.filter_config import DESIGN, filter_config
from similitude.population import Prior
from similitude.program.c import print_c
from similitude.program.compile import load_library
from similitude.program.library import Library, assemble, shipped
from similitude.program.python import print_python

_POINTER, _LONG = ctypes.c_void_p, ctypes.c_long
BICYCLE = "bicycle_population"
CAR = Prior(
    ("K", "pi1", "eta", "rho"),
    ("log", "linear", "log", "log"),
    np.array([145.68, 0.4431, 1.42, 1.017]),
    np.diag(np.array([0.5, 0.03, 0.13, 0.09]) ** 2),
)
NOISE = np.deg2rad(0.15)  # rad/s


def car_config(library: Library, *, L: float = 2.7, **changes: float) -> np.ndarray:
    """Configuration of the shipped filter for a middle-sized car."""
    return filter_config(library, CAR, L=L, noise_std=NOISE, input_scale_sd=0.02, **changes)


def user_library(reduction) -> Library:
    """A reduced model through the whole of the generator, compiled."""
    program = population_filter(reduction)
    layout = types.ModuleType(program.name)
    exec(compile(print_python(program), f"{program.name}.py", "exec"), layout.__dict__)
    return assemble(layout, print_c(program))


def twin_of(library: Library) -> Library:
    """The same estimator run by its Python twin."""
    return Library(library.name, library.layout, None)


@dataclass
class Float32:
    """The shipped filter built in single precision; structs are float32 arrays."""

    library: Library

    def __post_init__(self):
        source = _source(self.library)
        self.c = load_library(source, name=self.library.name, real="float")

    def run(self, config, samples):
        """Outputs, status and last state over the samples."""
        name, single = self.library.name, np.float32
        with np.errstate(over="ignore"):  # 1e300 is inf to a float
            config, samples = (np.ascontiguousarray(x, dtype=single) for x in (config, samples))
        state = np.zeros(len(self.library.names("state")), single)
        outputs = np.zeros((len(samples), len(self.library.names("output"))), single)
        status = np.zeros(len(samples), np.int32)
        at = [x.ctypes.data for x in (config, state, samples, outputs, status)]
        init, batch = getattr(self.c, f"{name}_init"), getattr(self.c, f"{name}_batch")
        init.argtypes = [_POINTER] * 2
        batch.argtypes = [*[_POINTER] * 2, _LONG, *[_POINTER] * 3]
        init(at[0], at[1])
        batch(at[0], at[1], len(samples), *at[2:])
        return outputs, status, state


def _source(library: Library) -> str:
    return Path(library.layout.__file__).with_suffix(".c").read_text(encoding="utf-8")


def covariance(library: Library, state: np.ndarray) -> np.ndarray:
    """The full covariance out of a flat state."""
    n = len(library.layout.COORDINATES)
    start = library.index("state", "P")
    P = np.zeros((n, n))
    P[np.triu_indices(n)] = state[start : start + n * (n + 1) // 2]
    return P + np.triu(P, 1).T


def scaled_eigenvalues(P: np.ndarray) -> np.ndarray:
    """Eigenvalues of the correlation matrix: what rounding can harm, free of units."""
    sd = np.sqrt(np.diag(P))
    return np.linalg.eigvalsh(P / np.outer(sd, sd))


def car() -> Library:
    """The shipped filter."""
    return shipped(BICYCLE)


def design(library: Library) -> dict:
    """Design constants that the library has a field for."""
    fields = {name for name, *_ in library.layout.CONFIG}
    return {name: value for name, value in DESIGN.items() if name in fields}
