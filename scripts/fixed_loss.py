"""Prints what whole numbers cost: each fixed-point estimator beside the same step in double.

The rows of `scripts/embedded.py`: a double lane change of a car and a simulated drive, 100 Hz. And how much
rounding moves the innovation against the sensor's noise at several rates (`embedded.fixed_guard`).

    python scripts/fixed_loss.py
"""

from __future__ import annotations

import numpy as np

from embedded import CAR, logs
from similitude.embedded.fixed_guard import check_profile
from similitude.embedded.fixed_profile import FIXED, Profile, fixed_profile
from similitude.embedded.fixed_texts import expected_words, integer_rows
from similitude.errors import UsageError

RATES = (100, 1000, 10_000)  # samples a second


def compared(profile: Profile, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Outputs (n, fields) and status (n,) in whole numbers, and in double of the same samples."""
    words = integer_rows(profile, rows)
    steps = [
        np.array([f.format.step for f in fields]) for fields in (profile.fixed.sample, profile.fixed.output)
    ]
    answered, library = expected_words(profile, words), profile.plain.library()
    exact, status = library.run(profile.config, library.start(profile.config), words * steps[0])
    return answered.outputs.view(np.int32) * steps[1], answered.status, exact, status


def main() -> None:
    """A row for each estimator, then the guard's figures."""
    rows, step = logs()
    print(
        f"{'estimator':18} {'samples':>8} {'learnt':>7} {'status':>7} "
        f"{'ln K':>9} {'of its sd':>9} {'innovation':>11}"
    )
    for name in FIXED:
        profile = fixed_profile("bicycle", name, vehicle=CAR, sample_time=step)
        ours, status, exact, wanted = compared(profile, rows)
        differ = np.abs(np.log(ours[:, 0] / exact[:, 0]))
        rest = np.sqrt(np.mean((ours[:, 3] - exact[:, 3]) ** 2))
        print(
            f"{name:18} {len(rows):8} {(wanted == 0).sum():7} {(status != wanted).sum():7} "
            f"{differ.max():9.1e} {(differ / np.sqrt(exact[:, 1])).max():9.1e} {rest:7.1e} rad/s"
        )
    for name in FIXED:
        shares = []
        for rate in RATES:
            try:
                found = check_profile(fixed_profile("bicycle", name, sample_time=1 / rate)).rounding
                shares.append(f"{rate} Hz: {found:.1g}")
            except UsageError as refusal:
                shares.append(f"{rate} Hz: refused ({refusal.what.rpartition('rounding ')[2]})")
        print(f"{name:18} rounding over noise  {', '.join(shares)}")


if __name__ == "__main__":
    main()
