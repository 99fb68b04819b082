"""Formulas for people: a line of text for the terminal, MathML for a page; products and whole expressions.

    pi3, k_1   π₃, k₁           Caf    C with the index af           delta   δ
    v, starred                  v*, measured in its scale

Greek is what spells a letter in three letters or more (mu may be the mass of an unsprung wheel).

Invariant: a name is shown so that it can be told from every other, and markup contains no text of somebody
else that was not escaped.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from fractions import Fraction
from xml.dom.minidom import Document

import sympy as sp
from sympy.printing.mathml import MathMLPresentationPrinter

from similitude.dimensional.base_check import product_text
from similitude.report.html_page import Html

GREEK = {
    name: chr(code)
    for code, name in enumerate(
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho _ sigma tau "
        "upsilon phi chi psi omega".split(),
        start=0x3B1,
    )
    if len(name) > 2
}
_STAR = "\ue000"  # in place of the star while asterisks still mean products
_INDICES = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_POWERS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def parts_of(name: str) -> tuple[str, str]:
    """The letter of a name and its index, which may be empty.

    >>> parts_of("pi3"), parts_of("Caf"), parts_of("k_on"), parts_of("delta")
    (('π', '3'), ('C', 'af'), ('k', 'on'), ('δ', ''))
    """
    head, _, index = name.partition("_")
    if not head or not index:
        head, index = name, ""
    if not index and (found := re.fullmatch(r"([^\d]+)(\d+)", name)):
        head, index = found.groups()
    if not index and re.fullmatch(r"[A-Z]\w*[a-z]\w*", name):
        head, index = name[0], name[1:]
    return ("π" if head == "pi" and index.isdigit() else GREEK.get(head, head)), index


def plain_name(name: str, starred: Collection[str] = ()) -> str:
    """A name on one line: Greek letters, and digits as indices."""
    head, index = parts_of(name)
    shown = head + index.translate(_INDICES) if index.isdigit() else GREEK.get(name, name)
    return shown + ("*" if name in starred else "")


def plain_product(exponents: Mapping[str, Fraction], starred: Collection[str] = ()) -> str:
    """A product of powers on one line: ``Caf L/(m U²)``."""
    text = product_text({plain_name(name, starred): power for name, power in exponents.items()})
    return re.sub(r"\^(\d+)", lambda found: found[1].translate(_POWERS), text)


def plain_formula(e: sp.Expr, starred: Collection[str] = ()) -> str:
    """An expression on one line, products with a point, whole powers raised."""
    names = {s.name: plain_name(s.name, starred).replace("*", _STAR) for s in e.free_symbols}
    text = re.sub(r"[^\W\d]\w*", lambda word: names.get(word[0], word[0]), sp.sstr(e))
    text = re.sub(r"\*\*(\d+)(?![\d.])", lambda found: found[1].translate(_POWERS), text)
    text = text.replace("**", "^").replace("*", "·").replace("Saturation", "sat")
    return text.replace(_STAR, "*")


def math(e: sp.Expr, starred: Collection[str] = ()) -> Html:
    """An expression as MathML."""
    printer = _Printer(starred)
    inside = _plain(printer.doprint(e)).replace("<mo>-</mo>", "<mo>−</mo>")
    inside = inside.replace("<mo> </mo>", '<mspace width="0.17em"></mspace>')
    return Html(f'<math displaystyle="true">{inside}</math>')


def math_product(exponents: Mapping[str, Fraction], starred: Collection[str] = ()) -> Html:
    """A product of powers as MathML."""
    powers = (
        sp.Symbol(name, positive=True) ** sp.Rational(p.numerator, p.denominator)
        for name, p in exponents.items()
    )
    return math(sp.Mul(*powers), starred)


def math_rate(name: str, starred: Collection[str] = (), time: str = "t") -> Html:
    """The rate d(name)/d(time) as MathML."""
    over, under = (_plain(_Printer(starred).doprint(sp.Symbol(n))) for n in (name, time))
    rate = f"<mfrac><mrow><mi>d</mi>{over}</mrow><mrow><mi>d</mi>{under}</mrow></mfrac>"
    return Html(f'<math displaystyle="true">{rate}</math>')


def _plain(markup: str) -> str:
    """Characters in place of their numbers."""
    return re.sub(r"&#(\d+);", lambda found: chr(int(found[1])), markup)


class _Printer(MathMLPresentationPrinter):
    def __init__(self, starred: Collection[str]) -> None:
        super().__init__({"mul_symbol": " "})
        self.starred = starred

    def _print_Symbol(self, symbol: sp.Symbol, style: str = "plain"):
        head, index = parts_of(symbol.name)
        node = self._leaf("mi", head)
        star = symbol.name in self.starred
        if index or star:
            whole = self.dom.createElement("msubsup" if index and star else "msub" if index else "msup")
            whole.appendChild(node)
            if index:
                whole.appendChild(self._leaf("mn" if index.isdigit() else "mi", index))
            if star:
                whole.appendChild(self._leaf("mo", "*"))
            return whole
        return node

    def _print_Saturation(self, e: sp.Expr):
        row = self.dom.createElement("mrow")
        row.appendChild(self._leaf("mi", "sat"))
        row.appendChild(self._leaf("mo", "("))
        row.appendChild(self._print(e.args[0]))
        row.appendChild(self._leaf("mo", ")"))
        return row

    def _leaf(self, tag: str, text: str):
        node = self.dom.createElement(tag)
        node.appendChild((self.dom or Document()).createTextNode(text))
        return node
