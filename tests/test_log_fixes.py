"""A repair gives back the sound log where that can be, changes nothing else, and says what it did."""

import numpy as np
import pytest

from similitude.errors import UsageError
from similitude.log import read_log
from similitude.log_fixes import FIXES, apply_fixes, check_fixes
from similitude.log_survey import survey

from .damaged_drives import clipped, interpolated, look, restarted, sound_drives, spiked, stuck
from .log_text import HEADERS, csv_text, drive, write


@pytest.fixture(scope="module")
def sound():
    lively = [one for one in sound_drives(30, seed=9) if one.rms > 0.003]
    return lively[0]


def read(folder, columns, *fixes, headers=HEADERS):
    return read_log(write(folder, csv_text(columns, headers=headers)), fixes=fixes)


DEG = 180 / np.pi
EXACT = {
    "unwrap_time": lambda c: c | {"t": (c["t"] + 60) % 65.536},
    "yaw_rate_is_deg_per_s": lambda c: c | {"r": c["r"] * DEG},
    "steer_is_deg": lambda c: c | {"delta": c["delta"] * DEG},
    "speed_is_kmh": lambda c: c | {"U": c["U"] * 3.6},
    "speed_is_mph": lambda c: c | {"U": c["U"] / 0.44704},
    "speed_is_knots": lambda c: c | {"U": c["U"] * 3600 / 1852},
    "flip_steer_sign": lambda c: c | {"delta": -c["delta"]},
    "flip_yaw_rate_sign": lambda c: c | {"r": -c["r"]},
    "sort_time": lambda c: {name: one.reshape(-1, 2)[:, ::-1].ravel() for name, one in c.items()},
    "drop_repeated_rows": lambda c: {name: np.repeat(one, 2) for name, one in c.items()},
}


@pytest.mark.parametrize("name", EXACT)
def test_a_repair_undoes_its_fault(tmp_path, name):
    columns = dict(zip(("t", "delta", "r", "U"), drive(1000).T, strict=True))
    path = write(tmp_path, csv_text(np.column_stack(list(EXACT[name](columns).values()))))

    (said,) = read_log(path, fixes=[name]).fixes
    log = read_log(path, fixes=[name])

    assert said.startswith(f"{name}: ")
    for quantity in ("delta", "r", "U"):
        np.testing.assert_allclose(getattr(log, quantity), columns[quantity], rtol=1e-14, atol=1e-17)
    np.testing.assert_allclose(np.diff(log.t), np.diff(columns["t"]), atol=1e-9)


@pytest.mark.parametrize(
    ("damage", "fix"),
    [(stuck("r"), "drop_stuck"), (interpolated, "drop_interpolated"), (clipped("r"), "drop_clipped"),
     (spiked("U"), "drop_spikes")],
)  # fmt: skip
def test_what_was_not_measured_becomes_missing_and_the_rest_stays(tmp_path, sound, damage, fix):
    damaged = damage(sound, np.random.default_rng(1))
    columns = look(sound, tmp_path).columns

    values, (said,) = apply_fixes([fix], damaged, columns, [])

    for name, column in values.items():
        kept = np.isfinite(column)
        np.testing.assert_array_equal(column[kept], damaged[name][kept])
    spoilt = np.any([damaged[name] != sound.columns[name] for name in damaged], axis=0)
    emptied = np.any([np.isnan(column) for column in values.values()], axis=0)
    assert np.count_nonzero(spoilt & emptied) > 0.9 * np.count_nonzero(spoilt)
    assert "left empty" in said


def test_the_longest_of_joined_recordings_is_kept(tmp_path, sound):
    damaged = restarted(sound, np.random.default_rng(3))
    columns = look(sound, tmp_path).columns

    values, (said,) = apply_fixes(["keep_longest_part"], damaged, columns, [])

    part = values["r"].size
    assert part >= damaged["t"].size / 2
    assert np.array_equal(values["r"], damaged["r"][:part]) or np.array_equal(
        values["r"], damaged["r"][-part:]
    )
    assert "2 parts found" in said


def test_a_header_in_the_middle_is_mended_by_the_same_repair(tmp_path):
    text = csv_text(drive(400))
    again = "".join(csv_text(drive(300)).splitlines(keepends=True))
    path = write(tmp_path, text + again)

    seen = survey(path)
    log = read_log(path, fixes=["keep_longest_part"])

    assert seen.certain[0].fault == "header_again"
    assert seen.certain[0].paste == "--fix keep_longest_part"
    assert log.samples == 400


def test_text_in_cells_is_left_out_on_request_and_counted(tmp_path):
    text = csv_text(drive()).replace("\n0.5,", "\n0.5,#REF!", 1)
    log = read_log(write(tmp_path, text), fixes=["blank_text"])

    assert log.fixes == ("blank_text: 1 cells left empty",)
    assert np.count_nonzero(np.isnan(log.delta)) == 1


def test_slow_columns_are_held_only_on_request_and_the_yaw_rate_never(tmp_path):
    columns = drive(1000)
    for column in (1, 2, 3):
        columns[np.arange(1000) % 4 != column % 2, column] = np.nan
    path = write(tmp_path, csv_text(columns).replace("nan", ""))

    log, held = read_log(path), read_log(path, fixes=["hold_slow_columns"])

    assert [one.fault for one in log.findings] == ["column_slower"] * 3
    assert np.isnan(log.delta).mean() == pytest.approx(0.75, abs=0.01)
    assert np.isnan(held.delta).mean() < 0.01
    np.testing.assert_array_equal(held.r, log.r)
    np.testing.assert_array_equal(held.U[5::4], held.U[6::4])


def test_rows_without_a_time_are_left_out(tmp_path):
    columns = drive()
    columns[50, 0] = np.nan
    path = write(tmp_path, csv_text(columns).replace("nan", ""))

    assert survey(path).certain[0].fix == "drop_untimed_rows"
    assert read_log(path, fixes=["drop_untimed_rows"]).samples == 299


def test_repairs_are_made_in_one_order_and_unknown_ones_refused():
    assert check_fixes(["drop_spikes", "sort_time"]) == ("sort_time", "drop_spikes")
    assert all(fix.words for fix in FIXES.values())
    with pytest.raises(UsageError, match="there are blank_text, unwrap_time"):
        check_fixes(["mend"])


def test_a_repair_of_a_column_that_is_not_there_says_so():
    values, said = apply_fixes(["flip_steer_sign"], {"t": np.arange(9.0)}, {}, [])

    assert values.keys() == {"t"}
    assert said == ("flip_steer_sign: nothing changed, the column could not be read",)
