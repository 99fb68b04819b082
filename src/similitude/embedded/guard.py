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

DIFFERENCES = {"paper": 0, "band": 1}  # of what the filter hands on; those of `paper` are among its sections
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
    """The sections of a configuration: (k, 5) b0, b1, b2, a1, a2, or (k, 2) 1 + a1 + a2, a2."""
    names = [row[0] for row in library.layout.CONFIG if row[0].startswith("poles_")]
    if names:
        return np.array([config[library.index("config", name) :][:2] for name in names])
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
    below = [_denominator(row.astype(kind).astype(float)) for row in sections]
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


def _denominator(row: NDArray) -> tuple[float, float, float]:
    return (1.0, row[0] - 1.0 - row[1], row[1]) if len(row) == 2 else (1.0, row[3], row[4])


def _rounding(library: Library, config: NDArray, kind: type, differences: int, sample_time: float) -> float:
    sections = sections_of(library, config)
    noise = float(np.sqrt(config[library.index("config", "noise_variance")]))
    swing = SWING * float(config[library.index("config", "output_limit")])
    wave = swing * np.sin(2 * np.pi * np.arange(SAMPLES) * sample_time)
    passed = _bends if sections.shape[1] == 2 else _cascade
    exact = np.diff(passed(sections, wave, np.float64), differences)
    rounded = np.diff(passed(sections, wave, kind).astype(float), differences)
    impulse = np.zeros(SAMPLES)
    impulse[max(differences, 1)] = 1.0
    heard = noise * float(np.linalg.norm(np.diff(passed(sections, impulse, np.float64), differences)))
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


def _bends(sections: NDArray, values: NDArray, kind: type) -> NDArray:
    """Second difference behind high-pass sections as `high_pass_section` has it, from the first value."""
    taken = values.astype(kind)
    bend = np.diff(np.diff(taken, prepend=taken[:1]), prepend=kind(0.0))
    for c, a2 in sections.astype(kind):
        held = change = kind(0.0)
        passed = np.empty(len(values), kind)
        for k, x in enumerate(bend):
            now = x + change * a2 - held * c
            held, passed[k], change = held + now, now - change, now
        bend = passed
    return bend
