"""Errors that say what is wrong, what it usually means, what to paste and where to read more.

    SimilitudeError
    ├── UnitError        a unit string, or a unit of the wrong dimension
    ├── LogError         a driving log that cannot be read or believed
    ├── VehicleError     a vehicle file with an unknown key or an impossible value
    ├── ModelError       a model whose units or names do not fit together
    ├── ProgramError     a step program that cannot be generated
    ├── CompileError     generated C that cannot be compiled or loaded
    ├── ScenarioError    a scenario file with an unknown key or an impossible value
    └── UsageError       a command or call that cannot be carried out as written

Invariant: every message of the product has all four parts; "invalid input" is never one of them.
"""

from __future__ import annotations


class SimilitudeError(Exception):
    """Base of every error the product raises on purpose.

    Parameters
    ----------
    what : str
        What is wrong, with names, values and units as the user typed them.
    usually : str
        What it usually means; the text that follows the word "Usually".
    paste : str
        One line to paste: a header, a line of a vehicle file, a command.
    read : str
        Where to read more, such as ``docs/logs.md, "Columns"``.
    fault : str
        Short name of the fault, where docs/logs.md lists it: ``no_unit``.

    Attributes
    ----------
    what, usually, paste, read, fault : str
        The parts, unchanged.
    """

    def __init__(self, what: str, *, usually: str, paste: str, read: str, fault: str = "") -> None:
        super().__init__(what)
        self.fault = fault
        self.what = what
        self.usually = usually
        self.paste = paste
        self.read = read

    def __str__(self) -> str:
        usually = self.usually.removeprefix("Usually ")
        return (
            f"{type(self).__name__}: {self.what}\n"
            f"  Usually {usually}\n"
            f"  Paste:  {self.paste}\n"
            f"  Read:   {self.read}"
        )

    def __reduce__(self):
        # Keyword-only arguments defeat the default pickling of exceptions; worker processes
        # of a fleet hand errors back pickled.
        return (_rebuild, (type(self), self.what, self.usually, self.paste, self.read, self.fault))


def shown(text: object, *, longest: int = 60) -> str:
    """Return `text` in quotes for a message: shortened, and safe to print on a terminal."""
    plain = str(text)
    if len(plain) > longest:
        plain = plain[: longest - 1] + "…"
    return "'" + "".join(c if c.isprintable() else repr(c)[1:-1] for c in plain) + "'"


def _rebuild(kind: type[SimilitudeError], what: str, usually: str, paste: str, read: str, fault: str):
    return kind(what, usually=usually, paste=paste, read=read, fault=fault)


class UnitError(SimilitudeError):
    """A unit string that is not known, or a unit of the wrong dimension."""


class LogError(SimilitudeError):
    """A driving log that cannot be read, or whose values cannot be what they claim."""


class VehicleError(SimilitudeError):
    """A vehicle file with an unknown key or an impossible value."""


class ScenarioError(SimilitudeError):
    """A scenario file with an unknown key, an impossible value or parts that do not fit together."""


class ModelError(SimilitudeError):
    """A model whose names, units or equations do not fit together."""


class ProgramError(SimilitudeError):
    """A step program that cannot be generated from its model."""


class CompileError(SimilitudeError):
    """Generated C that cannot be compiled or loaded on this machine."""


class UsageError(SimilitudeError):
    """A command or a call that cannot be carried out as written."""
