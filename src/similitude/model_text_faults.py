"""What can be wrong with a formula given as text, each with the line that would have worked."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Sequence

from similitude.errors import ModelError, shown

READ = 'docs/symmetries.md, "Rates as text"'


def no_text(what: str, given: object) -> ModelError:
    """Something else was given where text was asked for."""
    return _fault(
        f"{what} is a {type(given).__name__}, {shown(given)}, and no text",
        "A number or an expression was given where its text was asked for.",
        repr(str(given)) if isinstance(given, (int, float)) else "'k*x'",
    )


def strange_character(what: str, text: str, at: int) -> ModelError:
    """A character that no formula has."""
    return _fault(
        f"{what}, {shown(text)}, has {shown(text[at])} at character {at + 1}, which no formula has",
        "An equals sign, an index in brackets, a dot or a quotation mark was left in; a formula is "
        "made of names, numbers, + - * / ** and round brackets.",
        "'k1*x - k2*x**2'",
    )


def unknown_name(what: str, text: str, name: str, names: Sequence[str]) -> ModelError:
    """A name that nobody declared."""
    near = difflib.get_close_matches(name, names, n=1)
    said = ", ".join(names[:20]) + (" …" if len(names) > 20 else "")
    return _fault(
        f"{what}, {shown(text)}, uses {shown(name)}, which is not declared (declared: {said or 'nothing'})",
        "A parameter is missing from the list, a state has no rate, or a name was misspelt; names are "
        "case-sensitive.",
        f"{near[0]}   # in place of {name}" if near else f"parameters=[..., {name!r}]",
    )


def calls_a_quantity(what: str, text: str, name: str) -> ModelError:
    """A declared quantity with a bracket behind it."""
    return _fault(
        f"{what}, {shown(text)}, calls {shown(name)}, which is a declared quantity",
        "The sign * was left out between a quantity and a bracket.",
        f"{name}*(...)",
    )


def unknown_function(what: str, text: str, name: str, functions: Collection[str]) -> ModelError:
    """A call of something that is no function of the grammar."""
    near = difflib.get_close_matches(name, functions, n=1)
    return _fault(
        f"{what}, {shown(text)}, calls {shown(name)}, which is no function here "
        f"(there are {', '.join(functions)})",
        "A function of another program was meant, or the sign * was left out before a bracket.",
        f"{near[0] if near else 'exp'}(...)",
    )


def argument_count(what: str, text: str, name: str, given: int, wanted: int) -> ModelError:
    """A function with too many or too few arguments."""
    return _fault(
        f"{what}, {shown(text)}, gives {name} {given} arguments; it takes {wanted}",
        "A comma stands for a point in a number, or a logarithm was given its base.",
        f"{name}({', '.join('xy'[:wanted])})",
    )


def not_real(what: str, text: str, part: object) -> ModelError:
    """A part of the formula that is no real number."""
    return _fault(
        f"{what}, {shown(text)}, contains {shown(part)}, which is no real number",
        "A root or a logarithm lost a sign.",
        "sqrt(x)   # x inside the function's range",
    )


def divides_by_zero(what: str, text: str) -> ModelError:
    """A denominator that is zero whatever the quantities are."""
    return _fault(
        f"{what}, {shown(text)}, divides by zero",
        "Two terms of a denominator cancel, or a zero stands where a name was meant.",
        "'k*x/(c + x)'   # a denominator that is not zero",
    )


def too_large(what: str, text: str, digits: int) -> ModelError:
    """A number that nobody means."""
    return _fault(
        f"{what}, {shown(text)}, makes a number of more than {digits} digits",
        "An exponent lost its bracket or its decimal point.",
        "'x**(3/2)'",
    )


def beyond_reals(what: str, text: str) -> ModelError:
    """A constant no computer holds as a float64."""
    return _fault(
        f"{what}, {shown(text)}, holds a constant beyond 1.8e308",
        "A function was given a number in place of a quantity over its scale.",
        "'exp(x/x0)'",
    )


def too_high(what: str, text: str, power: object, highest: int) -> ModelError:
    """A power that nobody means."""
    return _fault(
        f"{what}, {shown(text)}, raises to the power {power}; {highest} is the highest that is read",
        "An exponent lost its decimal point, or an exponential was meant: exp(...).",
        "'x**(3/2)'",
    )


def too_deep(what: str, text: str, deepest: int) -> ModelError:
    """Brackets inside brackets without end."""
    return _fault(
        f"{what}, {shown(text)}, nests more than {deepest} brackets, signs or powers",
        "The text was made by a program that brackets every step.",
        "{'x': sp.sympify(...)}   # expressions instead of their text",
    )


def open_bracket(what: str, text: str, at: int) -> ModelError:
    """A bracket that is never closed."""
    return _fault(
        f"{what}, {shown(text)}, never closes the bracket of character {at + 1}",
        "The formula was cut off, or one bracket too few was typed.",
        shown(text.strip() + ")"),
    )


def cut_off(what: str, text: str) -> ModelError:
    """Nothing at all, or nothing behind an operator."""
    if not text.strip():
        return _fault(f"{what} is empty", "A state that does not change was meant.", "'0'   # a rate of zero")
    return _fault(
        f"{what}, {shown(text)}, ends where something must follow",
        "The formula was cut off.",
        shown(text.strip().rstrip("+-*/^( ") or "k*x"),
    )


def cannot_go_on(what: str, text: str, at: int, found: str, before: str) -> ModelError:
    """Two factors or two operators in a row."""
    two_factors = found[0].isalnum() or found[0] in "_("
    return _fault(
        f"{what}, {shown(text)}, has {shown(found)} at character {at + 1}, where a formula cannot go on",
        "The sign * was left out between two factors, or the text is no formula."
        if two_factors
        else "A sign or a bracket was typed twice, or the text is no formula.",
        f"{before}*{found}" if two_factors and before else "'k1*x - k2*x**2'",
    )


def _fault(what: str, usually: str, paste: str) -> ModelError:
    return ModelError(what, usually=usually, paste=paste, read=READ)
