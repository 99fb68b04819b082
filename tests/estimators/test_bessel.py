"""The Bessel sections against scipy's own."""

import numpy as np
import pytest
from scipy import signal

from similitude.estimators.bessel import bessel_sections, cascade_response


@pytest.mark.parametrize("sample_time", [1e-3, 1e-2, 5e-2])
@pytest.mark.parametrize(("kind", "name"), [("low", "lowpass"), ("high", "highpass")])
def test_they_are_the_bilinear_transform_of_the_analogue_filter(kind, name, sample_time):
    w = np.linspace(0.05, 0.95, 40) * np.pi / sample_time
    over, under = signal.bessel(4, 60.0, name, analog=True, norm="phase")
    expected = signal.freqs(over, under, 2 / sample_time * np.tan(w * sample_time / 2))[1]
    sections = bessel_sections(kind, 60.0, sample_time)
    found = signal.freqz_sos(np.insert(sections, 3, 1.0, axis=1), w * sample_time)[1]

    assert np.allclose(found, expected, rtol=1e-9, atol=1e-12)
    assert (np.abs(np.roots([1, *sections[0, 3:]])) < 1).all()


def test_the_cascade_is_scipy_s():
    sections = np.vstack([bessel_sections("high", 45, 0.01), bessel_sections("low", 90, 0.01)])
    x = np.random.default_rng(0).standard_normal(300)
    expected = signal.sosfilt(np.insert(sections, 3, 1.0, axis=1), x)

    assert np.allclose(cascade_response(sections, x), expected, rtol=0, atol=1e-12)
