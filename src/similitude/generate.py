"""Writes the committed C and twins of the shipped estimators: ``python -m similitude.generate``.

Invariant: what stands under ``generated/`` is exactly what this writes; a test compares.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from similitude.estimators.band import band_regression
from similitude.estimators.monitor import monitor
from similitude.estimators.output_error import output_error_method
from similitude.estimators.paper import paper_regression
from similitude.estimators.population_filter import population_filter
from similitude.estimators.robust import robust_regression
from similitude.estimators.scalar_population import scalar_population_filter
from similitude.estimators.small_population import small_population_filter
from similitude.program.c import print_c
from similitude.program.ir import Program
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction
from similitude.systems.bicycle_with_accelerometer import (
    bicycle_with_accelerometer_reduction,
    small_accelerometer_reduction,
)
from similitude.systems.saturating_bicycle import saturating_bicycle_reduction

DIRECTORY = Path(__file__).parent / "generated"


def shipped() -> tuple[Program, ...]:
    """The step programs that ship with the package."""
    reduction = bicycle_reduction()
    makers = (
        population_filter,
        small_population_filter,
        monitor,
        paper_regression,
        band_regression,
        output_error_method,
        robust_regression,
        scalar_population_filter,
    )
    richer = (saturating_bicycle_reduction(), bicycle_with_accelerometer_reduction())
    small = small_population_filter(small_accelerometer_reduction())
    return (*map(population_filter, richer), small, *(make(reduction) for make in makers))


def texts(programs: Iterable[Program]) -> dict[str, str]:
    """File name -> text of the generated files of these programs."""
    result = {}
    for program in programs:
        result[f"{program.name}.c"] = print_c(program)
        result[f"{program.name}.py"] = print_python(program)
    return result


def main() -> None:
    """Write every generated file."""
    for name, text in texts(shipped()).items():
        (DIRECTORY / name).write_text(text, encoding="utf-8")
        print(f"{name}: {len(text.splitlines())} lines")


if __name__ == "__main__":
    main()
