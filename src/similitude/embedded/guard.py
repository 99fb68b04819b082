"""Do an estimator's filters survive the chosen precision at the chosen rate? Advice or refusal.

Invariant: the numbers are those of the very sections that are exported, rounded as the target rounds.

A slow filter at a high rate has its poles near one and passes on small differences of large numbers. A steady
swing of one hertz goes through sections and differences twice, in the target's real and in double; what they
differ by is set against what the sensor's own noise leaves there: below it, rounding is one more small noise.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.vectors import TYPES
from similitude.errors import UsageError
from similitude.program.library import Library

DIFFERENCES = {"paper": 2, "band": 1}  # that the regression takes of what the sections pass on
SAMPLES = 4000  # the second half is judged: the sections have settled long before
SWING = 0.05  # of the greatest believable output: a hard steer
ADVISED, REFUSED = 0.1, 1.0  # rounding against the sensor's noise, both behind the sections
READ = 'docs/embedded.md, "Filters and precision"'


@dataclass(frozen=True)
class Guard:
    """Greatest pole radius of the rounded sections; rounding over the noise behind them [-]; the type."""

    pole_radius: float
    rounding: float
    real: str = "float"

    @property
    def advice(self) -> str:
        """A sentence where rounding shows; empty where it does not."""
        if self.rounding <= ADVISED:
            return ""
        return (
            f"rounding in the filters is {100 * self.rounding:.0f} % of the sensor's noise there (poles up "
            f"to {self.pole_radius:.6f}): hand on every second sample, or export --real "
            + ("float" if self.real == "fixed" else "double")
        )


def sections_of(library: Library, config: NDArray) -> NDArray:
    """The biquads of a configuration, (sections, 5): b0, b1, b2, a1, a2."""
    names = [row[0] for row in library.layout.CONFIG if row[0].startswith("biquad_") and row[3] == 5]
    rows = [config[library.index("config", name) :][:5] for name in names]
    return np.array(rows).reshape(-1, 5)


def check_sections(
    library: Library, config: NDArray, *, estimator: str, real: str, sample_time: float
) -> Guard | None:
    """Pole radius and rounding of an estimator's sections; None where it has none.

    Parameters
    ----------
    config : the flat configuration.
    estimator : its name without the system's.
    real : ``float`` or ``double``.
    sample_time : [s].

    Raises
    ------
    UsageError    the rounded sections are unstable, or rounding exceeds the sensor's noise.
    """
    sections = sections_of(library, config)
    if not sections.size or estimator not in DIFFERENCES:
        return None
    kind = TYPES[real]
    below = [[1.0, *row[3:].astype(kind).astype(float)] for row in sections]
    radius = max(float(np.abs(np.roots(row)).max()) for row in below)
    found = Guard(radius, _rounding(library, config, kind, DIFFERENCES[estimator], sample_time), real)
    if radius >= 1 or found.rounding > REFUSED:
        raise UsageError(
            f"the filters of {library.name} do not survive --real {real} at {1 / sample_time:.6g} samples a "
            f"second: poles up to {radius:.7f}, rounding {100 * found.rounding:.0f} % of the sensor's noise",
            usually="the loop is much faster than the car, and a filter of a few hertz works on last digits.",
            paste=f'--sample-time "{1000 * 4 * sample_time:g} ms"   # every fourth sample; or --real double',
            read=READ,
        )
    return found


def _rounding(library: Library, config: NDArray, kind: type, differences: int, sample_time: float) -> float:
    sections = sections_of(library, config)
    noise = float(np.sqrt(config[library.index("config", "noise_variance")]))
    swing = SWING * float(config[library.index("config", "output_limit")])
    wave = swing * np.sin(2 * np.pi * np.arange(SAMPLES) * sample_time)
    exact = np.diff(_cascade(sections, wave, np.float64), differences)
    rounded = np.diff(_cascade(sections, wave, kind).astype(float), differences)
    impulse = np.zeros(SAMPLES)
    impulse[differences] = 1.0
    heard = noise * float(np.linalg.norm(np.diff(_cascade(sections, impulse, np.float64), differences)))
    return float(np.sqrt(np.mean((rounded - exact)[SAMPLES // 2 :] ** 2))) / heard


def _cascade(sections: NDArray, values: NDArray, kind: type) -> NDArray:
    """The sections in transposed direct form two, as the estimators compute them."""
    for row in sections.astype(kind):
        b0, b1, b2, a1, a2 = row
        one = two = kind(0.0)
        passed = np.empty(len(values), kind)
        for k, x in enumerate(values.astype(kind)):
            y = one + b0 * x
            one = two + b1 * x - a1 * y
            two = b2 * x - a2 * y
            passed[k] = y
        values = passed
    return values
