"""The system that an estimator is exported for: shipped with the package, or a user's file.

Invariant: a shipped system's C is the committed text; a user's is printed by the same generator.
"""

from __future__ import annotations

import difflib
import importlib
import runpy
import types
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from similitude.errors import ModelError, SimilitudeError, UsageError
from similitude.program.library import GENERATED, Library

SHIPPED = {
    "bicycle": (
        "population",
        "small_population",
        "scalar_population",
        "monitor",
        "paper",
        "band",
        "output_error",
        "robust",
    ),
    "saturating_bicycle": ("population",),
    "bicycle_with_accelerometer": ("population", "small_population"),
}
ESTIMATORS = SHIPPED["bicycle"]
MAKERS = {
    "population": ("population_filter", "population_filter"),
    "small_population": ("small_population", "small_population_filter"),
    "scalar_population": ("scalar_population", "scalar_population_filter"),
    "monitor": ("monitor", "monitor"),
    "paper": ("paper", "paper_regression"),
    "band": ("band", "band_regression"),
    "output_error": ("output_error", "output_error_method"),
    "robust": ("robust", "robust_regression"),
}
LINE = "similitude export {system} --estimator {estimator} --real float --target cortex-m4f --out firmware"
READ = 'docs/embedded.md, "A system of your own"'


@dataclass(frozen=True)
class Source:
    """An estimator as the generator prints it: C and twin, and the numbers its file states."""

    name: str
    estimator: str
    c: str
    twin: str
    system: str  # as the user named it
    stated: Mapping[str, Any] | None = field(default=None)  # CONFIG of a user's file; None of a shipped one
    numbers: Any = None  # configuration.Numbers, where the file holds an estimator with all its numbers

    def library(self) -> Library:
        """Its layout, not compiled."""
        layout = types.ModuleType(self.name)
        exec(compile(self.twin, f"{self.name}.py", "exec"), layout.__dict__)
        return Library(self.name, layout, None)


def find_source(system: str, estimator: str | None) -> Source:
    """The generated C and twin of an estimator for a system.

    Parameters
    ----------
    system : name of a shipped system, or path of a Python file that holds an Estimator or a Reduction.
    estimator : one of ``ESTIMATORS``; None takes the one that a file holds.

    Raises
    ------
    UsageError    no such system, file or estimator.
    ModelError    the file does not run, holds no Reduction or several, or the estimator cannot be
                  derived from it.
    """
    if estimator is None and system.endswith(".py"):
        return _held(Path(system))
    if estimator not in ESTIMATORS:
        near = difflib.get_close_matches(str(estimator), ESTIMATORS, n=1)
        raise UsageError(
            f"--estimator '{estimator}' is not exported; there are {', '.join(ESTIMATORS)}",
            usually="the batch fit was meant, which needs the whole log; the population filter does not.",
            paste=f"--estimator {near[0] if near else 'population'}",
            read='docs/embedded.md, "The command"',
        )
    if system.endswith(".py"):
        return _users(Path(system), estimator)
    if system not in SHIPPED:
        raise UsageError(
            f"'{system}' is no shipped system and no file; there are {' and '.join(SHIPPED)}",
            usually="a file of your own was meant, and its ending .py left out.",
            paste=LINE.format(system=f"{system}.py", estimator=estimator),
            read=READ,
        )
    if estimator not in SHIPPED[system]:
        raise UsageError(
            f"{system} ships no estimator '{estimator}', only {', '.join(SHIPPED[system])}",
            usually="the regressions and the monitor take the linear bicycle.",
            paste=LINE.format(system="bicycle", estimator=estimator),
            read='docs/embedded.md, "The command"',
        )
    name = f"{system}_{estimator}"
    path = Path(importlib.import_module(f"{GENERATED}.{name}").__file__)
    c, twin = (path.with_suffix(end).read_text(encoding="utf-8") for end in (".c", ".py"))
    return Source(name, estimator, c, twin, system)


def find_estimator(path: Path) -> Any:
    """The one estimator, from `make_estimator`, that a Python file holds.

    Raises
    ------
    UsageError    there is no such file.
    ModelError    the file does not run, or holds no estimator or several.
    """
    names = _run(_there(path))
    found = {name: value for name, value in names.items() if type(value).__name__ == "Estimator"}
    if len({id(value) for value in found.values()}) == 1:
        return next(iter(found.values()))
    raise ModelError(
        f"{path.name} should hold one Estimator, and there is "
        + (f"{len(found)} of them: {', '.join(found)}" if found else "none"),
        usually="the model is there, and the estimator is made inside a function or in another file.",
        paste="estimator = make_estimator(SYSTEM, drive=u, step='10 ms', noise='1 mm', prior={...})",
        read='docs/estimator.md, "From the command line"',
    )


def find_reduction(system: str) -> Any:
    """The Reduction of a shipped system, or the one that a file holds.

    Raises
    ------
    UsageError    there is no such system or file.
    ModelError    the file does not run, or holds no Reduction or several.
    """
    if system.endswith(".py"):
        path = _there(Path(system))
        return _only_reduction(path, _run(path))
    if system == "bicycle":
        from similitude.systems.bicycle import bicycle_reduction

        return bicycle_reduction()
    raise UsageError(
        f"'{system}' has no fixed-point profile; of the shipped systems the bicycle has",
        usually="the saturating bicycle was meant, whose only estimator carries a covariance.",
        paste=LINE.format(system="bicycle", estimator="paper"),
        read='docs/embedded.md, "Fixed point"',
    )


def _held(path: Path) -> Source:
    estimator = find_estimator(path)
    return replace(estimator.source, system=path.name, numbers=estimator.numbers)


def _there(path: Path) -> Path:
    if path.is_file():
        return path
    raise UsageError(
        f"there is no file '{path}' (looked in {Path.cwd()})",
        usually="the path is that of another folder.",
        paste=f"ls {path.name}",
        read=READ,
    )


def _users(path: Path, estimator: str) -> Source:
    from similitude.program.c import print_c
    from similitude.program.python import print_python

    names = _run(_there(path))
    reduction = _only_reduction(path, names)
    module, maker = MAKERS[estimator]
    make = getattr(importlib.import_module(f"similitude.estimators.{module}"), maker)
    program = make(reduction)
    stated = names.get("CONFIG", {})
    if not isinstance(stated, Mapping):
        raise ModelError(
            f"CONFIG in {path.name} is a {type(stated).__name__}, not a mapping from names to numbers",
            usually="a list or a function was written.",
            paste='CONFIG = {"noise_variance": 1e-6}',
            read=READ,
        )
    return Source(program.name, estimator, print_c(program), print_python(program), path.name, dict(stated))


def _run(path: Path) -> dict[str, Any]:
    try:
        return runpy.run_path(str(path))
    except SimilitudeError:
        raise
    except Exception as fault:
        raise ModelError(
            f"{path.name} does not run: {type(fault).__name__}: {fault}",
            usually="a name was misspelt, or a package it imports is not installed here.",
            paste=f"python {path}",
            read=READ,
        ) from fault


def _only_reduction(path: Path, names: Mapping[str, Any]) -> Any:
    """The Reduction a file holds: a value, or what its function ``…reduction()`` returns."""
    from similitude.reduction import Reduction

    made: dict[str, Any] = {name: value for name, value in names.items() if isinstance(value, Reduction)}
    functions: dict[str, Callable] = {
        name: value
        for name, value in names.items()
        if isinstance(value, types.FunctionType)
        and name.endswith("reduction")
        and value.__code__.co_filename == str(path)
        and not value.__code__.co_argcount
    }
    found = made or {name: value() for name, value in functions.items()}
    if len(found) == 1 and isinstance(next(iter(found.values())), Reduction):
        return next(iter(found.values()))
    what = f"{len(found)} of them: {', '.join(found)}" if found else "none"
    raise ModelError(
        f"{path.name} should hold one Reduction, and there is {what}",
        usually="the model is there, and which unknowns stand in place of its groups was not yet said.",
        paste="def my_reduction(): return Reduction(groups=reparameterize(MODEL, base=(...)), ...)",
        read=READ,
    )
