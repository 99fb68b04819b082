"""What is committed under generated/ is what the Models generate today."""

import difflib

import pytest

from similitude import generate
from similitude.generated import __path__ as generated


@pytest.fixture(scope="module")
def programs():
    return generate.shipped()


@pytest.fixture(scope="module")
def texts(programs):
    return generate.texts(programs)


def test_the_committed_files_are_a_fresh_generation(texts):
    stale = []
    for name, fresh in texts.items():
        path = generate.DIRECTORY / name
        committed = path.read_text(encoding="utf-8") if path.exists() else ""
        lines = committed.splitlines(), fresh.splitlines()
        stale += list(difflib.unified_diff(*lines, f"{name} (committed)", f"{name} (fresh)", "", "", 2, ""))
    if stale:
        shown = "\n".join(stale[:80])
        pytest.fail(
            f"{shown}\n\nThe model or the generator changed; run and commit:\n"
            "    python -m similitude.generate",
            pytrace=False,
        )


def test_nothing_else_lies_beside_them(texts):
    found = {p.name for p in generate.DIRECTORY.iterdir() if p.is_file()}

    assert found == {*texts, "__init__.py"}
    assert str(generate.DIRECTORY) in list(generated)


def test_main_writes_every_file(programs, texts, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(generate, "DIRECTORY", tmp_path)
    monkeypatch.setattr(generate, "shipped", lambda: programs)

    generate.main()

    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == texts
    assert len(capsys.readouterr().out.splitlines()) == len(texts)


def test_every_shipped_program_names_its_source(programs):
    for program in programs:
        assert program.name.isidentifier()
        assert any("Brennan" in line for line in program.provenance)
