"""Which column is which: aliases, ``--map``, and everything that is refused."""

import re

import pytest

from similitude.errors import LogError, UnitError, UsageError
from similitude.log_columns import choose_columns
from similitude.log_quantities import QUANTITIES

GOOD = ("t [s]", "delta [rad]", "r [rad/s]", "U [m/s]")


def choose(*headers, **mapping):
    columns, findings = choose_columns(headers, file="drive.csv", mapping=mapping)
    assert findings == []
    return columns


@pytest.mark.parametrize(
    ("name", "alias"),
    [(name, alias) for name, one in QUANTITIES.items() for alias in sorted(one.aliases)],
)
def test_every_alias_finds_its_quantity_in_any_case(name, alias):
    kept = {"t": GOOD[0], "delta": GOOD[1], "r": GOOD[2], "U": GOOD[3]}
    if name == "steering_wheel":
        kept.pop("delta")
    kept.pop(name, None)
    unit = QUANTITIES[name].si
    for written in (alias, alias.upper(), alias.replace("_", " ").title(), f" {alias} "):
        chosen = choose(*kept.values(), f"{written} [{unit}]")
        assert chosen[name].position == len(kept)


def test_unused_columns_need_no_unit_and_no_known_name():
    chosen = choose("counter", *GOOD, "note", "x [furlonk]")

    assert {name: column.position for name, column in chosen.items()} == {
        "t": 1, "delta": 2, "r": 3, "U": 4,
    }  # fmt: skip


@pytest.mark.parametrize("wanted", ["SWA", "SWA [deg]", " SWA "])
def test_a_column_is_mapped_by_its_name_or_by_its_full_header(wanted):
    chosen = choose(GOOD[0], "SWA [deg]", *GOOD[2:], delta=wanted)

    assert chosen["delta"].position == 1
    assert chosen["delta"].mapped
    assert "steering_wheel" not in chosen


def test_a_mapping_may_state_the_unit_that_the_header_lacks():
    chosen = choose(GOOD[0], GOOD[1], "gyro", GOOD[3], r="gyro [deg/s]")

    assert chosen["r"].unit.text == "deg/s"


def test_a_mapping_settles_two_candidates_and_both_steers():
    assert choose(*GOOD, "speed [km/h]", U="speed")["U"].position == 4
    assert choose(*GOOD, "swa [deg]", delta="delta").keys() == {"t", "delta", "r", "U"}
    assert "delta" not in choose(*GOOD, "swa [deg]", steering_wheel="swa")


def test_a_quantity_may_be_named_in_either_case():
    assert choose(*GOOD[:3], "v_wheel [m/s]", u="v_wheel")["U"].mapped


REFUSED = {
    "missing": (
        (*GOOD[:2], "gyr [rad/s]", GOOD[3]), {}, LogError,
        "no column for 'r' \\(yaw rate\\); its columns are 't \\[s\\]'", '--map "r=gyr"',
    ),
    "all missing": (("a", "b"), {}, LogError, "'t' \\(time\\) and 'delta'", "t [s],delta [rad],"),
    "ambiguous steer": (
        (GOOD[0], "Steering Angle [deg]", *GOOD[2:]), {}, LogError,
        "no column for 'delta'", '--map "steering_wheel=Steering Angle"',
    ),
    "two for one": (
        (*GOOD, "speed [km/h]"), {}, LogError,
        "two columns for the speed: 'U \\[m/s\\]' and 'speed \\[km/h\\]'", '--map "U=speed"',
    ),
    "one name twice": (
        (*GOOD, "U [km/h]"), {}, LogError, "two columns for the speed", '--map "U=U [km/h]"',
    ),
    "both steers": (
        (*GOOD, "SWA [deg]"), {}, LogError,
        "'delta \\[rad\\]' and 'SWA \\[deg\\]'", '--map "delta=delta"',
    ),
    "no unit": (
        (*GOOD[:2], "r", GOOD[3]), {}, UnitError, "column 'r' of drive.csv.*has no unit",
        "r [rad/s]",
    ),
    "round brackets": (
        GOOD[:3], {"U": "speed (km/h)"}, LogError, "no column of this name", "--map",
    ),
    "round brackets mapped": (
        (*GOOD[:3], "speed (km/h)"), {"U": "speed (km/h)"}, UnitError, "has no unit",
        "speed [km/h]",
    ),
    "unknown unit": (
        (*GOOD[:2], "r [deg/sek]", GOOD[3]), {}, UnitError, "'sek' in 'deg/sek' is not known",
        "r [rad/s]",
    ),
    "wrong dimension": (
        (*GOOD[:2], "r [deg]", GOOD[3]), {}, UnitError, "unit 'deg' is no unit of a yaw rate",
        "r [rad/s]",
    ),
    "turns a second": (
        (*GOOD[:2], "r [Hz]", GOOD[3]), {}, UnitError, "'Hz' is no unit of a yaw rate", "r [rad/s]",
    ),
    "share of full steer": (
        (GOOD[0], "delta [%]", *GOOD[2:]), {}, UnitError, "'%' is no unit of a road wheel angle",
        "delta [rad]",
    ),
    "gram": (
        (*GOOD, "ay [kg]"), {}, UnitError, "'kg' is no unit of a lateral acc", "ay [m/s^2]",
    ),
    "no such column": (
        GOOD, {"r": "gyro"}, LogError, "--map r=gyro: drive.csv has no column of this name",
        "--map",
    ),
    "no such quantity": (
        GOOD, {"SWA": "delta"}, UsageError, "'SWA', which is no quantity", "--map",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_a_doubtful_header_is_refused_with_the_line_to_write(case):
    headers, mapping, kind, what, paste = REFUSED[case]

    if kind is UsageError:
        with pytest.raises(UsageError, match=what) as caught:
            choose_columns(headers, file="drive.csv", mapping=mapping)
        error = caught.value
    else:
        _, findings = choose_columns(headers, file="drive.csv", mapping=mapping)
        assert findings[0].certain
        error = findings[0].error

    assert re.search(what, str(error))
    assert type(error) is kind
    assert error.paste.startswith(paste)
    assert all([error.usually, error.read])


def test_every_fault_of_a_header_is_said_and_the_sound_columns_are_chosen():
    headers = ("t [s]", "delta [rad]", "delta [deg]", "r", "U [m/s]")

    columns, findings = choose_columns(headers, file="drive.csv", mapping={})

    assert [one.fault for one in findings] == ["two_columns", "no_unit"]
    assert columns.keys() == {"t", "U"}


def test_a_clock_needs_no_unit():
    columns, findings = choose_columns(
        ("timestamp", *GOOD[1:]), file="drive.csv", mapping={}, is_clock=lambda position: position == 0
    )

    assert findings == []
    assert columns["t"].unit.factor == 1.0


def test_g_on_an_acceleration_is_standard_gravity_and_one_is_a_radian():
    chosen = choose("t [s]", "delta [1]", "r [1/s]", "U [m/s]", "ay [g]")

    assert chosen["ay"].unit.factor == 9.80665
    assert chosen["delta"].unit.factor == chosen["r"].unit.factor == 1.0
