"""What can be wrong with the command line itself, each with the line that would have worked."""

from __future__ import annotations

import difflib
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path

import typer

from similitude.errors import UnitError, UsageError

ESTIMATORS = ("population", "batch", "robust", "output_error", "band", "paper")


def read_mapping(pairs: Sequence[str]) -> dict[str, str]:
    """Turn `delta=SWA` into {"delta": "SWA"}.

    Parameters
    ----------
    pairs : sequence of str
        What each `--map` was given.

    Returns
    -------
    dict of str to str
        Our column name to the log's.

    Raises
    ------
    UsageError
        No `=`, an empty side, or one of our names twice.
    """
    mapping: dict[str, str] = {}
    for pair in pairs:
        ours, equals, theirs = (part.strip() for part in pair.partition("="))
        if not (ours and equals and theirs) or ours in mapping:
            again = f" a second time ('{mapping[ours]}' and '{theirs}')" if ours in mapping else ""
            raise UsageError(
                f"--map '{pair}' does not name one column of the log{again}",
                usually="the sign = is missing, a side is empty, or one name was mapped twice; "
                "our name stands left, the log's right.",
                paste="--map delta=SWA",
                read='docs/logs.md, "Columns"',
            )
        mapping[ours] = theirs
    return mapping


def read_spacing(text: str) -> float:
    """Turn "0.4 m" into metres.

    Parameters
    ----------
    text : str
        What `--spacing` was given.

    Raises
    ------
    UsageError
        It is no positive length.
    """
    from similitude.units import LENGTH, parse_quantity

    try:
        metres, unit = parse_quantity(text, expect=LENGTH)
    except UnitError as error:
        raise _no_length(text, f": {error.what}") from None
    if unit.dimension != LENGTH or not metres > 0:
        raise _no_length(text, "")
    return metres


def _no_length(text: str, why: str) -> UsageError:
    return UsageError(
        f"--spacing '{text}' is no positive length{why}",
        usually="the unit is missing; a tenth to a fifth of the wheelbase is meant.",
        paste='--spacing "0.4 m"',
        read='docs/filter.md, "Sampling by distance"',
    )


def list_fixes(names: list[str] | None) -> list[str] | None:
    """Print the repairs and leave where `--fix list` asks for them, and refuse unknown names.

    Parameters
    ----------
    names : list of str or None
        What each `--fix` was given.

    Returns
    -------
    list of str or None
        The same.

    Raises
    ------
    UsageError
        There is no repair of that name.
    typer.Exit
        The list was printed.
    """
    if not names:
        return names
    from similitude.log_fixes import FIXES, check_fixes

    if "list" in names:
        for name, fix in FIXES.items():
            typer.echo(f"{name:<22} {fix.words}")
        raise typer.Exit
    check_fixes(names)
    return names


def check_estimator(name: str) -> None:
    """Refuse an estimator that does not exist, naming those that do.

    Parameters
    ----------
    name : str
        What `--estimator` was given.

    Raises
    ------
    UsageError
        It is not known.
    """
    if name in ESTIMATORS:
        return
    near = difflib.get_close_matches(name, ESTIMATORS, n=1)
    raise UsageError(
        f"--estimator '{name}' is not known; there are {' and '.join(ESTIMATORS)}",
        usually="the default is what is wanted: the population filter, which needs no tuning.",
        paste=f"--estimator {near[0] if near else ESTIMATORS[0]}",
        read='docs/identify.md, "The command"',
    )


def check_state(state: Path | None, how: Mapping[str, object]) -> None:
    """Refuse a state file where nothing could be kept in it.

    Parameters
    ----------
    state : Path or None
        What `--state` was given.
    how : mapping
        The `estimator` and the `spacing` of rows, None for rows by time.

    Raises
    ------
    UsageError
        The estimator keeps no state, or the state is a folder.
    """
    if state is None:
        return
    if state.is_dir():
        raise UsageError(
            f"--state '{state}' is a folder; the state is one file",
            usually="the name of the file was left out.",
            paste=f"--state {shlex.quote(str(state / 'car.json'))}",
            read="docs/state.md",
        )
    if how["estimator"] != "population" or how["spacing"] is not None:
        other = "--spacing" if how["spacing"] is not None else f"--estimator {how['estimator']}"
        raise UsageError(
            f"--state '{state}' was given together with {other}",
            usually="only the population filter by time goes on where an earlier drive stopped.",
            paste=f"similitude identify LOG --vehicle car.toml --state {shlex.quote(str(state))}",
            read="docs/state.md",
        )


def no_vehicle(logs: Sequence[Path]) -> UsageError:
    """Say that the wheelbase is needed, with the command that supplies it."""
    return UsageError(
        "no vehicle file was given (--vehicle), so the wheelbase L is not known",
        usually="it was left out because mass and stiffness are not needed; they are not, but the "
        "wheelbase is: it sets the scale of time, L/U.",
        paste=f"echo 'L = \"2.69 m\"' > car.toml && {_command(logs)} --vehicle car.toml",
        read='docs/vehicle.md, "The vehicle file"',
    )


def no_such_vehicle(vehicle: Path, logs: Sequence[Path]) -> UsageError:
    """Say that the vehicle file is not there, with the command that starts one."""
    return UsageError(
        f"--vehicle '{vehicle}': there is no such file (looked in {Path.cwd()})",
        usually="the path is that of another folder, or the file has yet to be written.",
        paste=f"similitude vehicle --new > {shlex.quote(str(vehicle))}",
        read='docs/vehicle.md, "The vehicle file"',
    )


def out_is_a_file(out: str) -> UsageError:
    """Say that the results need a folder."""
    return UsageError(
        f"--out '{out}' is a file; the results need a folder",
        usually="the name of one result was meant; all of them go into one folder together.",
        paste=f"--out {shlex.quote(str(Path(out).with_suffix('')) + '-results')}",
        read='docs/identify.md, "Files"',
    )


def _command(logs: Sequence[Path]) -> str:
    shown = [str(log) for log in logs[:3]]
    return "similitude identify " + shlex.join(shown) + (" ..." if len(logs) > 3 else "")
