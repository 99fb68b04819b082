"""Header, separator and rows are found before any number is read."""

from pathlib import Path

import pytest

from similitude.readers.csv_text import take_apart, wide_text


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


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_two_bytes_a_character_are_told_without_a_mark(tmp_path, encoding):
    text = "t [s],r [rad/s]\n" + "".join(f"{0.01 * k:.2f},0.1\n" for k in range(9))

    assert wide_text(text.encode(encoding)) == encoding
    assert take_apart(tmp_path / "log.csv", text.encode(encoding)).headers == ("t [s]", "r [rad/s]")
    assert wide_text(text.encode()) is None
    assert wide_text(bytes(64)) is None
