"""Runs statements of a step program on numbers, as the twin would."""

from collections.abc import Iterable, Mapping

from similitude.program.ir import Statement
from similitude.program.python import _body
from similitude.program.text import PYTHON, expression_text


def run_statements(statements: Iterable[Statement], values: Mapping[str, float]) -> dict:
    """The names and values after the statements."""
    scope = dict(values)
    exec("\n".join(["pass", *_body(statements, 0)]), {}, scope)
    return scope


def evaluate(expression, values: Mapping[str, float]) -> float:
    """One expression on numbers, in the order the twin takes."""
    return eval(expression_text(expression, PYTHON), {}, dict(values))
