"""How a command says that something is wrong, and the exit code that goes with it.

Invariant: only the standard library is imported until something is wrong.
"""

from __future__ import annotations

from similitude.errors import SimilitudeError, UsageError

RAN, USAGE, BAD_INPUT = 0, 2, 3


def complain(error: SimilitudeError) -> None:
    """Print the four parts on stderr, unbroken so that the line to paste can be pasted."""
    from rich.console import Console
    from rich.text import Text

    text = Text(str(error))
    text.stylize("bold red", 0, str(error).find(":"))
    Console(stderr=True, highlight=False, soft_wrap=True).print(text)


def exit_code(error: SimilitudeError) -> int:
    """2 where the command must be written otherwise, 3 where an input cannot be used."""
    return USAGE if isinstance(error, UsageError) else BAD_INPUT
