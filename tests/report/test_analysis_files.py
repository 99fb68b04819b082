"""The files of an analysis are both there or the fault is said."""

import json

import pytest

from similitude.errors import UsageError
from similitude.report.analysis_files import write_analysis

from .analysis_case import analysed


def test_the_page_and_the_record_are_written(tmp_path):
    files = write_analysis(analysed("bicycle"), tmp_path / "deep" / "folder")

    assert json.loads((tmp_path / "deep/folder/analysis.json").read_text())["system"] == "bicycle"
    assert (tmp_path / "deep/folder/analysis.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    assert sorted(p.name for p in (tmp_path / "deep/folder").iterdir()) == ["analysis.html", "analysis.json"]
    assert set(files) == {"html", "json"}


def test_a_file_in_the_way_is_named(tmp_path):
    (tmp_path / "taken").write_text("")

    with pytest.raises(UsageError, match="cannot be written") as caught:
        write_analysis(analysed("bicycle"), tmp_path / "taken" / "below")
    assert caught.value.paste == "--out similitude-out"
