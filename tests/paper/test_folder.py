"""The files: all of them, or a message."""

import json

import pytest

from similitude.errors import UsageError
from similitude.paper import folder
from similitude.paper.pictures import PICTURES

from .reproduced import small


@pytest.fixture(autouse=True)
def plain_page(monkeypatch):
    monkeypatch.setattr(folder, "companion", lambda done: "<!DOCTYPE html>")


def test_page_claims_and_pictures_are_written(tmp_path):
    files = folder.write(small(), tmp_path / "new" / "folder")

    assert set(files) == {"paper.html", "claims.json", *(p.file for p in PICTURES.values())}
    records = json.loads((tmp_path / "new" / "folder" / "claims.json").read_text())
    assert [sorted(r)[:3] for r in records] and records[0]["id"] == "eq32-gain"
    assert sorted(p.name for p in (tmp_path / "new" / "folder").iterdir()) == sorted(files)


def test_a_folder_that_cannot_be_is_refused(tmp_path):
    (tmp_path / "file").write_text("x")
    with pytest.raises(UsageError, match="cannot be written"):
        folder.write(small(), tmp_path / "file" / "below")
