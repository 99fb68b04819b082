"""Kept drives: made once, made again when anything they depend on changes or the file is damaged."""

import numpy as np
import pytest

from similitude.benchmark.kept_drives import kept


@pytest.fixture
def made(tmp_path, monkeypatch):
    """A maker that counts, and a cache of its own."""
    monkeypatch.setenv("SIMILITUDE_CACHE", str(tmp_path))
    calls = []

    def make():
        calls.append(1)
        return {"r": np.arange(3.0)}

    return make, calls, tmp_path


def test_the_same_is_made_once(made):
    make, calls, _ = made
    first, second = kept({"seed": 1}, make), kept({"seed": 1}, make)

    assert len(calls) == 1 and np.array_equal(first["r"], second["r"])


def test_another_description_is_another_drive(made):
    make, calls, _ = made
    kept({"seed": 1}, make)
    kept({"seed": 2}, make)

    assert len(calls) == 2


@pytest.mark.parametrize("damage", [b"", b"no archive", b"PK\x03\x04half"])
def test_a_damaged_file_is_made_again(made, damage):
    make, calls, folder = made
    kept({"seed": 1}, make)
    next(folder.rglob("*.npz")).write_bytes(damage)

    assert np.array_equal(kept({"seed": 1}, make)["r"], np.arange(3.0)) and len(calls) == 2


def test_a_cache_that_cannot_be_written_does_not_stop_a_run(made):
    make, _, folder = made
    (folder / "drives").write_text("a file where the folder should be")

    assert kept({"seed": 1}, make)["r"].size == 3
