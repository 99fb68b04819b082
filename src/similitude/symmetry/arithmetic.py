"""Three arithmetics in which a tape runs: integers modulo a prime, floats, numbers of sixty digits.

    Modular    exact up to the choice of prime and point; ranks are ranks
    Floats     fast; for checks
    Digits     mpmath's numbers, for functions that no finite field knows

Values are arrays (..., 1 + q): a value and its slopes along q directions. `run` evaluates a tape at order
zero, `Series` goes on to higher orders in time.

Invariant: a division by zero, a root or a logarithm that leaves the real numbers raises `BadPoint`, so
that the caller takes another point.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import mpmath
import numpy as np
import sympy as sp

from similitude.symmetry.tape import Tape

PRIME = 2**31 - 1  # a product of two residues fits in 64 bits
PRIMES = (PRIME, 2**31 - 19)  # together they tell fractions of seven digits
DIGITS = 60  # of the numbers in Digits


class BadPoint(ArithmeticError):
    """The point at hand is singular for some expression; nearly every other point is not."""


class Modular:
    """Residues modulo a prime below 2^31, int64."""

    dtype = np.int64

    def __init__(self, prime: int = PRIME) -> None:
        self.prime = prime

    def number(self, value: sp.Expr) -> int:
        """The residue of a rational number."""
        return int(value.p) * pow(int(value.q), -1, self.prime) % self.prime

    def wrap(self, values: np.ndarray) -> np.ndarray:
        """Residues of what a sum or product made."""
        return values % self.prime

    def inverse(self, values: np.ndarray) -> np.ndarray:
        """1/values."""
        if not np.all(values):
            raise BadPoint("a denominator is zero")
        flat = [pow(int(x), -1, self.prime) for x in np.ravel(values)]
        return np.array(flat, dtype=np.int64).reshape(np.shape(values))

    def draw(self, rng: np.random.Generator, shape) -> np.ndarray:
        """Random residues, none of them zero."""
        return rng.integers(1, self.prime, size=shape, dtype=np.int64)


class Floats:
    """Doubles."""

    dtype = np.float64

    def number(self, value: sp.Expr):
        """The nearest double."""
        return float(value)

    def wrap(self, values: np.ndarray) -> np.ndarray:
        """Nothing to do."""
        return values

    def inverse(self, values: np.ndarray) -> np.ndarray:
        """1/values."""
        if not np.all(values):
            raise BadPoint("a denominator is zero")
        return 1 / values

    def draw(self, rng: np.random.Generator, shape) -> np.ndarray:
        """Random numbers between 1/2 and 3/2."""
        return 0.5 + rng.random(shape)

    def call(self, name: str, power, values: np.ndarray) -> np.ndarray:
        """A function of the tape, element by element."""
        return np.vectorize(lambda x: _real(math, name, power, x), otypes=[self.dtype])(values)


class Digits(Floats):
    """mpmath numbers of DIGITS digits, in object arrays."""

    dtype = object

    def number(self, value: sp.Expr):
        """The value to DIGITS digits."""
        with mpmath.workdps(DIGITS):
            if value.is_Rational:
                return mpmath.mpf(int(value.p)) / int(value.q)
            return mpmath.mpmathify(sp.N(value, DIGITS))

    def draw(self, rng: np.random.Generator, shape) -> np.ndarray:
        """Random fractions of 2^20 between 1/2 and 3/2."""
        whole = rng.integers(2**19, 3 * 2**19, size=shape)
        return np.vectorize(lambda x: mpmath.mpf(int(x)) / 2**20, otypes=[object])(whole)

    def call(self, name: str, power, values: np.ndarray) -> np.ndarray:
        """A function of the tape, element by element."""
        return np.vectorize(lambda x: _real(mpmath, name, power, x), otypes=[object])(values)


def _real(library, name: str, power, x):
    try:
        if name == "power":
            value = x ** (library.mpf(power.p) / power.q if library is mpmath else power.p / power.q)
        else:
            value = getattr(library, name)(x)
    except (ValueError, OverflowError, ZeroDivisionError) as error:
        raise BadPoint(str(error)) from None
    if isinstance(value, (complex, mpmath.mpc)) or value != value:
        raise BadPoint(f"{name} leaves the real numbers")
    return value


class Series:
    """A tape's steps as Taylor series, one order at a time.

    Parameters
    ----------
    tape : Tape
    field : Modular, Floats or Digits
    symbols : name -> list of coefficients, each (..., 1 + q); the caller may append to them between orders.
    choices : branch step -> place of the largest or smallest argument, or whether the argument is
        positive; those of a point of real numbers, where residues have none. Filled in where it is empty.
    """

    def __init__(
        self,
        tape: Tape,
        field,
        symbols: Mapping[str, list[np.ndarray]],
        choices: dict[int, np.ndarray] | None = None,
    ) -> None:
        self.tape, self.field, self.symbols = tape, field, symbols
        self.choices = {} if choices is None else choices
        self.values: list[list[np.ndarray]] = [[] for _ in tape.steps]
        self.order = 0
        self.zero = np.zeros_like(next(iter(symbols.values()))[0])

    def advance(self) -> list[np.ndarray]:
        """One more coefficient of every result, in the tape's order of results."""
        for place, (kind, what, earlier) in enumerate(self.tape.steps):
            self.values[place].append(self._coefficient(place, kind, what, [self.values[i] for i in earlier]))
        self.order += 1
        return [self.values[place][-1] for place in self.tape.results]

    def _coefficient(self, place: int, kind: str, what, a: list[list[np.ndarray]]) -> np.ndarray:
        k = self.order
        if kind == "symbol":
            known = self.symbols[what]
            return known[k] if k < len(known) else self.zero
        if kind == "number":
            value = self.zero.copy()
            if k == 0:
                value[..., 0] = self.field.number(what)
            return value
        if kind == "add":
            return self.field.wrap(a[0][k] + a[1][k])
        if kind == "mul":
            return self._convolved(a[0], a[1], range(k + 1), k)
        if kind == "inv":
            return self._inverse(place, a[0], k)
        if kind == "call":
            return self._called(place, what, a[0], k)
        return self._branch(place, kind, a, k)

    def _product(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        wrap = self.field.wrap
        with np.errstate(over="ignore", invalid="ignore"):  # a high power of a double may well overflow
            product = wrap(wrap(x[..., :1] * y) + wrap(y[..., :1] * x))
            product[..., 0] = wrap(x[..., 0] * y[..., 0])
        return product

    def _convolved(self, x, y, indices: range, k: int) -> np.ndarray:
        total = self.zero
        for i in indices:
            total = self.field.wrap(total + self._product(x[i], y[k - i]))
        return total

    def _inverse(self, place: int, a, k: int) -> np.ndarray:
        own = self.values[place]
        if k == 0:
            head = self.field.inverse(a[0][..., :1])
            value = self.field.wrap(-self.field.wrap(head * head) * a[0])
            value[..., 0] = head[..., 0]
            return value
        rest = self._convolved(a, own, range(1, k + 1), k)
        return self.field.wrap(-self._product(own[0], rest))

    def _called(self, place: int, what, a, k: int) -> np.ndarray:
        slope = self.values[self.tape.slopes[place]]
        if k == 0:
            name, power = what
            head = self.field.call(name, power, a[0][..., :1])
            value = _slope(name, power, self.field, a[0][..., :1], head) * a[0]
            value[..., 0] = head[..., 0]
            return value
        total = self.zero
        for i in range(1, k + 1):
            total = total + i * self._product(a[i], slope[k - i])
        return total / k

    def _branch(self, place: int, kind: str, a, k: int) -> np.ndarray:
        """abs, sign, max and min follow the branch that holds at order zero."""
        if place not in self.choices:
            heads = [x[0][..., 0] for x in a]
            decide = {"max": np.argmax, "min": np.argmin}.get(kind)
            self.choices[place] = decide(heads, axis=0) if decide else np.greater(heads[0], 0)
        chosen = self.choices[place]
        if kind in ("max", "min"):
            parts = [np.where(np.equal(chosen, i)[..., None], x[k], self.zero) for i, x in enumerate(a)]
            return sum(parts[1:], parts[0])
        signs = np.where(chosen, 1, -1)[..., None]
        if kind == "abs":
            return self.field.wrap(signs * a[0][k])
        value = self.zero.copy()
        if k == 0:
            value[..., 0] = self.field.wrap(signs[..., 0])
        return value


def _slope(name: str, power, field, a, h):
    """dh/da from the value of a function and of its argument."""
    one_less = 1 - a * a
    table = {
        "exp": lambda: h,
        "log": lambda: field.inverse(a),
        "sin": lambda: field.call("cos", None, a),
        "cos": lambda: -field.call("sin", None, a),
        "tan": lambda: 1 + h * h,
        "sinh": lambda: field.call("cosh", None, a),
        "cosh": lambda: field.call("sinh", None, a),
        "tanh": lambda: 1 - h * h,
        "asin": lambda: field.inverse(field.call("sqrt", None, one_less)),
        "acos": lambda: -field.inverse(field.call("sqrt", None, one_less)),
        "atan": lambda: field.inverse(1 + a * a),
        "power": lambda: field.number(power) * h * field.inverse(a),
    }
    return table[name]()


def run(tape: Tape, field, symbols: Mapping[str, np.ndarray]) -> list[np.ndarray]:
    """Values and gradients of a tape's results.

    Parameters
    ----------
    symbols : name -> (..., 1 + q), value and slopes.

    Raises
    ------
    BadPoint    the point is singular.
    """
    return Series(tape, field, {name: [value] for name, value in symbols.items()}).advance()
