"""Which model a command line means, and what is said where it means none or several."""

import pytest

from similitude.errors import ModelError, UsageError
from similitude.systems.bicycle import BICYCLE
from similitude.systems.system_file import find_model

LAG = """
from similitude import Model, Quantity

{name} = Model(
    name="lag",
    states=(Quantity("x", "m"),),
    inputs=(Quantity("u", "m"),),
    outputs=(Quantity("x", "m"),),
    parameters=(Quantity("T", "s"),),
    rates={{"x": "(u - x)/T"}},
    output_map={{"x": "x"}},
)
"""


def written(tmp_path, *parts, name="lag.py"):
    path = tmp_path / name
    path.write_text("\n".join(parts), encoding="utf-8")
    return str(path)


def test_a_shipped_system_brings_its_base():
    found = find_model("bicycle")

    assert found.model is BICYCLE
    assert found.base == ("m", "L", "U")


def test_a_file_with_one_model_is_that_model(tmp_path):
    found = find_model(written(tmp_path, LAG.format(name="MINE")))

    assert (found.model.name, found.base) == ("lag", None)


def test_two_names_of_one_model_are_one_model(tmp_path):
    assert find_model(written(tmp_path, LAG.format(name="MINE"), "SAME = MINE")).model.name == "lag"


def test_a_system_in_the_file_brings_its_base(tmp_path):
    text = "from similitude.systems.bicycle import SYSTEM"

    assert find_model(written(tmp_path, text)).base == ("m", "L", "U")


def test_a_file_may_import_its_neighbours(tmp_path):
    (tmp_path / "my_neighbour_letters.py").write_text("T = 'T'", encoding="utf-8")
    text = "from my_neighbour_letters import T\n" + LAG.format(name="MINE")

    assert find_model(written(tmp_path, text)).model.name == "lag"


def test_several_are_told_apart_by_name(tmp_path):
    path = written(tmp_path, LAG.format(name="ONE"), LAG.format(name="TWO"))

    with pytest.raises(ModelError, match="makes 2 Models: ONE, TWO") as caught:
        find_model(path)
    assert caught.value.paste == f"similitude analyze {path}:ONE"
    assert find_model(f"{path}:TWO").model.name == "lag"
    with pytest.raises(ModelError, match="no Model called 'THREE'"):
        find_model(f"{path}:THREE")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("x = 3", "makes no Model"),
        ("import nothing_of_this_name", "line 1: ModuleNotFoundError"),
        ("x = 1\ny = x/0", "line 2: ZeroDivisionError"),
        ("def f(:", "line 1: SyntaxError"),
        ("raise SystemExit(3)", "SystemExit: 3"),
        (LAG.format(name="A").replace("(u - x)/T", "(u - x)/Q"), "not declared"),
    ],
)
def test_files_that_fail_say_where(tmp_path, text, says):
    with pytest.raises(ModelError) as caught:
        find_model(written(tmp_path, text))

    assert says in caught.value.what
    assert all((caught.value.usually, caught.value.paste, caught.value.read))


@pytest.mark.parametrize("text", ["bycicle", "nothing.py", "docs", "pyproject.toml", ""])
def test_what_names_nothing_is_a_fault_of_usage(text):
    with pytest.raises(UsageError) as caught:
        find_model(text)

    assert caught.value.paste.startswith("similitude analyze ")
