"""What a user gives as rates or outputs, made into SymPy expressions.

    text            read with the declared names only (`model_text`)
    expression      taken as it is; a symbol made without real=True is recognised by its name
    number          taken exactly
    function        f(states, inputs, parameters), called once with symbols in place of numbers

Invariant: what comes out holds only symbols ``Symbol(name, real=True)``, or symbols nobody declared,
which `Model` refuses by name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

import sympy as sp

from similitude.errors import ModelError, shown
from similitude.model_text import parse_expression

READ = 'docs/model.md, "Rates"'
Formula = str | int | float | sp.Expr
Formulas = Mapping[str, Formula] | Callable


class Symbols(Mapping):
    """Named symbols, handed to a function that is traced: ``p.m``, ``p["m"]``, ``m, k = p``.

    Iterating gives the symbols, in the order in which the quantities were declared; ``keys()`` the names.
    """

    def __init__(self, kind: str, names: Sequence[str]) -> None:
        self._kind = kind
        self._symbols = {name: sp.Symbol(name, real=True) for name in names}

    def __getitem__(self, name: str | int) -> sp.Symbol:
        if isinstance(name, int):
            return list(self._symbols.values())[name]
        if name not in self._symbols:
            raise ModelError(
                f"the function asks the {self._kind} for {shown(name)} (there are {', '.join(self.keys())})",
                usually="The quantity was declared under another name, or as something else.",
                paste=f"{self._kind}.{next(iter(self._symbols), 'name')}",
                read=READ,
            )
        return self._symbols[name]

    def __getattr__(self, name: str) -> sp.Symbol:
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[sp.Symbol]:
        return iter(self._symbols.values())

    def __len__(self) -> int:
        return len(self._symbols)

    def keys(self) -> tuple[str, ...]:
        """The names."""
        return tuple(self._symbols)


def read_formulas(
    given: Formulas,
    *,
    what: str,
    owners: Sequence[str],
    states: Sequence[str],
    inputs: Sequence[str],
    parameters: Sequence[str],
) -> dict[str, sp.Expr]:
    """Expressions by name.

    Parameters
    ----------
    given : a mapping of name to text, expression or number; or a function of (states, inputs, parameters)
        that returns such a mapping, or one formula for each owner in their order.
    what : "rate" or "output", for messages.
    owners : names that are to get one formula each.
    states, inputs, parameters : the declared names.

    Raises
    ------
    ModelError    text that cannot be read, something that is no formula, or a function that cannot be
                  traced; the owner is named.
    """
    names = (*states, *inputs, *parameters)
    if callable(given) and not isinstance(given, Mapping):
        arguments = (Symbols("states", states), Symbols("inputs", inputs), Symbols("parameters", parameters))
        given = _by_name(_traced(given, arguments, what), owners, what)
    if not isinstance(given, Mapping):
        raise ModelError(
            f"the {what}s are a {type(given).__name__}, not a mapping from names to formulas",
            usually="A list was given; formulas are named after what they belong to.",
            paste=f"{{{owners[0]!r}: ...}}" if owners else "{}",
            read=READ,
        )
    return {name: read_formula(f, names, what=f"the {what} of {name!r}") for name, f in given.items()}


def read_formula(given: Formula, names: Sequence[str], *, what: str) -> sp.Expr:
    """One formula as an expression in ``Symbol(name, real=True)``.

    Raises
    ------
    ModelError    it cannot be read, or is no formula.
    """
    if isinstance(given, str):
        return parse_expression(given, names, what=what)
    try:
        expression = sp.sympify(given, strict=True)
    except (sp.SympifyError, TypeError):
        expression = None
    if not isinstance(expression, sp.Basic):
        raise ModelError(
            f"{what} is a {type(given).__name__}, {shown(given)}, and no formula",
            usually="A list, an array or None was given; a formula is text, a SymPy expression or a number.",
            paste="'k*x'",
            read=READ,
        )
    known = {name: sp.Symbol(name, real=True) for name in names}
    return expression.xreplace({s: known[s.name] for s in expression.free_symbols if s.name in known})


def _traced(function: Callable, arguments: tuple[Symbols, ...], what: str) -> object:
    try:
        return function(*arguments)
    except ModelError:
        raise
    except Exception as error:
        raise ModelError(
            f"the {what}s' function cannot be followed with symbols: {type(error).__name__}: {error}",
            usually="It decides by value (if x > 0) or calls math or numpy, which want numbers; sympy has "
            "the same functions, and Piecewise, Max and Min in place of a decision. It takes exactly "
            "three arguments: states, inputs, parameters.",
            paste="from sympy import sqrt, exp, sin, Abs, Max, Piecewise",
            read=READ,
        ) from error


def _by_name(returned: object, owners: Sequence[str], what: str) -> Mapping:
    if isinstance(returned, Mapping):
        return returned
    if isinstance(returned, Formula):
        returned = [returned]
    if not isinstance(returned, Sequence) or len(returned) != len(owners):
        count = len(returned) if isinstance(returned, Sequence) else f"a {type(returned).__name__}"
        raise ModelError(
            f"the {what}s' function returned {count} where {len(owners)} formulas are wanted"
            f" ({', '.join(owners)})",
            usually="A return statement is missing, or a formula was forgotten.",
            paste="return {" + ", ".join(f"{name!r}: ..." for name in owners) + "}",
            read=READ,
        )
    return dict(zip(owners, returned, strict=True))
