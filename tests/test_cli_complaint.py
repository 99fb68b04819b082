"""What goes wrong has four parts on stderr and its own exit code."""

from similitude.cli_complaint import BAD_INPUT, USAGE, complain, exit_code
from similitude.errors import LogError, UsageError

PARTS = {"usually": "that.", "paste": "--map delta=SWA", "read": "docs/logs.md"}


def test_a_complaint_has_its_four_parts_on_stderr(capsys):
    complain(LogError("a column is missing", **PARTS))

    out, err = capsys.readouterr()
    assert out == ""
    assert all(text in err for text in ("LogError: a column is missing", *PARTS.values()))


def test_a_long_line_to_paste_is_not_broken(capsys):
    line = "similitude inspect " + "a" * 300
    complain(LogError("x", usually="y.", paste=line, read="z"))

    assert line in capsys.readouterr().err


def test_usage_and_input_have_codes_of_their_own():
    assert exit_code(UsageError("x", **PARTS)) == USAGE == 2
    assert exit_code(LogError("x", **PARTS)) == BAD_INPUT == 3
