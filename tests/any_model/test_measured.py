"""A file in any units and arrays in SI give the same rows; faults are named."""

import numpy as np
import pytest

from similitude import shipped_system
from similitude.any_model.measured import read_columns
from similitude.errors import LogError, UnitError

RLC = shipped_system("rlc_circuit").model
U, Y = np.arange(5.0), np.arange(5.0) / 2


def test_a_file_in_other_units_gives_the_same_rows(tmp_path):
    path = tmp_path / "log.csv"
    lines = [f"{20 * k},{1000 * u},{y},ignored" for k, (u, y) in enumerate(zip(U, Y, strict=True))]
    path.write_text("t [us],u [mV],vc [V],note\n" + "\n".join(lines) + "\n")
    arrays = read_columns({"u": U, "vc": Y}, RLC, step=2e-5)

    np.testing.assert_allclose(read_columns(path, RLC, step=1.0).rows, arrays.rows, rtol=1e-9)
    np.testing.assert_allclose(arrays.rows[:, 0], 2e-5)


def test_missing_values_stay_missing():
    rows = read_columns({"u": U, "vc": [0, np.nan, 1, 2, 3]}, RLC, step=1.0).rows

    assert np.isnan(rows[1, 2]) and np.isfinite(np.delete(rows, 1, axis=0)).all()


@pytest.mark.parametrize(
    ("log", "said"),
    [
        ({"u": U}, "has no column 'vc'"),
        ({"u": U, "vc": Y[:3]}, "have shapes"),
        ({"u": U[:1], "vc": Y[:1]}, "1 rows"),
        ({}, "log: empty"),
    ],
)
def test_what_is_missing_is_named(log, said):
    with pytest.raises(LogError, match=said):
        read_columns(log, RLC, step=1.0)


@pytest.mark.parametrize(("header", "kind"), [("u", LogError), ("u [m]", UnitError)])
def test_a_column_without_its_unit_is_refused(tmp_path, header, kind):
    path = tmp_path / "log.csv"
    path.write_text(f"{header},vc [V]\n1,1\n2,2\n3,3\n")
    with pytest.raises(kind, match="column"):
        read_columns(path, RLC, step=1.0)
