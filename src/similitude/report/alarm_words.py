"""What the monitor found, as sentences: changes, what is known, tyre and road.

Invariant: terminal and page say the same words.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from similitude.report.numerals import uncertain

if TYPE_CHECKING:
    from similitude.run import Run

KINDS = {"stiffness_drop": "the tyres became softer", "stiffness_rise": "the tyres became stiffer"}


def alarm_lines(run: Run) -> list[str]:
    """One sentence a change: when, what, how large."""
    return [_alarm(alarm) for alarm in run.alarms]


def _alarm(alarm) -> str:
    size, std, low, high = (100 * alarm[name] for name in ("change", "std", "lo", "hi"))
    return (
        f"t = {alarm['t']:.2f} s: {KINDS.get(alarm['kind'], alarm['kind'])} by {abs(size):.0f} ± {std:.0f} % "
        f"(K {low:+.0f} to {high:+.0f} %, 95 %), since about t = {alarm['onset']:.2f} s"
    ).replace("-", "−")


def known_lines(run: Run) -> list[str]:
    """What is known now, what would halve it, tyre and road, and whether a change would be found."""
    lines = []
    if run.information:
        lines.append(str(run.information["text"]))
    if run.time_scales:
        lines.append(_scales(run.time_scales))
    if run.monitor:
        share, hours = run.monitor["armed_share"], run.monitor["hours_between_false_alarms"]
        if share > 0:
            lines.append(
                f"a change of stiffness would have been found in {100 * share:.0f} % of the log; "
                f"about one alarm in {hours:.0f} h of driving is false"
            )
        else:
            lines.append(
                "a change of stiffness would not have been found: for that K must be known to 20 % "
                "for some seconds, and the steering must move"
            )
    return lines


def _scales(scales) -> str:
    tyre, road = scales["tyre"], scales["road"]
    value, std = uncertain(tyre["K"], tyre["std"])
    over = f"over {tyre['drives']} drives" if tyre["drives"] > 1 else "over this drive"
    factor, off = uncertain(road["factor"], road["std"])
    return f"tyre {over}: K = {value} ± {std} m²/s²; road and load now: {factor} ± {off} times that"
