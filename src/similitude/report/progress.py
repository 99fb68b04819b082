"""A progress bar on stderr that stays away when the work takes less than a second."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Iterator
from types import TracebackType

from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

PATIENCE = 1.0  # time before the bar is shown [s]


class ProgressBar:
    """Count steps of work; show them when the work is slow and stderr is a terminal.

    Parameters
    ----------
    total : int
        Number of steps.
    console : rich.console.Console
        The console of stderr; nothing is ever drawn when it is not a terminal.
    patience : float
        Time before the bar appears [s].
    """

    def __init__(self, total: int, *, console: Console, patience: float = PATIENCE) -> None:
        self._bar = Progress(
            SpinnerColumn(), TextColumn("{task.description}"), BarColumn(bar_width=28),
            TimeElapsedColumn(), console=console, transient=True,
        )  # fmt: skip
        self._task = self._bar.add_task("", total=total)
        self._lock = threading.Lock()
        self._closed = self._begun = False
        self._timer = threading.Timer(patience, self._show)
        self._timer.daemon = True
        self._may_show = console.is_terminal

    def __enter__(self) -> ProgressBar:
        if self._may_show:
            self._timer.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with self._lock:
            self._closed = True
            self._timer.cancel()
            if self.visible:
                self._bar.stop()

    @property
    def visible(self) -> bool:
        """Whether the bar is on the screen now."""
        return self._bar.live.is_started

    @contextlib.contextmanager
    def aside(self) -> Iterator[None]:
        """Take the bar off the screen while something else is printed."""
        with self._lock:
            was_visible = self.visible
            if was_visible:
                self._bar.stop()
            try:
                yield
            finally:
                if was_visible and not self._closed:
                    self._bar.start()

    @property
    def done(self) -> float:
        """Number of steps finished."""
        return self._bar.tasks[0].completed

    def begin(self, text: str) -> None:
        """Name the step that starts now; the one before it is done."""
        self._bar.update(self._task, description=text, advance=1 if self._begun else 0)
        self._begun = True

    def finish_to(self, steps: float) -> None:
        """Count `steps` as finished in all, however many were begun."""
        self._bar.update(self._task, completed=steps)
        self._begun = False

    def _show(self) -> None:
        with self._lock:
            if not self._closed:
                self._bar.start()
