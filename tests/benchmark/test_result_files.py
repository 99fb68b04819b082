"""The files: every number once more from the JSON, never as a word, nothing half-written over a file."""

import json
import math

import pytest

from similitude.benchmark.result_files import as_json, plain, read_result, write_result
from similitude.errors import UsageError

from .small_result import small_result


def test_a_result_is_read_back_as_it_was_written(tmp_path):
    result = small_result()
    files = write_result(result, tmp_path / "new" / "folder")
    back = read_result(tmp_path / "new" / "folder" / "benchmark.json")

    assert plain(back.record) == plain(result.record)
    assert back.rows(estimator="<b>mine</b>")[0]["alarm_s"] == math.inf
    assert set(files) == {"numbers", "page"}


def test_the_file_is_strict_json_with_a_row_a_line():
    text = as_json(small_result().record)

    assert len(json.loads(text)["rows"]) == 4
    assert sum('"manoeuvre"' in line for line in text.splitlines()) == 4
    assert "Infinity" not in text and "NaN" not in text


def test_what_has_no_number_is_null_and_never_is_a_word():
    assert plain({"a": [math.nan, math.inf, 1.23456789, 3]}) == {"a": [None, "never", 1.235, 3]}


def test_a_folder_that_is_a_file_is_refused(tmp_path):
    (tmp_path / "taken").write_text("")
    with pytest.raises(UsageError, match="taken"):
        write_result(small_result(), tmp_path / "taken")
