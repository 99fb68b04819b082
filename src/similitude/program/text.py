"""Prints one expression the same way for C and for Python, so that both round alike.

Invariant: both languages evaluate the printed text left to right with the same brackets; powers
are products, there is no function call (a magnitude, only ever compared, is a sign bit cleared), and a select
is the only branch inside an expression.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from similitude.errors import ProgramError

LONG_SUM = 12  # terms; from here on a sum is added in two halves, which a large processor does side by side


@dataclass(frozen=True)
class Language:
    """What differs between the printed languages."""

    number: str  # how a floating-point literal is written, e.g. "R({})"
    select: str  # "({c} ? {a} : {b})"
    conjunction: str
    disjunction: str
    negation: str
    within: str = "abs({x}) < {limit}"  # a magnitude against a limit that is not negative
    beyond: str = "abs({x}) > {limit}"
    names: Mapping[str, str] = field(default_factory=dict)  # symbols that are written otherwise
    whole: frozenset[str] = frozenset()  # symbols that are integers, and compared with constants alone


C = Language(
    "R({})", "({c} ? {a} : {b})", " && ", " || ", "!({})", "WITHIN({x}, {limit})", "BEYOND({x}, {limit})"
)
PYTHON = Language("{}", "({a} if {c} else {b})", " and ", " or ", "not ({})")


def expression_text(expression: sp.Basic, language: Language) -> str:
    """The expression as source text.

    Raises
    ------
    ProgramError    it holds a function that cannot be printed without a mathematics library.
    """
    return _Printer(language).text(expression)


class _Printer:
    def __init__(self, language: Language) -> None:
        self.language = language

    def text(self, node: sp.Basic) -> str:
        """The node and all below it as source text."""
        for kind, method in (
            (sp.Symbol, self._symbol),
            (sp.Number, self._number),
            (sp.Add, self._add),
            (sp.Mul, self._mul),
            (sp.Pow, self._pow),
            (sp.Max, self._extreme),
            (sp.Min, self._extreme),
            (sp.core.relational.Relational, self._relation),
            (sp.And, self._and),
            (sp.Or, self._or),
            (sp.Not, self._not),
            (sp.Piecewise, self._piecewise),
        ):
            if isinstance(node, kind):
                return method(node)
        raise ProgramError(
            f"{type(node).__name__} in {sp.sstr(node)[:80]!r} cannot be printed as a step program",
            usually="The rates or outputs use a function such as sin or exp; the step has no libm.",
            paste="replace it by a rational approximation over the range that can occur",
            read="docs/architecture.md, 'Step programs'",
        )

    def _symbol(self, node: sp.Symbol) -> str:
        return self.language.names.get(node.name, node.name)

    def _number(self, node: sp.Number) -> str:
        if not node.is_finite:
            raise ProgramError(
                f"{sp.sstr(node)} is no number a step can work with",
                usually="A division by zero or an overflow while the expression was made.",
                paste="Max(x, least)   # keep a divisor off zero",
                read="docs/architecture.md, 'Step programs'",
            )
        value = float(node)
        return self.language.number.format(repr(value)) if value >= 0 else f"(-{self._number(-node)})"

    def _bracket(self, node: sp.Basic) -> str:
        text = self.text(node)
        return f"({text})" if isinstance(node, sp.Add) else text

    def _add(self, node: sp.Add) -> str:
        terms = sorted(node.args, key=lambda a: (a.could_extract_minus_sign(), sp.default_sort_key(a)))
        if len(terms) >= LONG_SUM and not any(t.could_extract_minus_sign() for t in terms):
            half = len(terms) // 2
            return f"({self._sum(terms[:half])}) + ({self._sum(terms[half:])})"
        return self._sum(terms)

    def _sum(self, terms: Sequence[sp.Expr]) -> str:
        text = self.text(terms[0])
        for term in terms[1:]:
            if term.could_extract_minus_sign():
                text += f" - {self._bracket(-term)}"
            else:
                text += f" + {self._bracket(term)}"
        return text

    def _mul(self, node: sp.Mul) -> str:
        if node.could_extract_minus_sign():
            return f"(-({self.text(-node)}))" if isinstance(-node, sp.Add) else f"(-{self.text(-node)})"
        over, under = [], []
        for factor in node.args:
            if isinstance(factor, sp.Pow) and factor.exp.is_negative:
                under.append(sp.Pow(factor.base, -factor.exp))
            elif isinstance(factor, sp.Rational) and factor.q != 1 and len(node.args) > 1:
                over.append(sp.Float(float(factor), 17))
            else:
                over.append(factor)
        text = "*".join(self._bracket(f) for f in over) if over else self._number(sp.Integer(1))
        if not under:
            return text
        below = "*".join(self._bracket(f) for f in under)
        return f"{text}/({below})" if len(under) > 1 or "*" in below else f"{text}/{below}"

    def _pow(self, node: sp.Pow) -> str:
        if not node.exp.is_Integer:
            raise ProgramError(
                f"the power {sp.sstr(node)[:80]!r} is not a whole one",
                usually="A square root or fractional power reached the step; it has no libm.",
                paste="carry the square as the state instead",
                read="docs/architecture.md, 'Step programs'",
            )
        count = abs(int(node.exp))
        product = "*".join([self._bracket(node.base)] * count)
        if node.exp > 0:
            return f"({product})" if count > 1 else product
        one = self._number(sp.Integer(1))
        return f"({one}/({product}))" if count > 1 else f"({one}/{product})"

    def _extreme(self, node: sp.Max | sp.Min) -> str:
        sign = ">" if isinstance(node, sp.Max) else "<"
        arguments = [self.text(a) for a in sorted(node.args, key=sp.default_sort_key)]
        text = arguments[0]
        for other in arguments[1:]:
            text = self.language.select.format(c=f"({text}) {sign} ({other})", a=text, b=other)
        return text

    def _relation(self, node: sp.core.relational.Relational) -> str:
        if isinstance(node.lhs, sp.Symbol) and node.lhs.name in self.language.whole:
            bound = sp.ceiling(node.rhs) if node.rel_op in ("<", ">=") else sp.floor(node.rhs)
            return f"{self._symbol(node.lhs)} {node.rel_op} {int(bound)}"
        if isinstance(node.lhs, sp.Abs) and node.rel_op in "<>":
            form = self.language.within if node.rel_op == "<" else self.language.beyond
            return form.format(x=self.text(node.lhs.args[0]), limit=self.text(node.rhs))
        return f"{self._bracket(node.lhs)} {node.rel_op} {self._bracket(node.rhs)}"

    def _and(self, node: sp.And) -> str:
        parts = sorted(f"({self.text(a)})" for a in node.args)
        return self.language.conjunction.join(parts)

    def _or(self, node: sp.Or) -> str:
        parts = sorted(f"({self.text(a)})" for a in node.args)
        return self.language.disjunction.join(parts)

    def _not(self, node: sp.Not) -> str:
        return self.language.negation.format(self.text(node.args[0]))

    def _piecewise(self, node: sp.Piecewise) -> str:
        *cases, (last, final) = node.args
        if final is not sp.true:
            raise ProgramError(
                f"the select {sp.sstr(node)[:80]!r} has no 'otherwise'",
                usually="A Piecewise was written without its last (value, True) pair.",
                paste="Piecewise((a, x > 0), (b, True))",
                read="docs/architecture.md, 'Step programs'",
            )
        text = self.text(last)
        for value, condition in reversed(cases):
            text = self.language.select.format(c=self.text(condition), a=self.text(value), b=text)
        return text


def count_operations(text: str) -> int:
    """Arithmetic operations, comparisons and selects in a printed C expression."""
    body = re.sub(r"R\([^)]*\)", "1", text)  # a literal's exponent sign is no operation
    unary = len(re.findall(r"\(-", body))
    return len(re.findall(r"[-+*/?<>]|WITHIN|BEYOND", body)) - unary
