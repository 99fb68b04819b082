"""Header, separator and rows are found before any number is read."""

from pathlib import Path

import pytest

from similitude.readers.csv_text import take_apart


@pytest.mark.parametrize(
    ("raw", "headers", "separator", "body"),
    [
        (b"a,b\n1,2\n", ("a", "b"), ",", b"1,2\n"),
        (b"a;b,c\r\n1;2\r\n", ("a;b", "c"), ",", b"1;2\r\n"),
        (b'"yaw, r [deg/s]";t;x\n', ("yaw, r [deg/s]", "t", "x"), ";", b""),
        (b"\xef\xbb\xbf a\t b \n1\t2", ("a", "b"), "\t", b"1\t2"),
        (b"r [\xb0/s],t\n1,2\n", ("r [°/s]", "t"), ",", b"1,2\n"),
        (b"only\n1\n", ("only",), ",", b"1\n"),
    ],
)
def test_a_file_comes_apart(raw, headers, separator, body):
    text = take_apart(Path("drive.csv"), raw)

    assert (text.headers, text.separator, text.body) == (headers, separator, body)
