"""Bounds that a step's state keeps, against drives made to reach them; and the program that Eva is given."""

import re

import numpy as np
import pytest
from scipy import signal

from similitude.embedded.configuration import find_numbers
from similitude.embedded.finiteness import finite_text, impulse_norms, paper_bounds
from similitude.embedded.system import find_source
from similitude.estimators.bessel import bessel_sections
from similitude.program.library import shipped


@pytest.fixture(scope="module")
def paper():
    library = shipped("bicycle_paper")
    return library, find_numbers(find_source("bicycle", "paper"), vehicle=None, sample_time=None).values


def test_norms_are_those_of_the_impulse_response():
    sections = bessel_sections("high", 45.0, 0.01)
    impulse = np.zeros(2000)
    impulse[0] = 1.0
    out = signal.sosfilt(np.insert(sections, 3, 1.0, axis=1), impulse)

    assert impulse_norms(sections)[1] == pytest.approx(np.abs(out).sum(), rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_no_drive_leaves_the_bounds(paper, seed):
    """Swings between the gates at every pace, the worst that they let through."""
    library, config = paper
    bounds, rng = paper_bounds(library, config), np.random.default_rng(seed)
    state = library.start(config)
    names = library.names("state")
    for pace in (1, 2, 3, 5, 8, 13, 40, 200):
        flips = np.repeat(rng.choice([-1.0, 1.0], 400), pace)[:400]
        for flip in flips:
            row = [[0.01, 1.2999 * flip, rng.choice([0.51, 20.0, 149.9]), 11.999 * rng.choice([flip, -flip])]]
            library.run(config, state, np.array(row))
            for name, value in zip(names, state.tolist(), strict=True):
                if name in bounds.ranges:
                    low, high = bounds.ranges[name]
                    assert low <= value <= high, name


def test_what_eva_cannot_carry_is_named(paper):
    bounds = paper_bounds(*paper)
    resting = set(bounds.ranges) - bounds.carried

    assert resting == {
        "mean_square",
        *(f"{s}_{k}{end}" for s in ("input", "output") for k in (1, 2) for end in ("", "_change")),
    }


def test_the_program_bounds_every_state_that_a_step_writes_and_asks_for_every_number(paper):
    library, config = paper
    text = finite_text(library, config, "paper")
    set_, asked = re.findall(r"state\.(\w+) = Frama_C", text), re.findall(r"is_finite\((\w+\.\w+)\)", text)

    assert set(library.names("state")) - set(set_) == {"from_input", "from_output"}
    assert len(asked) == len(library.names("state")) + len(library.names("output"))
