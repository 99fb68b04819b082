"""A time in minutes or hours that claims seconds is found by the pace of driver and car."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.log_survey import survey
from similitude.log_time import check_time
from similitude.signal_faults.time_scale import FASTEST

from ..damaged_drives import UNITS, look, sound_drives

LIVELY = [one for one in sound_drives(60, seconds=150.0, seed=3) if one.columns["r"].std() > 0.012]


def in_unit(drive, size):
    return replace(drive, columns={**drive.columns, "t": drive.columns["t"] / size})


@pytest.mark.parametrize(("unit", "size"), [("min", 60.0), ("h", 3600.0)])
def test_minutes_and_hours_are_refused_with_their_name(tmp_path, unit, size):
    assert len(LIVELY) > 8
    for drive in LIVELY:
        found = look(in_unit(drive, size), tmp_path, with_ay=False).certain
        assert found[0].fault == "time_unit" and found[0].paste == f"t [{unit}]"


def test_seconds_that_claim_milliseconds_are_named_whatever_the_rate(tmp_path):
    for drive in LIVELY:
        found = look(drive, tmp_path, units={**UNITS, "t": "ms"}).certain
        assert found[0].fault == "time_unit" and found[0].paste == "t [s]"


def test_no_sound_log_at_any_rate_is_accused(tmp_path):
    for drive in LIVELY[:4]:
        t = drive.columns["t"]
        fine = np.arange(0, 30, 1e-3)  # a logger of 1 kHz
        columns = {name: np.interp(fine, t, x) for name, x in drive.columns.items()}
        seen = look(replace(drive, columns=columns), tmp_path, with_ay=False)
        assert "time_unit" not in {one.fault for one in seen.findings}


def test_noise_tells_no_pace(tmp_path):
    rng = np.random.default_rng(0)
    t = np.arange(20_000) / 1000
    columns = {"t": t, "delta": 1e-3 * rng.standard_normal(t.size), "r": 1e-3 * rng.standard_normal(t.size),
               "U": np.full(t.size, 20.0)}  # fmt: skip
    seen = look(replace(LIVELY[0], columns=columns), tmp_path)
    assert "time_unit" not in {one.fault for one in seen.findings}


def test_the_pace_is_in_the_message(tmp_path):
    (found,) = [one for one in look(in_unit(LIVELY[0], 60.0), tmp_path).findings if one.fault == "time_unit"]
    assert 0 < found.value < FASTEST and "no driver steers so fast" in found.what


@pytest.mark.parametrize(
    ("raw", "factor", "unit"),
    [(10.0, 1.0, "ms"), (10_000.0, 1e-3, "us"), (0.01, 1e-3, "s"), (0.02, 60.0, "s"), (3e-6, 1.0, "h")],
)
def test_the_unit_that_is_named_is_not_that_of_the_header(raw, factor, unit):
    t = raw * factor * np.arange(10_000)
    (found, *_) = check_time(t, header="t [x]", factor=factor, file="drive.csv")
    assert (found.fault, found.paste) == ("time_unit", f"t [{unit}]")


def test_a_survey_without_a_steer_says_nothing(tmp_path):
    path = tmp_path / "drive.csv"
    path.write_text("t [s],r [rad/s]\n" + "".join(f"{k / 1000},{np.sin(k):.4f}\n" for k in range(5000)))
    assert "time_unit" not in {one.fault for one in survey(path).findings}
