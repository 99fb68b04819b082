"""All pictures by name, with what the paper's figure shows beside what ours shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from similitude.paper import pictures_data, pictures_drawn, pictures_drives
from similitude.paper.canvas import png


@dataclass(frozen=True)
class Picture:
    """A figure: its file, title, what the paper's shows (empty for our own), what ours shows."""

    file: str
    title: str
    theirs: str
    ours: str
    draw: Callable[[], Figure]


PICTURES = {
    "1": Picture(
        "figure_1.png",
        "Figure 1. Vehicle co-ordinates",
        "The bicycle model in SAE axes, z into the road.",
        "The same, drawn anew: one wheel an axle, forces to the side to which the wheels are turned.",
        pictures_drawn.figure_1,
    ),
    "2": Picture(
        "figure_2.png",
        "Figure 2. Relative distribution of Iz",
        "Some 700 vehicles of the NHTSA database in light grey, 70 of the literature in dark grey; a long "
        "tail to "
        "the right.",
        "The 204 distinct vehicles of that database that are at hand, and those of the literature with a "
        "source. "
        "Shaded red: the part of a normal fit with a negative inertia.",
        pictures_data.figure_2,
    ),
    "3": Picture(
        "figure_3.png",
        "Figure 3. Relative distribution of π5",
        "The same vehicles: narrow and bell-shaped about 0.2510.",
        "The same narrow hump. The 204 lack a wheelbase: π5 follows from a·b with π1 at its average. The "
        "two far to "
        "the left are cars with their engine in the middle of a long wheelbase, and one stripped for "
        "research.",
        pictures_data.figure_3,
    ),
    "4": Picture(
        "figure_4.png",
        "Figure 4. Linearity of the z-coefficients",
        "b1, b2, a1 + 2 and a2 − 1 over π3 from 0.1 to 1.4: straight to the eye.",
        "The same four, signs chosen so that all are positive, against the lines of eq 22; below, how far "
        "the lines "
        "are off.",
        pictures_data.figure_4,
    ),
    "5": Picture(
        "figure_5.png",
        "Figure 5. The identification in simulation",
        "Position on a square wave, yaw rate, and an estimate that follows the halved stiffness with a "
        "slight lag and "
        "a small steady bias.",
        "The same drive (scenario square_closed_loop), a perfect sensor. The first bias is as small as "
        "printed. With the printed λ the estimate swings about the middle of the two values; with a "
        "twentieth of the memory it gets there, in the jumps of the path, since only they teach.",
        pictures_drives.figure_5,
    ),
    "6": Picture(
        "figure_6.png",
        "Figure 6. The test vehicle",
        "A photograph of the scale vehicle.",
        "Its plan to scale (lengths in mm) and its data; width and wheels are assumed.",
        pictures_drawn.figure_6,
    ),
    "7": Picture(
        "figure_7.png",
        "Figure 7. The treadmill",
        "The experiment: dry driving, the lane change at 60 s, an estimate of 0.4 that falls at 65 s, "
        "falls again "
        "while the tyres hydroplane and at the fish-tail of 88 s, and recovers.",
        "A simulation of that story (scenario treadmill_hydroplaning): the motion is there, the fish-tail "
        "included. "
        "The estimate is not: the printed λ forgets too slowly to fall, and while hydroplaning it rises. Our "
        "vehicle is back on the dry two seconds earlier.",
        pictures_drives.figure_7,
    ),
    "noise": Picture(
        "noise.png",
        "What the noise of a gyro does to the regression",
        "",
        "Figure 5's steer, constant stiffness. The closed form and the compiled estimator agree; both say "
        "that the "
        "method needs a sensor that no car has.",
        pictures_data.noise_picture,
    ),
    "seven": Picture(
        "seven.png",
        "Seven parameters at once",
        "",
        "Left: the least sd along each principal direction of the Fisher information, three of which are "
        "never "
        "informed on. Right: two fits of one record from starts 30 % off, equally good, and different cars.",
        pictures_data.seven_picture,
    ),
    "today-5": Picture(
        "today_5.png",
        "Figure 5 today",
        "",
        "The population filter on the same drive with a gyro of 0.1 deg/s. Below: its error, the sd that "
        "it states, "
        "and the bound that no estimator with this prior beats.",
        pictures_drives.today_5,
    ),
    "today-7": Picture(
        "today_7.png",
        "Figure 7 today",
        "",
        "The same belt with the paper's fixed gain, and with the gain that follows the estimate of the "
        "filter running "
        "beside. Below: the filter's estimate on the drive with the fixed gain, its error and sd, and a "
        "bound of linear "
        "tyres on a smooth belt, which no estimator can reach here: what the belt does is not known to it.",
        pictures_drives.today_7,
    ),
}


def draw_all(begin: Callable[[str], None] = lambda text: None) -> dict[str, bytes]:
    """Draw every picture: file name -> PNG.

    Parameters
    ----------
    begin : called with the title of each before it is drawn.
    """
    drawn = {}
    for picture in PICTURES.values():
        begin(picture.title)
        drawn[picture.file] = png(picture.draw())
    return drawn
