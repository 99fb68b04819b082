"""Functions of a small matrix as straight-line statements, by the theorem of Cayley and Hamilton.

Every polynomial or rational function of an (n, n) matrix J is a polynomial of degree below n in J.
Its n coefficients are scalars, so products and the inverse cost O(n^2) instead of O(n^3), and the
only matrices ever formed are the powers of J and the results.

Invariant: a polynomial is a list of n expressions, constant term first, already reduced.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.program.ir import Assign

Polynomial = list[sp.Expr]


class MatrixFunction:
    """Collects statements for functions of one matrix.

    Parameters
    ----------
    J : (n, n) matrix of symbols or zeros.
    """

    def __init__(self, J: sp.Matrix) -> None:
        self.J = J
        self.n = J.shape[0]
        variable = sp.Symbol("lambda")
        characteristic = J.charpoly(variable).all_coeffs()[::-1]  # constant term first, monic
        self.lines: list[Assign] = []
        self.root = self.named("p", [sp.expand(c) for c in characteristic[:-1]])

    def named(self, prefix: str, values: Sequence[sp.Expr], comment: str = "") -> Polynomial:
        """Assign the coefficients to ``<prefix>0``, ``<prefix>1``, … unless they are plain."""
        result: Polynomial = []
        for k, value in enumerate(values):
            if value.is_Number or value.is_Symbol:
                result.append(value)
                continue
            self.lines.append(Assign(f"{prefix}{k}", value, comment if k == 0 else ""))
            result.append(sp.Symbol(f"{prefix}{k}", real=True))
        return result

    def reduced(self, coefficients: Sequence[sp.Expr]) -> Polynomial:
        """A polynomial of any degree modulo the characteristic one."""
        rest = [sp.sympify(c) for c in coefficients]
        while len(rest) > self.n:
            top = rest.pop()
            shift = len(rest) - self.n
            for k, c in enumerate(self.root):
                rest[shift + k] -= top * c
        return rest + [sp.Integer(0)] * (self.n - len(rest))

    def product(self, a: Polynomial, b: Polynomial) -> list[sp.Expr]:
        """Product of two polynomials, reduced."""
        full = [sp.Integer(0)] * (2 * self.n - 1)
        for i, x in enumerate(a):
            for j, y in enumerate(b):
                full[i + j] += x * y
        return self.reduced(full)

    def inverse(self, a: Polynomial, prefix: str, comment: str = "") -> Polynomial:
        """Reciprocal of a polynomial; one division."""
        columns = [self.reduced([sp.Integer(0)] * k + a) for k in range(self.n)]
        multiply = sp.Matrix(columns).T
        self.lines.append(Assign(f"{prefix}_det", 1 / multiply.det(method="berkowitz"), comment))
        det = sp.Symbol(f"{prefix}_det", real=True)
        return self.named(prefix, [det * x for x in multiply.adjugate()[:, 0]])

    def matrix(self, a: Polynomial, prefix: str, comment: str = "") -> sp.Matrix:
        """The polynomial as a matrix of assigned symbols ``<prefix>_ij``."""
        total, power = sp.zeros(self.n), sp.eye(self.n)
        for k, coefficient in enumerate(a):
            total += coefficient * power
            power = self._power(power * self.J, k + 1) if k + 1 < self.n else power
        for i in range(self.n):
            for j in range(self.n):
                text = comment if i + j == 0 else ""
                self.lines.append(Assign(f"{prefix}_{i}{j}", total[i, j], text))
        return sp.Matrix(self.n, self.n, lambda i, j: sp.Symbol(f"{prefix}_{i}{j}", real=True))

    def _power(self, value: sp.Matrix, k: int) -> sp.Matrix:
        """J^k as symbols; J itself already is."""
        if k == 1:
            return value
        done = {line.target for line in self.lines}
        names = sp.Matrix(self.n, self.n, lambda i, j: sp.Symbol(f"J{k}_{i}{j}", real=True))
        entries = [(i, j) for i in range(self.n) for j in range(self.n)]
        new = [at for at in entries if names[at].name not in done]
        self.lines += [Assign(names[at].name, value[at]) for at in new]
        return names
