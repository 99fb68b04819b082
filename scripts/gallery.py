"""Prints what docs/gallery.md and docs/estimator.md claim: coverage of the five systems (`make gallery`).

Each estimator is rehearsed on systems drawn from its prior, simulated by their dimensional equations.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.any_model.gallery import CASES, made

from similitude.any_model.rehearsal import rehearse

SYSTEMS = 200


def main() -> None:
    """One block a system."""
    for name in CASES:
        estimator = made(name)
        print(f"{name}: {estimator.choice.kind}, since {estimator.choice.reason}")
        print(rehearse(estimator, systems=SYSTEMS, seed=5).text, flush=True)


if __name__ == "__main__":
    main()
