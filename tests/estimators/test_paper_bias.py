"""The predicted bias against the regression itself on noisy signals."""

import numpy as np
import pytest
from scipy import signal

from similitude.estimators.paper_bias import autocorrelation, noise_bias, predicted_bias
from similitude.estimators.paper_design import bessel_biquads, paper_config, slopes

from .paper_case import OWN, TS, K, L, U, library, outputs, samples, servo_square, yaw_rate

N = 60_000
DEG = np.pi / 180


def noisy(noise_std, *, amplitude=0.1, scale=1.0, seed=1):
    """Estimated and predicted pi3 over true, and the sentence, on the square wave."""
    delta = servo_square(N, amplitude)
    r = yaw_rate(delta, scale)
    r = r + np.random.default_rng(seed).normal(0, noise_std, N)
    config = paper_config(library(), sample_time=TS, L=L, speed=U, noise_std=noise_std, **OWN)
    state = library().start(config)
    values, _ = library().run(config, state, samples(delta, r))
    pi3 = scale * K / U**2
    found = predicted_bias(library(), config, state, L=L, noise_std=noise_std, pi3=pi3)
    return outputs(values, "pi3")[-1] / pi3, found


@pytest.mark.parametrize("scale", [1.0, 0.5])
@pytest.mark.parametrize("noise", [0.01 * DEG, 0.1 * DEG])
def test_the_bias_is_predicted_within_a_few_per_cent(noise, scale):
    """Between the noiseless bias of some per cent and the scatter of 20,000 samples."""
    measured, predicted = noisy(noise, scale=scale)

    assert measured > 10  # ten times the stiffness, from a gyro better than any on sale
    assert predicted.reads / predicted.pi3 == pytest.approx(measured, rel=0.05)


def test_a_large_steer_angle_brings_the_known_figures():
    """0.2 rad: +380 % at full and +846 % at half stiffness, within +213 .. +1065 %."""
    readings = [noisy(0.01 * DEG, amplitude=0.2, scale=scale)[0] - 1 for scale in (1.0, 0.5)]

    assert 2.13 < readings[0] < readings[1] < 10.65


def test_without_a_filter_it_is_the_regression_of_white_noise():
    """An ordinary least squares over independent samples of eqs 24-27."""
    rng = np.random.default_rng(2)
    n, pi3, noise_std, T = 400_000, 0.3, 0.01, 0.011
    m1, m2 = slopes(T, **OWN)
    delta = signal.lfilter([1], [1, -0.9], rng.normal(0, 0.2, n))
    pole = 1 - m2 * pi3
    rate = signal.lfilter([0, m1 * pi3], [1, -pole], delta)  # eq 23, exactly
    rate = rate + rng.normal(0, noise_std, n)
    y = rate[2:] - 2 * rate[1:-1] + rate[:-2]
    phi = m2 * (rate[:-2] - rate[1:-1]) + m1 * (delta[1:-1] - delta[:-2])
    found = noise_bias(pi3=pi3, m2=m2, noise_std=noise_std, mean_square=float(phi @ phi) / n)

    assert found.reads == pytest.approx(float(phi @ y) / float(phi @ phi), rel=0.02)
    assert found.relative > 1


def test_nothing_but_noise_has_a_limit_that_depends_on_no_signal():
    found = noise_bias(pi3=0.3, m2=0.02, noise_std=0.01, mean_square=0.0)

    assert found.reads == pytest.approx(3 / (2 * 0.02))
    assert found.noise_share == 1


def test_no_noise_no_bias():
    found = noise_bias(pi3=0.3, m2=0.02, noise_std=0.0, mean_square=1e-9)

    assert (found.reads, found.relative, found.noise_share) == (0.3, 0.0, 0.0)


def test_autocorrelation_is_that_of_filtered_white_noise():
    biquads = bessel_biquads(5e-3)
    white = np.random.default_rng(5).normal(0, 1, 400_000)
    seen = signal.sosfilt(np.insert(biquads, 3, 1.0, axis=1), white)[1_000:]
    measured = [float(seen[i:] @ seen[: seen.size - i]) / seen.size for i in range(3)]

    # four sd of a mean of 400,000 products
    assert autocorrelation(biquads) == pytest.approx(measured, abs=4 / np.sqrt(seen.size))
    assert autocorrelation([[1, 0, 0, 0, 0]] * 2) == pytest.approx([1, 0, 0])


def test_the_sentence_says_both_numbers():
    text = noise_bias(pi3=0.25, m2=0.02, noise_std=0.01 * DEG, mean_square=1e-10, star=L / U).text

    assert "0.01 deg/s" in text
    assert "true 0.25" in text
    assert "%" in text
