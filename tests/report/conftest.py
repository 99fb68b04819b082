"""The made-up run and the strict reader of HTML, loaded by their path: tests are no package."""

import importlib.util
from pathlib import Path

import pytest


def _beside(name):
    """A module of this folder."""
    spec = importlib.util.spec_from_file_location(f"report_{name}", Path(__file__).parent / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


_module = _beside("example_run")


@pytest.fixture
def example_run():
    """The builder `example_run(samples, verdict=..., ...)`."""
    return _module.example_run


@pytest.fixture
def verdicts():
    """Every verdict there is."""
    return tuple(_module.REASONS)


@pytest.fixture(scope="session")
def strict_html():
    """The reader `strict_html(source)`; it fails where a page is not well formed."""
    return _beside("strict_html").Page
