"""An estimator in whole numbers: which there are, whose numbers they take, how near to reals they stay."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.estimators.fixed_case import rows_of_a_drive

from similitude.embedded.fixed_profile import FIXED, fixed_profile
from similitude.embedded.fixed_texts import expected_words, integer_rows
from similitude.errors import UsageError

made = cache(fixed_profile)  # once each, and not before a test asks
WORDS = st.one_of(st.integers(-(2**31), 2**31 - 1), st.sampled_from([-(2**31), 2**31 - 1, 0, 1, -1]))


def ran(profile, rows):
    """Outputs (n, fields) in SI units and status (n,), in integers and in double, of the same samples."""
    integers = integer_rows(profile, rows)
    words = expected_words(profile, integers)
    steps = [
        np.array([f.format.step for f in fields]) for fields in (profile.fixed.sample, profile.fixed.output)
    ]
    library = profile.plain.library()
    exact, status = library.run(profile.config, library.start(profile.config), integers * steps[0])
    return words.outputs.view(np.int32) * steps[1], words.status, exact, status


@pytest.mark.parametrize("name", FIXED)
def test_a_drive_reads_as_in_double(name):
    profile = made("bicycle", name)
    ours, status, exact, wanted = ran(profile, rows_of_a_drive(6000, noise=0.0026))

    assert np.mean(status == wanted) > 0.999  # a sample on an edge may fall on its other side
    assert (wanted == 0).sum() > 500
    differ = np.abs(np.log(ours[1000:, 0] / exact[1000:, 0])).max()
    print(f"{name}: ln K differs by {differ:.1e} at most, its sd is {np.sqrt(exact[-1, 1]):.1e}")
    assert differ < 0.01 * np.sqrt(exact[-1, 1]) + 1e-4


@pytest.mark.parametrize("name", FIXED)
@settings(max_examples=150, deadline=None)
@given(data=st.data())
def test_any_words_leave_every_word_inside_its_format(name, data):
    profile = made("bicycle", name)
    twin = profile.source.library().layout
    state = data.draw(st.sampled_from(states(name)))[:]
    for row in data.draw(st.lists(st.lists(WORDS, min_size=4, max_size=4), min_size=1, max_size=8)):
        status, outputs = twin.step([0], state, row)
        assert status in twin.STATUS.values()
        for f, word in zip(profile.fixed.output, outputs, strict=True):
            assert f.format.lo <= word <= f.format.hi
        at = iter(state)
        for f in profile.fixed.state:
            word = (next(at) << 32) + next(at) if f.format.wide else next(at)
            assert f.format.lo <= word <= f.format.hi, f.name


@cache
def states(name):
    """States along a drive, to begin from."""
    profile = made("bicycle", name)
    twin = profile.source.library().layout
    state, found = twin.init([0]), []
    found.append(state[:])
    for k, row in enumerate(integer_rows(profile, rows_of_a_drive(1500, noise=0.0026)).tolist()):
        twin.step([0], state, row)
        found += [state[:]] if k % 300 == 299 else []
    return found


def test_after_any_garbage_it_learns_again():
    profile = made("bicycle", "paper")
    twin = profile.source.library().layout
    state = twin.init([0])
    garbage = np.random.default_rng(0).integers(-(2**31), 2**31, (2000, 4))
    for row in [*garbage.tolist(), *integer_rows(profile, rows_of_a_drive(400)).tolist()]:
        status, _ = twin.step([0], state, row)

    assert status in (0, 1, 2, 3)


def test_other_numbers_are_another_estimator():
    slower = fixed_profile("bicycle", "paper", sample_time=0.02)

    assert slower.numbers.values[0] != made("bicycle", "paper").numbers.values[0]
    assert slower.source.c != made("bicycle", "paper").source.c


@pytest.mark.parametrize("name", ["population", "robust", None])
def test_what_does_not_fit_integers_is_refused(name):
    with pytest.raises(UsageError, match="has no fixed-point profile"):
        fixed_profile("bicycle", name)


def test_another_system_is_refused_by_name():
    with pytest.raises(UsageError, match="of the shipped systems the bicycle has"):
        fixed_profile("saturating_bicycle", "paper")
