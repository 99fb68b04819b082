"""What can be wrong with the command line, each with the line that would have worked."""

from pathlib import Path

import pytest
import typer

from similitude.cli_usage import (
    ESTIMATORS,
    check_estimator,
    check_state,
    list_fixes,
    no_vehicle,
    read_mapping,
)
from similitude.errors import UsageError
from similitude.log_fixes import FIXES


def test_a_mapping_is_our_name_then_the_log_s():
    assert read_mapping(["delta=SWA", "r = gyro z"]) == {"delta": "SWA", "r": "gyro z"}


@pytest.mark.parametrize("pairs", [["delta"], ["=SWA"], ["delta="], ["r=a", "r=b"]])
def test_a_mapping_without_two_sides_is_refused_with_the_line_to_write(pairs):
    with pytest.raises(UsageError) as refused:
        read_mapping(pairs)
    assert repr(pairs[-1])[1:-1] in refused.value.what
    assert refused.value.paste.startswith("--map ")


@pytest.mark.parametrize("name", ESTIMATORS)
def test_estimators_that_exist_pass(name):
    assert check_estimator(name) is None


@pytest.mark.parametrize("name", ["bands", "populaton", ""])
def test_estimators_that_do_not_exist_name_those_that_do(name):
    with pytest.raises(UsageError) as refused:
        check_estimator(name)
    assert all(known in refused.value.what for known in ESTIMATORS)


def test_the_nearest_name_is_offered():
    with pytest.raises(UsageError) as refused:
        check_estimator("papr")
    assert refused.value.paste == "--estimator paper"


def test_without_a_vehicle_the_wheelbase_is_asked_for():
    error = no_vehicle([Path("drive.csv")])
    assert "wheelbase" in error.what
    assert "vehicle" in error.paste


def test_known_repairs_pass_and_others_name_the_nearest():
    assert list_fixes(["sort_time"]) == ["sort_time"]
    assert list_fixes(None) is None
    with pytest.raises(UsageError) as refused:
        list_fixes(["flip_sign"])
    assert refused.value.paste.startswith("--fix flip_")


def test_the_list_of_repairs_names_each_with_its_words(capsys):
    with pytest.raises(typer.Exit):
        list_fixes(["list"])
    said = capsys.readouterr().out
    assert all(f"{name} " in said and fix.words in said for name, fix in FIXES.items())


def test_a_state_belongs_to_the_population_filter_by_time(tmp_path):
    by_time = {"estimator": "population", "spacing": None}
    check_state(None, {"estimator": "paper", "spacing": 0.4})
    check_state(tmp_path / "car.json", by_time)
    for how in ({**by_time, "estimator": "batch"}, {**by_time, "spacing": 0.4}):
        with pytest.raises(UsageError, match="together with"):
            check_state(tmp_path / "car.json", how)
    with pytest.raises(UsageError, match="folder"):
        check_state(tmp_path, by_time)
