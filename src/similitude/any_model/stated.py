"""What a user states, read: numbers with units as text or in SI, the planned drive, the doubts.

Invariant: a wrong name, unit or shape is answered with the argument's name and the line to write.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from similitude.any_model.filter_numbers import Doubts
from similitude.errors import UnitError, UsageError, shown
from similitude.model import Model
from similitude.units import parse_quantity, parse_unit

READ = 'docs/estimator.md, "The call"'
FEWEST = 50  # rows of a drive
DOUBTS = ("input_error", "input_offset", "output_bias", "disturbance", "model_error", "drift")


def number_of(name: str, text: str | float, unit: str, *, least: float = 0.0) -> float:
    """A positive number in SI of text with a unit, or of a number that is in SI.

    Raises
    ------
    UsageError    not above ``least``, or not finite.
    UnitError     the text cannot be read, or is of another dimension.
    """
    if isinstance(text, str):
        try:
            if unit == "1" and text.strip().endswith("%"):
                value = float(text.strip()[:-1]) / 100
            else:
                value, _ = parse_quantity(text, expect=parse_unit(unit).dimension)
        except (UnitError, ValueError) as error:
            what = getattr(error, "what", f"{shown(text)} is no number")
            raise UnitError(f"{name}: {what}", usually=getattr(error, "usually", "a unit is missing."),
                            paste=f"{name}='0.1 {unit}'", read=READ) from None  # fmt: skip
    else:
        value = float(text)
    if not (np.isfinite(value) and value > least) and not (least == 0 and value == 0 and name in DOUBTS):
        raise UsageError(
            f"{name} = {shown(text)} is not above {least:g} {unit}",
            usually="a sign slipped in, or zero stands for a value nobody knows.",
            paste=f"{name}='0.1 {unit}'",
            read=READ,
        )
    return value


def numbers_of(
    model: Model,
    what: str,
    given: Mapping[str, str | float] | None,
    *,
    wanted: Sequence[str],
    own: Mapping[str, float],
) -> dict[str, float]:
    """Name -> value [SI] of ``signals`` or ``start``.

    Raises
    ------
    UsageError    a name is not there, or one of ``wanted`` has no value.
    UnitError     a text cannot be read.
    """
    there = model.signals if what == "signals" else tuple(q.name for q in model.states)
    strange = [n for n in given or {} if n not in there]
    if strange:
        raise UsageError(
            f"{what} names {shown(strange[0])}; {model.name!r} has {', '.join(there) or 'none'}",
            usually="the name was misspelt, or is that of a parameter: those go into prior.",
            paste=f"{what}={{{there[0] if there else '...'!r}: '1 ...'}}",
            read=READ,
        )
    found = {n: own[n] for n in wanted if n in own}
    for name, text in (given or {}).items():
        unit = model.quantity(name).unit
        found[name] = number_of(f"{what}[{name!r}]", text, unit, least=-np.inf)
    missing = [n for n in wanted if n not in found]
    if missing:
        q = model.quantity(missing[0])
        raise UsageError(
            f"signal {q.name!r} [{q.unit}] of {model.name!r} has no usual value",
            usually="it comes with every sample, and the numbers of the estimator are paced by a usual one.",
            paste=f"signals={{{q.name!r}: '1 {q.unit}'}}",
            read=READ,
        )
    return found


def drive_of(drive: ArrayLike, model: Model) -> NDArray[np.float64]:
    """The planned input, (n,) [SI].

    Raises
    ------
    UsageError    not one row of finite numbers, too few, or all zero.
    """
    name, unit = model.inputs[0].name, model.inputs[0].unit
    try:
        u = np.asarray(drive, dtype=float)
    except (TypeError, ValueError):
        u = np.empty(0)
    if u.ndim != 1 or len(u) < FEWEST or not np.isfinite(u).all() or not u.any():
        raise UsageError(
            f"drive has shape {u.shape}{', all zero' if u.size and not u.any() else ''}; wanted are "
            f"{FEWEST} or more values of {name!r} [{unit}, in SI] that do something",
            usually="the time was passed along with it, a value is missing, or the input stays at zero.",
            paste="drive=0.1*np.sin(2*np.pi*0.5*np.arange(0, 20, 0.01))",
            read=READ,
        )
    return u


def doubts_of(model: Model, noise: str | float, given: Mapping[str, str | float] | None) -> Doubts:
    """What may be wrong besides the unknowns, in SI.

    Raises
    ------
    UsageError    there is no such doubt, or one is negative.
    UnitError     a text cannot be read.
    """
    strange = [n for n in given or {} if n not in DOUBTS]
    if strange:
        raise UsageError(
            f"doubts names {shown(strange[0])}; there are {', '.join(DOUBTS)}",
            usually="the name was misspelt; the spread of a parameter goes into prior.",
            paste="doubts={'output_bias': '0.1 " + model.outputs[0].unit + "'}",
            read=READ,
        )
    u, y = model.inputs[0].unit, model.outputs[0].unit
    units = {"input_offset": u, "disturbance": u, "output_bias": y}
    told = {
        n: _drift(v) if n == "drift" else number_of(n, v, units.get(n, "1")) for n, v in (given or {}).items()
    }
    return Doubts(number_of("noise", noise, y), **told)


def _drift(text: str | float) -> float:
    """``"5 % in 1 min"``: sd of the logarithm after that time, as a random walk [1/sqrt(s)]."""
    if not isinstance(text, str):
        return number_of("drift", text, "1")
    share, found, time = text.partition(" in ")
    if not found:
        raise UnitError(
            f"drift: {shown(text)} does not say how much in which time",
            usually="only one of both was written.",
            paste="doubts={'drift': '5 % in 1 min'}",
            read=READ,
        )
    return number_of("drift", share, "1") / float(np.sqrt(number_of("drift", time, "s")))
