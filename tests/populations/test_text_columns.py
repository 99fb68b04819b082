"""Words of a table come row by row with its numbers, from either format."""

import pyarrow as pa
import pyarrow.parquet as parquet

from similitude.populations.text_columns import read_words


def test_words_are_those_of_their_rows(tmp_path):
    path = tmp_path / "cars.csv"
    path.write_text('vehicle,m [kg],source\nA,1,"x, y"\n\n"B",2,\n', encoding="utf-8")

    assert read_words(path, ["vehicle", "source"]) == {"vehicle": ("A", "B"), "source": ("x, y", "")}
    assert read_words(path, []) == {}


def test_parquet_says_the_same(tmp_path):
    path = tmp_path / "cars.parquet"
    parquet.write_table(pa.table({"vehicle": ["A", None], "m [kg]": [1.0, 2.0]}), path)

    assert read_words(path, ["vehicle"]) == {"vehicle": ("A", "")}
