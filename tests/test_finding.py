"""A finding reads the same as an error and as a warning."""

from similitude.finding import Finding

SLOW = Finding(
    "speed_unit",
    certain=True,
    what="column 'U [m/s]' of drive.csv reaches 130",
    usually="these values look like km/h.",
    paste="U [km/h]",
    read='docs/logs.md, "What is refused"',
)


def test_the_error_has_the_four_parts():
    for part in (SLOW.what, SLOW.usually, SLOW.paste, SLOW.read):
        assert part.rstrip(".") in str(SLOW.error)


def test_the_warning_is_one_line_without_a_full_stop():
    assert SLOW.warning == "column 'U [m/s]' of drive.csv reaches 130; usually these values look like km/h"
