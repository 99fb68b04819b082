"""Systems that are no bicycle go the whole way with no change to the library."""

import numpy as np
import pytest

from ..filter_rig import covariance, scaled_eigenvalues, twin_of, user_library
from ..small_systems import CASES

SAMPLES = 6000
LEARNT = {"heater": 0.1, "spring": 0.1, "drive": 0.15, "aircraft": 0.5}  # share of the prior sd


@pytest.fixture(scope="module", params=CASES)
def case_and_library(request):
    case = CASES[request.param]()
    library = user_library(case.reduction)
    assert library.c is not None, library.why_slow
    return case, library


def test_the_estimate_comes_within_three_sd_and_says_something(case_and_library):
    case, library = case_and_library
    first = case.reduction.unknowns[0]
    for seed in range(3):
        config = case.config(library)
        state = library.start(config)
        outputs, _ = library.run(config, state, case.log(SAMPLES, seed=seed))
        estimate, sd = outputs[-1, 0], np.sqrt(outputs[-1, 1])
        away = estimate - case.true_value()
        if first.kind == "log":
            away = np.log(estimate / case.true_value())

        assert abs(away) < 3 * sd
        assert sd < LEARNT[case.model.name] * case.prior[first.name][1]
        normalised = outputs[500:, 3] ** 2 / outputs[500:, 4]
        # mean of 5500 squared normals: 1 +- 0.02; the noise adapts within about a tenth
        assert 0.8 < normalised.mean() < 1.2
        assert (np.diag(covariance(library, state)) > 0).all()
        assert scaled_eigenvalues(covariance(library, state)).min() > -1e-12


def test_the_twin_gives_the_same_bits(case_and_library):
    case, library = case_and_library
    config, rows = case.config(library), case.log(1500, seed=9)
    rng = np.random.default_rng(0)
    for column in range(rows.shape[1]):
        rows[rng.random(len(rows)) < 0.01, column] = rng.choice([np.nan, np.inf, 0.0, -1e9])
    states = library.start(config), twin_of(library).start(config)

    ours, theirs = (
        lib.run(config, state, rows) for lib, state in zip((library, twin_of(library)), states, strict=True)
    )

    assert ours[0].tobytes() == theirs[0].tobytes() and (ours[1] == theirs[1]).all()
    assert states[0].tobytes() == states[1].tobytes()
    assert np.isfinite(states[0]).all()


def test_nothing_in_the_layout_speaks_of_a_car(case_and_library):
    _, library = case_and_library
    words = " ".join(
        f" {name} {unit} {meaning} "
        for kind in ("CONFIG", "STATE", "SAMPLE", "OUTPUT")
        for name, unit, meaning, _ in getattr(library.layout, kind)
    )

    assert [w for w in ("steer", "yaw", " delta ", "rad/s", "lateral") if w in words] in (
        [],
        ["rad/s"],  # the drive and the aircraft turn too
    )
