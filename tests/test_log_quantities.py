"""No name belongs to two quantities, and headers split the way people write them."""

import pytest

from similitude.log_quantities import AMBIGUOUS, QUANTITIES, normal_name, split_header
from similitude.units import parse_unit


def test_no_alias_belongs_to_two_quantities():
    everything = [alias for one in QUANTITIES.values() for alias in one.aliases]

    assert len(everything) == len(set(everything))
    assert not AMBIGUOUS & set(everything)


def test_every_alias_is_written_as_it_is_compared():
    for one in QUANTITIES.values():
        assert {normal_name(alias) for alias in one.aliases} == one.aliases


@pytest.mark.parametrize("name", QUANTITIES)
def test_every_unit_that_is_offered_is_of_the_right_dimension(name):
    one = QUANTITIES[name]

    for text in (one.si, *one.examples.split(", ")):
        assert parse_unit(text, expect=one.dimension).dimension == one.dimension


@pytest.mark.parametrize(
    ("header", "parts"),
    [
        ("r [deg/s]", ("r", "deg/s")),
        ("  yaw rate[ deg/s ] ", ("yaw rate", "deg/s")),
        ("a[0] [m]", ("a[0]", "m")),
        ("r", ("r", None)),
        ("r [", ("r [", None)),
        ("r []", ("r", "")),
        ("[s]", ("", "s")),
        ("", ("", None)),
    ],
)
def test_a_header_splits_into_name_and_unit(header, parts):
    assert split_header(header) == parts


def test_spellings_of_one_name_are_one():
    assert len({normal_name(n) for n in ("Yaw Rate", "yaw-rate", "yawRate", "YAW_RATE")}) == 1
