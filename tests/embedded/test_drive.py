"""The rows of the self-test: believable ones, then all that can go wrong, then believable ones again."""

import numpy as np

from similitude.embedded.configuration import find_numbers
from similitude.embedded.drive import AFTER, CLEAN, self_test_rows
from similitude.embedded.system import find_source


def rows_of(estimator):
    source = find_source("bicycle", estimator)
    numbers = find_numbers(source, vehicle=None, sample_time=0.02)
    return self_test_rows(source, source.library(), numbers.values, numbers.sample_time)


def test_faults_stand_between_good_samples():
    rows = rows_of("paper")

    assert np.isfinite(rows[:CLEAN]).all() and np.isfinite(rows[-AFTER:]).all()
    for column in rows[CLEAN:-AFTER].T:
        assert np.isnan(column).any() and np.isposinf(column).any() and np.isneginf(column).any()


def test_what_a_filter_hands_to_the_monitor_is_finite():
    assert np.isfinite(rows_of("monitor")[:, 4:]).all()


def test_time_between_samples_is_that_of_the_loop():
    assert (rows_of("band")[:CLEAN, 0] == 0.02).all()
