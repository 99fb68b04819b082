"""The rivals: four where padasip is installed, each with a line about it."""

from importlib.util import find_spec

from similitude.benchmark import rivals as module


def test_every_rival_has_a_name_and_a_line():
    found = module.rivals()

    assert [one.name for one in found][:3] == ["nine_state", "dual_ekf", "window"]
    assert all(one.about for one in found)
    assert ("padasip" in {one.name for one in found}) == (find_spec("padasip") is not None)


def test_a_package_that_is_missing_leaves_its_rival_out(monkeypatch):
    monkeypatch.setattr(module, "find_spec", lambda name: None)

    assert "padasip" not in {one.name for one in module.rivals()}
