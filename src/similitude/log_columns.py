"""Which column of a file is which quantity: header, aliases, ``--map`` and units.

Invariant: no column is chosen by guess. Two candidates, an ambiguous name and a missing unit are
refused with the line to write.

    t time [s]; delta road wheel angle [rad]; steering_wheel angle [rad]; r yaw rate [rad/s];
    U speed [m/s]; ay lateral acceleration [m/s^2]
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from similitude.dimension import FREQUENCY
from similitude.errors import LogError, UnitError, UsageError, shown
from similitude.finding import Finding, refusal
from similitude.log_names import fits_unit, other_name, unit_of
from similitude.log_quantities import QUANTITIES, STEER, normal_name, split_header
from similitude.units import Unit, parse_unit

READ = 'docs/logs.md, "Columns"'


@dataclass(frozen=True)
class Column:
    """One chosen column: where it stands, how it reads, and its unit."""

    position: int
    header: str
    unit: Unit
    mapped: bool


def column_of(name: str, columns: Mapping[str, Column]) -> Column:
    """Return the column a quantity comes from; that of the road wheel may be the steering wheel's."""
    return columns["steering_wheel"] if name == "delta" and name not in columns else columns[name]


def choose_columns(
    headers: Sequence[str],
    *,
    file: str,
    mapping: Mapping[str, str],
    is_clock: Callable[[int], bool] = lambda position: False,
) -> tuple[dict[str, Column], list[Finding]]:
    """Find the column of each quantity.

    Parameters
    ----------
    headers : sequence of str   as written in the file, ``name [unit]``
    file : str                  name of the file, for messages
    mapping : mapping           quantity -> column, as its full header or its name without unit
    is_clock : callable         position -> whether the cells are dates with a time of day, which
                                need no unit

    Returns
    -------
    dict of str to Column       t, r, U and one of delta and steering_wheel; ay where present;
                                without those that findings speak of
    list of Finding             a column is missing; two match one quantity; a used column has no
                                unit, an unknown one or one of the wrong dimension

    Raises
    ------
    UsageError                  a mapping names no quantity
    """
    findings: list[Finding] = []
    found = _mapped(headers, file, mapping, findings)
    stated = {_quantity_of(key) for key in mapping}
    doubtful = (stated - found.keys()) | _find_by_name(headers, file, stated, found, findings)
    if "delta" in found and "steering_wheel" in found:
        both = [found["delta"][1], found["steering_wheel"][1]]
        findings.append(refusal(_two(file, "steer", "delta", "steering_wheel", both)))
    findings += _missing(headers, file, found, doubtful)
    columns = {}
    for name, (position, header) in found.items():
        try:
            unit = parse_unit("s") if name == "t" and is_clock(position) else _unit(name, header, file)
            columns[name] = Column(position, headers[position], unit, name in stated)
        except UnitError as error:
            findings.append(refusal(error, column=header))
    return columns, findings


def _find_by_name(
    headers: Sequence[str], file: str, stated: set[str], found: dict, findings: list[Finding]
) -> set[str]:
    """Add to `found` what goes by a known name; return the names for which there are two."""
    doubled = set()
    taken = {position for position, _ in found.values()}
    for name, quantity in QUANTITIES.items():
        if name in stated or (name in STEER and STEER & stated):
            continue
        matches = [
            position
            for position, header in enumerate(headers)
            if position not in taken and normal_name(split_header(header)[0]) in quantity.aliases
        ]
        if len(matches) > 1:
            two = [headers[one] for one in matches[:2]]
            findings.append(refusal(_two(file, quantity.words, name, name, two), column=two[0]))
            doubled.add(name)
        elif matches:
            found[name] = (matches[0], headers[matches[0]])
    return doubled


def _quantity_of(key: str) -> str:
    for name in QUANTITIES:
        if key.casefold() == name.casefold():
            return name
    near = difflib.get_close_matches(key, QUANTITIES, n=1, cutoff=0.0)[0]
    raise UsageError(
        f"--map names {shown(key)}, which is no quantity of a log: {', '.join(QUANTITIES)}",
        usually="the two sides were exchanged; the quantity stands left, the column right.",
        paste=f"--map {near}=COLUMN",
        read=READ,
    )


def _mapped(
    headers: Sequence[str], file: str, mapping: Mapping[str, str], findings: list[Finding]
) -> dict[str, tuple[int, str]]:
    found = {}
    for key, wanted in mapping.items():
        name, wanted = _quantity_of(key), wanted.strip()
        matches = [at for at, header in enumerate(headers) if header.strip() == wanted]
        matches = matches or [at for at, header in enumerate(headers) if split_header(header)[0] == wanted]
        header = headers[matches[0]] if matches else wanted
        if not matches and split_header(wanted)[1] is not None:
            # "gyro [deg/s]" for a column "gyro": the user states the unit that the file lacks.
            bare = split_header(wanted)[0]
            matches = [at for at, header in enumerate(headers) if header.strip() == bare]
            header = wanted
        if len(matches) != 1:
            findings.append(refusal(_no_such_column(headers, file, key, wanted, len(matches))))
            continue
        found[name] = (matches[0], header)
    return found


def _no_such_column(headers: Sequence[str], file: str, key: str, wanted: str, count: int):
    near = difflib.get_close_matches(wanted, headers, n=1, cutoff=0.0) or ["COLUMN"]
    fault = f"{count} columns" if count else "no column"
    return LogError(
        f"--map {key}={wanted}: {file} has {fault} of this name; its columns are " + _listed(headers),
        usually="two columns share one name; rename one."
        if count
        else "it is a matter of spelling; upper and lower case differ.",
        paste=f'--map "{key}={split_header(near[0])[0]}"',
        read=READ,
        fault="no_such_column",
    )


def _two(file: str, words: str, first: str, second: str, headers: Sequence[str]) -> LogError:
    one, other = headers
    column = split_header(other)[0] if first == second else split_header(one)[0]
    if split_header(one)[0] == split_header(other)[0]:
        column = other
    alike = one == other
    return LogError(
        f"{file} has two columns for the {words}: {shown(one)} and {shown(other)}",
        usually="the column was exported twice; one of the two must go by another name."
        if alike
        else "one is raw and one is computed; say which to use.",
        paste=f"{one} again" if alike else f'--map "{first}={column}"',
        read=READ,
        fault="two_columns",
    )


def _missing(headers: Sequence[str], file: str, found: Mapping, doubtful: set[str]) -> list[Finding]:
    missing = [name for name in ("t", "r", "U") if name not in found.keys() | doubtful]
    if not STEER & (found.keys() | doubtful):
        missing.insert(1 if "t" in missing else 0, "delta")
    if not missing:
        return []
    names = " and ".join(f"'{name}' ({QUANTITIES[name].words})" for name in missing)
    free = [one for one in headers if one not in [header for _, header in found.values()]]
    usually, paste = other_name(free, missing, nothing_known=not found)
    error = LogError(
        f"{file} has no column for {names}; its columns are {_listed(headers)}",
        usually=usually,
        paste=paste,
        read=READ,
        fault="missing_column",
    )
    return [refusal(error)]


def _listed(headers: Sequence[str]) -> str:
    listed = ", ".join(shown(header, longest=30) for header in headers[:12])
    return listed + (f" and {len(headers) - 12} more" if len(headers) > 12 else "")


def _unit(name: str, header: str, file: str) -> Unit:
    quantity = QUANTITIES[name]
    label, text = split_header(header)
    where = f"column {shown(header)} of {file} ({quantity.words})"
    if text is None:
        in_round = re.fullmatch(r"(.*?)\s*\(([^()]*)\)", label)
        raise UnitError(
            f"{where} has no unit",
            usually="the unit is known to the logger only; write it in square brackets.",
            paste=f"{in_round.group(1)} [{in_round.group(2)}]" if in_round
            else f"{label} [{quantity.si}]",
            read='docs/logs.md, "Units"',
            fault="no_unit",
        )  # fmt: skip
    try:
        unit = unit_of(name, text)
    except UnitError as error:
        raise UnitError(
            f"{where}: {error.what}",
            usually=f"one of {quantity.examples} is meant.",
            paste=f"{label} [{quantity.si}]",
            read='docs/logs.md, "Units"',
            fault="unknown_unit",
        ) from None
    if not fits_unit(name, unit):
        of_wheel = name == "U" and unit.dimension == FREQUENCY
        raise UnitError(
            f"{where}: unit '{text}' is no unit of a {quantity.words}; {quantity.examples} are",
            usually="it is how fast a wheel turns; the speed is that times its radius, 0.3 m for a car."
            if of_wheel
            else "another quantity is stored under this name, or a '/s' was lost.",
            paste=f'log["U [m/s]"] = log["{header}"] * {unit.factor:.6g} * 0.31'
            if of_wheel
            else f"{label} [{quantity.si}]",
            read='docs/logs.md, "Units"',
            fault="wrong_dimension",
        )
    return unit
