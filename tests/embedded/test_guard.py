"""Filters are exported where the real can carry them, and refused with numbers where it cannot."""

import numpy as np
import pytest

from similitude.embedded.configuration import find_numbers
from similitude.embedded.guard import check_sections, sections_of
from similitude.embedded.system import find_source
from similitude.errors import UsageError


def checked(estimator, sample_time, real="float"):
    source = find_source("bicycle", estimator)
    numbers = find_numbers(source, vehicle=None, sample_time=sample_time)
    return check_sections(
        source.library(), numbers.values, estimator=estimator, real=real, sample_time=sample_time
    )


def test_the_radius_is_that_of_the_worst_conjugate_pair():
    source = find_source("bicycle", "band")
    numbers = find_numbers(source, vehicle=None, sample_time=0.01)
    rounded = sections_of(source.library(), numbers.values).astype(np.float32).astype(float)
    pairs = np.sqrt(rounded[:, 4])  # |z|^2 = a2 of a conjugate pair

    assert checked("band", 0.01).pole_radius == pytest.approx(pairs.max(), rel=1e-9)


def test_rounding_grows_with_the_rate_and_shrinks_with_the_digits():
    shares = [checked("band", step).rounding for step in (0.01, 0.002, 0.0005)]

    assert shares == sorted(shares)
    assert checked("band", 0.0005, "double").rounding < 1e-6 * shares[-1]  # 29 bits more: 2e-9


def test_a_rate_beyond_the_real_is_refused_with_a_line_to_paste():
    with pytest.raises(UsageError, match="do not survive --real float at 100000 samples a second") as caught:
        checked("band", 1e-5)
    assert caught.value.paste.startswith('--sample-time "0.04 ms"')
    assert checked("band", 1e-5, "double").advice == ""


def test_estimators_without_sections_need_no_guard():
    assert checked("population", 1e-4) is None
