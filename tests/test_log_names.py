"""A column under a foreign name: the line to paste works, and nothing is proposed that could not be."""

import shlex

import pytest

from similitude.cli_usage import read_mapping
from similitude.errors import LogError
from similitude.log_columns import choose_columns
from similitude.log_names import fits_unit, other_name, unit_of

FOREIGN = ("Zeit [s]", "Lenkradwinkel [°]", "Gierrate [°/s]", "v [km/h]", "Drehzahl")


def refused(*headers, **mapping):
    (finding,) = choose_columns(headers, file="drive.csv", mapping=mapping)[1]
    assert isinstance(finding.error, LogError)
    return finding.error


def pasted(line):
    """What the words of `--map "r=gyr"` and the like ask for."""
    words = shlex.split(line)
    assert set(words[::2]) == {"--map"}
    return read_mapping(words[1::2])


def test_foreign_names_are_told_by_their_units_and_the_line_reads_the_log():
    error = refused(*FOREIGN)
    columns, findings = choose_columns(FOREIGN, file="drive.csv", mapping=pasted(error.paste))
    assert findings == []
    assert {name: one.header for name, one in columns.items()} == dict(
        zip(("t", "steering_wheel", "r", "U"), FOREIGN, strict=False)
    )
    assert "road wheel" in error.usually


@pytest.mark.parametrize("gyro", ["yaw [deg/s]", "Gierrate [rad/s]", "wobble [mrad/s]"])
def test_the_only_column_with_the_right_unit_is_proposed(gyro):
    error = refused("t [s]", "delta [rad]", gyro, "U [m/s]", "roll [deg]", "rpm")
    assert pasted(error.paste) == {"r": gyro.split(" [")[0]}


def test_of_two_with_the_right_unit_the_nearer_name_is_proposed():
    assert '"r=' in refused("t [s]", "delta [rad]", "roll rate [deg/s]", "rr [deg/s]", "U [m/s]").paste


def test_units_in_round_brackets_are_written_anew():
    error = refused("t (s)", "delta (rad)", "r (rad/s)", "U (m/s)")
    assert error.paste == "t [s],delta [rad],r [rad/s],U [m/s]"
    assert "round brackets" in error.usually


def test_a_file_that_is_no_log_is_not_dressed_up_as_one():
    usually, paste = other_name(["Dear diary"], ["t", "delta", "r", "U"], nothing_known=True)
    assert "no driving log" in usually and paste.startswith("t [s],delta [rad]")


def test_angles_and_their_rates_are_told_apart():
    assert fits_unit("r", unit_of("r", "deg/s")) and not fits_unit("r", unit_of("r", "Hz"))
    assert fits_unit("delta", unit_of("delta", "1")) and not fits_unit("delta", unit_of("delta", "m"))
    assert unit_of("ay", "g").factor == pytest.approx(9.80665)
