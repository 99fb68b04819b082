import numpy as np
import pyarrow.parquet
import pytest

from similitude.report.table import estimate_table, write_estimate
from similitude.status import STATUS

COLUMNS = [
    "t [s]", "K [m^2/s^2]", "K_std [m^2/s^2]", "K_lo [m^2/s^2]", "K_hi [m^2/s^2]", "pi3 [-]",
    "pi3_std [-]", "Caf [N/rad]", "status",
]  # fmt: skip


def test_the_columns_of_the_contract_one_row_a_sample(example_run, tmp_path):
    run = example_run(700)
    write_estimate(run, tmp_path / "estimate.parquet")
    table = pyarrow.parquet.read_table(tmp_path / "estimate.parquet")
    assert table.column_names == COLUMNS
    assert table.num_rows == 700
    np.testing.assert_array_equal(table["t [s]"].to_numpy(), run.trace.t)
    assert all(table[name].null_count == 0 for name in COLUMNS)
    assert all(np.isfinite(table[name].to_numpy()).all() for name in COLUMNS[:-1])


def test_the_interval_is_symmetric_in_ln_K_and_1_96_deviations_wide(example_run):
    run = example_run(700)
    K, std, low, high = (estimate_table(run)[name].to_numpy() for name in COLUMNS[1:5])
    np.testing.assert_allclose(low * high, K**2, rtol=1e-12)
    np.testing.assert_allclose(np.log(high / low) / (2 * 1.96), std / K, rtol=1e-9)


def test_stiffness_needs_mass_and_wheelbase(example_run):
    table = estimate_table(example_run(50))
    ratio = table["Caf [N/rad]"].to_numpy() / table["K [m^2/s^2]"].to_numpy()
    np.testing.assert_allclose(ratio, 2010.0 / 2.69)  # Caf = K m / L
    assert "Caf [N/rad]" not in estimate_table(example_run(50, with_mass=False)).column_names


def test_an_interval_wider_than_a_double_still_is_a_number(example_run):
    run = example_run(50)
    run.trace.ln_K_std = np.full(50, 1e5)
    for name in ("K_lo [m^2/s^2]", "K_hi [m^2/s^2]"):
        assert np.isfinite(estimate_table(run)[name].to_numpy()).all()


@pytest.mark.parametrize("name", STATUS)
def test_a_status_is_written_by_its_name(example_run, name):
    run = example_run(20)
    run.trace.status = np.full(20, STATUS[name], np.int32)
    assert estimate_table(run)["status"].to_pylist() == [name] * 20
