"""Numbers of the Bessel filters: fourth order, as two sections, low-pass and high-pass.

Phase-normalised at the corner (the asymptotes are those of a Butterworth filter) and taken to discrete
time by the bilinear rule without prewarping; the paper leaves both open.

Invariant: a low-pass passes a constant unchanged, a high-pass not at all.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

REVERSE_BESSEL = (1.0, 10.0, 45.0, 105.0, 105.0)  # s^4 + 10 s^3 + 45 s^2 + 105 s + 105


def bessel_sections(kind: Literal["low", "high"], corner: float, sample_time: float) -> NDArray[np.float64]:
    """The fourth-order Bessel filter as two sections.

    Parameters
    ----------
    kind : ``low`` or ``high``, what it lets pass.
    corner : [rad/s].
    sample_time : [s].

    Returns
    -------
    sections : (2, 5) numbers b0, b1, b2, a1, a2 of each section, a0 = 1 [-].

    References
    ----------
    W. E. Thomson, Proc. IEE 96 (1949), for the filter.
    """
    upper = [p for p in np.roots(REVERSE_BESSEL) if p.imag > 0]
    prototype = np.array(sorted(upper, key=abs)) * REVERSE_BESSEL[-1] ** -0.25
    poles = corner * prototype if kind == "low" else corner / prototype
    c = 2.0 / sample_time
    rows = []
    for pole in poles:
        a, b = -2.0 * pole.real, abs(pole) ** 2  # s^2 + a s + b
        whole = c * c + a * c + b
        over = b * np.array([1, 2, 1]) if kind == "low" else c * c * np.array([1, -2, 1])
        rows.append([*(over / whole), (2 * b - 2 * c * c) / whole, (c * c - a * c + b) / whole])
    return np.array(rows)


def cascade_response(sections: NDArray[np.float64], signal: NDArray[np.float64]) -> NDArray[np.float64]:
    """What the sections make of a signal, (n,), from rest; for the few samples of a design.

    Parameters
    ----------
    sections : (k, 5) numbers of each section.
    signal : (n,).
    """
    out = np.asarray(signal, dtype=float)
    for b0, b1, b2, a1, a2 in np.asarray(sections, dtype=float):
        first = second = 0.0
        passed = np.empty_like(out)
        for i, x in enumerate(out.tolist()):
            y = b0 * x + first
            first, second = b1 * x - a1 * y + second, b2 * x - a2 * y
            passed[i] = y
        out = passed
    return out
