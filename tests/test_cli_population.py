"""`similitude population`: contract of the JSON, exit codes, files."""

import json
import pathlib

import pytest

from similitude.cli import main

DATA = pathlib.Path(__file__).parents[1] / "data"


def run(capsys, *words):
    with pytest.raises(SystemExit) as left:
        main(["population", *map(str, words)])
    out = capsys.readouterr()
    return left.value.code or 0, out.out, out.err


def test_a_bundled_table_gives_one_line_of_json_and_the_files(capsys, tmp_path):
    code, out, _ = run(
        capsys, DATA / "lvipd_204.csv", "--system", "bicycle", "--json", "--out", tmp_path / "p"
    )
    record = json.loads(out)

    assert code == 0 and record["rows"] == 204 and out.count("\n") == 1
    (ratio,) = [g for name, g in record["groups"].items() if name.startswith("Iz/")]
    assert ratio["n"] == 204 and 2.718281828 ** ratio["mean_log"] == pytest.approx(1.034, rel=0.01)
    assert json.loads((tmp_path / "p" / "population.json").read_text())["rows"] == 204
    assert "Distributions" in (tmp_path / "p" / "population.html").read_text()


def test_columns_can_be_named_and_signals_stated(capsys, tmp_path):
    table = tmp_path / "cars.csv"
    table.write_text(
        "weight of car [kg],wb [m],front [kN/rad]\n" + "1500,2.7,100\n1400,2.6,95\n1300,2.5,90\n"
    )
    named = ("--map", "m=weight of car", "--map", "L=wb", "--map", "Caf=front")
    code, out, _ = run(capsys, table, *named, "--at", "U=90 km/h", "--json")
    record = json.loads(out)

    assert code == 0 and record["at"] == pytest.approx({"U": 25.0})
    assert record["groups"]["pi3"]["mean_log"] == pytest.approx(-1.2645, abs=1e-3)  # ln(95e3 2.6/(1400 625))


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("nowhere.csv",), 3, "cannot be opened"),
        ((DATA / "lvipd_204.csv", "--system", "tractor"), 2, "not known"),
        ((DATA / "lvipd_204.csv", "--at", "m=3 kg"), 2, "no signal"),
        ((DATA / "lvipd_204.csv", "--map", "q=ab"), 2, "no parameter"),
    ],
)
def test_faults_leave_with_their_exit_code(capsys, words, code, said):
    left, _, err = run(capsys, *words)
    assert left == code and said in err
