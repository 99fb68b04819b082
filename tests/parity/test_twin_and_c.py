"""The Python twin and the compiled C agree bit for bit, on every status path."""

import ctypes

import numpy as np
import pytest

from similitude.status import STATUS

from ..filter_rig import car, car_config, twin_of
from ..rough_drive import rough_drive


def bits(array):
    return np.ascontiguousarray(array, dtype=np.float64).view(np.uint64)


def assert_same_bits(samples: int, seed: int) -> None:
    library = car()
    assert library.c is not None, library.why_slow
    config, rows = car_config(library), rough_drive(samples, seed)
    state_c, state_twin = library.start(config), twin_of(library).start(config)
    assert np.array_equal(bits(state_c), bits(state_twin))

    out_c, status_c = library.run(config, state_c, rows)
    out_twin, status_twin = twin_of(library).run(config, state_twin, rows)

    differ = np.nonzero((bits(out_c) != bits(out_twin)).any(axis=1) | (status_c != status_twin))[0]
    assert differ.size == 0, f"first at sample {differ[0]}: {rows[differ[0]]}"
    assert np.array_equal(bits(state_c), bits(state_twin))
    seen = np.bincount(status_c, minlength=len(STATUS))
    assert {name for name, code in STATUS.items() if seen[code] < 10} == set()


@pytest.mark.parametrize("seed", range(4))
def test_the_same_bits_over_a_rough_drive(seed):
    assert_same_bits(25_000, seed)  # four parts, so that the workers share 1e5 samples


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4, 12))
def test_the_same_bits_over_a_million_samples(seed):
    assert_same_bits(125_000, seed)


def test_the_batch_loop_does_what_single_steps_do():
    library = car()
    assert library.c is not None, library.why_slow
    config, rows = car_config(library), rough_drive(5000, 31)
    state, alone = library.start(config), library.start(config)
    batch, codes = library.run(config, state, rows)

    step = getattr(library.c, f"{library.name}_step")
    step.argtypes = [ctypes.c_void_p] * 4
    out = np.zeros_like(batch)
    status = [step(*(x.ctypes.data for x in (config, alone, rows[i], out[i]))) for i in range(len(rows))]

    assert np.array_equal(bits(batch), bits(out))
    assert status == codes.tolist()
    assert np.array_equal(bits(state), bits(alone))
