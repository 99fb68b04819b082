"""The command on the bundled logs as a user types it: exit code, JSON, files, what is imported."""

import importlib.util
import json
import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow.parquet as parquet
import pytest

from similitude.status import STATUS
from similitude.verdict import VERDICTS

ROOT = Path(__file__).parents[1]
DATA = ROOT / "data"
RUN = "import sys; from similitude.cli import main; sys.argv[0] = 'similitude'; main(sys.argv[1:])"
KEYS = {
    "schema": int, "log": str, "samples": int, "duration_s": float, "estimator": str, "verdict": str,
    "reason": str, "K": dict, "pi3": dict, "groups": dict, "nuisance": dict, "alarms": list,
    "prediction": dict, "handling": dict, "warnings": list, "assumed": dict, "files": dict,
}  # fmt: skip
COLUMNS = [
    "t [s]", "K [m^2/s^2]", "K_std [m^2/s^2]", "K_lo [m^2/s^2]", "K_hi [m^2/s^2]", "pi3 [-]",
    "pi3_std [-]", "Caf [N/rad]", "status",
]  # fmt: skip


def command(*words, code=RUN, cwd=ROOT, **environment):
    """Run Python code on words in a fresh process; a value of None unsets a variable."""
    env = {**os.environ, **environment}
    env = {name: value for name, value in env.items() if value is not None}
    words = [sys.executable, "-c", code, *map(str, words)]
    return subprocess.run(words, cwd=cwd, env=env, capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def demo():
    """The script of `make demo`, for the log it makes."""
    spec = importlib.util.spec_from_file_location("demo", ROOT / "scripts" / "demo.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def answers(tmp_path_factory, demo):
    """Name of a log to its JSON, and the folder of its files."""
    out = tmp_path_factory.mktemp("out")
    sine = demo.write_log_with_sines(DATA / "rav4_straight.csv", out / "rav4_with_sines.csv")
    jobs = {
        "rav4.toml": [DATA / "rav4_straight.csv", sine],
        "f1tenth.toml": [DATA / "f1tenth_ds1.csv"],
        "bmw_m8.toml": [DATA / "bmw_m8_double_lane_change.csv"],
    }
    found = {}
    for car, logs in jobs.items():
        done = command("identify", *logs, "--vehicle", DATA / car, "--out", out / car, "--json")
        assert (done.returncode, done.stderr) == (0, "")
        for log, line in zip(logs, done.stdout.splitlines(), strict=True):
            found[log.stem] = json.loads(line)
    return found


NAMES = ("rav4_straight", "rav4_with_sines", "f1tenth_ds1", "bmw_m8_double_lane_change")


@pytest.mark.parametrize("name", NAMES)
def test_the_json_is_the_contract_key_by_key(answers, name):
    a = answers[name]
    assert {key: type(a[key]) for key in KEYS} == KEYS
    assert a["schema"] == 1
    assert a["verdict"] in VERDICTS
    assert a["estimator"] == "population"
    assert Path(a["log"]).stem == name
    assert a["K"].keys() == {"value", "std", "lo", "hi", "unit"} and a["K"]["unit"] == "m^2/s^2"
    assert a["pi3"].keys() == {"value", "std", "at_speed"}
    assert {"K", "pi1", "eta", "rho"} <= a["groups"].keys()
    assert all({"value", "std", "prior"} <= group.keys() for group in a["groups"].values())
    assert {"yaw_bias", "steer_offset"} <= a["nuisance"].keys()
    assert all(found.keys() == {"value", "std", "unit"} for found in a["nuisance"].values())
    assert a["alarms"] == []
    assert all({"value", "from"} <= given.keys() and given["from"] for given in a["assumed"].values())
    assert all(isinstance(line, str) for line in a["warnings"])


@pytest.mark.parametrize("name", NAMES)
def test_the_numbers_of_the_json_fit_each_other(answers, name):
    a = answers[name]
    K, sd = a["K"]["value"], a["K"]["std"] / a["K"]["value"]
    assert a["K"]["hi"] / K == pytest.approx(math.exp(1.96 * sd))
    assert K / a["K"]["lo"] == pytest.approx(math.exp(1.96 * sd))
    assert a["pi3"]["value"] * a["pi3"]["at_speed"] ** 2 == pytest.approx(K)
    assert a["groups"]["K"]["value"] == pytest.approx(K)
    prior_sd = a["groups"]["K"]["prior_std"] / a["groups"]["K"]["prior"]
    if a["verdict"] == "identified":
        assert sd <= 0.15 and sd <= prior_sd / 2
    if a["verdict"] == "not_excited":
        assert sd > prior_sd / 2
    if a["verdict"] == "weak":
        assert 0.15 < sd <= prior_sd / 2


@pytest.mark.parametrize("name", NAMES)
def test_the_files_are_there_and_the_table_has_a_whole_row_for_each_row(answers, name):
    a = answers[name]
    assert a["files"].keys() == {"estimate", "summary", "plot", "report"}
    files = {kind: Path(path) for kind, path in a["files"].items()}
    wanted = {"estimate.parquet", "summary.json", "plot.png", "report.html"}
    assert {path.name for path in files.values()} == wanted
    assert json.loads(files["summary"].read_text("utf-8")) == a
    assert files["plot"].read_bytes().startswith(b"\x89PNG")
    assert {path.name for path in files["plot"].parent.iterdir()} >= {path.name for path in files.values()}
    assert not list(files["plot"].parent.glob(".similitude-*"))
    table = parquet.read_table(files["estimate"])
    assert table.column_names == COLUMNS or table.column_names == [c for c in COLUMNS if "Caf" not in c]
    assert table.num_rows == a["samples"]
    for column in table.column_names:
        values = table[column].to_numpy()
        assert table[column].null_count == 0
        assert set(values) <= set(STATUS) if column == "status" else np.isfinite(values).all()
    assert table["K [m^2/s^2]"][-1].as_py() == a["K"]["value"]
    assert table["K_hi [m^2/s^2]"][-1].as_py() == pytest.approx(a["K"]["hi"])


def test_the_straight_drive_is_not_excited_and_says_so(answers):
    a = answers["rav4_straight"]
    assert a["verdict"] == "not_excited"
    assert "steering" in a["reason"]


def test_with_a_little_steer_it_is_identified_and_the_plant_is_in_the_interval(answers, demo):
    a = answers["rav4_with_sines"]
    assert a["verdict"] == "identified"
    # The plant answers the sines alone and the car's own drive stays in: 3 sd, not 1.96.
    sd = a["K"]["std"] / a["K"]["value"]
    assert abs(math.log(a["K"]["value"] / demo.PLANT["K"])) < 3 * sd
    assert a["prediction"]["rms"]["estimate"] < a["prediction"]["rms"]["kinematic"]


def test_the_model_car_s_warning_names_lag_and_steer_scale(answers):
    a = answers["f1tenth_ds1"]
    total = a["lag"]["value"] + a["lag"]["servo"]
    assert 0.03 < total < 0.15  # the logger's command acts 40 to 140 ms later
    assert a["lag"]["servo_slew"] > 1.0
    assert a["lag"]["from"] == "scanned"
    assert len(a["lag"]["scanned_s"]) == len(a["lag"]["cost"]) > 10
    said = " ".join(a["warnings"])
    assert f"{1000 * total:.0f} ms" in said and "command" in said
    assert "K and steer scale trade" in said
    assert a["assumed"]["steer_scale_std"]["value"] == 0.2


def test_the_bmw_s_warning_names_the_steer_scale(answers):
    assert "K and steer scale trade" in " ".join(answers["bmw_m8_double_lane_change"]["warnings"])
    assert "steer_lag" in answers["bmw_m8_double_lane_change"]["assumed"]


# ---- without a compiler -----------------------------------------------------------------------


@pytest.fixture
def short_log(tmp_path):
    """Three seconds of the straight drive with the sine: enough to learn, short for the twin."""
    lines = (DATA / "rav4_straight.csv").read_text().splitlines()
    rows = np.array([[float(x) for x in line.split(",")] for line in lines[1501:1651]])
    rows[:, 1] += 0.003 * np.sin(np.pi * rows[:, 0])
    text = "\n".join([lines[0], *(",".join(f"{x:.9g}" for x in row) for row in rows)])
    path = tmp_path / "short.csv"
    path.write_text(text + "\n")
    return path


def _identify_short(log, out, **environment):
    cache = {"SIMILITUDE_CACHE": str(out / "cache")}
    car = out.parent / "stated.toml"  # the lag is stated: without a compiler no whole-log fit finds it
    car.write_text((DATA / "rav4.toml").read_text() + 'steer_lag = "10 ms"\n')
    words = ["identify", log, "--vehicle", car, "--out", out, "--json"]
    done = command(*words, **cache, **environment)
    assert done.returncode == 0, done.stderr
    table = parquet.read_table(out / "estimate.parquet")
    return json.loads(done.stdout), table


def _without_words(answer):
    """Without the texts, and without the fit of the whole log, for which the twin is too slow."""
    answer["prediction"].pop("ratio_to_batch")
    answer["prediction"]["rms"].pop("batch", None)
    return {key: value for key, value in answer.items() if key not in ("warnings", "files", "batch")}


def test_without_a_compiler_the_twin_gives_the_same_bits(short_log, tmp_path):
    compiled, fast = _identify_short(short_log, tmp_path / "c", SIMILITUDE_CC=None)
    twin, slow = _identify_short(short_log, tmp_path / "py", SIMILITUDE_CC="/nowhere/cc")

    assert slow.equals(fast)
    assert _without_words(twin) == _without_words(compiled)
    said = [line for line in twin["warnings"] if line not in compiled["warnings"]]
    assert len(said) == 1
    assert "Python twin" in said[0] and "/nowhere/cc" in said[0] and "\n" not in said[0]
    assert not list((tmp_path / "py" / "cache").glob("*.so"))


@pytest.mark.skipif(importlib.util.find_spec("ziglang") is not None, reason="ziglang is a compiler")
def test_with_no_compiler_on_the_path_the_line_says_what_was_looked_for(short_log, tmp_path):
    empty = tmp_path / "empty"
    empty.mkdir()
    answer, _ = _identify_short(short_log, tmp_path / "py", SIMILITUDE_CC=None, PATH=str(empty))
    line = next(line for line in answer["warnings"] if "Python twin" in line)
    assert "no C compiler was found" in line and "gcc" in line


# ---- what is imported -------------------------------------------------------------------------

LOADED = """
import sys
from similitude.cli import main
try:
    main(sys.argv[1:])
except SystemExit as end:
    names = ("numpy", "scipy", "sympy", "pint", "matplotlib", "pyarrow")
    print("loaded", end.code, *[name for name in names if name in sys.modules])
"""


def _loaded(*words):
    done = command(*words, code=LOADED)
    _, exit_code, *names = done.stdout.splitlines()[-1].split()
    assert exit_code in ("0", "None"), done.stderr
    return set(names)


def test_help_imports_nothing_of_weight():
    assert _loaded("--help") == set()
    assert _loaded("identify", "--help") == set()


@pytest.mark.parametrize(
    ("log", "car"), [("rav4_straight.csv", "rav4.toml"), ("f1tenth_ds1.csv", "f1tenth.toml")]
)
def test_identify_imports_neither_sympy_nor_pint_nor_scipy(tmp_path, log, car):
    names = _loaded("identify", DATA / log, "--vehicle", DATA / car, "--out", tmp_path / "out", "--json")
    assert "numpy" in names
    assert not names & {"sympy", "pint", "scipy"}


# ---- exits ------------------------------------------------------------------------------------


def test_one_bad_log_ends_with_3_in_four_parts_and_the_good_one_is_done(tmp_path):
    good, bad = tmp_path / "good.csv", tmp_path / "bad.csv"
    shutil.copy(DATA / "rav4_straight.csv", good)
    bad.write_text("t [s],delta [rad],r,U [m/s]\n0,0,0,1\n")
    done = command("identify", bad, good, "--vehicle", DATA / "rav4.toml", "--json", cwd=tmp_path)
    assert done.returncode == 3
    assert [json.loads(line)["log"] for line in done.stdout.splitlines()] == [str(good)]
    assert len(done.stderr.strip().splitlines()) == 4
    assert {path.name for path in (tmp_path / "similitude-out").iterdir()} == {"good"}


def test_the_page_for_people_says_verdict_and_number(tmp_path):
    words = ["identify", DATA / "rav4_straight.csv", "--vehicle", DATA / "rav4.toml", "--out", tmp_path]
    done = command(*words)
    assert done.returncode == 0
    assert "not excited" in done.stdout and "m²/s²" in done.stdout.replace("m^2/s^2", "m²/s²")


def test_a_state_is_kept_over_drives_and_refused_by_another_car(tmp_path):
    state = tmp_path / "car.json"
    drives = [DATA / f"f1tenth_ds{i}.csv" for i in (1, 5)]
    words = ["--vehicle", DATA / "f1tenth.toml", "--state", state, "--json", "--out", tmp_path / "out"]
    done = command("identify", *drives, *words)
    first, second = (json.loads(line) for line in done.stdout.splitlines())

    assert done.returncode == 0, done.stderr
    assert first["time_scales"]["tyre"]["drives"] == 1 and second["time_scales"]["tyre"]["drives"] == 2
    assert "state file" in second["assumed"]["start"]["from"] and "start" not in first["assumed"]
    kept = state.read_bytes()
    other = ["--vehicle", DATA / "bmw_m8.toml", "--state", state, "--out", tmp_path / "other"]
    refused = command("identify", DATA / "bmw_m8_double_lane_change.csv", *other)
    assert refused.returncode == 3 and "StateError" in refused.stderr and str(state) in refused.stderr
    assert state.read_bytes() == kept and not (tmp_path / "other").exists()
