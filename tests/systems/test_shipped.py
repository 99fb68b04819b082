"""Shipped systems are found by name, one file each, and imported only when asked for."""

import subprocess
import sys

import pytest

from similitude import shipped_system
from similitude.errors import UsageError
from similitude.systems import __path__ as folder
from similitude.systems.shipped import SHIPPED


def test_a_system_a_file_and_a_model_share_one_name():
    for name in SHIPPED:
        assert shipped_system(name).name == name


def test_every_file_with_a_system_is_listed():
    from pathlib import Path

    files = {p.stem for p in Path(next(iter(folder))).glob("*.py") if "\nSYSTEM = " in p.read_text()}

    assert files == set(SHIPPED)


def test_the_list_imports_no_system():
    program = "import sys; from similitude.systems.shipped import SHIPPED; print('sympy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)

    assert done.stdout.strip() == "False"


def test_an_unknown_name_is_answered_with_the_nearest():
    with pytest.raises(UsageError, match="no shipped system 'bycicle'") as caught:
        shipped_system("bycicle")
    assert "shipped_system('bicycle')" in caught.value.paste
