"""A small program in integers, and its C in a library."""

import ctypes
import types

import numpy as np
from tests.program.tiny import tiny_program

from similitude.program.compile import load_library
from similitude.program.fixed.bounds import Ranges
from similitude.program.fixed.c import print_fixed_c
from similitude.program.fixed.lower import lower
from similitude.program.fixed.python import print_fixed_python

RATE = 0.4
STATED = Ranges(
    {
        "dt": (0.0, 1.0),
        "x": (-10.0, 10.0),
        "mean": (-10.0, 10.0),
        "last_0": (-10.0, 10.0),
        "last_1": (-10.0, 10.0),
    },
    wide=frozenset({"mean"}),
)


def tiny_fixed():
    """The average of `tests.program.tiny`, its mean in 64 bits."""
    return lower(tiny_program(), {"rate": RATE}, STATED)


def twin_of(fixed) -> types.ModuleType:
    """The twin as a module."""
    module = types.ModuleType(fixed.name)
    exec(compile(print_fixed_python(fixed), fixed.name, "exec"), module.__dict__)
    return module


def run_twin(fixed, rows):
    """Status (n,), outputs (n, fields) and last state of the twin over words (n, fields)."""
    twin = twin_of(fixed)
    state, status, outputs = twin.init([0]), [], []
    for row in np.asarray(rows).tolist():
        code, out = twin.step([0], state, row)
        status.append(code)
        outputs.append(out)
    return np.array(status), np.array(outputs), np.array(state)


def run_c(fixed, rows):
    """The same of the C."""
    library = load_library(print_fixed_c(fixed), name=fixed.name)
    rows = np.ascontiguousarray(rows, np.int32)
    state = np.zeros(len(twin_of(fixed).STATE), np.int32)
    outputs = np.zeros((len(rows), len(fixed.output)), np.int32)
    status, config = np.zeros(len(rows), np.int32), np.zeros(1, np.int32)
    at = [ctypes.c_void_p(x.ctypes.data) for x in (config, state, rows, outputs, status)]
    getattr(library, f"{fixed.name}_init")(at[0], at[1])
    getattr(library, f"{fixed.name}_batch")(at[0], at[1], ctypes.c_long(len(rows)), *at[2:])
    return status, outputs, state
