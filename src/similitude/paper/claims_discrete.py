"""Claims of the paper's section 5: the z-transform, its lines, and what they become as a regression.

Invariant: "exact" is the zero-order hold of the shipped model's transfer function.
"""

from __future__ import annotations

import numpy as np
import sympy as sp

from similitude.estimators.paper_design import (
    PAPER_GROUPS,
    dimensionless_step,
    exact_coefficients,
    linearity_error,
    slopes,
)
from similitude.paper import printed
from similitude.paper.bode import transfer_function
from similitude.paper.claim import Claim, claim, identity_claim, number_claim

ALMOST = 0.05  # relative error: what "almost perfectly linear" is taken to mean
FULL_SIZE = {"sample_time": 0.01, "U": 25.0, "L": 2.8}  # s, m/s, m: a car logged at 100 Hz
NAMES = ("b1", "b2", "a1+2", "a2-1")


def discrete_claims() -> list[Claim]:
    """Eqs 19 to 28."""
    return [
        _eq_20(),
        _sample_time(),
        _linear(),
        _full_size_linear(),
        *_eq_22(),
        *_eq_23(),
        _second_difference(),
        _regression(),
        _eq_28(),
    ]


def transfer_19(literal: bool) -> tuple[sp.Expr, sp.Expr]:
    """Eq 20 minus eq 19 with pi4 = k pi3, read literally (one letter for both) or with k; (num, den)."""
    p1, p3, p5, k, s, p4 = sp.symbols("pi1 pi3 pi5 k s pi4", positive=True)
    slope = p4 if literal else k
    rear = p4 if literal else k * p3
    num = p1 / p5 * p3 * s + slope / p5 * p3**2 - (p1 * p3 / p5 * s + p3 * rear / p5)
    den = (1 + slope + (p1**2 + (1 - p1) ** 2 * slope) / p5) * p3 * s
    den += (p3**2 * slope - p1 * p3 + (1 - p1) * slope * p3) / p5
    den -= (p3 + rear + (p1**2 * p3 + (1 - p1) ** 2 * rear) / p5) * s + (
        p3 * rear - p1 * p3 + (1 - p1) * rear
    ) / p5
    return sp.simplify(num), sp.simplify(den)


def _eq_20() -> Claim:
    literal = sum(e != 0 for e in transfer_19(True))
    right = sum(e != 0 for e in transfer_19(False))
    return claim(
        "eq20-p4",
        "eqs 19, 20",
        "eq 20 is eq 19 with π3 taken out",
        printed=0,
        ours=literal,
        holds=literal == 0,
        under=right == 0,
        tolerance=0,
        condition="its π4 is read as the slope k = π4/π3 = 1.0977",
        unit="polynomials that differ",
        why="The letter π4 stands for the group in eq 19 and for the slope in eq 20.",
    )


def _sample_time() -> Claim:
    ours = dimensionless_step(printed.SAMPLE_TIME, printed.TEST_VEHICLE["U"], printed.WHEELBASE)
    return number_claim(
        "sec5-sample-time",
        "section 5",
        "1 ms is T = 0.011 in dimensionless time",
        printed=printed.T,
        ours=ours,
        tolerance=0.0005,
        digits=5,
        why=f"{ours:.6f}, rounded; dimensionless, not seconds as the paper's line ends.",
    )


def _linear() -> Claim:
    error = linearity_error(printed.T, printed.PI1, printed.SLOPE, printed.PI5)
    up_to_one = max(abs(lines_off(1.0)))
    said = ", ".join(f"{n} {100 * error[n]:+.1f} %" for n in NAMES)
    return claim(
        "fig4-linear",
        "section 5, Figure 4",
        "the z-coefficients are almost perfectly linear in π3",
        printed="almost perfectly linear",
        ours=error["worst"],
        holds=error["worst"] < ALMOST,
        under=bool(up_to_one < ALMOST),
        tolerance=ALMOST,
        condition=f"π3 stays below 1 (worst {100 * up_to_one:.1f} % there)",
        digits=3,
        why=f"Worst relative error over 0.1 ≤ π3 ≤ 1.4 at T = 0.011: {said}.",
    )


def lines_off(pi3: float) -> np.ndarray:
    """Relative errors of the four lines at a value of pi3 and T = 0.011, (4,) [-]."""
    m1, m2 = slopes(printed.T, **PAPER_GROUPS)
    lines = pi3 * np.array([m1, -m1, m2, -m2])
    return lines / exact_coefficients(pi3, printed.T, **PAPER_GROUPS)[0] - 1


def _full_size_linear() -> Claim:
    T = dimensionless_step(**FULL_SIZE)
    at = {step: linearity_error(step, printed.PI1, printed.SLOPE, printed.PI5)["worst"] for step in (T, 0.01)}
    return claim(
        "sec5-any-sample-time",
        "section 5",
        "T much smaller than the groups is no restriction",
        printed="unrestrictive",
        ours=at[T],
        holds=at[T] < ALMOST,
        under=at[0.01] < ALMOST,
        tolerance=ALMOST,
        digits=3,
        condition="the sample rate is high: T = 0.01 or less, 900 Hz on that car",
        why=f"A full-size car logged at 100 Hz has T = {T:.3f}; its coefficients are wrong by up to "
        f"{100 * at[T]:.0f} % (at T = 0.01 by up to {100 * at[0.01]:.1f} %).",
    )


def _eq_22() -> list[Claim]:
    m1, m2 = slopes(printed.T, **PAPER_GROUPS)
    pi3 = printed.RANGE[0]
    exact = exact_coefficients(pi3, printed.T, **PAPER_GROUPS)[0]
    a1 = exact[2] - 2
    as_printed, right = (-2 + m2) * pi3, -2 + m2 * pi3
    near = exact_coefficients(np.array([0.099, 0.101]), printed.T, **PAPER_GROUPS)[:, 2]
    slope = float(np.diff(near)[0] / 0.002)
    return [
        number_claim(
            "eq22-b1",
            "eq 22",
            "b1 = m1 π3 (at π3 = 0.1)",
            printed=round(m1 * pi3, 8),
            ours=float(exact[0]),
            tolerance=round(0.005 * m1 * pi3, 8),
            digits=6,
        ),
        number_claim(
            "eq22-a1",
            "eq 22",
            "a1 = (−2 + m2 T) π3 (at π3 = 0.1)",
            printed=round(as_printed, 6),
            ours=float(a1),
            tolerance=0.001,
            digits=6,
            why=f"The offsets stand outside: −2 + m2 π3 = {right:.6f}, with T inside m2. The same for a2.",
        ),
        number_claim(
            "eq22-m2",
            "after eq 22",
            "m2 = 1 + π4 + (π1² + (1 − π1)² π4)/π5, without T",
            printed=round(m2 / printed.T, 4),
            ours=slope,
            tolerance=round(0.01 * m2, 6),
            why=f"The slope of a1 in π3 is {slope:.4f} = {m2 / printed.T:.4f} T: m2 carries T "
            f"once, and "
            "eq 23 is right only then.",
        ),
    ]


def _eq_23() -> list[Claim]:
    z, m1, m2, p3 = sp.symbols("z m1 m2 pi3", positive=True)
    over = m1 * p3 * z - m1 * p3
    under = z**2 + (-2 + m2 * p3) * z + (1 - m2 * p3)
    lowest = sp.fraction(sp.cancel(over / under))[1]
    gain = sp.cancel(over / under).subs(z, 1)
    exact = exact_coefficients(1.0, printed.T, **PAPER_GROUPS)[0]
    predicted = (printed.SLOPE + (1 - printed.PI1) * printed.SLOPE - printed.PI1) * printed.T**2 / printed.PI5
    return [
        number_claim(
            "eq23-order",
            "eq 23",
            "the model that is identified is of second order",
            printed=2,
            ours=int(sp.degree(lowest, z)),
            tolerance=0,
            why="Numerator and denominator share the factor (1 − z⁻¹). What is left is a "
            "first-order lag; "
            "the second difference of eq 26 is only a filter before it.",
        ),
        _stands_for_19(
            float(gain.subs({m1: slopes(1.0, **PAPER_GROUPS)[0], m2: slopes(1.0, **PAPER_GROUPS)[1]}))
        ),
        number_claim(
            "eq23-left-out",
            "eqs 22, 23",
            "1 + a1 + a2 = 0 (at π3 = 1)",
            printed=0.0,
            ours=float(exact[2] + exact[3]),
            tolerance=1e-5,
            why=f"The lines leave out π3 (k π3 + π2 k − π1) T²/π5 = {predicted:.7f}: the static gain.",
        ),
    ]


def _stands_for_19(steady: float) -> Claim:
    """Whether eq 23 answers as eq 19 does: slowly, and at 20 rad per wheelbase."""
    vehicle = printed.of_groups(printed.PI1, 1.0, printed.SLOPE, printed.PI5)
    exact = abs(transfer_function(vehicle, 1e-6j)[0])
    m1, m2 = slopes(1.0, **PAPER_GROUPS)
    fast = abs(m1 / (20j + m2)) / abs(transfer_function(vehicle, 20j)[0]) - 1
    return number_claim(
        "eq23-steady",
        "eqs 20-23",
        "eq 23 stands for eq 19 (gain from steer to yaw rate at π3 = 1)",
        printed=round(exact, 4),
        ours=steady,
        tolerance=round(ALMOST * exact, 4),
        conditioned=exact * (1 + fast),
        condition=f"the steer is fast: at 20 rad per wheelbase travelled the two gains differ by "
        f"{100 * fast:.1f} %",
        why="Ours is the steady gain of eq 23, m1/m2, which does not depend on π3; beside it the steady "
        "gain of "
        "eq 19. Only the fast part of the answer teaches; that is the part with the most noise.",
    )


def _second_difference() -> Claim:
    """y(q) of a parabola t²/2 sampled at T: T² times the second derivative."""
    T = 0.01
    t = np.array([0.0, -T, -2 * T]) + 0.3
    y = t**2 / 2
    wave = np.sin(3 * t)
    second = (wave[0] - 2 * wave[1] + wave[2]) / T**2
    centred = abs(second / (-9 * wave[1]) - 1)
    now = abs(second / (-9 * wave[0]) - 1)
    return claim(
        "eq26-central",
        "section 5",
        "y(q) of eq 26 is a scaled central difference of the second derivative",
        printed=1,
        ours=float((y[0] - 2 * y[1] + y[2]) / T**2),
        holds=now < 1e-3,
        under=centred < 1e-3,
        tolerance=1e-3,
        condition="it is taken as that of one sample earlier",
        digits=6,
        why=f"Scaled by T². At time q itself it is off by {100 * now:.1f} % for a motion of 3 rad per "
        f"wheelbase at T = 0.01.",
    )


def _sequence(pi3: float, n: int = 400) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A steer (n,), the answer of eq 23 to it and phi of eq 26."""
    m1, m2 = slopes(printed.T, **PAPER_GROUPS)
    d = np.sign(np.sin(np.arange(n) / 17.0)) * 0.02
    r = np.zeros(n)
    for q in range(2, n):
        r[q] = (2 - m2 * pi3) * r[q - 1] - (1 - m2 * pi3) * r[q - 2] + m1 * pi3 * (d[q - 1] - d[q - 2])
    phi = np.zeros(n)
    phi[2:] = -m2 * (r[1:-1] - r[:-2]) + m1 * (d[1:-1] - d[:-2])
    return d, r, phi


def recursion(y: np.ndarray, phi: np.ndarray, *, forgetting: float, P: float = 1e12) -> tuple[float, float]:
    """The unnumbered lines of recursive least squares after eq 27: last estimate and P.

    Parameters
    ----------
    y, phi : (n,). forgetting : λ. P : before the first sample.
    """
    theta = 0.0
    for target, regressor in zip(y.tolist(), phi.tolist(), strict=True):
        gain = P * regressor / (forgetting + regressor * P * regressor)
        theta += gain * (target - regressor * theta)
        P = (1 - gain * regressor) * P / forgetting
    return theta, P


def _regression() -> Claim:
    _, r, phi = _sequence(0.3)
    y = np.append([0.0, 0.0], r[2:] - 2 * r[1:-1] + r[:-2])
    return identity_claim(
        "eq27-regression",
        "eqs 24-27",
        "y = φ π3 is eq 23 multiplied out",
        float(np.abs(y - 0.3 * phi).max() / np.abs(y).max()),
    )


def _eq_28() -> Claim:
    """Eq 28 is a matrix; the estimate comes from the lines before it."""
    _, r, phi = _sequence(0.3)
    y = np.append([0.0, 0.0], r[2:] - 2 * r[1:-1] + r[:-2])
    disturbed = y + 1e-5 * np.cos(np.arange(y.size))
    Phi = phi[:, None]  # eq 28
    batch = float(np.linalg.solve(Phi.T @ Phi, Phi.T @ disturbed)[0])
    theta, _ = recursion(disturbed, phi, forgetting=1.0)
    return claim(
        "eq28-reference",
        "section 5, step 6",
        "the estimate is updated by “the RLSE of Equation (28)”",
        printed="one number",
        ours=f"a matrix of {Phi.shape[0]} × {Phi.shape[1]}",
        holds=Phi.size == 1,
        under=abs(theta / batch - 1) < 1e-6,
        tolerance=1e-6,
        condition="the unnumbered recursion before it is meant",
        why="(28) is Φ, the regressors one below the other. With λ = 1 the recursion gives (ΦᵀΦ)⁻¹Φᵀy: "
        "the two agree in a millionth, so what is meant is clear.",
    )
