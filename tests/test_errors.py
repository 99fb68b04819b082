"""Every error has four parts, survives a worker process, and prints safely."""

import pickle

import pytest

from similitude import errors
from similitude.errors import SimilitudeError, shown

KINDS = [
    kind for kind in vars(errors).values() if isinstance(kind, type) and issubclass(kind, SimilitudeError)
]
PARTS = {
    "what": "column 'r' of drive.csv has no unit",
    "usually": "the unit is known to the logger only.",
    "paste": "r [deg/s]",
    "read": 'docs/logs.md, "Units"',
}


def build(kind):
    parts = dict(PARTS)
    return kind(parts.pop("what"), **parts)


@pytest.mark.parametrize("kind", KINDS)
def test_message_has_four_parts_in_order_under_the_name_of_its_kind(kind):
    lines = str(build(kind)).splitlines()

    assert lines[0] == f"{kind.__name__}: {PARTS['what']}"
    assert lines[1].strip() == f"Usually {PARTS['usually']}"
    assert lines[2].strip() == f"Paste:  {PARTS['paste']}"
    assert lines[3].strip() == f"Read:   {PARTS['read']}"
    assert len(lines) == 4


@pytest.mark.parametrize("kind", KINDS)
def test_an_error_survives_pickling_between_processes(kind):
    before = build(kind)

    after = pickle.loads(pickle.dumps(before))

    assert type(after) is kind
    assert str(after) == str(before)
    assert {name: getattr(after, name) for name in PARTS} == PARTS


def test_usually_is_not_said_twice():
    error = SimilitudeError("x", usually="Usually y.", paste="z", read="docs")

    assert str(error).count("Usually") == 1


def test_a_part_cannot_be_left_out():
    with pytest.raises(TypeError):
        SimilitudeError("something is wrong", usually="y.", paste="z")


def test_shown_text_is_short_and_holds_no_control_characters():
    assert shown("r [deg/s]") == "'r [deg/s]'"
    assert shown("a\x1b[31mb\n") == "'a\\x1b[31mb\\n'"
    assert len(shown("x" * 10_000)) < 70
