"""The command `similitude export`."""

import pytest

from similitude.cli import main


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main(["export", *map(str, arguments)])
    said = capsys.readouterr()
    return end.value.code, said.out, said.err


def test_it_writes_and_verifies(capsys, tmp_path):
    out = tmp_path / "firmware"
    how = (
        "--estimator",
        "paper",
        "--real",
        "float",
        "--target",
        "host",
        "--sample-time",
        "5 ms",
        "--out",
        out,
    )
    code, said, _ = run(capsys, "bicycle", *how)

    assert code == 0
    assert "sample_time = 0.005 s  (--sample-time)" in said
    assert "L = 2.69 m  (reference: state yours with --vehicle FILE.toml)" in said
    code, said, _ = run(capsys, "--verify", out)
    assert code == 0 and "0 of" in said


def test_a_differing_word_is_exit_code_3(capsys, tmp_path):
    out = tmp_path / "firmware"
    run(capsys, "bicycle", "--estimator", "paper", "--real", "float", "--target", "host", "--out", out)
    config = out / "bicycle_paper_config.h"
    config.write_text(config.read_text().replace("9.9995e-01f", "9.9994e-01f"))
    code, _, said = run(capsys, "--verify", out)

    assert code == 3 and "words of bicycle_paper differ" in said


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("bicycle",), "was not told --estimator, --real, --target, --out"),
        (("bicycle", "--verify", "x"), "was given together with"),
        (("--verify", "nowhere"), "is no folder that"),
        (
            ("bicycle", "--estimator", "paper", "--real", "float", "--target", "host", "--out", "x",
             "--sample-time", "100"),
            "is no time between two samples",
        ),
        (
            ("bicycle", "--estimator", "paper", "--real", "float", "--target", "host", "--out", "x",
             "--vehicle", "nowhere.toml"),
            "there is no such file",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_a_usage_error(capsys, arguments, said):
    code, _, error = run(capsys, *arguments)

    assert code == 2 and said in error
