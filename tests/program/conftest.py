"""A cache of its own for every test, so that no test finds another one's library."""

import pytest


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """An empty cache directory; no compiler asked for by name."""
    directory = tmp_path / "cache"
    monkeypatch.setenv("SIMILITUDE_CACHE", str(directory))
    monkeypatch.delenv("SIMILITUDE_CC", raising=False)
    return directory
