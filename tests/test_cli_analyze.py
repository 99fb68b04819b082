"""`similitude analyze` from the outside."""

import json
import subprocess
import sys

import pytest

from similitude.cli import main


def run(capsys, *words):
    with pytest.raises(SystemExit) as left:
        main(["analyze", *words])
    said = capsys.readouterr()
    return left.value.code or 0, said.out, said.err


def test_a_shipped_system_is_one_page(capsys):
    code, out, _ = run(capsys, "rlc_circuit")

    assert code == 0
    assert "What the outputs tell" in out


def test_json_is_one_line_and_holds_the_base_asked_for(capsys):
    code, out, _ = run(capsys, "rlc_circuit", "--base", "R, C,V", "--json")

    assert code == 0
    assert out.count("\n") == 1
    record = json.loads(out)
    assert record["base"] == ["R", "C", "V"]
    assert record["base_from"] == "as asked"


def test_files_go_where_out_says(capsys, tmp_path):
    code, out, _ = run(capsys, "rlc_circuit", "--out", str(tmp_path / "page"))

    assert code == 0
    assert (tmp_path / "page" / "analysis.html").exists()
    assert "analysis.html" in out.replace("\n", "")


@pytest.mark.parametrize(
    ("words", "code", "says"),
    [
        (["bycicle"], 2, "similitude analyze bicycle"),
        (["missing.py"], 2, "no file"),
        (["bicycle", "--base", "m,,U"], 2, "no list of different names"),
        (["bicycle", "--base", "m,L"], 3, "cannot be a base"),
        (["bicycle", "--base", "m,L,Q"], 3, "'Q'"),
    ],
)
def test_faults_have_four_parts_and_a_code(capsys, words, code, says):
    got, out, err = run(capsys, *words)

    assert got == code
    assert says in err
    assert out == ""
    assert all(part in err for part in ("Usually", "Paste:", "Read:"))


def test_help_of_the_command_imports_no_algebra():
    code = (
        "import sys\n"
        "from similitude.cli import main\n"
        "try:\n    main(['analyze', '--help'])\nexcept SystemExit:\n    pass\n"
        "sys.exit(any(m in sys.modules for m in ('sympy', 'numpy', 'pint', 'matplotlib')))"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=False).returncode == 0
