"""`similitude simulate`: a drive in files, lists, changes, and what is refused."""

import json
import pathlib

import pytest

from similitude.cli import main


@pytest.fixture
def simulate(capsys, tmp_path, monkeypatch):
    """Run the command in an empty folder; its exit code, stdout and stderr."""
    monkeypatch.chdir(tmp_path)

    def run(*words):
        with pytest.raises(SystemExit) as left:
            main(["simulate", *map(str, words)])
        return left.value.code or 0, *capsys.readouterr()

    return run


SHORT = ("--set", "run.duration=2 s")


def test_a_drive_its_truth_and_its_vehicle_are_written(simulate):
    code, out, err = simulate("slalom", *SHORT)
    assert (code, err) == (0, "") and "similitude identify slalom.csv --vehicle slalom.toml" in out
    assert sorted(path.name for path in pathlib.Path().iterdir()) == [
        "slalom.csv", "slalom.toml", "slalom_truth.csv",
    ]  # fmt: skip


def test_json_is_one_line(simulate):
    code, out, _ = simulate("slalom", *SHORT, "--json", "--out", "a.parquet", "--truth", "b.csv", "--seed", 4)
    record = json.loads(out, parse_constant=pytest.fail)
    assert code == 0 and record["files"] == {"log": "a.parquet", "truth": "b.csv", "vehicle": "a.toml"}
    assert record["seed"] == 4 and record["samples"] == 201 and record["K"]["first"] > 0


def test_the_same_seed_gives_the_same_bytes_and_another_does_not(simulate):
    for name, seed in (("a", 1), ("b", 1), ("c", 2)):
        simulate("slalom", *SHORT, "--out", f"{name}.csv", "--seed", seed)
    a, b, c = (pathlib.Path(f"{name}.csv").read_bytes() for name in "abc")
    assert a == b != c


def test_shipped_scenarios_are_listed_and_shown(simulate):
    code, out, _ = simulate("--list")
    assert code == 0 and "treadmill" in out and "peak friction" in out
    code, shown, _ = simulate("slalom", "--show")
    assert code == 0 and shown.startswith("title") and "[driver]" in shown
    pathlib.Path("mine.toml").write_text(shown)
    assert simulate("mine.toml", *SHORT)[0] == 0 and pathlib.Path("mine.csv").exists()


@pytest.mark.parametrize(
    ("words", "code", "says"),
    [
        ([], 2, "--list"),
        (["slalon"], 2, "similitude simulate slalom"), (["slalom", "--set", "x"], 2, "--set"),
        (["slalom", "--out", "drive.txt"], 2, ".parquet"),
        (["slalom", "--set", "driver.amplitude=3"], 3, "mrad"),
        (["slalom", "--set", "vehicle.m=-1 kg"], 3, "not positive"), (["slalom", "--seed", "-1"], 2, "seed"),
        (["treadmill_hydroplaning", "--set", "plant.kind=linear"], 3, "no keys of its own"),
        (["square_closed_loop", "--set", "driver.schedule=estimate"], 3, "sensors.r.noise"),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_said_and_leaves_nothing(simulate, words, code, says):
    found, out, err = simulate(*words)
    assert (found, out) == (code, "") and says in err and list(pathlib.Path().iterdir()) == []


def test_a_driver_may_believe_the_truth_or_the_filter_that_runs_beside(simulate):
    """On the wet half of the belt, which has a place: all three drive differently."""
    for schedule in ("none", "truth", "estimate"):
        words = (
            "--set",
            f"driver.schedule={schedule}",
            "--set",
            "run.duration=14 s",
            "--out",
            f"{schedule}.csv",
        )
        code, _, err = simulate("wet_lane", *words)
        assert (code, err) == (0, "")
    places = [pathlib.Path(f"{name}_truth.csv").read_bytes() for name in ("none", "truth", "estimate")]
    assert len(set(places)) == 3
