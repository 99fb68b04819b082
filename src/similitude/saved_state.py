"""What is kept from one drive to the next: a JSON file, versioned, with a checksum, written atomically.

Floats are written so that they read back bit for bit; a drive that goes on where the last one stopped
therefore gives what one long drive would have given.

Invariant: a file is believed whole or refused with a reason; nothing is taken from one that does not fit.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from similitude.errors import SimilitudeError, shown

VERSION = 1
KIND = "similitude state"
READ = "docs/state.md"
LONGEST_PATH = 300  # characters shown
LARGEST = 4_000_000  # bytes: a state of ours has a hundredth of it


class StateError(SimilitudeError):
    """A state file that cannot be read, or belongs to another vehicle, estimator or version."""


@dataclass(frozen=True)
class SavedState:
    """An estimator after the last row of a log; SI units.

    ``made_for``  what must be the same for it to be used: estimator, programs, wheelbase, population, ...
    ``settings``  noise, steer scale and lag the drive was estimated with
    ``clock``     time stamp of the last row [s];  ``tail`` its last time stamps [s] and steer angles [rad]
    ``filter``, ``monitor``   flat states in the order of the programs
    ``tyre``      the slow estimate: mean and variance of ln K, drives it rests on
    """

    made_for: Mapping[str, Any]
    settings: Mapping[str, float]
    clock: float
    tail: Mapping[str, list[float]]
    filter: list[float]
    monitor: list[float]
    tyre: Mapping[str, float] = field(default_factory=dict)
    origin: str = field(default="state.json", compare=False)  # where it was read, for messages


def write_state(state: SavedState, path: str | os.PathLike[str]) -> None:
    """Write a state file, or leave the one that is there as it is.

    Raises
    ------
    StateError    the folder cannot be written.
    """
    path = Path(path)
    body: dict[str, Any] = {"kind": KIND, "version": VERSION, **{n: getattr(state, n) for n in _NAMES}}
    text = json.dumps({**body, "checksum": _checksum(body)}, indent=1, allow_nan=False) + "\n"
    scratch = ""
    try:
        with tempfile.NamedTemporaryFile(
            "w", encoding="ascii", dir=path.parent, prefix=f".{path.name}-", delete=False
        ) as file:
            scratch = file.name
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(scratch, path)
    except OSError as fault:
        if scratch:
            Path(scratch).unlink(missing_ok=True)
        raise StateError(
            f"--state {shown(path, longest=LONGEST_PATH)} cannot be written: {fault.strerror or fault}",
            usually="the folder does not exist or belongs to somebody else; the old state, if any, is whole.",
            paste=f"mkdir -p {path.parent}",
            read=READ,
        ) from fault


def read_state(path: str | os.PathLike[str]) -> SavedState:
    """Read a state file.

    Raises
    ------
    StateError    it cannot be read, is damaged, cut short, of another kind or from a newer version.
    """
    path = Path(path)
    try:
        data = path.read_bytes()[: LARGEST + 1]
    except OSError as fault:
        raise _refused(
            path, f"cannot be read: {fault.strerror or fault}", "the path is another's."
        ) from fault
    try:
        if len(data) > LARGEST:
            raise ValueError("it is larger than any state")
        body = json.loads(data.decode("utf-8"), parse_constant=_no_constant, parse_float=_finite)
    except (ValueError, RecursionError) as fault:
        why = "a copy was cut short, or it is another file: a state is written in one go and is never half."
        raise _refused(path, f"is no whole state file ({shown(fault)})", why) from fault
    if not isinstance(body, dict) or body.get("kind") != KIND:
        raise _refused(path, "is not a state of ours", "another file of that name was meant.")
    if body.get("version") != VERSION:
        newer = isinstance(body.get("version"), int) and body["version"] > VERSION
        why = "a newer similitude wrote it." if newer else "it was edited, or is of a version long gone."
        raise _refused(
            path, f"has version {shown(body.get('version'))}; this similitude reads {VERSION}", why
        )
    checksum = body.pop("checksum", None)
    if checksum != _checksum(body):
        raise _refused(path, "does not match its own checksum", "it was edited or damaged on the way.")
    if set(body) != {"kind", "version", *_NAMES} or not _is_sound(body):
        raise _refused(path, "holds other things than a state does", "another program wrote it.")
    return SavedState(**{name: body[name] for name in _NAMES}, origin=str(path))


def fits(state: SavedState, made_for: Mapping[str, Any]) -> None:
    """Compare what a state was made for with what it is to be used for.

    Raises
    ------
    StateError    names what differs, with both values.
    """
    for name in sorted({*state.made_for, *made_for}):
        was, now = state.made_for.get(name), made_for.get(name)
        if was != now:
            raise _refused(
                state.origin,
                f"was saved for {name} = {shown(was)}, and this drive has {shown(now)}",
                "it belongs to another vehicle, or vehicle file, population or program changed since.",
            )


_NAMES = ("made_for", "settings", "clock", "tail", "filter", "monitor", "tyre")


def _checksum(body: Mapping[str, Any]) -> str:
    plain = json.dumps(body, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(plain.encode("ascii")).hexdigest()


def _finite(text: str) -> float:
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(f"{shown(text)} in it")
    return number


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} in it")


def _is_sound(body: Mapping[str, Any]) -> bool:
    def numbers(values: object) -> bool:
        return isinstance(values, list) and all(type(x) is float and math.isfinite(x) for x in values)

    tail = body["tail"]
    return (
        type(body["clock"]) is float
        and math.isfinite(body["clock"])
        and all(isinstance(body[name], dict) for name in ("made_for", "settings", "tail", "tyre"))
        and all(type(x) is float for x in (*body["settings"].values(), *body["tyre"].values()))
        and set(tail) == {"t", "delta"}
        and len(tail["t"]) == len(tail["delta"])
        and all(numbers(values) for values in (tail["t"], tail["delta"], body["filter"], body["monitor"]))
    )


def _refused(path: object, what: str, usually: str) -> StateError:
    return StateError(
        f"--state {shown(path, longest=LONGEST_PATH)} {what}",
        usually=f"{usually} The file was left as it is.",
        paste=f"mv {path} {path}.old   # the next drive then starts from the population",
        read=f'{READ}, "When a state is refused"',
    )
