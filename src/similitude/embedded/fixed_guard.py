"""Does an estimator survive whole numbers at the chosen rate? Advice or refusal, with numbers.

A hard swing of one hertz, with the sensor's own noise on it, goes through the step in integers and through
the same step in double. What the innovations differ by is set against the sensor's noise, what the unknown
differs by against itself.

Invariant: what is judged is the very step that is exported, not a model of its rounding.
"""

from __future__ import annotations

import numpy as np

from similitude.embedded.fixed_profile import Profile
from similitude.embedded.fixed_texts import expected_words, integer_rows
from similitude.embedded.guard import REFUSED, SWING, Guard, sections_of
from similitude.errors import UsageError
from similitude.program.fixed.arithmetic import MANTISSA

SAMPLES = 4000  # the second half is judged
READ = 'docs/embedded.md, "Fixed point"'


def check_profile(profile: Profile) -> Guard:
    """Pole radius of the rounded sections, rounding of the whole step over the sensor's noise.

    Raises
    ------
    UsageError    the rounded sections are unstable, or rounding exceeds the sensor's noise.
    """
    library = profile.plain.library()
    sections = sections_of(library, profile.config)
    rounded = np.round(sections * 2.0**MANTISSA) / 2.0**MANTISSA
    roots = [np.abs(np.roots([1.0, *row[3:]])).max() for row in rounded]
    found = Guard(float(max(roots, default=0.0)), _rounding(profile), "fixed")
    step = profile.numbers.sample_time
    if found.pole_radius >= 1 or found.rounding > REFUSED:
        raise UsageError(
            f"{profile.source.name} does not survive --real fixed at {1 / step:.6g} samples a second: poles "
            f"up to {found.pole_radius:.7f}, rounding {100 * found.rounding:.0f} % of the sensor's noise",
            usually="the loop is much faster than the car, and differences between samples are last digits.",
            paste=f'--sample-time "{1000 * 4 * step:g} ms"   # every fourth sample; or --real float',
            read=READ,
        )
    return found


def drive(profile: Profile) -> np.ndarray:
    """Rows (n, sample fields) of the swing, SI units."""
    value = dict(zip(profile.plain.library().names("config"), profile.config.tolist(), strict=True))
    step, n = profile.numbers.sample_time, SAMPLES
    noise = np.sqrt(value["noise_variance"]) * np.random.default_rng(0).standard_normal(n)
    phase = 2 * np.pi * step * np.arange(n)
    rows = np.empty((n, len(profile.fixed.sample)))
    rows[:, 0] = step
    rows[:, 1] = SWING * value["input_limit"] * np.sin(phase)
    rows[:, 2:-1] = 0.2 * value["signal_limit"]
    rows[:, -1] = SWING * value["output_limit"] * np.sin(phase - 0.3) + noise
    return rows


def _rounding(profile: Profile) -> float:
    library = profile.plain.library()
    rows = integer_rows(profile, drive(profile))
    exact_rows = rows * np.array([f.format.step for f in profile.fixed.sample])
    exact, _ = library.run(profile.config, library.start(profile.config), exact_rows)
    words = expected_words(profile, rows).outputs.view(np.int32)
    steps = np.array([f.format.step for f in profile.fixed.output])
    names = [f.name for f in profile.fixed.output]
    at = names.index("innovation")
    differ = (words * steps - exact)[SAMPLES // 2 :, at]
    noise = float(np.sqrt(profile.config[library.index("config", "noise_variance")]))
    return float(np.sqrt(np.mean(differ**2))) / noise
