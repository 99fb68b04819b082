"""The steering lag and, when it was searched, how much worse every other lag fits."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rich.text import Text

if TYPE_CHECKING:
    from similitude.run import LagScan

BARS = "▁▂▃▄▅▆▇█"
WIDEST = 40  # characters of the curve
INSIDE = 1.92  # rise of -ln L at the edge of a 95 % interval of one unknown (chi2_1 / 2) [-]


def cost_curve(lag: LagScan) -> Text:
    """Write the lag, where it came from and the cost curve of the search.

    Parameters
    ----------
    lag : LagScan
        lags (k,) [s] increasing; cost (k,) negative log likelihood above the best [-]; k may be 0.

    Returns
    -------
    rich.text.Text
        One line, or two with the curve; a tall bar fits badly, the chosen lag is marked.
    """
    text = Text.assemble((f"{1000 * lag.chosen:.0f} ms", "bold"), (f"   {lag.origin}", "dim"))
    points = [(float(s), float(c)) for s, c in zip(lag.lags, lag.cost, strict=True)]
    points = [point for point in points if math.isfinite(point[1])]
    if len(points) < 3:
        return text
    return text.append_text(_verdict_on_lag(points)).append("\n").append_text(_bars(points, lag))


def _verdict_on_lag(points: list[tuple[float, float]]) -> Text:
    best = min(cost for _, cost in points)
    near = [1000 * lag for lag, cost in points if cost - best <= INSIDE]
    if len(near) == len(points):
        return Text("; this log cannot tell one lag from another", style="dim")
    if len(near) == 1:
        return Text("; every other lag tried fits clearly worse", style="dim")
    return Text(f"; {near[0]:.0f} to {near[-1]:.0f} ms fit about as well", style="dim")


def _bars(points: list[tuple[float, float]], lag: LagScan) -> Text:
    """Bars of sqrt(cost), which is straight on both sides of a parabola's foot."""
    every = -(-len(points) // WIDEST)
    shown = [min(points[i : i + every], key=lambda p: p[1]) for i in range(0, len(points), every)]
    best = min(cost for _, cost in points)
    heights = [math.sqrt(max(cost - best, 0.0)) for _, cost in shown]
    tallest = max(*heights, math.sqrt(INSIDE))
    chosen = min(range(len(shown)), key=lambda i: abs(shown[i][0] - lag.chosen))
    text = Text(f"{1000 * points[0][0]:.0f} ms ", style="dim", no_wrap=True)
    for i, height in enumerate(heights):
        bar = BARS[round(height / tallest * (len(BARS) - 1))]
        text.append(bar, style="bold green" if i == chosen else "cyan")
    return text.append(f" {1000 * points[-1][0]:.0f} ms   taller fits worse", style="dim")
