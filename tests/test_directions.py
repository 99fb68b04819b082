"""Roles follow spread and noise; the bias of freezing is the one a fit would have."""

import numpy as np
import pytest

from similitude.directions import reduce
from similitude.errors import UsageError
from similitude.output_sensitivity import sampled_response
from similitude.populations.shipped import shipped_population
from similitude.systems.bicycle import bicycle_reduction

REDUCTION = bicycle_reduction()
PRIOR = shipped_population("passenger_cars").prior
SCALES = {"m": 1500.0, "L": 2.7, "U": 25.0}
T = np.arange(0, 20, 0.01)
STEER = 0.01 * np.sin(2 * np.pi * 0.3 * T) + 0.005 * np.sin(2 * np.pi * 1.1 * T)
NOISE = np.deg2rad(0.15)


@pytest.fixture(scope="module")
def reduced():
    return reduce(REDUCTION, PRIOR, STEER, 0.01, noise=NOISE, scales=SCALES)


def test_stiffness_comes_first_as_the_paper_has_it(reduced):
    roles = {one.name: one.role for one in reduced.roles}

    assert roles["K"] == "identify" and reduced.reduction.unknowns[0].name == "K"
    leading = reduced.directions[0].of
    assert max(leading, key=lambda n: abs(leading[n])) == "K"
    assert [d.move for d in reduced.directions] == sorted((d.move for d in reduced.directions), reverse=True)


def test_freezing_claims_more_than_it_keeps(reduced):
    assert reduced.frozen_sd < reduced.sd < reduced.frozen_bias
    assert "biased by" in reduced.text and "K " in reduced.text


def test_the_bias_of_a_frozen_unknown_is_that_of_a_fit(reduced):
    """Least squares of ln K on the noiseless record of a car whose eta is a tenth of an sd off."""
    values = {**SCALES, **dict(zip(PRIOR.names[2:], PRIOR.mean[2:], strict=True))}
    respond = sampled_response(REDUCTION, values, STEER, 0.01)
    eta = next(one for one in reduced.roles if one.name == "eta")
    truth = respond({**values, "eta": values["eta"] * np.exp(0.1 * eta.before)})
    kappa = 0.0
    for _ in range(4):
        now, ahead = (respond({**values, "K": values["K"] * np.exp(kappa + h)}) for h in (0.0, 1e-5))
        slope = (ahead - now) / 1e-5
        kappa += slope @ (truth - now) / (slope @ slope)

    assert abs(kappa) == pytest.approx(0.1 * eta.bias, rel=0.05)


def test_no_noise_decides_nothing_and_much_noise_leaves_only_priors():
    loud = reduce(REDUCTION, PRIOR, STEER, 0.01, noise=1e3, scales=SCALES)

    assert {one.role for one in loud.roles} == {"identify", "never"}
    assert loud.sd == pytest.approx(0.5, rel=1e-3)


def test_roles_can_be_overridden_and_say_so():
    mine = reduce(
        REDUCTION, PRIOR, STEER, 0.01, noise=NOISE, scales=SCALES, roles={"eta": "identify", "K": "consider"}
    )
    assert mine.reduction.unknowns[0].name == "eta" and "(yours)" in mine.text
    with pytest.raises(UsageError, match="does not exist"):
        reduce(REDUCTION, PRIOR, STEER, 0.01, noise=NOISE, scales=SCALES, roles={"mu": "never"})
    with pytest.raises(UsageError, match="nothing to identify"):
        never = dict.fromkeys(("K", "pi1", "eta", "rho"), "never")
        reduce(REDUCTION, PRIOR, STEER, 0.01, noise=NOISE, scales=SCALES, roles=never)
