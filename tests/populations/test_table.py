"""Tables of systems: units, gaps, weights, products, and faults said with the row."""

from fractions import Fraction

import numpy as np
import pyarrow as pa
import pyarrow.parquet as parquet
import pytest

from similitude.errors import LogError, UnitError, UsageError
from similitude.populations.table import joined, read_population_table
from similitude.systems.bicycle import BICYCLE

from .drawn import independent, table_of

GOOD = """vehicle,m [t],sd_m [kg],L [mm],ab [m^2],weight [-],colour,source
one,1.5,50,2700,,1,red,here
two,1.2,,,1.6,0.5,blue,there
"""


def read(tmp_path, text, **how):
    path = tmp_path / "cars.csv"
    path.write_text(text, encoding="utf-8")
    return read_population_table(path, BICYCLE, **how)


def test_values_are_si_gaps_are_nan_and_every_row_has_its_source(tmp_path):
    table = read(tmp_path, GOOD, columns={"a*b": "ab"})

    assert table.names == ("a b", "m", "L")  # those that were named first
    np.testing.assert_allclose(table.value, [[np.nan, 1500, 2.7], [1.6, 1200, np.nan]], rtol=1e-12)
    np.testing.assert_allclose(table.sd[:, 1], [50, np.nan])
    assert list(table.weight) == [1.0, 0.5]
    assert table.labels == ("one", "two") and table.sources == ("here", "there")
    assert table.unused == ("colour",)


def test_parquet_reads_the_same(tmp_path):
    path = tmp_path / "cars.parquet"
    parquet.write_table(pa.table({"vehicle": ["x"], "m [kg]": [1500.0], "a*b [m^2]": [1.7]}), path)
    table = read_population_table(path, BICYCLE)

    assert table.names == ("m", "a b") and table.labels == ("x",)
    assert table.products[1] == {"a": Fraction(1), "b": Fraction(1)}


@pytest.mark.parametrize(
    ("text", "error", "said"),
    [
        ("m,L [m]\n1,2\n", LogError, "no unit"),
        ("m [m],L [m]\n1,2\n", UnitError, "dimension"),
        ("m [kg],L [m]\n1,2\n0,2\n", UsageError, "data row 2"),
        ("m [kg],L [m]\n1,2\n-3,2\n", UsageError, "data row 2"),
        ("m [kg],weight [-]\n1,-1\n", UsageError, "weight"),
        ("mass,wheelbase\n1,2\n", UsageError, "parameters: m, L"),
        ("m [kg]\n1\n", None, ""),
    ],
)
def test_faults_are_said_with_what_to_write(tmp_path, text, error, said):
    if error is None:
        assert len(read(tmp_path, text)) == 1
        return
    with pytest.raises(error) as told:
        read(tmp_path, text)
    assert said in told.value.what and told.value.paste and told.value.usually


def test_joined_tables_keep_every_row_and_know_which_table_it_was_of():
    one, other = table_of(independent(3, 0)), table_of(independent(2, 1)[:, :2], ("m", "L"))
    both = joined([one, other, one], name="both")

    assert len(both) == 8 and list(both.stratum) == [0, 0, 0, 1, 1, 2, 2, 2]
    assert np.isnan(both.value[3:5, 2:]).all() and np.isfinite(both.value[:, :2]).all()
    assert len(both.rows(np.array([0, 0, 4])).labels) == 3
