"""The README of an export says what is there, in words a firmware engineer can follow."""

import re

import pytest

from similitude.embedded.folder import export
from similitude.embedded.targets import TARGETS


@pytest.mark.parametrize("target", ["cortex-m4f", "avr", "host"])
def test_every_file_it_names_is_there(tmp_path, target, monkeypatch):
    monkeypatch.setenv("PATH", "/nowhere")  # without tools: what was not measured is said
    done = export("bicycle", estimator="paper", real="float", target=target, out=tmp_path / "f")
    page = (done.folder / "README.md").read_text()
    table = page.partition("| File")[2].partition("## Use")[0]
    named = re.findall(r"`([\w/.]+\.[ch]|[\w]+/|evidence\.json)`", table)

    assert len(named) >= 5
    for name in named:
        assert (done.folder / name).exists() or name == ".h", name
    if target != "host":
        assert "was not measured: this machine lacked" in page
        assert TARGETS[target].packages in page
        for name in re.findall(r"(?<= )[\w]+\.(?:c|ld)(?= )", page.partition("cd emulated")[2]):
            assert (done.folder / "emulated" / name).exists(), name
