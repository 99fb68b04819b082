"""An entrant of the benchmark: a function from a drive to an answer, ours or somebody else's.

Invariant: an entrant is given a log and a vehicle file and never the truth; what it answers is checked before
it is scored, and what it raises is its own result.
"""

from __future__ import annotations

import runpy
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from numpy.typing import ArrayLike

from similitude.benchmark.drives import Drive
from similitude.errors import UsageError

READ = 'docs/benchmark.md, "Entering an estimator"'
IDENTIFIED_STD = 0.15  # of ln K, as in `identify`


@dataclass(frozen=True, eq=False)
class Answer:
    """What an estimator says of a drive; a number stands for one a row.

    Parameters
    ----------
    K : (n,) or float               estimate, row by row from that row and those before it [m^2/s^2]
    ln_K_std : (n,) or float        sd of its logarithm, which makes the 95 % interval K·exp(±1.96 sd) [-]
    alarms : sequence of float      moments at which a change of the stiffness was decided [s]
    identified : bool or None       whether it says that it knows K at the end; None: where the sd is
                                    at most 0.15 there
    operations : int or None        additions, multiplications and divisions a sample, where counted [-]
    step_seconds : float or None    time of the bare loop over the rows, where it was measured [s]
    """

    K: ArrayLike
    ln_K_std: ArrayLike
    alarms: Sequence[float] = ()
    identified: bool | None = None
    operations: int | None = None
    step_seconds: float | None = None


@dataclass(frozen=True)
class Entrant:
    """A named estimator.

    Parameters
    ----------
    name : str
    about : str           one line
    estimate : function   from a Drive to an Answer
    whole_log : bool      it has one K for a whole log: it is given the drive up to the change
    """

    name: str
    about: str
    estimate: Callable[[Drive], Answer]
    whole_log: bool = False


def read_entrant(path: str | Path) -> Entrant:
    """Read an entrant from a Python file.

    Parameters
    ----------
    path : str or Path   with a function ``estimate(drive)``; its name is the file's, what it is about the
                         first line of the file's docstring

    Raises
    ------
    UsageError   there is no such file, it does not run, or has no such function
    """
    path = Path(path)
    try:
        names = runpy.run_path(str(path))
    except Exception as error:  # whatever a file of somebody else raises is said, not shown as ours
        raise UsageError(
            f"'{path}' cannot be run: {type(error).__name__}: {error}",
            usually="the path is that of another folder, or the file has an error of its own.",
            paste=f"python {path}",
            read=READ,
        ) from None
    estimate = names.get("estimate")
    if not callable(estimate):
        raise UsageError(
            f"'{path}' has no function estimate(drive)",
            usually="the function has another name.",
            paste="def estimate(drive): return Answer(K=150.0, ln_K_std=0.5)",
            read=READ,
        )
    about = (names.get("__doc__") or path.stem).strip().splitlines()[0]
    return Entrant(path.stem, about, estimate, bool(names.get("WHOLE_LOG", False)))
