"""Linear algebra in integers modulo a prime, and the small fractions that residues stand for.

Invariant: a rank found here is never larger than the true one, and equals it but for an unlucky prime.

References: P. S. Wang, M. J. T. Guy, J. H. Davenport, P-adic reconstruction of rational numbers, SIGSAM
Bulletin 16 (1982).
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

import numpy as np

from similitude.symmetry.arithmetic import PRIME


def eliminate(matrix: np.ndarray, prime: int = PRIME) -> tuple[np.ndarray, list[int]]:
    """Reduced row echelon form modulo a prime of residues (m, n), zero rows dropped, and its pivots."""
    rows = np.array(matrix, dtype=np.int64) % prime
    pivots: list[int] = []
    for j in range(rows.shape[1]):
        k = len(pivots)
        alive = np.flatnonzero(rows[k:, j])
        if not alive.size:
            continue
        rows[[k, k + alive[0]]] = rows[[k + alive[0], k]]
        rows[k] = rows[k] * pow(int(rows[k, j]), -1, prime) % prime
        factors = rows[:, j].copy()
        factors[k] = 0
        touched = np.flatnonzero(factors)
        rows[touched] = (rows[touched] - factors[touched, None] * rows[k] % prime) % prime
        pivots.append(j)
        if len(pivots) == len(rows):
            break
    return rows[: len(pivots)], pivots


def fraction_of(residue: int, modulus: int = PRIME) -> Fraction:
    """The fraction of small numerator and denominator with this residue (Wang's reconstruction)."""
    bound = isqrt(modulus // 2)
    (low, high), (s, t) = (modulus, residue % modulus), (0, 1)
    while high > bound:
        quotient = low // high
        low, high, s, t = high, low - quotient * high, t, s - quotient * t
    return Fraction(high, t)


def joined(first: int, second: int, primes: tuple[int, int]) -> int:
    """The residue modulo the product of two primes that has these residues (Chinese remainders)."""
    p, q = primes
    return int(first) + p * ((int(second) - int(first)) * pow(p, -1, q) % q)
