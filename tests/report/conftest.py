"""The made-up run for the tests of the report, loaded by its path: tests are no package."""

import importlib.util
from pathlib import Path

import pytest

_spec = importlib.util.spec_from_file_location("report_example_run", Path(__file__).parent / "example_run.py")
_module = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(_module)


@pytest.fixture
def example_run():
    """The builder `example_run(samples, verdict=..., ...)`."""
    return _module.example_run


@pytest.fixture
def verdicts():
    """Every verdict there is."""
    return tuple(_module.REASONS)
