"""docs/logs.md lists every fault and every repair there is, and no other."""

import re
from pathlib import Path

from similitude.log_fixes import FIXES

ROOT = Path(__file__).parents[2]
PLACES = ("log_*.py", "readers/*.py", "signal_faults/*.py")
SOURCES = [path for place in PLACES for path in (ROOT / "src/similitude").glob(place)]
TEXT = (ROOT / "docs/logs.md").read_text(encoding="utf-8")


def named_in_code():
    """Names handed to a finding or an error as its fault."""
    names = set()
    for path in SOURCES:
        source = path.read_text(encoding="utf-8")
        names |= set(re.findall(r'fault="(\w+)"', source))
        names |= set(re.findall(r'(?:Finding|_refused|_said|noted)\(\s*"(\w{3,})",', source))
        names |= set(re.findall(r'_said\((?:name|"r"), header, "(\w+)"', source))
        names |= set(
            re.findall(r'fault="(\w+)" if \w+ else "(\w+)"', source)[0] if "odd_row" in source else ()
        )
    return names


def listed():
    rows = re.findall(r"^\| (`.*?) \|", TEXT, re.MULTILINE)
    return {name for row in rows for name in re.findall(r"`(\w+)`", row)}


def test_the_tables_name_every_fault():
    columns = {"t", "delta", "r", "U", "ay", "steering_wheel"}

    assert listed() - columns == named_in_code()


def test_every_repair_is_named_and_no_other():
    last_cells = re.findall(r"\| ([^|]*) \|$", TEXT, re.MULTILINE)
    named = {name for cell in last_cells for name in re.findall(r"`(\w+)`", cell)}

    assert named == set(FIXES)


def test_every_place_to_read_more_exists():
    for path in SOURCES:
        for heading in re.findall(r"docs/logs.md, \"([^\"]+)\"", path.read_text(encoding="utf-8")):
            assert f"## {heading}" in TEXT
