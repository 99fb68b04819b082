"""Figures 1 and 6, drawn: the coordinates of the vehicle, and the test vehicle with its data."""

from __future__ import annotations

import math

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle, FancyArrowPatch, FancyBboxPatch, Rectangle
from matplotlib.transforms import Affine2D

from similitude.paper import printed
from similitude.paper.canvas import INK, LIGHT, MUTED, OURS, PAPER, panels
from similitude.paper.claims_groups import test_vehicle_groups

STEER = math.radians(17)
A, B = 1.2, 1.7  # drawn lengths, not to the scale of anything


def figure_1() -> Figure:
    """Vehicle co-ordinates, as the paper's Figure 1 and its eqs 2 and 3 have them (SAE: z into the road)."""
    figure, (axes,) = panels(1, 3.6)
    _bare(axes, (-2.5, 2.6), (-1.25, 1.15))
    axes.plot([-B, A], [0, 0], color=INK, lw=2)
    for x, turned in ((A, -STEER), (-B, 0.0)):
        _wheel(axes, x, 0.0, 0.62, 0.17, turned)
    axes.add_patch(Circle((0, 0), 0.07, facecolor="white", edgecolor=INK, lw=1.6, zorder=5))
    axes.plot([A, A + 1.15], [0, 0], color=MUTED, lw=0.8, ls=(0, (4, 3)))
    axes.plot(
        [A, A + 1.1 * math.cos(STEER)], [0, -1.1 * math.sin(STEER)], color=MUTED, lw=0.8, ls=(0, (4, 3))
    )
    axes.add_patch(Arc((A, 0), 1.7, 1.7, theta1=-math.degrees(STEER), theta2=0, color=OURS, lw=1.4))
    _text(axes, A + 0.98, -0.15, "δ", OURS)
    _arrow(axes, (0, 0), (0.75, 0), INK)
    _text(axes, 0.6, 0.13, "x, U", INK)
    _arrow(axes, (0, 0), (0, -0.75), INK)
    _text(axes, 0.2, -0.68, "y, ẏ", INK)
    axes.add_patch(
        FancyArrowPatch(
            (-0.33, 0.3),
            (0.33, 0.3),
            connectionstyle="arc3,rad=-0.55",
            arrowstyle="-|>",
            mutation_scale=12,
            color=INK,
            lw=1.4,
        )
    )
    _text(axes, 0.0, 0.62, "ψ, ψ̇   (z into the road)", INK)
    _arrow(axes, (A, 0), (A - 0.25, -0.8), PAPER)
    _text(axes, A - 0.52, -0.72, "Caf αf", PAPER)
    _arrow(axes, (-B, 0), (-B, -0.7), PAPER)
    _text(axes, -B + 0.36, -0.6, "Car αr", PAPER)
    _measure(axes, 0, A, -1.0, "a")
    _measure(axes, -B, 0, -1.0, "b")
    _measure(axes, -B, A, 0.9, "L = a + b")
    return figure


def figure_6() -> Figure:
    """The test vehicle: a plan to scale and its data (eq 4), with the groups at 3 and 4 m/s."""
    figure, (axes, data) = panels(1, 3.3, columns=2, share=False)
    v, half = printed.TEST_VEHICLE, 0.115  # m, half of the track, assumed
    _bare(axes, (-0.34, 0.27), (-0.25, 0.22))
    body = FancyBboxPatch(
        (-0.27, -0.075),
        0.46,
        0.15,
        boxstyle="round,pad=0.01,rounding_size=0.03",
        facecolor="#eef1f4",
        edgecolor=INK,
        lw=1.2,
    )
    axes.add_patch(body)
    for x in (v["a"], -v["b"]):
        axes.plot([x, x], [-half, half], color=MUTED, lw=1.4)
        for y in (-half, half):
            _wheel(axes, x, y, 0.075, 0.032, 0.0)
    axes.add_patch(Circle((0, 0), 0.009, facecolor="white", edgecolor=INK, lw=1.4, zorder=5))
    _text(axes, 0.0, 0.03, "CG", INK)
    _measure(axes, 0, v["a"], -0.175, f"a {1e3 * v['a']:.1f}")
    _measure(axes, -v["b"], 0, -0.175, f"b {1e3 * v['b']:.1f}")
    _measure(axes, -v["b"], v["a"], 0.175, f"L {1e3 * printed.WHEELBASE:.1f} mm")
    _bare(data, (0, 1), (0, 1), equal=False)
    at = {U: test_vehicle_groups(U) for U in (4.0, 3.0)}
    lines = [
        ("mass m", f"{v['m']} kg", "scale about 1/7"),
        ("yaw inertia Iz", f"{v['Iz']} kg m²", f"π5 {at[4.0]['pi5']:.4f}"),
        ("stiffness Caf, Car", f"{v['Caf']:.0f}, {v['Car']:.0f} N/rad", f"k {v['Car'] / v['Caf']:.3f}"),
        ("K = Caf L/m", f"{v['Caf'] * printed.WHEELBASE / v['m']:.3f} m²/s²", f"π1 {at[4.0]['pi1']:.4f}"),
        ("at 4 m/s", f"π3 {at[4.0]['pi3']:.4f}", f"π4 {at[4.0]['pi4']:.4f}"),
        ("at 3 m/s", f"π3 {at[3.0]['pi3']:.4f}", f"π4 {at[3.0]['pi4']:.4f}"),
        ("steering servo", "5 Hz, damping 0.707", ""),
    ]
    for i, (name, value, more) in enumerate(lines):
        y = 0.92 - 0.14 * i
        data.text(0.0, y, name, fontsize=9, color=MUTED, va="center")
        data.text(0.40, y, value, fontsize=9, color=INK, va="center")
        data.text(0.80, y, more, fontsize=9, color=INK, va="center")
        data.plot([0, 1], [y - 0.07, y - 0.07], color=LIGHT, lw=0.6)
    return figure


def _bare(axes: Axes, x: tuple, y: tuple, *, equal: bool = True) -> None:
    axes.set(xlim=x, ylim=y)
    axes.set_axis_off()
    if equal:
        axes.set_aspect("equal")


def _wheel(axes: Axes, x: float, y: float, length: float, width: float, turned: float) -> None:
    wheel = Rectangle(
        (-length / 2, -width / 2), length, width, facecolor=LIGHT, edgecolor=INK, lw=1.2, zorder=4
    )
    wheel.set_transform(Affine2D().rotate(turned).translate(x, y) + axes.transData)
    axes.add_patch(wheel)


def _arrow(axes: Axes, start: tuple, end: tuple, colour: str) -> None:
    axes.add_patch(
        FancyArrowPatch(
            start,
            end,
            arrowstyle="-|>",
            mutation_scale=12,
            color=colour,
            lw=1.4,
            shrinkA=0,
            shrinkB=0,
            zorder=6,
        )
    )


def _text(axes: Axes, x: float, y: float, words: str, colour: str) -> None:
    axes.text(x, y, words, fontsize=10, color=colour, ha="center", va="center")


def _measure(axes: Axes, first: float, last: float, y: float, words: str) -> None:
    axes.add_patch(
        FancyArrowPatch(
            (first, y),
            (last, y),
            arrowstyle="<|-|>",
            mutation_scale=9,
            color=MUTED,
            lw=0.9,
            shrinkA=0,
            shrinkB=0,
        )
    )
    axes.text(
        (first + last) / 2,
        y,
        f" {words} ",
        fontsize=9,
        color=INK,
        ha="center",
        va="center",
        bbox={"fc": "white", "ec": "none", "pad": 1},
    )
