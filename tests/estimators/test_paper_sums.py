"""The paper's regression in sums is the paper's regression: the same unknown to the last digits."""

import types

import numpy as np
import pytest
from tests.estimators.fixed_case import paper_named, rows_of_a_drive

from similitude.estimators.paper_sums import paper_sums
from similitude.program.c import print_c
from similitude.program.library import assemble, shipped
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction


@pytest.fixture(scope="module")
def sums():
    program = paper_sums(bicycle_reduction())
    layout = types.ModuleType(program.name)
    exec(print_python(program), layout.__dict__)
    return assemble(layout, print_c(program))


def values(library, named):
    rows = library.layout.CONFIG
    return library.config(
        {n: [named[f"{n}_{i}"] for i in range(k)] if k > 1 else named[n] for n, _, _, k in rows}
    )


def test_it_reads_what_the_paper_reads(sums):
    rows = rows_of_a_drive(4000)
    paper, named = paper_named()
    library = shipped("bicycle_paper")
    for name in ("normal_start", "normal_least"):  # no prior in either: they state theirs differently
        paper[library.index("config", name)] = 1e-30
    per_theta = paper[library.index("config", "K_per_theta")]
    paper[library.index("config", "theta_low")] = named["K_low"] / per_theta
    named |= {"normal_start": 1e-30, "K_limit": 1e9, "psi_limit": 1e9}
    config = values(sums, named)
    ours, status = sums.run(config, sums.start(config), rows)
    theirs, wanted = library.run(paper, library.start(paper), rows)
    learnt = wanted == 0

    assert learnt.sum() > 500
    assert np.array_equal(status, wanted)
    # both solve the same sums, which a first few samples leave nearly singular
    assert ours[learnt, 0][50:] == pytest.approx(theirs[learnt, 0][50:], rel=1e-8)
    assert ours[learnt, -1][50:] == pytest.approx(theirs[learnt, -1][50:], rel=1e-8)


def test_the_mean_square_averages_over_a_power_of_two(sums):
    _, named = paper_named()
    config = values(sums, named)
    state = sums.start(config)
    sums.run(config, state, rows_of_a_drive(4000))
    at = {n: state[sums.index("state", n)] for n in ("updates", "span", "pace")}

    assert at["span"] * at["pace"] == 1.0
    assert at["span"] <= at["updates"] < 2 * at["span"]
