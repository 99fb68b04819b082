"""How a unit is written: text -> names with exact powers. Knows no unit by name.

    unit    = term { "/" term }              left to right; "a/b/c" is a/(b c)
    term    = factor { [ "*" | "." | "·" ] factor }     a blank multiplies
    factor  = ( NAME | "1" | "(" unit ")" ) [ power ]
    power   = ( "^" | "**" ) exponent | digits glued to a name (m2, s-2) | superscripts (s⁻²)
    exponent = [sign] digits [ "." digits ] | "(" [sign] digits [ "/" digits ] ")"

Invariant: a product after a slash ("J/kg K") is refused, because people and programs disagree
about what it means.
"""

from __future__ import annotations

import re
from fractions import Fraction

from similitude.errors import shown

# What no log or textbook needs, and what keeps a damaged header from costing time.
LONGEST_TEXT = 80
LARGEST_POWER = 24
LARGEST_ROOT = 12

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_SUPERSCRIPT_RUN = re.compile(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]+")
_TOKEN = re.compile(
    r"\s*(?:"
    r"(?P<power>(?:\^|\*\*)\s*(?:[-+]?\d+(?:\.\d+)?|\(\s*[-+]?\d+(?:\s*/\s*\d+|\.\d+)?\s*\)))"
    r"|(?P<name>[^\W\d_]+(?:_[^\W\d_]+)*|°[CF]?|%)"
    r"|(?P<glued>(?<=[^\W\d_])[-+]?\d+(?![\d.]))"
    r"|(?P<one>1(?![\w.]))"
    r"|(?P<sign>[*/·⋅().])"
    r")"
)


class GrammarError(ValueError):
    """The text is not written as a unit; the message says what stands in the way."""


def parse_terms(text: str) -> list[tuple[str, Fraction]]:
    """Split a unit into names and powers.

    Parameters
    ----------
    text : str
        Such as ``"kg m^2"``, ``"m/s²"``, ``"N m/rad"``, ``"m s^-1 Hz^(-1/2)"``, ``"1"``.

    Returns
    -------
    list of (name, power)
        Powers are exact [-]; ``"1"`` gives an empty list; names may repeat.

    Raises
    ------
    GrammarError
        With one clause that says what is wrong.

    Examples
    --------
    >>> parse_terms("N m/rad")
    [('N', Fraction(1, 1)), ('m', Fraction(1, 1)), ('rad', Fraction(-1, 1))]
    """
    if not text.strip():
        raise GrammarError("it is empty")
    if len(text) > LONGEST_TEXT:
        raise GrammarError(f"it is {len(text)} characters long")
    spelled = _SUPERSCRIPT_RUN.sub(lambda run: "^" + run.group().translate(_SUPERSCRIPTS), text.strip())
    tokens = _tokens(spelled)
    terms, rest = _unit(tokens)
    if rest:
        raise GrammarError(f"'{rest[0][1]}' stands where a unit should begin or end")
    return terms


def _tokens(text: str) -> list[tuple[str, str]]:
    tokens, at = [], 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise GrammarError(f"{shown(text[at:].strip())} is no part of a unit")
        tokens.append((match.lastgroup, match.group(match.lastgroup)))
        at = match.end()
    return tokens


def _unit(tokens: list) -> tuple[list, list]:
    terms, rest, factors = _term(tokens)
    slashes = 0
    while rest and rest[0][1] == "/":
        more, rest, factors = _term(rest[1:])
        slashes += 1
        if factors > 1:
            raise GrammarError(
                "a product follows the '/': write brackets, 'J/(kg K)', or one '/' each, 'J/kg/K'"
            )
        terms = terms + [(name, -power) for name, power in more]
    return terms, rest


def _term(tokens: list) -> tuple[list, list, int]:
    terms, rest = _factor(tokens)
    factors = 1
    while rest and rest[0][1] not in ("/", ")"):
        if rest[0][1] in ("*", "·", "⋅", "."):
            rest = rest[1:]
        more, rest = _factor(rest)
        terms = terms + more
        factors += 1
    return terms, rest, factors


def _factor(tokens: list) -> tuple[list, list]:
    if not tokens:
        raise GrammarError("it ends where a unit should follow")
    (kind, word), rest = tokens[0], tokens[1:]
    if kind == "name":
        terms = [(word, Fraction(1))]
    elif kind == "one":
        terms = []
    elif word == "(":
        terms, rest = _unit(rest)
        if not rest or rest[0][1] != ")":
            raise GrammarError("a bracket is not closed")
        rest = rest[1:]
    else:
        raise GrammarError(f"'{word}' stands where a unit should begin")
    if rest and rest[0][0] in ("power", "glued"):
        power, rest = _exponent(rest[0][1]), rest[1:]
        terms = [(name, own * power) for name, own in terms]
    return terms, rest


def _exponent(text: str) -> Fraction:
    above, _, below = re.sub(r"[\s()^*]", "", text).partition("/")
    if below and not int(below):
        raise GrammarError(f"the power {above}/{below} divides by zero")
    power = Fraction(above) / int(below or 1)
    if abs(power) > LARGEST_POWER or power.denominator > LARGEST_ROOT:
        raise GrammarError(f"the power {power} is beyond any unit in use")
    return power
