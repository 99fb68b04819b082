"""`similitude compare`: simulate, identify, compare, as three commands."""

import json

import pytest

from similitude.cli import main


def run(capsys, *words):
    with pytest.raises(SystemExit) as left:
        main([*map(str, words)])
    return left.value.code or 0, *capsys.readouterr()


def test_simulate_identify_compare(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run(capsys, "simulate", "friction_step", "--out", "drive.csv", "--seed", 1)[0] == 0
    assert run(capsys, "identify", "drive.csv", "--vehicle", "drive.toml", "--json")[0] == 0

    code, out, err = run(capsys, "compare", "similitude-out/drive", "drive_truth.csv")
    assert (code, err) == (0, "") and "half-way after" in out

    code, out, _ = run(capsys, "compare", "similitude-out/drive", "drive_truth.csv", "--json")
    record = json.loads(out, parse_constant=pytest.fail)
    assert code == 0 and record["coverage"] > 0.8 and record["rms_end"] < 0.3
    assert 0 < record["changes"][0]["half_way"] < 5


def test_a_file_that_is_not_there_is_usage(capsys, tmp_path):
    code, _, err = run(capsys, "compare", tmp_path / "none", tmp_path / "truth.csv")
    assert code == 2 and "no file" in err
