import json
import os

import pyarrow.parquet
import pytest

from similitude.errors import UsageError
from similitude.report import files
from similitude.report.files import write_report

OURS = {"estimate.parquet", "plot.png", "report.html", "summary.json"}


def _names(folder):
    return {path.name for path in folder.iterdir()}


def test_all_files_of_a_run_and_nothing_else(example_run, tmp_path):
    folder = tmp_path / "deep" / "er"
    written = write_report(example_run(300), folder)
    assert _names(folder) == OURS
    assert json.loads((folder / "summary.json").read_text("utf-8"))["files"] == written
    assert all(os.path.isfile(path) for path in written.values())
    assert pyarrow.parquet.read_table(written["estimate"]).num_rows == 300


def test_older_files_of_ours_are_replaced_and_those_of_others_stay(example_run, tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    write_report(example_run(300), tmp_path)
    write_report(example_run(200), tmp_path)
    assert _names(tmp_path) == OURS | {"notes.txt"}
    assert json.loads((tmp_path / "summary.json").read_text("utf-8"))["samples"] == 200
    assert pyarrow.parquet.read_table(tmp_path / "estimate.parquet").num_rows == 200


@pytest.mark.parametrize("stage", ["write_estimate", "save_plot", "html_report", "json_page"])
@pytest.mark.parametrize("fault", [RuntimeError, KeyboardInterrupt])
def test_a_failure_half_way_leaves_nothing_at_all(example_run, tmp_path, monkeypatch, stage, fault):
    def fail(*_):
        raise fault

    monkeypatch.setattr(files, stage, fail)
    with pytest.raises(fault):
        write_report(example_run(200), tmp_path / "new" / "folder")
    assert _names(tmp_path) == set()


def test_a_failure_leaves_the_older_results_whole(example_run, tmp_path, monkeypatch):
    write_report(example_run(300), tmp_path)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}

    def disk_full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files, "save_plot", disk_full)
    with pytest.raises(UsageError, match="No space left on device"):
        write_report(example_run(200), tmp_path)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_a_summary_is_never_beside_files_of_another_run(example_run, tmp_path, monkeypatch):
    write_report(example_run(300), tmp_path)
    moved = []

    def cut_off_after_one(source, target):
        if moved:
            raise KeyboardInterrupt
        moved.append(target)
        os.rename(source, target)

    monkeypatch.setattr(files.os, "replace", cut_off_after_one)
    with pytest.raises(KeyboardInterrupt):
        write_report(example_run(200), tmp_path)
    assert _names(tmp_path) == OURS - {"summary.json"}


def test_a_file_in_the_way_is_named(example_run, tmp_path):
    (tmp_path / "taken").write_text("")
    with pytest.raises(UsageError, match="taken"):
        write_report(example_run(200), tmp_path / "taken")
    with pytest.raises(UsageError, match="taken"):
        write_report(example_run(200), tmp_path / "taken" / "below")
    assert (tmp_path / "taken").read_text() == ""
