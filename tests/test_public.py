"""The front page: every public name leads somewhere, and importing it loads nothing."""

import subprocess
import sys

import pytest

import similitude


@pytest.mark.parametrize("name", similitude.__all__)
def test_a_public_name_leads_to_something_documented(name):
    assert getattr(similitude, name).__doc__
    assert name in dir(similitude)


def test_an_unknown_name_is_an_attribute_error_that_names_it():
    with pytest.raises(AttributeError, match="identfy"):
        _ = similitude.identfy


def test_importing_the_package_loads_nothing_heavy():
    program = "import sys, similitude; print(*{m.partition('.')[0] for m in sys.modules})"
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout

    heavy = {"numpy", "scipy", "sympy", "pint", "pyarrow", "matplotlib", "rich", "typer"}
    assert heavy & set(loaded.split()) == set()
