"""Systems by name or from a file, and the line to write where there is none."""

import pytest

from similitude.errors import UsageError
from similitude.systems.named import named_system

TANK = """
import sympy as sp
from similitude.model import Model, Quantity
h, q, A, k = sp.symbols("h q A k", real=True)
tank = Model(
    name="tank", states=(Quantity("h", "m"),), inputs=(Quantity("q", "m^3/s"),),
    outputs=(Quantity("h", "m"),), parameters=(Quantity("A", "m^2"), Quantity("k", "m^2/s")),
    rates={"h": (q - k * h) / A}, output_map={"h": h},
)
"""


def test_shipped_systems_have_their_base():
    assert named_system("bicycle").groups.base == ("m", "L", "U")
    assert named_system("bicycle", base=["m", "a", "U"]).groups.base == ("m", "a", "U")
    assert len(named_system("saturating_bicycle").groups.groups) == 6


def test_a_file_is_run_and_its_model_taken(tmp_path):
    path = tmp_path / "tank.py"
    path.write_text(TANK)
    assert named_system(str(path), base=["A", "k"]).groups.model.name == "tank"
    path.write_text(TANK + "BASE = ('A', 'k')\n")
    assert named_system(str(path)).groups.groups == ()


@pytest.mark.parametrize(
    ("text", "said"), [("1/0", "cannot be run"), ("x = 1", "holds no model"), (TANK, "says no base")]
)
def test_what_is_wrong_with_a_file_is_said(tmp_path, text, said):
    path = tmp_path / "tank.py"
    path.write_text(text)
    with pytest.raises(UsageError, match=said):
        named_system(str(path))


def test_an_unknown_name_is_refused():
    with pytest.raises(UsageError, match="not known"):
        named_system("bycicle")
