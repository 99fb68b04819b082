"""Times of several actions taken in turn, so that a slow moment of the machine meets all of them.

Invariant: ratios are formed inside one run only; one uncounted round comes first.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Times:
    """Times of one action over the rounds [s]."""

    all: tuple[float, ...]

    @property
    def median(self) -> float:
        """Median [s]."""
        return statistics.median(self.all)

    @property
    def least(self) -> float:
        """Shortest [s]; what the machine can do when nobody else uses it."""
        return min(self.all)


def interleave(
    actions: Mapping[str, Callable[[], object]],
    rounds: int,
    clock: Callable[[], float] = time.thread_time,
) -> dict[str, Times]:
    """Time the actions A B C A B C ...

    Parameters
    ----------
    actions : name to what is timed.
    rounds : how often each is timed.
    clock : [s]; this thread's processor time, which others on the machine disturb least.

    Returns
    -------
    times : name to its times.
    """
    taken: dict[str, list[float]] = {name: [] for name in actions}
    for round_ in range(rounds + 1):
        for name, action in actions.items():
            begin = clock()
            action()
            end = clock()
            if round_:
                taken[name].append(end - begin)
    return {name: Times(tuple(times)) for name, times in taken.items()}
