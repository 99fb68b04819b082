"""The command `similitude estimate`, and the export of an estimator that a file holds."""

import json

import numpy as np
import pytest

from similitude.cli import main

FILE = """
import numpy as np
from similitude import make_estimator, shipped_system

u = 10 * np.sign(np.sin(2 * np.pi * 500 * np.arange(0, 0.02, 2e-5)))
ESTIMATOR = make_estimator(
    shipped_system("rlc_circuit"), drive=u, step="20 us", noise="0.1 V", prior={"R": "280 ohm +- 30 %"}
)
"""


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main(list(map(str, arguments)))
    said = capsys.readouterr()
    return end.value.code, said.out, said.err


@pytest.fixture(scope="module")
def circuit(tmp_path_factory):
    folder = tmp_path_factory.mktemp("circuit")
    file, log = folder / "circuit.py", folder / "log.csv"
    file.write_text(FILE)
    names: dict = {}
    exec(FILE, names)
    columns = names["ESTIMATOR"].simulate(seed=1)
    header = "t [s],u [V],vc [V]"
    np.savetxt(log, np.column_stack(list(columns.values())), delimiter=",", header=header, comments="")
    return file, log


def test_a_log_gives_an_estimate_as_text_and_as_json(capsys, circuit):
    file, log = circuit
    code, said, _ = run(capsys, "estimate", file, log)
    assert code == 0 and "identified" in said and "taken: " in said

    code, said, _ = run(capsys, "estimate", file, log, "--json")
    assert code == 0 and json.loads(said)["parameters"]["R"]["unit"] == "ohm"


def test_a_bad_log_does_not_stop_the_others(capsys, circuit, tmp_path):
    file, log = circuit
    bad = tmp_path / "bad.csv"
    bad.write_text("t [s],u [V]\n0,1\n1,1\n")
    code, said, wrong = run(capsys, "estimate", file, bad, log, "--json")

    assert code == 3 and json.loads(said)["verdict"] == "identified" and "no column 'vc'" in wrong


def test_the_same_file_is_exported(capsys, circuit, tmp_path):
    file, _ = circuit
    out = tmp_path / "firmware"
    code, said, _ = run(capsys, "export", file, "--real", "double", "--target", "host", "--out", out)
    assert code == 0 and "sample_time = 2e-05 s  (stated)" in said
    assert run(capsys, "export", "--verify", out)[0] == 0

    code, _, said = run(
        capsys, "export", file, "--real", "double", "--target", "host", "--out", out, "--sample-time", "1 ms"
    )
    assert code == 2 and "has its own numbers at 2e-05 s" in said


def test_a_file_without_an_estimator_says_so(capsys, tmp_path):
    file = tmp_path / "empty.py"
    file.write_text("x = 1\n")
    code, _, said = run(capsys, "estimate", file, "log.csv")

    assert code == 3 and "should hold one Estimator" in said
