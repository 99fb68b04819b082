"""Fields of a second measurement: named after it, in its units, and only where there is one."""

import pytest

from similitude.program.library import shipped
from similitude.unit import parse_unit

WITH = shipped("bicycle_with_accelerometer_population")
WITHOUT = shipped("saturating_bicycle_population")


def rows(library, struct):
    return {name: unit for name, unit, *_ in getattr(library.layout, struct)}


@pytest.mark.parametrize(
    "struct, beginnings",
    [("CONFIG", ("ay_", "place")), ("STATE", ("ay_", "place"))],
)
def test_what_is_added_is_named_after_the_output_or_the_unknown(struct, beginnings):
    added = rows(WITH, struct).keys() - rows(WITHOUT, struct).keys()
    assert added and all(name.startswith(beginnings) for name in added)
    assert rows(WITHOUT, struct).keys() <= rows(WITH, struct).keys()


def test_units_are_those_of_the_output():
    acceleration = parse_unit("m/s^2").dimension
    config, state = rows(WITH, "CONFIG"), rows(WITH, "STATE")
    for name in ("ay_bias_sd", "ay_limit"):
        assert parse_unit(config[name]).dimension == acceleration
    assert parse_unit(config["ay_variance"]).dimension == acceleration**2
    assert parse_unit(config["ay_bias_drift"]).dimension == acceleration**2 / parse_unit("s").dimension
    assert parse_unit(state["ay_bias"]).dimension == acceleration


def test_the_measurement_is_the_last_of_the_sample():
    assert WITH.names("sample") == [*WITHOUT.names("sample"), "ay_measured"]
    assert WITH.layout.COORDINATES[-1] == "ay_bias"
