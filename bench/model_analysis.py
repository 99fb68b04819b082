"""The general method as a user waits for it: scalings of a long chain of reactions, a whole analysis.

The chain is x0 -> x1 -> ... with one rate constant a reaction, or with Michaelis and Menten's two. The
analysis is a process of its own, from its start to the printed page.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable

from similitude.symmetry.scalings import scaling_symmetries

REACTIONS = 60
ANALYZE = [sys.executable, "-m", "similitude.cli", "analyze", "bicycle"]


def chain(reactions: int) -> tuple[dict[str, str], list[str]]:
    """Rates and parameters of a linear chain, one parameter a reaction."""
    rates = {f"x{i}": (f"k{i - 1}*x{i - 1} - " if i else "-") + f"k{i}*x{i}" for i in range(reactions)}
    return rates, [f"k{i}" for i in range(reactions)]


def saturating_chain(reactions: int) -> tuple[dict[str, str], list[str]]:
    """The same with saturating rates, two parameters a reaction."""
    flows = [f"v{i}*x{i}/(K{i} + x{i})" for i in range(reactions)]
    rates = {f"x{i}": (f"{flows[i - 1]} - " if i else "-") + flows[i] for i in range(reactions)}
    return rates, [f"{letter}{i}" for i in range(reactions) for letter in "vK"]


def scalings(reactions: int) -> dict[str, Callable[[], object]]:
    """What to time, by the names of their rows."""
    plain, saturating = chain(reactions), saturating_chain(reactions)
    return {
        f"scalings of {reactions} reactions": lambda: scaling_symmetries(*plain),
        f"scalings of {reactions} saturating reactions": lambda: scaling_symmetries(*saturating),
    }


def run_analysis() -> None:
    """`similitude analyze bicycle` in a process of its own.

    Raises
    ------
    RuntimeError    it failed or printed no page.
    """
    done = subprocess.run(
        ANALYZE, capture_output=True, text=True, check=False, env={**os.environ, "COLUMNS": "100"}
    )
    if done.returncode or "What the outputs tell" not in done.stdout:
        raise RuntimeError(f"{' '.join(ANALYZE)} failed:\n{done.stderr}")
