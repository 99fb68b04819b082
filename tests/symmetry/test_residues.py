"""Fractions and row spaces survive the way through residues."""

from fractions import Fraction

import numpy as np
import pytest

from similitude.symmetry.arithmetic import PRIME, PRIMES
from similitude.symmetry.lattice import integers
from similitude.symmetry.residues import eliminate, fraction_of, joined


@pytest.mark.parametrize("value", [Fraction(0), Fraction(1), Fraction(-3, 7), Fraction(12345, 678)])
def test_a_fraction_is_read_back_from_its_residue(value):
    residue = value.numerator * pow(value.denominator, -1, PRIME) % PRIME

    assert fraction_of(residue) == value


def test_elimination_keeps_the_row_space():
    rows = np.array([[2, 4, 6], [1, 2, 3], [0, 5, 5]])
    reduced, pivots = eliminate(rows)

    assert pivots == [0, 1]
    assert [integers([fraction_of(int(x)) for x in row]) for row in reduced] == [[1, 0, 1], [0, 1, 1]]


@pytest.mark.parametrize("value", [Fraction(857143, 1000000), Fraction(-69999), Fraction(3, 9999991)])
def test_two_primes_tell_longer_fractions(value):
    modulus = PRIMES[0] * PRIMES[1]
    residues = [value.numerator * pow(value.denominator, -1, p) % p for p in PRIMES]

    assert fraction_of(joined(*residues, PRIMES), modulus) == value
