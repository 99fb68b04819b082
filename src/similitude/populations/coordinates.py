"""Coordinates of a population, in which a Gaussian is unbounded and constraints hold exactly.

    z      (d,) coordinates: ln of a base parameter, ln of a group, or the logit of a share
    ln p   (p,) logarithms of the parameters,   T ln p = [C z; ln s(z); ln s(-z)],   s the logistic function

A constraint such as b = L - a is no straight line in logarithms. The share a/L as logit makes it one:
ln a = ln L + ln s(z), ln b = ln L + ln s(-z), true for every real z. What remains curved (a b = L^2
s(z) s(-z)) is handed out with its slope, for whoever linearises it. A signal (a car's speed) is no
property of a system: it stands at a stated value.

Invariant: `logs` and `slopes` are one function and its derivative, for any stack of z.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.errors import ModelError
from similitude.groups import Groups
from similitude.model import Model

Product = Mapping[str, Fraction]


@dataclass(frozen=True, eq=False)
class Coordinates:
    """Names (d,), and how the logarithms of the parameters follow."""

    names: tuple[str, ...]
    parameters: tuple[str, ...]
    signals: Mapping[str, float]  # ln of the stated value
    shares: tuple[int, ...]  # places of the logits in z
    inverse: NDArray[np.float64]  # (p, rows of T): T^-1
    sizes: tuple[int, ...] = ()  # places of the base in z: they may differ from table to table
    triples: tuple[tuple[str, str, str], ...] = ()  # whole, part, rest of each share

    def logs(self, z: NDArray) -> NDArray:
        """Logarithms of the parameters, (..., p), of coordinates (..., d)."""
        return self._features(z) @ self.inverse.T

    def slopes(self, z: NDArray) -> NDArray:
        """d ln p/dz, (..., p, d)."""
        d, s = len(self.names), len(self.shares)
        plain = [k for k in range(d) if k not in self.shares]
        rows = np.zeros((*z.shape[:-1], len(plain) + 2 * s, d))
        rows[..., range(len(plain)), plain] = 1.0
        for i, k in enumerate(self.shares):
            share = _logistic(z[..., k])
            rows[..., len(plain) + 2 * i, k] = 1.0 - share
            rows[..., len(plain) + 2 * i + 1, k] = -share
        return self.inverse @ rows

    def exponents(self, products: Sequence[Product]) -> tuple[NDArray, NDArray]:
        """Exponents (q, p) of products over the parameters, and what signals add to their logs (q,)."""
        matrix = np.array([[float(c.get(n, 0)) for n in self.parameters] for c in products])
        fixed = np.array([sum(float(c.get(n, 0)) * v for n, v in self.signals.items()) for c in products])
        return matrix.reshape(len(products), len(self.parameters)), fixed

    def _features(self, z: NDArray) -> NDArray:
        plain = [k for k in range(len(self.names)) if k not in self.shares]
        parts = [z[..., plain]]
        for k in self.shares:
            parts.append(np.stack([-np.logaddexp(0, -z[..., k]), -np.logaddexp(0, z[..., k])], axis=-1))
        return np.concatenate(parts, axis=-1)


def coordinates_of(
    groups: Groups, *, at: Mapping[str, float] | None = None, products: Mapping[str, Product] | None = None
) -> Coordinates:
    """Coordinates of a model's parameters.

    Parameters
    ----------
    groups : Groups    model and base.
    at : signal -> value [SI] at which groups are stated; 1 where left out.
    products : name -> product of powers, wanted as coordinates before the groups themselves.

    Returns
    -------
    Coordinates        logits of shares, ln of the base, ln of `products`, then of groups, as many
                       as there are independent parameters.

    Raises
    ------
    ModelError         a constraint is neither a sum of two parameters nor a product.
    """
    model = groups.model
    parameters = tuple(q.name for q in model.parameters if q.name not in model.signals)
    shares, fixed = _constraints(model)
    rows: list[tuple[str, NDArray]] = []

    def row(product: Product) -> NDArray:
        return np.array([float(product.get(n, 0)) for n in parameters])

    taken = [
        r for whole, part, rest in shares for r in (row({part: 1, whole: -1}), row({rest: 1, whole: -1}))
    ]
    taken += [row(product) for product in fixed]
    wanted = [(f"ln {n}", {n: Fraction(1)}) for n in groups.base if n not in model.signals]
    wanted += [(f"ln {name}", product) for name, product in (products or {}).items()]
    wanted += [(f"ln {g.name}", g.exponents) for g in groups.groups]
    for name, product in wanted:
        stacked = np.array([*taken, *(r for _, r in rows), row(product)])
        if np.linalg.matrix_rank(stacked) == len(stacked):
            rows.append((name, row(product)))
    logits = [f"logit {part}/{whole}" for whole, part, _ in shares]
    T = np.array([*(r for _, r in rows), *taken])
    names = tuple(name for name, _ in rows) + tuple(logits)
    inverse = np.linalg.inv(T)[:, : len(rows) + 2 * len(shares)]
    stated = {n: float(np.log((at or {}).get(n, 1.0))) for n in model.signals}
    logit_places = tuple(range(len(rows), len(names)))
    sizes = tuple(names.index(f"ln {n}") for n in groups.base if f"ln {n}" in names)
    return Coordinates(names, parameters, stated, logit_places, inverse, sizes, tuple(shares))


def _constraints(model: Model) -> tuple[list[tuple[str, str, str]], list[dict[str, Fraction]]]:
    """Shares (whole, part, rest) and products that are one, from the model's constraints."""
    shares, products = [], []
    for name, expression in model.constraints.items():
        terms = sp.Add.make_args(sp.expand(expression))
        signs = {(t.as_coeff_Mul()[0], t.as_coeff_Mul()[1]) for t in terms}
        lengths = {s: [x.name for c, x in signs if c == s and x.is_Symbol] for s in (1, -1)}
        if len(terms) == 2 and len(lengths[1]) == len(lengths[-1]) == 1:
            shares.append((lengths[1][0], lengths[-1][0], name))
        elif len(terms) == 2 and len(lengths[1]) == 2:
            shares.append((name, *sorted(lengths[1])))
        elif len(terms) == 1 and _is_product(terms[0]):
            powers = {b.name: -Fraction(int(e.p), int(e.q)) for b, e in terms[0].as_powers_dict().items()}
            products.append({name: Fraction(1)} | powers)
        else:
            raise ModelError(
                f"model {model.name!r}: a population cannot keep the constraint {name} = "
                f"{sp.sstr(expression)}",
                usually="it is neither a sum of two parameters nor a product of powers; declare the "
                "parameters it ties together as one.",
                paste=f"constraints={{{name!r}: L - a}}",
                read='docs/populations.md, "Rows that know little"',
            )
    return shares, products


def _is_product(term: sp.Expr) -> bool:
    powers = term.as_powers_dict()
    return all(base.is_Symbol and power.is_Rational for base, power in powers.items())


def _logistic(x: NDArray) -> NDArray:
    return np.exp(-np.logaddexp(0, -x))
