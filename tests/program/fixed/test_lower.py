"""A lowered step does what its program does, to the resolution of its formats, and never wraps."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.program.fixed.lowered import RATE, run_twin, tiny_fixed, twin_of

from similitude.program.fixed.lower import If, Put

FIXED = tiny_fixed()
STEPS = np.array([f.format.step for f in FIXED.sample])


def test_numbers_become_literals_and_statements_keep_their_order():
    guard = next(line for line in FIXED.step if isinstance(line, If))

    assert [line.target for line in guard.body if isinstance(line, Put)] == [
        "weight",
        "mean",
        "last_1",
        "last_0",
    ]
    assert FIXED.constants["rate"] == RATE
    assert [f.name for f in FIXED.state] == ["mean", "last_0", "last_1"]


def test_it_follows_the_real_program_to_its_resolution():
    rng = np.random.default_rng(3)
    rows = np.rint(np.column_stack([np.full(300, 0.1), rng.uniform(-9, 9, 300)]) / STEPS)
    _, outputs, _ = run_twin(FIXED, rows.astype(int))
    mean, wanted = 0.0, []
    for dt, x in rows * STEPS:
        mean += min(1.0, dt * RATE) * (x - mean)
        wanted.append(mean)
    weight = 0.1 * RATE
    # a literal of 30 bits and a weight of 28, each of which moves the mean by its share of 20 volts
    bound = FIXED.output[0].format.step + 20 * (2.0**-29 + 2.0**-27) / weight

    assert np.abs(outputs[:, 0] * FIXED.output[0].format.step - wanted).max() <= bound


@settings(max_examples=200)
@given(st.lists(st.tuples(*[st.integers(-(2**31), 2**31 - 1)] * 2), min_size=1, max_size=20))
def test_any_words_leave_every_value_inside_its_format(rows):
    twin = twin_of(FIXED)
    state = twin.init([0])
    for row in rows:
        status, outputs = twin.step([0], state, list(row))
        assert status in (0, 7)
        assert all(-(2**31) <= word < 2**31 for word in [*state, *outputs])
        for f, word in zip(FIXED.output, outputs, strict=True):
            assert f.format.lo <= word <= f.format.hi
