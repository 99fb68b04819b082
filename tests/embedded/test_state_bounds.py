"""Bounds that a step's state keeps, against drives made to reach them."""

import numpy as np
import pytest
from scipy import signal

from similitude.embedded.configuration import find_numbers
from similitude.embedded.state_bounds import BOUNDS, impulse_norms
from similitude.embedded.system import find_source
from similitude.estimators.bessel import bessel_sections
from similitude.program.library import shipped

FILTERED = {
    "paper": {f"{s}_{k}{end}" for s in ("input", "output") for k in (1, 2) for end in ("", "_change")},
    "band": {f"{s}_before" for s in ("input", "output")}
    | {f"{s}_memory_{i}" for s in ("input", "output") for i in range(8)},
}
AVERAGED = {"paper": {"residual"}, "band": {"mean_square", "excitation", "block_score", "block_weight"}}


@pytest.fixture(params=sorted(BOUNDS))
def estimator(request):
    return request.param


@pytest.fixture
def bounded(estimator):
    """Library, numbers and bounds of an estimator."""
    library = shipped(f"bicycle_{estimator}")
    config = find_numbers(find_source("bicycle", estimator), vehicle=None, sample_time=None).values
    return library, config, BOUNDS[estimator](library, config)


def flat_names(library):
    rows = library.layout.STATE
    return [name if size == 1 else f"{name}_{i}" for name, _, _, size in rows for i in range(size)]


def test_norms_are_those_of_the_impulse_response():
    sections = bessel_sections("high", 45.0, 0.01)
    impulse = np.zeros(2000)
    impulse[0] = 1.0
    out = signal.sosfilt(np.insert(sections, 3, 1.0, axis=1), impulse)

    assert impulse_norms(sections)[1] == pytest.approx(np.abs(out).sum(), rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_no_drive_leaves_the_bounds(bounded, seed):
    """Swings between the gates at every pace, the worst that they let through."""
    library, config, bounds = bounded
    rng = np.random.default_rng(seed)
    state, names = library.start(config), flat_names(library)
    for pace in (1, 2, 3, 5, 8, 13, 40, 200):
        flips = np.repeat(rng.choice([-1.0, 1.0], 400), pace)[:400]
        for flip in flips:
            row = [[0.01, 1.2999 * flip, rng.choice([0.51, 20.0, 149.9]), 11.999 * rng.choice([flip, -flip])]]
            library.run(config, state, np.array(row))
            for name, value in zip(names, state.tolist(), strict=True):
                if name in bounds.ranges:
                    low, high = bounds.ranges[name]
                    assert low <= value <= high, name


def test_what_eva_cannot_carry_is_named(bounded, estimator):
    _, _, bounds = bounded

    assert set(bounds.ranges) - bounds.carried == FILTERED[estimator] | AVERAGED[estimator]
