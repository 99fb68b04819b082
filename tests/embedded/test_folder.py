"""An exported folder: whole, the same for the same command, and as its README says."""

import json
import re
import shutil
import subprocess

import pytest

from similitude.embedded.folder import export
from similitude.errors import UsageError

PAPER = {"estimator": "paper", "real": "float", "target": "host"}


def test_the_example_runs_as_the_readme_says(tmp_path):
    done = export("bicycle", **PAPER, out=tmp_path / "firmware")
    page = (done.folder / "README.md").read_text()
    lines = re.search(r"```\n(cc .*?)```", page, re.S).group(1)
    subprocess.run(["sh", "-ec", lines], cwd=done.folder, check=True)


def test_the_same_command_writes_the_same_bytes(tmp_path):
    one, two = (export("bicycle", **PAPER, out=tmp_path / name) for name in ("one", "two"))

    assert one.files == two.files
    for name in one.files:
        assert (one.folder / name).read_bytes() == (two.folder / name).read_bytes(), name


def test_an_export_is_replaced_and_anything_else_is_left_alone(tmp_path):
    export("bicycle", **PAPER, out=tmp_path / "firmware")
    export("bicycle", **{**PAPER, "estimator": "band"}, out=tmp_path / "firmware")
    assert json.loads((tmp_path / "firmware" / "evidence.json").read_text())["estimator"] == "band"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["firmware"]
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "main.c").write_text("int main(void) { return 0; }\n")
    with pytest.raises(UsageError, match="no export wrote"):
        export("bicycle", **PAPER, out=tmp_path / "own")
    assert [path.name for path in (tmp_path / "own").iterdir()] == ["main.c"]


def test_the_step_calls_nothing(tmp_path):
    if shutil.which("nm") is None:
        pytest.skip("nm is missing")
    done = export("bicycle", **{**PAPER, "estimator": "population"}, out=tmp_path / "firmware")
    build = ["cc", "-std=c99", "-O2", "-ffreestanding", "-ffp-contract=off", "-c", f"{done.name}.c"]
    subprocess.run(build, cwd=done.folder, check=True)
    symbols = subprocess.run(
        ["nm", f"{done.name}.o"], cwd=done.folder, check=True, capture_output=True, text=True
    )
    kinds = [line.split()[-2:] for line in symbols.stdout.splitlines()]

    assert [name for kind, name in kinds if kind == "U"] == []
    assert [name for kind, name in kinds if kind in "BbDdC"] == []  # no globals
    own = ("init", "step", "save", "restore")
    assert {name for kind, name in kinds if kind == "T"} == {f"{done.name}_{verb}" for verb in own}


def test_numbers_nobody_stated_are_named(tmp_path):
    text = (export("bicycle", **PAPER, out=tmp_path / "f").folder / "bicycle_paper_config.h").read_text()

    assert "L = 2.69 m   reference: state yours with --vehicle FILE.toml" in text
