"""What is printed and cannot hold, what holds instead, and the claim whose computation shows it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Erratum:
    """One erratum or open point: ``claim`` is the id of the claim that checks it."""

    where: str
    as_printed: str
    holds: str
    claim: str


ERRATA = (
    Erratum("eq 13, time row", "left side +1·ψ̇, no time among the arguments", "−1, with S_t", "eq13-time"),
    Erratum("eq 22", "a1 ≈ (−2 + m2 T) π3, a2 ≈ (1 − m2 T) π3", "−2 + m2 π3, 1 − m2 π3", "eq22-a1"),
    Erratum("after eq 22", "m2 without T", "m2 carries T once", "eq22-m2"),
    Erratum("eqs 19, 20", "π4 for the group and for the slope 1.0977", "k = π4/π3", "eq20-p4"),
    Erratum("eq 23", "second order", "common factor (1 − z⁻¹): first order", "eq23-order"),
    Erratum("section 4", "traverse time U/L", "L/U", "sec4-traverse-time"),
    Erratum("section 5", "T = 0.011 s̄", "0.010953, without unit", "sec5-sample-time"),
    Erratum(
        "section 6", "4 m/s like 63 to 65 mph", "equal L/U, not equal π3 (51.8 mph)", "sec6-full-size-speed"
    ),
    Erratum(
        "section 5, step 6", "the RLSE of Equation (28)", "the unnumbered lines before it", "eq28-reference"
    ),
    Erratum(
        "Figure 7, section 7", "off-line π3 about 0.5 at 4 m/s", "0.272; 0.484 at 3 m/s", "fig7-offline-value"
    ),
    Erratum("section 1", "Kalman methods need 10⁴ to 10⁶ operations", "about a thousand", "sec1-kalman-cost"),
    Erratum(
        "eq 18",
        "π4 = 1.0977 π3, one line without an interval",
        "slope with an interval; TLS differs",
        "eq18-slope",
    ),
)
