"""`similitude inspect`: exit codes, streams, files, and what is imported."""

import json
import pathlib
import subprocess
import sys

import pytest

from similitude.cli import main

DATA = pathlib.Path(__file__).parents[1] / "data"
RAV4 = str(DATA / "rav4_straight.csv")


@pytest.fixture
def inspect(capsys):
    """Run the command; its exit code, stdout and stderr."""

    def run(*words):
        with pytest.raises(SystemExit) as left:
            main(["inspect", *map(str, words)])
        return left.value.code or 0, *capsys.readouterr()

    return run


def test_a_log_is_looked_at_whatever_is_found(inspect):
    code, out, err = inspect(RAV4)

    assert (code, err) == (0, "") and "wheelbase" in out


def test_a_log_that_identify_refuses_is_looked_at_too(inspect):
    code, out, _ = inspect(DATA / "opendbc_specs.csv")

    assert code == 0 and "refused by identify" in out


def test_a_table_below_facts_about_the_recording_is_looked_at_too(inspect, tmp_path):
    facts = tmp_path / "facts.csv"
    facts.write_text("Logger;X-12\nDriver: B\n\n" + pathlib.Path(RAV4).read_text())

    code, out, err = inspect(facts, "--json")

    found = json.loads(out)
    assert (code, err) == (0, "")
    assert ["late_header"] == [one["fault"] for one in found["findings"] if one["refuses"]]
    assert found["columns"][0]["header"] == "t [s]"


def test_nothing_to_look_at_is_3_and_does_not_stop_the_others(inspect, tmp_path):
    picture = tmp_path / "picture.csv"
    picture.write_bytes(b"\x89PNG\r\n\x1a\n")

    code, out, err = inspect(tmp_path / "none.csv", picture, RAV4, "--json")

    assert code == 3 and "none.csv" in err and "picture" in err
    assert [json.loads(line)["log"] for line in out.splitlines()] == [RAV4]


def test_json_is_one_line_a_log(inspect):
    code, out, _ = inspect(RAV4, RAV4, "--json", "--vehicle", DATA / "rav4.toml")

    records = [json.loads(line, parse_constant=pytest.fail) for line in out.splitlines()]
    assert code == 0 and len(records) == 2 and records[0] == records[1]
    assert records[0]["prospects"]["verdict"] == "not_excited"


def test_html_is_written_whole_and_the_page_is_printed_too(inspect, tmp_path):
    target = tmp_path / "deep" / "page.html"

    code, out, _ = inspect(RAV4, "--html", target)

    assert code == 0 and "Columns" in out
    assert target.read_text(encoding="utf-8").startswith("<!")
    assert [path.name for path in target.parent.iterdir()] == ["page.html"]


@pytest.mark.parametrize(
    "words",
    [
        [RAV4, RAV4, "--html", "page.html"],
        [RAV4, "--vehicle", "no.toml"],
        [RAV4, "--map", "delta"],
        [RAV4, "--map", "speed_of_light=U"],
        [],
    ],
)
def test_a_command_that_cannot_be_carried_out_is_2(inspect, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    assert inspect(*words)[0] == 2
    assert list(tmp_path.iterdir()) == []


def test_a_page_that_cannot_be_written_is_2_and_leaves_nothing(inspect, tmp_path):
    (tmp_path / "page.html").mkdir()

    code, _, err = inspect(RAV4, "--html", tmp_path / "page.html")

    assert code == 2 and "cannot be written" in err
    assert [path.name for path in tmp_path.iterdir()] == ["page.html"]


def test_columns_are_mapped(inspect, tmp_path):
    text = pathlib.Path(RAV4).read_text().replace("delta [rad]", "SWA [rad]", 1)
    log = tmp_path / "log.csv"
    log.write_text(text)

    _, out, _ = inspect(log, "--map", "delta=SWA", "--json")

    assert json.loads(out)["columns"][1]["taken_for"] == "delta"


def test_a_look_loads_neither_symbols_nor_pint_nor_scipy():
    words = ["inspect", RAV4, "--vehicle", str(DATA / "rav4.toml")]
    code = f"""
import sys
from similitude.cli import main
try:
    main({words!r})
except SystemExit:
    pass
print([name for name in ("sympy", "pint", "scipy", "matplotlib") if name in sys.modules])
"""
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout

    assert out.splitlines()[-1] == "[]"


def test_help_loads_nothing_heavy():
    code = """
import sys
from similitude.cli import main
try:
    main(["inspect", "--help"])
except SystemExit:
    pass
print([name for name in ("numpy", "sympy", "pint", "scipy", "matplotlib", "pyarrow") if name in sys.modules])
"""
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout

    assert out.splitlines()[-1] == "[]"
