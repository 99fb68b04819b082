"""A table is opened without its numbers being read."""

from similitude.readers import open_table


def test_opening_reads_no_number(tmp_path):
    path = tmp_path / "drive.csv"
    path.write_text("t,r\n1,word\n")

    table = open_table(path)

    assert table.headers == ("t", "r")
    assert table.load([0]).columns[0].tolist() == [1.0]
