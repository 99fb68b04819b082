"""Text to expression: the formulas of a model, read with the names that were declared and no others.

    sum     = product (("+" | "-") product)*
    product = signed (("*" | "/") signed)*
    signed  = ("+" | "-") signed | power
    power   = atom (("**" | "^") signed)?        right-associative: 2**3**2 is 2**9
    atom    = number | name | function "(" sum ("," sum)* ")" | "(" sum ")"

Numbers are exact: 0.1 is one tenth. N, S, E, I, beta, gamma and lambda are what the caller declared them
to be; SymPy's and Python's own meanings do not exist here, except for the functions of `FUNCTIONS` and
for `pi` where nobody declared it.

Invariant: nothing is evaluated but this grammar. No text can reach Python, nest deeper than `DEEPEST`
or make a number of more than `MOST_DIGITS` digits.
"""

from __future__ import annotations

import math
import re
import sys
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from similitude import model_text_faults as fault

FUNCTIONS = {
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "asin": sp.asin, "acos": sp.acos, "atan": sp.atan,
    "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh, "exp": sp.exp, "log": sp.log, "ln": sp.log,
    "sqrt": sp.sqrt, "abs": sp.Abs, "sign": sp.sign, "atan2": sp.atan2, "min": sp.Min, "max": sp.Max,
}  # fmt: skip
ARGUMENTS = {"atan2": 2, "min": None, "max": None}  # all others take one; None: any number
DEEPEST = 100  # brackets, signs and powers inside one another
MOST_DIGITS = 3000  # of a number that appears on the way
LARGEST = sp.Float(sys.float_info.max)
HIGHEST_POWER = 100  # of anything: physics stops long before, and algebra soon after

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[^\W\d]\w*)"
    r"|(?P<sign>\*\*|[-+*/^(),])|(?P<end>$))",
)
_SAME = str.maketrans("−–·×⋅", "--***")  # signs as text processors write them


def parse_expression(text: str, names: Iterable[str], *, what: str = "the expression") -> sp.Expr:
    """Read one formula.

    Parameters
    ----------
    text : the formula, such as ``"beta*S*I/N - gamma*I"``; powers as ``**`` or ``^``.
    names : every name it may use; each becomes ``Symbol(name, real=True)``, as ``Quantity.symbol``.
    what : how messages call it, such as ``"the rate of 'S'"``.

    Returns
    -------
    sympy.Expr    numbers in it are rational.

    Raises
    ------
    ModelError    not a formula of this grammar, a name that is not declared, a call of something that is
                  no function, a division by zero, or a number or a power too large to be meant.
    """
    if not isinstance(text, str):
        raise fault.no_text(what, text)
    declared = {_plain(name): sp.Symbol(name, real=True) for name in names}
    reader = _Reader(text, what, declared, _tokens(text, what))
    result = reader._sum()
    reader._expect_end()
    if result.has(sp.zoo, sp.nan, sp.oo, -sp.oo):
        raise fault.divides_by_zero(what, text)
    powers = [one.exp for one in result.atoms(sp.Pow) if one.exp.is_Rational]
    if any(abs(power) > HIGHEST_POWER for power in powers):
        raise fault.too_high(what, text, max(powers, key=abs), HIGHEST_POWER)
    return result


@dataclass(frozen=True)
class _Token:
    kind: str  # number, name, sign or end
    text: str
    at: int  # position in the text


def _plain(name: str) -> str:
    """One spelling of a name: the micro sign and the Greek letter mu are the same."""
    return unicodedata.normalize("NFKC", name)


def _tokens(text: str, what: str) -> list[_Token]:
    plain, tokens, at = text.translate(_SAME), [], 0
    while not tokens or tokens[-1].kind != "end":
        found = _TOKEN.match(plain, at)
        if found is None:
            blank = len(plain[at:]) - len(plain[at:].lstrip())
            raise fault.strange_character(what, text, at + blank)
        kind = found.lastgroup
        tokens.append(_Token(kind, found.group(kind), found.start(kind)))
        at = found.end()
    return tokens


class _Reader:
    """One pass over the tokens, one method a line of the grammar."""

    def __init__(self, text: str, what: str, declared: dict[str, sp.Symbol], tokens: list[_Token]) -> None:
        self.about = (what, text)
        self.declared = declared
        self.tokens = tokens
        self.place = 0
        self.depth = 0

    @property
    def _next(self) -> _Token:
        return self.tokens[self.place]

    def _take(self, *signs: str) -> str | None:
        """The next sign, if it is one of these; the reader then stands behind it."""
        if self._next.kind == "sign" and self._next.text in signs:
            self.place += 1
            return self.tokens[self.place - 1].text
        return None

    def _sum(self) -> sp.Expr:
        terms = [self._product()]
        while sign := self._take("+", "-"):
            term = self._product()
            terms.append(term if sign == "+" else -term)
        return self._sized(sp.Add(*terms))

    def _product(self) -> sp.Expr:
        factors = [self._signed()]
        while sign := self._take("*", "/"):
            factor = self._signed()
            factors.append(factor if sign == "*" else 1 / factor)
        return self._sized(sp.Mul(*factors))

    def _signed(self) -> sp.Expr:
        self.depth += 1
        if self.depth > DEEPEST:
            raise fault.too_deep(*self.about, DEEPEST)
        if sign := self._take("+", "-"):
            value = self._signed() if sign == "+" else -self._signed()
        else:
            value = self._power()
        self.depth -= 1
        return value

    def _power(self) -> sp.Expr:
        base = self._atom()
        if not self._take("**", "^"):
            return base
        exponent = self._signed()
        if exponent.is_Rational and abs(exponent) * _digits(base) > MOST_DIGITS:
            raise fault.too_large(*self.about, MOST_DIGITS)
        return self._real(base**exponent)

    def _atom(self) -> sp.Expr:
        token = self._next
        if token.kind == "end":
            raise fault.cut_off(*self.about)
        self.place += 1
        if token.kind == "number":
            return self._number(token)
        if token.kind == "name":
            return self._call(token) if self._next.text == "(" else self._name(token)
        if token.text != "(":
            raise self._unexpected(token)
        inner = self._sum()
        self._close(token)
        return inner

    def _number(self, token: _Token) -> sp.Expr:
        exponent = token.text.lower().partition("e")[2]
        if len(token.text) > MOST_DIGITS or (exponent and abs(int(exponent)) > MOST_DIGITS):
            raise fault.too_large(*self.about, MOST_DIGITS)
        return sp.Rational(token.text)

    def _name(self, token: _Token) -> sp.Expr:
        if _plain(token.text) in self.declared:
            return self.declared[_plain(token.text)]
        if token.text == "pi":
            return sp.pi
        raise fault.unknown_name(*self.about, token.text, [s.name for s in self.declared.values()])

    def _call(self, token: _Token) -> sp.Expr:
        name = token.text
        if _plain(name) in self.declared:
            raise fault.calls_a_quantity(*self.about, name)
        if name not in FUNCTIONS:
            raise fault.unknown_function(*self.about, name, FUNCTIONS)
        opening = self._next
        self.place += 1
        arguments = [self._sum()]
        while self._take(","):
            arguments.append(self._sum())
        self._close(opening)
        wanted = ARGUMENTS.get(name, 1)
        if wanted not in (None, len(arguments)):
            raise fault.argument_count(*self.about, name, len(arguments), wanted)
        return self._real(FUNCTIONS[name](*arguments))

    def _close(self, opening: _Token) -> None:
        if self._take(")"):
            return
        if self._next.kind == "end":
            raise fault.open_bracket(*self.about, opening.at)
        raise self._unexpected(self._next)

    def _expect_end(self) -> None:
        if self._next.kind != "end":
            raise self._unexpected(self._next)

    def _unexpected(self, token: _Token):
        place = self.tokens.index(token)
        before = self.tokens[place - 1].text if place else ""
        return fault.cannot_go_on(*self.about, token.at, token.text, before)

    def _real(self, value: sp.Expr) -> sp.Expr:
        if value.is_number and not value.is_Rational and _beyond_reals(value):
            raise fault.beyond_reals(*self.about)
        if value.is_number and value.is_real is False and value.is_finite is not False:
            raise fault.not_real(*self.about, value)
        return value

    def _sized(self, value: sp.Expr) -> sp.Expr:
        if value.is_Rational and _digits(value) > MOST_DIGITS:
            raise fault.too_large(*self.about, MOST_DIGITS)
        return value


def _beyond_reals(value: sp.Expr) -> bool:
    """Whether a constant such as exp(exp(10)) is larger than any float64."""
    try:
        size = abs(value.evalf(15))
        return bool(size.is_finite and size > LARGEST)
    except OverflowError:
        return True


def _digits(value: sp.Expr) -> float:
    """Decimal digits of a number; for anything else those of the largest number in it."""
    numbers = [value] if value.is_Rational else value.atoms(sp.Rational)
    return max((max(abs(x.p), x.q).bit_length() * math.log10(2) for x in numbers), default=0)
