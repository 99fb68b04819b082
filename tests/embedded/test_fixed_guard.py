"""Rounding of a fixed-point step against the sensor's noise: advice, refusal, numbers."""

from dataclasses import replace

import pytest

from similitude.embedded.fixed_guard import check_profile, drive
from similitude.embedded.fixed_profile import fixed_profile
from similitude.errors import UsageError


def test_at_an_ordinary_rate_rounding_is_far_below_the_noise():
    found = check_profile(fixed_profile("bicycle", "paper"))

    assert found.rounding < 1e-3
    assert 0.5 < found.pole_radius < 1
    assert found.advice == ""


def test_formats_follow_the_rate_so_that_a_fast_loop_survives():
    assert check_profile(fixed_profile("bicycle", "paper", sample_time=0.001)).rounding < 1e-3


def test_rounding_beyond_the_noise_is_refused_with_a_line_to_paste():
    profile = fixed_profile("bicycle", "paper")
    quiet = profile.config.copy()
    quiet[profile.plain.library().index("config", "noise_variance")] *= 1e-16
    with pytest.raises(UsageError, match="does not survive --real fixed at 100 samples a second") as caught:
        check_profile(replace(profile, config=quiet))
    assert caught.value.paste.startswith('--sample-time "40 ms"')
    assert drive(profile).shape == (4000, 4)
