"""Finding: one thing that is odd about a log, in the four parts of a message and in numbers.

Invariant: a finding never carries changed data. What is certain refuses the log; what is likely is
said with the number that gave it away; a repair happens only when its name was asked for.
"""

from __future__ import annotations

from dataclasses import dataclass

from similitude.errors import LogError, SimilitudeError


@dataclass(frozen=True)
class Finding:
    """What was noticed, where, and what to do about it.

    Parameters
    ----------
    fault : str                   short name, the same in messages, JSON and docs: ``yaw_rate_unit``
    certain : bool                True: the log is refused; False: a warning
    what, usually, paste, read    the four parts (see `similitude.errors`)
    column : str                  header as written in the file; empty for the file as a whole
    value : float or None         the number that gave it away
    rows : (int, int) or None     first and last data row concerned, counted from 1
    fix : str or None             name of the repair that ``--fix`` applies, where there is one
    kind : type                   the error it becomes: LogError, or UnitError
    """

    fault: str
    certain: bool
    what: str
    usually: str
    paste: str
    read: str
    column: str = ""
    value: float | None = None
    rows: tuple[int, int] | None = None
    fix: str | None = None
    kind: type[SimilitudeError] = LogError

    @property
    def error(self) -> SimilitudeError:
        """The finding as the error that refuses the log."""
        return self.kind(self.what, usually=self.usually, paste=self.paste, read=self.read, fault=self.fault)

    @property
    def warning(self) -> str:
        """The finding as one line of a warning."""
        repair = "" if self.fix is None else f" (--fix {self.fix})"
        return f"{self.what}; usually {self.usually.rstrip('.')}{repair}"


def refusal(error: SimilitudeError, *, column: str = "", fix: str | None = None) -> Finding:
    """Return the finding of an error: certain, and with the error's own parts."""
    return Finding(
        error.fault,
        certain=True,
        what=error.what,
        usually=error.usually,
        paste=error.paste if fix is None else f"--fix {fix}",
        read=error.read,
        column=column,
        fix=fix,
        kind=type(error),
    )
