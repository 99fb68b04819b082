import io
import time

from rich.console import Console

from similitude.report.progress import ProgressBar


def _terminal():
    return Console(file=io.StringIO(), force_terminal=True, width=80)


def test_quick_work_shows_no_bar():
    console = _terminal()
    with ProgressBar(3, console=console) as bar:
        bar.begin("reading")
        bar.finish_to(3)
    assert console.file.getvalue() == ""


def test_slow_work_shows_a_bar_and_takes_it_away():
    console = _terminal()
    with ProgressBar(3, console=console, patience=0.01) as bar:
        bar.begin("drive.csv: reading")
        _wait_until(lambda: bar.visible)
        with bar.aside():
            assert not bar.visible
        assert bar.visible
    assert not bar.visible
    assert "drive.csv: reading" in console.file.getvalue()


def test_nothing_is_drawn_where_nobody_looks():
    console = Console(file=io.StringIO(), width=80)
    with ProgressBar(1, console=console, patience=0.0) as bar:
        time.sleep(0.05)
        assert not bar.visible
    assert console.file.getvalue() == ""


def test_steps_are_counted_as_they_begin():
    with ProgressBar(3, console=Console(file=io.StringIO())) as bar:
        for text, done in (("reading", 0), ("estimating", 1), ("drawing", 2)):
            bar.begin(text)
            assert bar.done == done
        bar.finish_to(3)
        bar.begin("next")
        assert bar.done == 3


def _wait_until(condition, limit=5.0):
    end = time.monotonic() + limit
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    assert condition()
