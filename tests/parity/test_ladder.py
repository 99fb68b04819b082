"""Twin, compiled C and single precision of the ladder's regressions, on every status path."""

import numpy as np
import pytest

from similitude.status import STATUS

from ..estimators.ladder_case import LADDER, NOISE, config, drive, library, run
from ..filter_rig import Float32, twin_of
from ..rough_drive import rough_drive

SHORT = {"settle_samples": 5.0}  # the drive is hardly ever whole for longer
EDGES = ({"K_low": 100.0, "K_high": 200.0}, {"K_low": 1e-3, "K_high": 1e6, "excitation_least": 1e-12})


def bits(array):
    return np.ascontiguousarray(array, dtype=np.float64).view(np.uint64)


def assert_same_bits(name, samples, seed):
    """The same with near and with far limits of K; every status and number of unknowns occurs."""
    used = library(name)
    assert used.c is not None, used.why_slow
    seen, carried = np.zeros(len(STATUS), int), set()
    for edges in EDGES:
        made, rows = config(name, **SHORT, **edges), rough_drive(samples, seed, even=True)
        state_c, state_twin = used.start(made), twin_of(used).start(made)
        assert np.array_equal(bits(state_c), bits(state_twin))

        out_c, status_c = used.run(made, state_c, rows)
        out_twin, status_twin = twin_of(used).run(made, state_twin, rows)

        differ = np.nonzero((bits(out_c) != bits(out_twin)).any(axis=1) | (status_c != status_twin))[0]
        assert differ.size == 0, f"first at sample {differ[0]}: {rows[differ[0]]}"
        assert np.array_equal(bits(state_c), bits(state_twin))
        seen += np.bincount(status_c, minlength=len(STATUS))
        carried |= set(np.unique(out_c[:, used.index("output", "unknowns")]))
    assert {one for one, code in STATUS.items() if seen[code] < 10} == set()
    assert carried == ({0.0, 1.0, 4.0} if name == "robust" else {0.0, 1.0})


@pytest.mark.parametrize("name", LADDER)
def test_the_same_bits_over_a_rough_drive(name):
    assert_same_bits(name, 20_000, 1)


@pytest.mark.slow
@pytest.mark.parametrize("name", LADDER)
def test_the_same_bits_over_a_long_rough_drive(name):
    assert_same_bits(name, 100_000, 2)


@pytest.mark.parametrize("name", LADDER)
def test_float32_follows_double(name):
    """Rounding of 6e-8 a sample, gathered as a random walk over a memory of 2000 samples, seen through
    regressors that explain one another to a share of 3e-4 at least: 6e-8 x 45/3e-4 = 0.9 %. A step down or
    up may come a sample sooner; what is left of that fades with the memory.
    """
    rows = drive(300.0, noise=NOISE, rms=0.006, band=(0.3, 12.0)).astype(np.float32).astype(float)
    exact, _, _ = run(name, rows)

    single, _, state = Float32(library(name)).run(config(name), rows)

    assert np.isfinite(single).all() and np.isfinite(state).all()
    same = (single[:, -1] == exact["unknowns"])[3000:]
    apart = np.log(single[3000:, 0] / exact["estimate"][3000:])
    assert np.abs(apart[same]).max() < 0.009 and same.mean() > 0.99


@pytest.mark.parametrize("name", LADDER)
def test_float32_survives_a_rough_drive(name):
    rows = rough_drive(100_000, 7, even=True)

    outputs, _, state = Float32(library(name)).run(config(name, **SHORT), rows)

    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert (outputs[:, :2] > 0).all()
