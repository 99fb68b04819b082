"""Configurations: where each number comes from, and filters' noise moments against white noise."""

import numpy as np
import pytest
from scipy import signal

from similitude.errors import ProgramError
from similitude.estimators import ladder_design as design

from .ladder_case import LADDER, NOISE, PRIOR, L, config, library


@pytest.mark.parametrize("name", LADDER)
def test_the_configuration_holds_the_vehicle_the_prior_and_the_sensor(name):
    made = dict(zip(library(name).names("config"), config(name), strict=True))

    assert made["L"] == L
    assert made["K_start"] == PRIOR.mean[0]
    assert [made[n] for n in ("pi1", "eta", "rho")] == PRIOR.mean[1:].tolist()
    assert made["noise_variance"] == pytest.approx(NOISE**2)
    # limits three sd of prior and room for a halved stiffness away
    assert np.log(made["K_high"] / made["K_start"]) == pytest.approx(3 * np.hypot(0.5, 0.5))
    assert made["K_low"] * made["K_high"] == pytest.approx(made["K_start"] ** 2)
    assert made["U_least"] == pytest.approx(np.sqrt(PRIOR.mean[0] / 10))


@pytest.mark.parametrize("name", ["band", "robust"])
def test_the_past_fades_in_seconds_not_samples(name):
    for rate in (50, 100, 1000):
        made = dict(zip(library(name).names("config"), config(name, rate), strict=True))
        assert made["forgetting"] ** (rate * design.MEMORY) == pytest.approx(np.exp(-1))


@pytest.mark.parametrize("name", LADDER)
def test_a_constant_that_is_not_one_is_refused(name):
    with pytest.raises(ProgramError, match="corners"):
        config(name, corners=3.0)


def test_without_compensation_no_noise_is_taken_out():
    made = dict(zip(library("robust").names("config"), config("robust", compensated=False), strict=True))
    assert made["noise_variance"] == 0
    assert made["excitation_least"] > 0


@pytest.mark.parametrize("rate", [50, 100, 1000])
def test_the_moments_are_those_of_filtered_white_noise(rate):
    """400,000 samples, of which those within 0.1 s are alike: five sd of their mean."""
    n, w = 400_000, design.STATE_FILTER
    stages = [np.random.default_rng(1).standard_normal(n)]
    for _ in range(4):
        stages.append(signal.lfilter(*signal.bilinear([w], [1, w], fs=rate), stages[-1]))
    value, rated = stages[4], w * (stages[3] - stages[4])
    change = w * w * (stages[2] - 2 * stages[3] + stages[4])
    found = design.state_filter_moments(1 / rate)
    seen = {
        "value": value @ value, "rate": rated @ rated, "change": change @ change,
        "value_rate": value @ rated, "value_change": value @ change, "rate_change": rated @ change,
    }  # fmt: skip

    sd = {"value": found["value"], "rate": found["rate"], "change": found["change"]}
    for name, total in seen.items():
        one, other = (name.split("_") * 2)[:2]
        scale = np.sqrt(sd[one] * sd[other])
        assert found[name] == pytest.approx(total / n, abs=5 * scale * np.sqrt(0.2 * rate / n))
