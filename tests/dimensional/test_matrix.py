"""The dimension matrix: columns in the given order, angles on demand, light to import."""

import subprocess
import sys
from fractions import Fraction

from similitude.dimensional.matrix import column_text, dimension_matrix


def test_columns_stand_in_the_order_given():
    matrix = dimension_matrix({"F": "N", "a": "deg", "x": "m^(1/2)"}, angle=False)

    assert matrix.names == ("F", "a", "x") and len(matrix.rows) == 7
    assert matrix.column("F") == (1, 1, -2, 0, 0, 0, 0)
    assert matrix.columns[1] == (0,) * 7
    assert matrix.column("x")[1] == Fraction(1, 2)
    assert matrix.rank == 2


def test_an_angle_is_the_last_row():
    matrix = dimension_matrix({"w": "rpm", "c": "N m/rad", "f": "Hz"}, angle=True)

    assert matrix.rows[-1] == "angle"
    assert [column[-1] for column in matrix.columns] == [1, -1, 0]
    assert matrix.text("c") == "kg m^2 s^-2 rad^-1"


def test_a_column_as_text():
    assert column_text((0,) * 7) == "-"
    assert column_text((Fraction(1), Fraction(-1, 2), 0, 0, 0, 0, 0)) == "kg m^(-1/2)"


def test_groups_need_neither_sympy_nor_numpy_nor_pint():
    program = (
        "import sys; from similitude import pi_groups;"
        "pi_groups({'F': 'N', 'rho': 'kg/m^3', 'V': 'm/s', 'D': 'm'}, ['rho', 'V', 'D']);"
        "print(*{m.partition('.')[0] for m in sys.modules})"
    )
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout.split()

    assert "similitude" in loaded
    assert {"sympy", "numpy", "pint", "scipy"} & set(loaded) == set()
