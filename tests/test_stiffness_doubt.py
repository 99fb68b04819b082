"""A factor of two between file and estimate is said; an ordinary difference is not."""

import pytest

from similitude.run import positive_estimate
from similitude.stiffness_doubt import stiffness_doubts
from similitude.units import parse_uncertain
from similitude.vehicle_file import Vehicle

KNOWN = {"L": parse_uncertain("2.7 m"), "m": parse_uncertain("1500 kg")}


def doubts(ratio, *, sd=0.05, **known):
    stated = parse_uncertain("80000 N/rad")
    K = positive_estimate(ratio * stated.value * 2.7 / 1500, sd, "m^2/s^2")
    return stiffness_doubts(Vehicle("car", **(KNOWN | {"Caf": stated} | known)), K)


@pytest.mark.parametrize(("ratio", "said"), [(2.0, "of one tyre"), (0.5, "counted twice")])
def test_a_factor_of_two_is_said_with_its_usual_cause(ratio, said):
    assert said in doubts(ratio)[0]


@pytest.mark.parametrize("ratio", [0.7, 1.0, 1.4, 4.0])
def test_other_differences_are_not_that_of_a_tyre(ratio):
    assert doubts(ratio) == ()


def test_a_vague_estimate_and_an_unknown_mass_say_nothing():
    assert doubts(2.0, sd=0.4) == ()
    assert doubts(2.0, m=None) == ()
