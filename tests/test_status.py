"""One list of status names for Python, C and JSON; names and codes never change their meaning."""

import re

import pytest

from similitude.generate import DIRECTORY
from similitude.program.library import shipped
from similitude.status import MEANING, NAMES, STATUS

FIRST = "ok not_excited outside_linear at_limit no_measurement restarted too_slow bad_sample".split()


def test_names_and_codes_stay_as_they_were_published():
    assert [STATUS[name] for name in FIRST] == list(range(len(FIRST)))
    assert list(NAMES[: len(FIRST)]) == FIRST


def test_every_name_has_one_code_and_a_meaning():
    assert sorted(STATUS.values()) == list(range(len(STATUS)))
    assert set(MEANING) == set(STATUS)
    assert all(NAMES[code] == name for name, code in STATUS.items())
    assert all(re.fullmatch(r"[a-z_]+", name) for name in STATUS)


@pytest.mark.parametrize("name", sorted(p.stem for p in DIRECTORY.glob("*.c")))
def test_twin_and_c_carry_the_same_list(name):
    source = (DIRECTORY / f"{name}.c").read_text()
    found = dict(re.findall(rf"{name.upper()}_([A-Z_]+) = (\d+)", source))

    assert {key.lower(): int(code) for key, code in found.items()} == STATUS
    assert shipped(name).layout.STATUS == STATUS
