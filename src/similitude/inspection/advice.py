"""What an inspection amounts to, in sentences of the user's terms, the same on every page.

Invariant: every sentence holds the numbers it rests on; ± is one standard deviation.
"""

from __future__ import annotations

import numpy as np

from similitude.inspection.inspection import Inspection
from similitude.inspection.prospects import CALIBRATED, Prospects

MEANING = {
    "K": "Caf L/m, stiffness of the front tyres",
    "eta": "rear over front stiffness: balance",
    "rho": "Iz/(m a b), yaw inertia",
    "pi1": "a/L, centre of gravity",
    "input_offset": "steer when going straight",
    "output_bias": "bias of the gyro",
}
UNITS = {"input_offset": "deg", "output_bias": "deg/s"}
TYPICAL_LENGTH = 2.7  # m, of a car, for a guess without a vehicle file


# Findings after which a K is sharp and may yet be wrong: no interval holds them.
DOUBTFUL = {
    "steer_scale": "the scale of steer or speed",
    "outside_population": "whether the car is one of the population",
    "steer_against_yaw": "how steer, speed and yaw rate fit",
    "ay_against_yaw": "how speed, yaw rate and lateral acceleration fit",
    "speed_unit": "the unit of the speed",
    "clocks_apart": "the clocks of steer and yaw rate",
    "clipped": "a sensor at the end of its range",
    "steer_cut": "a steer that is cut off",
    "stuck": "a sensor that was stuck",
    "dead_band": "a yaw rate whose small values were set to zero",
    "dead_band_subtracted": "a yaw rate from which something was subtracted",
    "drives_joined": "two drives in one log",
}


def doubtful(look: Inspection) -> str:
    """What makes the K of a log that can show it doubtful, as one sentence; empty where nothing does."""
    plan = look.prospects
    if plan is None or look.survey.certain or (plan.verdict == "not_excited" and not plan.is_outside):
        return ""
    faults = list(dict.fromkeys(one.fault for one in look.findings if one.fault in DOUBTFUL))
    said = " and ".join(DOUBTFUL[fault] for fault in faults)
    return f"In doubt: {said}; no interval holds that, see the findings." if said else ""


def percent(std: float) -> str:
    """An sd of a logarithm as people read it: ± 12 %."""
    return f"± {100 * std:.2g} %" if std < 0.995 else f"± {100 * std:.0f} %"


def outlook(plan: Prospects) -> tuple[str, ...]:
    """What the log can show of K, what would be needed for half the sd, and what stands in the way."""
    now, before = percent(plan.K_std), percent(plan.unknowns["K"].before)
    if plan.verdict == "not_excited":
        lines = [f"This log cannot show K: {now} after it, against {before} before."]
    else:
        word = "to about" if plan.verdict == "identified" else "no better than to"
        lines = [f"This log can show K {word} {now}, against {before} before it."]
    ways = []
    if plan.steer_times:
        ways.append(f"steer {plan.steer_times:g} times as much")
    if plan.long_times:
        ways.append(f"drive {plan.long_times:g} times as long")
    if ways:
        lines.append(f"For {percent(plan.goal)}, {' or '.join(ways)}.")
    else:
        lines.append(f"Not even a drive {plan.longest:g} times as long would give {percent(plan.goal)}.")
    if not plan.is_linear:
        lines.append("An average car leaves the linear range of its tyres (0.3 g) on this drive: steer less.")
    elif plan.steer_limit:
        lines.append("Twice the steer would leave the linear range of the tyres (0.3 g).")
    if plan.known_scale < CALIBRATED * plan.K_std:
        lines.append(f"A calibrated road-wheel angle would give {percent(plan.known_scale)}.")
    if plan.too_slow > 0.1:
        lines.append(f"In {100 * plan.too_slow:.3g} % of the rows the car is too slow for its tyres to show.")
    return tuple(lines)


def relations(look: Inspection) -> tuple[tuple[str, str, str], ...]:
    """Rows of what, value and meaning: signs, lags, offsets, ratio."""
    rows = []
    steer, yaw = look.behind_steer, look.behind_yaw
    if steer is not None:
        rows.append(("yaw rate, steer", _side(steer.sign), f"correlation {steer.likeness:.2f}"))
        if steer.lag is not None:
            rows.append((
                "lag in all", f"{1000 * steer.lag:.0f} ± {1000 * steer.lag_std:.0f} ms",
                "steering, tyres and yaw inertia together",
            ))  # fmt: skip
    plan = look.prospects
    if plan is not None and plan.scan.origin == "scanned":
        alone = f"{1000 * plan.scan.total:.0f} ± {1000 * plan.scan.std:.0f} ms"
        rows.append(("of the steering", alone, "what a car of the population leaves over"))
    if yaw is not None:
        rows.append(("ay, r U", _side(yaw.sign), f"correlation {yaw.likeness:.2f}"))
    return (*rows, *_slow_rows(look))


def _side(sign: int) -> str:
    return {1: "same side", -1: "opposite sides"}.get(sign, "unrelated")


def _slow_rows(look: Inspection) -> list[tuple[str, str, str]]:
    slow, rows = look.slow, []
    if slow is None:
        return rows
    if slow.bias is not None:
        rows.append(("yaw bias", _degrees(slow.bias, "deg/s"), "of the gyro"))
    if slow.straight is not None:
        rows.append(("steer offset", _degrees(slow.straight, "deg"), "what the steer reads going straight"))
    if slow.length is None:
        rows.append(("steering ratio", "–", f"{slow.windows} calm stretches of 2 s are too few or too alike"))
        return rows
    spread = percent(slow.length_std)
    rows.append(("U δ / r, slow", f"{slow.length:.3g} m {spread}", "wheelbase times steering ratio"))
    if look.ratio is not None:
        value = look.ratio[0]
        if look.signals.at_wheel:
            rows.append(("steering ratio", f"{value:.3g} {spread}", "steering wheel over road wheel"))
        else:
            rows.append(("steer scale", f"{1 / value:.2f} {spread}", "1 for a road-wheel angle"))
    elif look.signals.at_wheel:
        guess = f"{slow.length / TYPICAL_LENGTH:.3g} {spread}"
        rows.append(("steering ratio", guess, f"were the wheelbase {TYPICAL_LENGTH} m"))
    return rows


def _degrees(found, unit: str) -> str:
    value, std = np.rad2deg(found.value), np.rad2deg(found.std)
    digits = max(0, 1 - int(np.floor(np.log10(max(std, 1e-4)))))
    return f"{value:.{digits}f} ± {std:.{digits}f} {unit}".replace("-", "−")
