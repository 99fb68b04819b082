"""From a table of a scenario file to a frozen dataclass; each key is declared beside its field.

Invariant: a key that is not known, a value without its unit and a value outside its bounds are
refused with the line to write; what a table does not say has the default of its dataclass, and a
field without one must be said.
"""

from __future__ import annotations

import dataclasses
import difflib
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NoReturn

from similitude.dimension import Dimension
from similitude.errors import ScenarioError, UnitError, shown
from similitude.units import parse_quantity

NUMBER = Dimension.none
ANGLE = "angle"  # an angle has no dimension, and must all the same have a unit
READ = 'docs/simulate.md, "Scenario files"'


@dataclass(frozen=True)
class Key:
    """What a key of a table may hold.

    Parameters
    ----------
    example : str           a value as TOML: ``'"20 mrad"'``
    of : Dimension or str   what it measures: a dimension, NUMBER, ANGLE, or "text", "choice",
                            "numbers" (a list of values of dimension `each`), "table", "tables"
    words : str             what it is, for messages and documentation
    least, most : float     bounds in SI, both allowed
    each : Dimension or None
    choices : tuple of str  the words it may be
    inside : type or None   the dataclass of a table
    """

    example: str
    of: Any
    words: str = ""
    least: float = -math.inf
    most: float = math.inf
    each: Any = None
    choices: tuple[str, ...] = ()
    inside: type | None = None


def key(example: str, of: Any, words: str = "", *, default: Any = dataclasses.MISSING, **bounds: Any) -> Any:
    """Declare a dataclass field that a scenario file may set; without `default` it must."""
    return field(default=default, metadata={"key": Key(example, of, words, **bounds)})


def choice(*choices: str, words: str = "", default: Any = dataclasses.MISSING) -> Any:
    """Declare a field that is one of a few words."""
    return key(f'"{choices[0]}"', "choice", words, default=default, choices=choices)


def table(inside: type, words: str = "", *, default: Any = None) -> Any:
    """Declare a field that is a table of its own; `default` where it is not there."""
    return key("", "table", words, default=default, inside=inside)


def tables(inside: type, words: str = "") -> Any:
    """Declare a field that is a list of tables; empty where there is none."""
    return key("", "tables", words, default=(), inside=inside)


@dataclass(frozen=True)
class Place:
    """Where in which file a table stands, for messages.

    Parameters
    ----------
    file : str     name of the file
    text : str     its text
    section : str  dotted name of the table, empty at the top
    """

    file: str
    text: str
    section: str = ""

    def within(self, name: str) -> Place:
        """Return the place of a table inside this one."""
        return Place(self.file, self.text, f"{self.section}.{name}" if self.section else name)

    def of(self, name: str) -> str:
        """Return file, line and section of a key as a message begins."""
        line = _line_of(self.text, self.section, name)
        section = f" [{self.section}]" if self.section else ""
        return f"{self.file}{f' line {line}' if line else ''}{section}"


def keys_of(kind: type) -> dict[str, Key]:
    """Return the keys of a dataclass by name."""
    return {one.name: one.metadata["key"] for one in dataclasses.fields(kind) if "key" in one.metadata}


def read_table(kind: type, given: object, place: Place) -> Any:
    """Read a table into its dataclass.

    Parameters
    ----------
    kind : type         a frozen dataclass whose fields were declared with `key` and its kin
    given : object      what the file holds there
    place : Place

    Returns
    -------
    instance of `kind`, values in SI

    Raises
    ------
    ScenarioError
        It is no table; a key is not known, is missing, or has a value that it cannot have.
    """
    known = keys_of(kind)
    if not isinstance(given, Mapping):
        first = next(iter(known))
        raise ScenarioError(
            f"{place.of('')}: {place.section or 'the file'} = {shown(given)} is no table",
            usually="its values belong below a line of their own with the name in brackets.",
            paste=f"[{place.section}]  then  {first} = {known[first].example}",
            read=READ,
        )
    for name in given:
        if name not in known:
            raise _unknown(name, known, place)
    values = {}
    for one in dataclasses.fields(kind):
        if one.name in given:
            values[one.name] = _value(one.name, given[one.name], known[one.name], place)
        elif one.default is dataclasses.MISSING and one.default_factory is dataclasses.MISSING:
            wanted = known[one.name]
            raise ScenarioError(
                f"{place.of('')}: {one.name} is missing" + (f" ({wanted.words})" if wanted.words else ""),
                usually="the line was left out; there is no value that would suit every scenario.",
                paste=f"{one.name} = {wanted.example}",
                read=READ,
            )
    return kind(**values)


def read_kind(kinds: Mapping[str, type], given: object, place: Place) -> Any:
    """Read a table whose key ``kind`` says which of several dataclasses it is."""
    named = given.get("kind") if isinstance(given, Mapping) else None
    if named not in kinds:
        near = difflib.get_close_matches(str(named), kinds, n=1, cutoff=0.0)[0]
        what = "has no 'kind'" if named is None else f"kind = {shown(named)} is not known"
        raise ScenarioError(
            f"{place.of('kind')}: {what}; there are {', '.join(kinds)}",
            usually="it is a matter of spelling." if named is not None else "the line was left out.",
            paste=f'kind = "{near}"',
            read=READ,
        )
    rest = {name: value for name, value in given.items() if name != "kind"}
    if rest and not keys_of(kinds[named]):
        refuse(
            place, next(iter(rest)),
            f"{', '.join(map(shown, rest))} cannot be said of {place.section} kind = {shown(named)}, which "
            "has no keys of its own",
            usually="the kind was changed and the keys of the other kind were left: delete their lines, or "
            "set the whole section anew.",
            paste=f"--set '{place.section}={{ kind = \"{named}\" }}'",
        )  # fmt: skip
    return read_table(kinds[named], rest, place)


def refuse(place: Place, name: str, what: str, *, usually: str, paste: str) -> NoReturn:
    """Raise a ScenarioError for one key of a table."""
    raise ScenarioError(f"{place.of(name)}: {what}", usually=usually, paste=paste, read=READ)


def _value(name: str, raw: object, wanted: Key, place: Place) -> Any:
    if wanted.of == "table":
        return read_table(wanted.inside, raw, place.within(name))
    if wanted.of == "tables":
        if not isinstance(raw, Sequence) or isinstance(raw, str):
            raw = [raw]
        return tuple(read_table(wanted.inside, one, place.within(name)) for one in raw)
    if wanted.of == "numbers":
        if not isinstance(raw, Sequence) or isinstance(raw, str) or not raw:
            _no_value(name, raw, wanted, place)
        return tuple(_quantity(name, one, wanted.each, wanted, place) for one in raw)
    if wanted.of in ("text", "choice"):
        return _word(name, raw, wanted, place)
    return _quantity(name, raw, wanted.of, wanted, place)


def _word(name: str, raw: object, wanted: Key, place: Place) -> str:
    if not isinstance(raw, str):
        _no_value(name, raw, wanted, place)
    if wanted.choices and raw not in wanted.choices:
        near = difflib.get_close_matches(raw, wanted.choices, n=1, cutoff=0.0)[0]
        refuse(
            place, name, f"{name} = {shown(raw)} is not known; there are {', '.join(wanted.choices)}",
            usually="it is a matter of spelling.", paste=f'{name} = "{near}"',
        )  # fmt: skip
    return raw


def _quantity(name: str, raw: object, of: Any, wanted: Key, place: Place) -> float:
    is_number = isinstance(raw, (int, float)) and not isinstance(raw, bool)
    if is_number and of == NUMBER:
        raw = str(raw)
    if not isinstance(raw, str):
        _no_value(name, raw, wanted, place)
    try:
        value, unit = parse_quantity(raw, expect=NUMBER if of == ANGLE else of)
    except UnitError as error:
        refuse(place, name, f"{name}: {error.what}", usually=error.usually,
               paste=f"{name} = {wanted.example}")  # fmt: skip
    if of == ANGLE and not unit.is_angle:
        _no_value(name, raw, wanted, place)
    if not wanted.least <= value <= wanted.most:
        refuse(
            place, name, f"{name} = {raw} lies outside {wanted.least:g} to {wanted.most:g} (SI)",
            usually="a digit, a sign or the unit is wrong.", paste=f"{name} = {wanted.example}",
        )  # fmt: skip
    return value


def _no_value(name: str, raw: object, wanted: Key, place: Place) -> NoReturn:
    is_word = wanted.of in ("text", "choice")
    refuse(
        place, name, f"{name} = {shown(raw)} is no {'text' if is_word else 'value with a unit'}",
        usually="the quotes are missing." if is_word
        else "a value is text in quotes: a number, a blank and a unit.",
        paste=f"{name} = {wanted.example}",
    )  # fmt: skip


def _unknown(name: str, known: Mapping[str, Key], place: Place) -> ScenarioError:
    near = difflib.get_close_matches(name.lower(), known, n=1, cutoff=0.0)[0]
    meant = known[near]
    is_table = meant.of in ("table", "tables")
    section = f"{place.section}.{near}" if place.section else near
    brackets = f"[[{section}]]" if meant.of == "tables" else f"[{section}]"
    return ScenarioError(
        f"{place.of(name)}: key {shown(name)} is not known; did you mean '{near}'?",
        usually="it is a matter of spelling, or the line stands in another section than it should; "
        f"known here are {', '.join(known)}.",
        paste=brackets if is_table else f"{near} = {meant.example}",
        read=READ,
    )


def _line_of(text: str, section: str, name: str) -> int | None:
    """Line on which a key, or the section itself, is first written; None where it is not."""
    here, head = "", None
    for number, line in enumerate(text.splitlines(), start=1):
        title = re.match(r"\s*\[\[?\s*([\w.\-\" ]+?)\s*\]", line)
        if title:
            here = title.group(1).replace('"', "").replace(" ", "")
            head = number if here == section and head is None else head
            if name and here == (f"{section}.{name}" if section else name):
                return number
        elif name and here == section and re.match(rf"\s*[\"']?{re.escape(name)}[\"']?\s*[=.]", line):
            return number
    return head
