"""As few numbers as the output tells, and the output depends on them alone."""

import numpy as np
import pytest

from similitude import shipped_system
from similitude.any_model.fewest_unknowns import fewest_unknowns
from similitude.any_model.knowledge import gather_knowledge
from similitude.any_model.one_channel import one_channel
from similitude.any_model.plant import respond
from similitude.errors import ModelError

from .gallery import CASES


def fewest(name, **changes):
    system, case = shipped_system(name), {**CASES[name], **changes}
    model = one_channel(system.model, input=case.get("input"))
    knowledge = gather_knowledge(model, values=system.numbers(), prior=case["prior"])
    signals = {n: system.numbers()[n] for n in model.signals}
    return model, fewest_unknowns(model, system.base, knowledge, signals=signals, start={})


@pytest.mark.parametrize(
    ("name", "uncertain", "unknown"),
    [
        ("overhead_crane", 2, 2),
        ("dc_motor", 2, 2),
        ("aircraft_short_period", 7, 6),  # moments over pitch inertia
        ("quarter_car", 5, 4),  # mass cancels
        ("rlc_circuit", 1, 1),
    ],
)
def test_there_are_no_more_unknowns_than_the_output_tells(name, uncertain, unknown):
    _, found = fewest(name)

    assert len(found.knowledge.uncertain) == uncertain
    assert len(found.reduction.unknowns) == unknown


def test_an_unknown_inertia_makes_the_time_scale_unknown_and_nothing_else():
    _, found = fewest("dc_motor", prior={"J": "0.01 kg m^2 +- 50 %"})

    assert found.prior.names == ("time_ratio",)
    assert found.prior.mean[0] == 1 and found.prior.std[0] == pytest.approx(0.5)


@pytest.mark.parametrize("name", CASES)
def test_systems_with_the_same_unknowns_have_the_same_output(name):
    """Parameters moved along what no unknown shows: the simulated output does not move."""
    model, found = fewest(name)
    S, E = found.knowledge.covariance, found.exponents
    values, vectors = np.linalg.eigh(S)
    root = vectors * np.sqrt(np.maximum(values, 0))
    _, sizes, right = np.linalg.svd(E @ root)
    hidden = right[len(sizes) :]  # draws of the prior that move no unknown
    drive = CASES[name]["drive"][:300]
    step = {"20 ms": 0.02, "10 ms": 0.01, "5 ms": 0.005, "20 us": 2e-5}[CASES[name]["step"]]
    for direction in hidden:
        logs = found.knowledge.mean + root @ direction
        drawn = dict(zip(found.knowledge.names, found.knowledge.signs * np.exp(logs), strict=True))
        one, two = (respond(model, {**v, **found.signals}, drive, step).output[0] for v in
                    (found.knowledge.values, drawn))  # fmt: skip
        np.testing.assert_allclose(two, one, atol=1e-6 * np.abs(one).max())


def test_parameters_follow_from_unknowns_as_the_prior_has_it():
    _, found = fewest("quarter_car")
    mean, covariance = found.parameters(found.prior.mean, found.prior.covariance)

    np.testing.assert_allclose(mean, list(found.knowledge.values.values()), rtol=1e-12)
    np.testing.assert_allclose(covariance, found.knowledge.covariance, atol=1e-12)


def test_what_is_all_known_or_unseen_is_refused():
    with pytest.raises(ModelError, match="nothing to estimate"):
        fewest("rlc_circuit", prior={})
    with pytest.raises(ModelError, match="does not depend on V"):
        fewest("rlc_circuit", prior={"V": "48 V +- 10 %"})
