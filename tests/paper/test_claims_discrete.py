"""Claims of section 5; the exact coefficients once more by scipy."""

import numpy as np
import pytest
from scipy import signal

from similitude.paper import printed
from similitude.paper.claims_discrete import discrete_claims, lines_off, recursion, transfer_19

from .pinned import check


def test_claims_are_the_pinned_ones():
    check("The z-transform and the regression", discrete_claims())


def test_the_worst_line_by_scipy():
    k, p1, p5, T, p3 = printed.SLOPE, printed.PI1, printed.PI5, printed.T, 1.4
    p2, p4 = 1 - p1, k * 1.4
    over = [p1 * p3 / p5, p3 * p4 / p5]
    under = [1, p3 + p4 + (p1**2 * p3 + p2**2 * p4) / p5, (p3 * p4 - p1 * p3 + p2 * p4) / p5]
    b, a, _ = signal.cont2discrete((over, under), T, method="zoh")
    m1 = p1 / p5 * T
    m2 = (1 + k + (p1**2 + p2**2 * k) / p5) * T
    exact = np.array([b[0, 1], b[0, 2], a[1] + 2, a[2] - 1])
    off = p3 * np.array([m1, -m1, m2, -m2]) / exact - 1

    assert lines_off(1.4) == pytest.approx(off, rel=1e-6)
    assert {c.id: c for c in discrete_claims()}["fig4-linear"].ours == pytest.approx(abs(off).max(), rel=5e-3)


def test_eq_20_is_eq_19_with_the_slope_and_not_with_the_group():
    assert transfer_19(False) == (0, 0)
    assert all(difference != 0 for difference in transfer_19(True))


def test_the_recursion_forgets():
    phi, y = np.ones(200), np.append(np.zeros(100), np.ones(100))
    assert recursion(y, phi, forgetting=1.0)[0] == pytest.approx(0.5, abs=1e-6)
    assert recursion(y, phi, forgetting=0.9)[0] == pytest.approx(1 - 0.9**100, abs=1e-4)
