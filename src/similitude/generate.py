"""Writes the committed C and twins of the shipped estimators: ``python -m similitude.generate``.

Invariant: what stands under ``generated/`` is exactly what this writes; a test compares.
"""

from __future__ import annotations

from pathlib import Path

from similitude.estimators.monitor import monitor
from similitude.estimators.paper import paper_regression
from similitude.estimators.population_filter import population_filter
from similitude.program.c import print_c
from similitude.program.ir import Program
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction

DIRECTORY = Path(__file__).parent / "generated"


def shipped() -> tuple[Program, ...]:
    """The step programs that ship with the package."""
    reduction = bicycle_reduction()
    return (population_filter(reduction), monitor(reduction), paper_regression(reduction))


def texts() -> dict[str, str]:
    """File name -> text of every generated file."""
    result = {}
    for program in shipped():
        result[f"{program.name}.c"] = print_c(program)
        result[f"{program.name}.py"] = print_python(program)
    return result


def main() -> None:
    """Write every generated file."""
    for name, text in texts().items():
        (DIRECTORY / name).write_text(text, encoding="utf-8")
        print(f"{name}: {len(text.splitlines())} lines")


if __name__ == "__main__":
    main()
