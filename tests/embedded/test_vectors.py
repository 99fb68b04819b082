"""What the twin expects is what the committed C computes, in both reals."""

import ctypes

import numpy as np
import pytest

from similitude.embedded.configuration import find_numbers
from similitude.embedded.drive import self_test_rows
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.vectors import TYPES, WORDS, expected
from similitude.program.compile import load_library

NAMES = [(system, estimator) for system, all_of in SHIPPED.items() for estimator in all_of]


@pytest.mark.parametrize("real", ["float", "double"])
@pytest.mark.parametrize(("system", "estimator"), NAMES)
def test_twin_and_committed_c_agree_on_every_word(system, estimator, real):
    source = find_source(system, estimator)
    library = source.library()
    numbers = find_numbers(source, vehicle=None, sample_time=None)
    rows = self_test_rows(source, library, numbers.values, numbers.sample_time)
    wanted = expected(source.twin, real, numbers.values, rows)
    c, kind = load_library(source.c, name=source.name, real=real), TYPES[real]
    with np.errstate(over="ignore"):
        config, samples = numbers.values.astype(kind), np.ascontiguousarray(rows, kind)
    state, status = np.zeros(wanted.state.size, kind), np.zeros(len(rows), np.int32)
    outputs = np.zeros(wanted.outputs.shape, kind)
    at = [ctypes.c_void_p(x.ctypes.data) for x in (config, state, samples, outputs, status)]
    getattr(c, f"{source.name}_init")(*at[:2])
    getattr(c, f"{source.name}_batch")(*at[:2], ctypes.c_long(len(rows)), *at[2:])

    assert (status == wanted.status).all()
    assert (outputs.view(WORDS[real]) == wanted.outputs).all()
    assert (state.view(WORDS[real]) == wanted.state).all()


@pytest.mark.parametrize(("system", "estimator"), NAMES)
def test_the_self_test_meets_good_samples_and_every_kind_of_bad_one(system, estimator):
    source = find_source(system, estimator)
    numbers = find_numbers(source, vehicle=None, sample_time=None)
    rows = self_test_rows(source, source.library(), numbers.values, numbers.sample_time)
    wanted = expected(source.twin, "double", numbers.values, rows)

    assert np.isfinite(wanted.outputs.view(np.float64)).all()
    assert np.isfinite(wanted.state.view(np.float64)).all()
    assert {0, 7} <= set(wanted.status.tolist()) or estimator == "monitor"
    assert len(set(wanted.status.tolist())) >= (4 if estimator != "monitor" else 2)
