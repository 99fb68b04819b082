"""How every picture of the companion looks: white ground, few colours, text that can be read in print.

Invariant: a picture depends on its numbers alone; no date and no version is written into the file.
"""

from __future__ import annotations

import io
from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

INK, MUTED, GRID = "#1d2733", "#5a6673", "#dde3e8"
OURS, PAPER, TRUTH, OTHER = "#1667b7", "#b4562b", "#1d2733", "#7a4fa8"
LIGHT, DARK, WET = "#c3c9d0", "#5a6673", "#dcebf7"
WIDTH = 8.2  # inch
DPI = 150


def panels(
    rows: int, height: float, *, share: bool = True, columns: int = 1
) -> tuple[Figure, Sequence[Axes]]:
    """A white figure with panels one below the other (or in columns), sharing x where asked.

    Parameters
    ----------
    rows, columns : number of panels. height : of the figure [inch].
    """
    figure = Figure(figsize=(WIDTH, height), facecolor="white", layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, columns, sharex=share, squeeze=False).ravel()
    for one in axes:
        one.grid(color=GRID, lw=0.6)
        one.set_axisbelow(True)
        for side in ("top", "right"):
            one.spines[side].set_visible(False)
        for side in ("left", "bottom"):
            one.spines[side].set_color(LIGHT)
        one.tick_params(labelsize=8.5, labelcolor=MUTED, color=LIGHT)
    return figure, axes


def label(axes: Axes, x: str = "", y: str = "", title: str = "") -> None:
    """Name the axes of a panel; empty names are left out."""
    if x:
        axes.set_xlabel(x, fontsize=9, color=INK)
    if y:
        axes.set_ylabel(y, fontsize=9, color=INK)
    if title:
        axes.set_title(title, fontsize=9.5, color=INK, loc="left", weight="bold")


def legend(axes: Axes, place: str = "best", columns: int = 1) -> None:
    """A legend without a box."""
    axes.legend(loc=place, fontsize=8.5, frameon=False, ncols=columns, labelcolor=INK)


def png(figure: Figure) -> bytes:
    """The figure as a PNG without anything that changes from run to run."""
    buffer = io.BytesIO()
    figure.savefig(
        buffer, dpi=DPI, format="png", metadata={"Software": None}, pil_kwargs={"compress_level": 6}
    )
    return buffer.getvalue()
