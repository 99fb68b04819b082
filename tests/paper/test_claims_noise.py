"""What noise and freezing do: pinned, and the closed form on white noise by hand."""

import numpy as np
import pytest

from similitude.paper import printed
from similitude.paper.claims_noise import biases, drawn_cars, noise_claims, steer_of

from .pinned import check


@pytest.mark.slow
def test_claims_are_the_pinned_ones():
    check("Noise and averages", noise_claims(), relative=0.03)


@pytest.mark.slow
def test_more_noise_more_bias_up_to_a_limit():
    simulated = [pair[0] for pair in biases().values()]
    assert simulated == sorted(simulated)
    m2 = (1 + 1.692 + (0.4**2 + 0.6**2 * 1.692) / 0.222) * printed.SAMPLE_TIME * 4 / printed.WHEELBASE
    assert 1 + simulated[-1] < 3 / (
        m2 * 0.272
    )  # above what white noise alone leads to: 3/(2 m2) over pi3, twice


def test_the_steer_is_a_square_that_a_servo_rounds():
    t = np.arange(0, 4, printed.SAMPLE_TIME)
    slow, fast = steer_of(t, 5.0), steer_of(t, 20.0)
    assert np.abs(slow[t < 0.5]).max() == 0 and np.abs(fast).max() == pytest.approx(0.01, rel=0.15)
    assert np.abs(np.diff(slow)).max() < np.abs(np.diff(fast)).max()


def test_cars_are_drawn_about_the_averages():
    cars = drawn_cars()
    assert np.exp(np.log(cars["K"]).mean()) == pytest.approx(printed.K, rel=0.1)
    assert all(values.shape == cars["L"].shape for values in cars.values())
