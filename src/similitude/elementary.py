"""sin, cos, exp, ln, roots and their kin as straight-line statements of a step: no loop, no libm.

    root     five steps of Newton, after x was brought between 1/4 and 4 by powers of four
    exp      x = sum of halved steps + r, |r| <= 1/4; r by its series to eighth order
    ln       x brought into 3/4 .. 3/2 by powers of two; ln x = 2 artanh((x - 1)/(x + 1)) by its series
    sin, cos x brought into -pi .. pi by whole turns (up to 32), folded into -pi/2 .. pi/2, series

Both languages do the same operations, so results agree bit for bit; against the true functions they are
right to 1e-9 over the ranges that a test states. Arguments outside are clipped: nothing overflows, and a
root or logarithm of what is not positive is that of 1e-12.

Invariant: every result is finite for every finite argument.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping

import sympy as sp

from similitude.program.ir import Assign

LEAST = sp.Float(1e-12)  # of a root's or logarithm's argument
GREATEST = sp.Float(1e12)
EXPONENT = 40  # |x| of exp x at most
KINDS = (sp.sin, sp.cos, sp.tan, sp.exp, sp.log, sp.tanh, sp.sinh, sp.cosh, sp.Abs, sp.sign, sp.atan)
Lines = list[Assign]
_NOTHING = sp.Integer(0)


def spelt_functions(
    named: Mapping[str, sp.Expr], prefix: str = "fn"
) -> tuple[list[Assign], dict[str, sp.Expr]]:
    """Statements for every elementary function, and the expressions with their results in place.

    Parameters
    ----------
    named : name -> expression [-].
    prefix : what the names of the statements' targets begin with.

    Returns
    -------
    lines, expressions : to be placed in this order; no lines where nothing is elementary.
    """
    lines: Lines = []
    known: dict[sp.Expr, sp.Expr] = {}
    names = (f"{prefix}{i}" for i in itertools.count())

    def spell(node: sp.Basic) -> sp.Basic:
        if not node.args or not _elementary(node):
            return node
        if node in known:
            return known[node]
        rebuilt = node.func(*(spell(a) for a in node.args))
        maker = _maker(rebuilt)
        if maker is not None:
            rebuilt = maker(rebuilt, next(names), lines)
            rebuilt = spell(rebuilt) if _elementary(rebuilt) else rebuilt
        known[node] = rebuilt
        return rebuilt

    return lines, {name: spell(sp.sympify(e)) for name, e in named.items()}


def _elementary(node: sp.Basic) -> bool:
    if node.has(*KINDS, sp.DiracDelta, sp.Heaviside):
        return True
    return any(not p.exp.is_Integer for p in node.atoms(sp.Pow))


def _maker(node: sp.Basic) -> Callable[[sp.Expr, str, Lines], sp.Expr] | None:
    if isinstance(node, sp.Pow) and not node.exp.is_Integer:
        return _power
    for kinds, maker in (
        (sp.exp, _exp), (sp.log, _log), ((sp.sin, sp.cos), _wave), (sp.tan, _tan),
        ((sp.tanh, sp.sinh, sp.cosh), _hyperbolic), ((sp.Abs, sp.sign), _sign), (sp.atan, _atan),
        ((sp.DiracDelta, sp.Heaviside), _edge),
    ):  # fmt: skip
        if isinstance(node, kinds):
            return maker
    return None


def _put(lines: Lines, name: str, expression: sp.Expr, comment: str = "") -> sp.Symbol:
    lines.append(Assign(name, expression, comment))
    return sp.Symbol(name, real=True)


def _where(condition: sp.Basic, yes: sp.Expr, no: sp.Expr) -> sp.Expr:
    return sp.Piecewise((yes, condition), (no, True))


def _number(value: sp.Expr) -> sp.Float:
    return sp.Float(float(value), 17)


def _series(x: sp.Expr, coefficients: list[sp.Expr]) -> sp.Expr:
    total = _number(coefficients[-1])
    for c in coefficients[-2::-1]:
        total = _number(c) + x * total
    return total


def _sign(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    x = _put(lines, f"{name}_x", node.args[0])
    if isinstance(node, sp.Abs):
        return _put(lines, name, _where(x < 0, -x, x), "size")
    return _put(
        lines, name, _where(x < 0, sp.Integer(-1), _where(x > 0, sp.Integer(1), sp.Integer(0))), "sign"
    )


def _edge(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    """A kink's slope: the step of a size's sign, and nothing for the peak of a step."""
    if isinstance(node, sp.DiracDelta):
        return sp.Integer(0)
    x = _put(lines, f"{name}_x", node.args[0])
    return _put(lines, name, _where(x > 0, sp.Integer(1), sp.Integer(0)), "side of a kink")


def _power(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    base, exponent = node.args
    doubled = 2 * exponent
    if not doubled.is_Integer:
        logarithm = _log(
            sp.log(sp.Symbol(f"{name}_b", real=True), evaluate=False), f"{name}l", _named(lines, name, base)
        )
        return sp.exp(exponent * logarithm)
    x = _put(lines, f"{name}_x", base)
    root = _root(x, name, lines)
    whole = sp.floor(exponent)
    return root * x**whole if whole >= 0 else root / (sp.Max(x, LEAST) ** (-whole))


def _named(lines: Lines, name: str, base: sp.Expr) -> Lines:
    _put(lines, f"{name}_b", base)
    return lines


def _root(x: sp.Symbol, name: str, lines: Lines) -> sp.Symbol:
    y = _put(lines, f"{name}_y0", sp.Min(sp.Max(x, LEAST), GREATEST), "root of it, kept off zero")
    s: sp.Expr = sp.Integer(1)
    for k, bits in enumerate((32, 16, 8, 4, 2)):  # powers of four, so that their roots are whole
        up, down = sp.Integer(2) ** bits, sp.Integer(2) ** -bits
        s = _put(lines, f"{name}_s{k}",
                 s * _where(y >= up, sp.Integer(2) ** (bits // 2),
                            _where(y <= down, sp.Rational(1, 2 ** (bits // 2)), sp.Integer(1))))  # fmt: skip
        less = _where(y <= down, up, sp.Integer(1))
        y = _put(lines, f"{name}_y{k + 1}", y * _where(y >= up, down, less))
    g = _put(lines, f"{name}_g0", (1 + y) / 2)
    for k in range(5):
        g = _put(lines, f"{name}_g{k + 1}", (g + y / g) / 2)
    return _put(lines, name, s * g, "square root")


def _exp(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    x = _put(lines, f"{name}_x0", sp.Min(sp.Max(node.args[0], -EXPONENT), EXPONENT), "exponent")
    e: sp.Expr = sp.Integer(1)
    for k, part in enumerate((32, 16, 8, 4, 2, 1, sp.Rational(1, 2), sp.Rational(1, 4))):
        more, less = (_number(sp.exp(sign * part)) for sign in (1, -1))
        e = _put(lines, f"{name}_e{k}", e * _where(x >= part, more, _where(x <= -part, less, sp.Integer(1))))
        size = sp.Float(part)
        x = _put(lines, f"{name}_x{k + 1}", x - _where(x >= part, size, _where(x <= -part, -size, _NOTHING)))
    return _put(lines, name, e * _series(x, [1 / sp.factorial(k) for k in range(9)]), "exponential")


def _log(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    y = _put(lines, f"{name}_y0", sp.Min(sp.Max(node.args[0], LEAST), GREATEST), "logarithm of it")
    n: sp.Expr = sp.Integer(0)
    for k, bits in enumerate((32, 16, 8, 4, 2, 1)):
        high = sp.Float(sp.Rational(3, 4) * 2**bits)
        low = sp.Float(sp.Rational(3, 2) / 2**bits)
        size, up = sp.Float(bits), sp.Integer(2) ** bits
        n = _put(lines, f"{name}_n{k}", n + _where(y >= high, size, _where(y <= low, -size, _NOTHING)))
        less = _where(y <= low, up, sp.Integer(1))
        y = _put(lines, f"{name}_y{k + 1}", y * _where(y >= high, 1 / up, less))
    z = _put(lines, f"{name}_z", (y - 1) / (y + 1))
    tail = _series(sp.Symbol(f"{name}_zz", real=True), [sp.Rational(2, 2 * k + 1) for k in range(9)])
    _put(lines, f"{name}_zz", z * z)
    return _put(lines, name, _number(sp.log(2)) * n + z * tail, "natural logarithm")


def _wave(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    """sin and cos; cos x = sin(x + pi/2)."""
    angle = node.args[0] + (_number(sp.pi / 2) if isinstance(node, sp.cos) else 0)
    x = _put(lines, f"{name}_x0", sp.Min(sp.Max(angle, -200), 200), "angle")
    for k, turns in enumerate((16, 8, 4, 2, 1)):
        whole, edge = _number(2 * sp.pi * turns), _number(sp.pi * (2 * turns - 1))
        x = _put(lines, f"{name}_x{k + 1}",
                 x - _where(x > edge, whole, _where(x < -edge, -whole, sp.Integer(0))))  # fmt: skip
    half, pi = _number(sp.pi / 2), _number(sp.pi)
    y = _put(lines, f"{name}_y", _where(x > half, pi - x, _where(x < -half, -pi - x, x)))
    yy = _put(lines, f"{name}_yy", y * y)
    series = _series(yy, [sp.Integer(-1) ** k / sp.factorial(2 * k + 1) for k in range(8)])
    return _put(lines, name, y * series, "cosine" if isinstance(node, sp.cos) else "sine")


def _tan(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    return sp.sin(node.args[0]) / sp.cos(node.args[0])


def _hyperbolic(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    up = sp.exp(sp.Min(sp.Max(node.args[0], -18), 18) if isinstance(node, sp.tanh) else node.args[0])
    if isinstance(node, sp.tanh):
        return 1 - 2 / (1 + up * up)
    return (up + 1 / up) / 2 if isinstance(node, sp.cosh) else (up - 1 / up) / 2


def _atan(node: sp.Expr, name: str, lines: Lines) -> sp.Expr:
    """Twice halved: atan x = 4 atan(y), |y| < 0.2; beyond one by its reciprocal."""
    x = _put(lines, f"{name}_x", node.args[0])
    size = _put(lines, f"{name}_a", _where(x < 0, -x, x))
    y = _put(lines, f"{name}_y0", _where(size > 1, 1 / sp.Max(size, 1), size))
    for k in range(2):
        square = _put(lines, f"{name}_q{k}", 1 + y * y)
        root = _root(square, f"{name}_r{k}", lines)
        y = _put(lines, f"{name}_y{k + 1}", y / (1 + root))
    yy = _put(lines, f"{name}_yy", y * y)
    inner = _put(
        lines, f"{name}_i", 4 * y * _series(yy, [sp.Integer(-1) ** k / (2 * k + 1) for k in range(8)])
    )
    whole = _put(lines, f"{name}_w", _where(size > 1, _number(sp.pi / 2) - inner, inner))
    return _put(lines, name, _where(x < 0, -whole, whole), "angle of a tangent")
