"""similitude paper: arguments, and what is printed; the work itself is tested under tests/paper."""

import importlib
import json

import pytest

from similitude import cli

from .paper.reproduced import small


@pytest.fixture
def quick(monkeypatch):
    """The command with the work taken out."""
    reproduction = importlib.import_module("similitude.paper.reproduction")
    folder = importlib.import_module("similitude.paper.folder")
    monkeypatch.setattr(reproduction, "reproduce", lambda begin: small())
    monkeypatch.setattr(folder, "companion", lambda done: "<!DOCTYPE html>")


def test_json_is_a_list_of_claims(quick, tmp_path, capsys):
    with pytest.raises(SystemExit) as left:
        cli.main(["paper", "--out", str(tmp_path / "out"), "--json"])
    records = json.loads(capsys.readouterr().out)

    assert left.value.code == 0
    assert all(
        {"id", "where", "printed", "ours", "verdict", "tolerance"} <= set(record) for record in records
    )
    assert (tmp_path / "out" / "paper.html").exists()


def test_the_table_ends_with_the_page(quick, tmp_path, capsys):
    with pytest.raises(SystemExit):
        cli.main(["paper", "--out", str(tmp_path / "out")])
    printed = capsys.readouterr().out

    assert "eq32-gain" in printed and printed.strip().endswith("paper.html")


def test_a_file_is_no_folder(tmp_path, capsys):
    (tmp_path / "page.html").write_text("")
    with pytest.raises(SystemExit) as left:
        cli.main(["paper", "--out", str(tmp_path / "page.html")])

    assert left.value.code == 2 and "is a folder" in capsys.readouterr().err
