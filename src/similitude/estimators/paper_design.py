"""Numbers of the paper's regression: its filters, its constants, and how far its line holds.

Invariant: every number of the configuration is given by the caller, is one of the paper's
constants below, or guards against values no car produces. scipy is imported when first needed.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from similitude.estimators.bessel import bessel_sections
from similitude.program.library import Library

GRAVITY = 9.80665  # m/s^2
CORNER = 45.0  # rad/s, of the high-pass (paper, section 6)
SETTLING = 5.0 / CORNER  # s that the high-pass is given before its output is used
RANGE = (0.1, 1.4)  # of pi3, over which the paper draws its lines (Figure 4)
GREATEST_T = 0.03  # dimensionless sample time beyond which the lines are not to be trusted
JUMP = (0.1, 8.0, 50.0)  # rad/s, noise sd, and rad/s^2 of yaw beyond any car, small ones included
SOURCE = "average of Brennan & Alleyne 2004, eq 18"
PAPER_GROUPS = {"pi1": 0.4431, "pi4_slope": 1.0977, "pi5": 0.2510}

K_LOW = 1e-2  # m^2/s^2, reported for a regression that says zero or less
K_LIMIT = 1e5  # m^2/s^2
PI3_START = 0.2  # the paper is silent on this
P_START, P_MOST = 1e9, 1e12  # of the textbook recursion, in dimensionless filtered outputs

DESIGN = {
    "forgetting": 0.99995,  # paper, section 6
    "dead_zone": 0.1,  # rad/s, same place
    "variance_limit": 1.0,  # of ln K: a factor e either way is nothing known
    "U_least": 0.5,  # m/s
    "input_limit": 1.3,  # rad
    "output_limit": 12.0,  # rad/s
    "signal_limit": 150.0,  # m/s
    "validity_limit": 0.3 * GRAVITY,  # m/s^2
}


def bessel_biquads(sample_time: float, *, corner: float = CORNER) -> NDArray[np.float64]:
    """The fourth-order high-pass Bessel filter as two sections.

    Phase-normalised at ``corner`` and taken to discrete time by the bilinear rule without
    prewarping, which the paper leaves open.

    Parameters
    ----------
    sample_time : [s].
    corner : [rad/s].

    Returns
    -------
    sections : (2, 5) numbers b0, b1, b2, a1, a2 of each section, a0 = 1 [-].
    """
    return bessel_sections("high", corner, sample_time)


def section_poles(biquad: ArrayLike) -> tuple[float, float]:
    """The two numbers of a high-pass section that its zeros at rest leave: 1 + a1 + a2, and a2 [-].

    Parameters
    ----------
    biquad : (5,) b0, b1, b2, a1, a2 with b1 = -2 b0, b2 = b0.
    """
    _, _, _, a1, a2 = (float(x) for x in np.asarray(biquad, dtype=float))
    return math.fsum((1.0, a1, a2)), a2


def high_pass_biquad(c: float, a2: float) -> tuple[float, float, float, float, float]:
    """The section of those two numbers that passes the fastest swing unchanged: b0, b1, b2, a1, a2 [-]."""
    b0 = (2.0 + 2.0 * a2 - c) / 4.0
    return b0, -2.0 * b0, b0, c - 1.0 - a2, a2


def section_gain(biquads: ArrayLike) -> float:
    """The weight of the newest sample in what the sections pass on: the product of their b0 [-]."""
    return float(np.prod(np.asarray(biquads, dtype=float).reshape(-1, 5)[:, 0]))


def paper_config(
    library: Library,
    *,
    sample_time: float,
    L: float,
    speed: float,
    noise_std: float,
    pi1: float,
    pi4_slope: float,
    pi5: float,
    biquads: ArrayLike | None = None,
    K_start: float | None = None,
    P_start: float = P_START,
    K_limit: float = K_LIMIT,
    **changes: float,
) -> NDArray[np.float64]:
    """The flat configuration of ``bicycle_paper``.

    Parameters
    ----------
    library : the compiled estimator.
    sample_time : [s]; steps from half to one and a half of it count as one sample.
    L : wheelbase [m].
    speed : [m/s] at which ``P_start`` is meant, and the start where ``K_start`` is left out; nothing else
        depends on it.
    noise_std : white noise of the yaw rate a sample [rad/s], > 0; bounds the reported variance.
    pi1, pi4_slope, pi5 : frozen groups [-]; the paper's averages are ``PAPER_GROUPS``.
    biquads : (2, 5) sections of another high-pass with its zeros at rest; the paper's where left out.
    K_start : K before the first update [m^2/s^2]; that of pi3 = 0.2 where left out.
    P_start : least covariance of pi3 per residual variance before the first update, in the paper's recursion;
        at the start nothing is claimed to be known, however good the sensor.
    K_limit : greatest magnitude of K [m^2/s^2].
    changes : design constants to replace, by name.

    Raises
    ------
    ProgramError    a value is missing, not finite or not a field.
    """
    first, second = sections = bessel_biquads(sample_time) if biquads is None else np.asarray(biquads)
    per_theta = K_per_theta(sample_time, L, pi1=pi1, pi4_slope=pi4_slope, pi5=pi5)
    m1, m2 = slopes(1.0, pi1=pi1, pi4_slope=pi4_slope, pi5=pi5)
    gain = section_gain(sections)
    fastest = L * changes.get("signal_limit", DESIGN["signal_limit"])
    theta_start = (PI3_START * speed**2 if K_start is None else K_start) / per_theta
    unknown = noise_std**2 / (theta_start**2 * changes.get("variance_limit", DESIGN["variance_limit"]))
    values: dict = DESIGN | {
        "input_ratio": m1 / m2 / L,
        "K_per_theta": per_theta,
        "poles_1": section_poles(first),
        "poles_2": section_poles(second),
        "theta_start": theta_start,
        "theta_low": K_LOW / per_theta,
        "theta_limit": K_limit / per_theta,
        "normal_start": min(1.0 / (P_start * (gain * L * speed / per_theta) ** 2), unknown),
        "normal_least": (1.0 - DESIGN["forgetting"]) / (P_MOST * (gain * fastest / per_theta) ** 2),
        "settle_samples": max(3, math.ceil(SETTLING / sample_time)) + 1,
        "output_jump": JUMP[0] + JUMP[1] * noise_std + JUMP[2] * sample_time,
        "noise_variance": noise_std**2,
        "sample_time": sample_time,
        "dt_room": 0.5 * sample_time,
    }
    return library.config(values | changes)


def K_per_theta(sample_time: float, L: float, *, pi1: float, pi4_slope: float, pi5: float) -> float:
    """K over theta = (a1 + 2) U [m/s], of the line a1 + 2 = m2 pi3 (eq 22)."""
    return 1.0 / slopes(sample_time / L, pi1=pi1, pi4_slope=pi4_slope, pi5=pi5)[1]


def dimensionless_step(sample_time: float, U: float, L: float) -> float:
    """T = Ts U/L [-]: the sample time [s] at speed U [m/s] and wheelbase L [m]."""
    return sample_time * U / L


def slopes(T: float, *, pi1: float, pi4_slope: float, pi5: float) -> tuple[float, float]:
    """m1, m2 of the lines b1 = m1 pi3 and a1 + 2 = m2 pi3 (eq 22, with T once in m2) [-]."""
    rear = (1.0 - pi1) ** 2 * pi4_slope
    return pi1 / pi5 * T, (1.0 + pi4_slope + (pi1**2 + rear) / pi5) * T


def exact_coefficients(
    pi3: ArrayLike, T: float, *, pi1: float, pi4_slope: float, pi5: float
) -> NDArray[np.float64]:
    """b1, b2, a1 + 2, a2 - 1 of eq 21: the exact zero-order hold of eq 19.

    Parameters
    ----------
    pi3 : (n,) [-].
    T : dimensionless sample time [-].

    Returns
    -------
    coefficients : (n, 4) [-].
    """
    from scipy.linalg import expm

    front = np.atleast_1d(np.asarray(pi3, dtype=float))
    rear, cross = pi4_slope * front, pi4_slope * front * (1 - pi1) - pi1 * front
    block = np.zeros((front.size, 3, 3))
    block[:, 0, 0], block[:, 0, 1] = -(front + rear), cross - 1
    block[:, 1, 0] = cross / pi5
    block[:, 1, 1] = -(pi1**2 * front + (1 - pi1) ** 2 * rear) / pi5
    block[:, 0, 2], block[:, 1, 2] = front, pi1 * front / pi5
    Phi = expm(block * T)
    F, G = Phi[:, :2, :2], Phi[:, :2, 2]
    b2 = F[:, 1, 0] * G[:, 0] - F[:, 0, 0] * G[:, 1]
    trace, determinant = F[:, 0, 0] + F[:, 1, 1], np.linalg.det(F)
    return np.stack([G[:, 1], b2, 2 - trace, determinant - 1], axis=1)


def linearity_error(T: float, pi1: float, k: float, pi5: float) -> dict[str, float]:
    """Worst relative error of the linear z-coefficients over 0.1 <= pi3 <= 1.4.

    Parameters
    ----------
    T : dimensionless sample time [-].
    pi1, k, pi5 : frozen groups, k = pi4/pi3 [-].

    Returns
    -------
    errors : linear over exact minus one, largest in magnitude, of ``b1``, ``b2``, ``a1+2``,
        ``a2-1`` with its sign, and ``least`` and ``worst`` of their magnitudes [-].
    """
    pi3 = np.linspace(*RANGE, 131)
    exact = exact_coefficients(pi3, T, pi1=pi1, pi4_slope=k, pi5=pi5)
    m1, m2 = slopes(T, pi1=pi1, pi4_slope=k, pi5=pi5)
    error = pi3[:, None] * np.array([m1, -m1, m2, -m2]) / exact - 1.0
    largest = error[np.abs(error).argmax(axis=0), np.arange(4)]
    named = dict(zip(("b1", "b2", "a1+2", "a2-1"), largest.tolist(), strict=True))
    sizes = np.abs(largest)
    return {**named, "least": float(sizes.min()), "worst": float(sizes.max())}


def linearity_warning(T: float, pi1: float, k: float, pi5: float) -> str:
    """A sentence where T is too large for the regression's lines; empty where it is not."""
    if T <= GREATEST_T:
        return ""
    error = linearity_error(T, pi1, k, pi5)
    return (
        f"dimensionless sample time T = {T:.3f} is above {GREATEST_T}: the coefficients the "
        f"regression takes as linear in pi3 are wrong by up to {100 * error['least']:.0f} to "
        f"{100 * error['worst']:.0f} %; a sample rate {T / GREATEST_T:.1f} times as high would do"
    )
