"""An Inspection as one page on the terminal: what is wrong first, then column by column.

Invariant: fits 80 columns; a value nobody could work out is a dash.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from rich.console import Console, Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from similitude.inspection.advice import MEANING, UNITS, doubtful, outlook, percent, relations
from similitude.inspection.excitation import KINDS, seconds_by_kind
from similitude.report.numerals import DEGREES_PER_RADIAN, plain, pretty_name, pretty_unit

if TYPE_CHECKING:
    from similitude.finding import Finding
    from similitude.inspection.channels import Channel
    from similitude.inspection.inspection import Inspection

HEADING, QUIET, VALUE = "bold cyan", "dim", "bold"
VERDICTS = {
    "identified": ("can be identified", "bold white on green4"),
    "weak": ("can be identified weakly", "bold black on orange3"),
    "not_excited": ("nothing to learn", "bold white on grey42"),
}
DOUBTED = "bold black on orange3"
REFUSED = ("refused by identify", "bold white on dark_red")
LOOKED = ("looked over", "bold white on grey42")
KIND_STYLES = {
    "missing": ("·", "dim"),
    "standing": ("_", "dim"),
    "reverse": ("<", "magenta"),
    "beyond_linear": ("▇", "bold red"),
    "straight": ("▁", "cyan"),
    "steered": ("▄", "bold green"),
}
SHORT = {
    "t": "time",
    "delta": "steer",
    "steering_wheel": "wheel",
    "r": "yaw rate",
    "U": "speed",
    "ay": "lat. acc.",
}
STRIP = 60  # characters of the map
WORD_STYLES = {"shown": "bold green", "a little": "yellow", "not shown": "dim"}
LONGEST_HEADER = 16
MOST_COLUMNS = 40


def print_inspection(look: Inspection, console: Console) -> None:
    """Print the page on a console, whose width decides the line breaks."""
    console.print(inspection_page(look))


def inspection_page(look: Inspection) -> Group:
    """Compose the page: outlook, findings, columns, clock, relations, map, unknowns.

    Parameters
    ----------
    look : Inspection    a log that was looked over

    Returns
    -------
    rich.console.Group   renderable at any width from 80 columns
    """
    parts = [_title(look), _headline(look)]
    if look.findings:
        parts.append(_section("Findings", _findings(look.findings), style="bold yellow"))
    parts.append(_section("Columns", _columns(look)))
    if look.clock is not None:
        parts.append(_section("Clock", Text(_clock(look))))
    rows = relations(look)
    if rows:
        parts.append(_section("Relations (± one sd)", _rows(rows)))
    if look.windows:
        parts.append(_section("The drive, two seconds a step", _map(look)))
    if look.prospects is not None:
        parts.append(_section("What it can show", _unknowns(look)))
    if look.missing:
        parts.append(_section("Left unsaid", Group(*(Text(line) for line in look.missing))))
    return Group(*parts)


def _title(look: Inspection) -> Text:
    about = "" if look.clock is None else (
        f"  {look.clock.rows} rows · {plain(look.clock.duration)} s at {plain(look.clock.rate)} Hz"
    )  # fmt: skip
    vehicle = f" · {look.vehicle.name}" if look.vehicle else " · no vehicle file"
    return Text.assemble(("\n" + look.survey.path.name, VALUE), (about + vehicle, QUIET))


def _headline(look: Inspection) -> Table:
    """A coloured word, and the sentences about K beside it."""
    plan = look.prospects
    word, style = REFUSED if look.survey.certain else LOOKED if plan is None else VERDICTS[plan.verdict]
    said = outlook(plan) if plan is not None else _counted(look.findings)
    doubt = doubtful(look)
    if doubt:
        word, style, said = f"{word}, in doubt", DOUBTED, (doubt, *said)
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_row(Text(f" {word} ", style=style), Text(" ".join(said)))
    return table


def _counted(findings: tuple[Finding, ...]) -> tuple[str, ...]:
    count = Counter("for which identify refuses it" if one.certain else "to know" for one in findings)
    return tuple(f"{number} finding{'s' * (number > 1)} {words}." for words, number in count.items())


def _section(title: str, body, *, style: str = HEADING) -> Group:
    return Group(Text("\n" + title, style=style), Padding(body, (0, 0, 0, 2)))


def _grid(*titles: str, gap: int = 2) -> Table:
    table = Table(box=None, show_header=bool(titles), padding=(0, gap, 0, 0), pad_edge=False)
    for title in titles:
        table.add_column(title, header_style=QUIET)
    return table


def _findings(findings: tuple[Finding, ...]) -> Table:
    """Each with its severity and its four parts; the line to paste stays whole."""
    table = Table.grid(padding=(0, 1, 0, 0))
    for one in findings:
        severity = Text("refuses", style="bold red") if one.certain else Text("likely", style="yellow")
        rest = f"\n{one.usually}\nPaste: {one.paste}\nRead:  {one.read}"
        table.add_row(severity, Text.assemble((one.what, VALUE), (rest, QUIET)))
    return table


def _columns(look: Inspection) -> Group:
    table = _grid("column", "is", "range", "mean", "noise", "grid", "new", "lacks", gap=1)
    for one in look.channels[:MOST_COLUMNS]:
        table.add_row(*_column(one, look))
    more = len(look.channels) - MOST_COLUMNS
    return Group(table, *([Text(f"and {more} more, in --json", style=QUIET)] if more > 0 else []))


def _column(one: Channel, look: Inspection) -> tuple[Text, ...]:
    name = one.header if len(one.header) <= LONGEST_HEADER else one.header[: LONGEST_HEADER - 1] + "…"
    words = SHORT[one.taken_for] if one.taken_for else "not used"
    if one.low is None:
        cells = ["no numbers", "", "", "", ""]
    else:
        step = look.clock.step * one.hold if look.clock else 0.0
        noise = "–" if not one.noise else f"{'<' if one.noise_is_bound else ''}{plain(one.noise, 2)}"
        cells = [
            _range(one),
            _short(one.mean),
            noise,
            plain(one.resolution, 2) if one.resolution else "–",
            f"{plain(1000 * step, 2)} ms {100 * one.fresh:3.0f} %" if step > 0 else "–",
        ]
    lacks = _share(one.missing) if one.missing else ""
    return (
        Text(name, style=VALUE if one.taken_for else "", no_wrap=True),
        Text(words, style="" if one.taken_for else QUIET, no_wrap=True),
        *(Text(cell, no_wrap=True) for cell in (*cells, lacks)),
    )


def _range(one: Channel) -> str:
    """Least and largest value; of a clock that counts from long ago the least, and how long it runs."""
    if one.taken_for == "t" and abs(one.low) > 1e5:
        return f"{_short(one.low)} + {_short(one.high - one.low)}"
    return f"{_short(one.low)} … {_short(one.high)}"


def _short(value: float) -> str:
    """Two digits, and every digit of a number of three and four before the point; a power from 100 000 on."""
    if abs(value) >= 1e5:
        return f"{value:.2g}".replace("e+0", "e").replace("e+", "e").replace("-", "−")
    return plain(value, 2 if abs(value) < 100 else 4)


def _share(share: float) -> str:
    return f"{100 * share:.0f} %" if share >= 0.01 else f"{100 * share:.1g} %"


def _clock(look: Inspection) -> str:
    clock = look.clock
    low, usual, high = (plain(1000 * x) for x in (clock.step_low, clock.step, clock.step_high))
    parts = [f"a row every {usual} ms, 98 % of them between {low} and {high} ms"]
    for pauses, words in ((clock.gaps, "gap"), (clock.jumps, "jump")):
        if pauses:
            first = pauses[0]
            parts.append(
                f"{len(pauses)} {words}{'s' * (len(pauses) > 1)}, the largest {plain(first.length)} s after "
                f"t = {plain(first.at, 5)} s (data row {first.row})"
            )
    if clock.repeated:
        parts.append(f"{clock.repeated} times repeated")
    if clock.missing:
        parts.append(f"{clock.missing} rows without a time")
    return "; ".join([*parts, *([] if clock.gaps or clock.jumps else ["no gaps, no jumps"])]) + "."


def _rows(rows) -> Table:
    table = _grid()
    for name, value, meaning in rows:
        cells = Text(name, no_wrap=True), Text(value, style=VALUE, no_wrap=True)
        table.add_row(*cells, Text(meaning, style=QUIET))
    return table


def _map(look: Inspection) -> Group:
    """A strip of the drive, and how long it was what."""
    every = -(-len(look.windows) // STRIP)
    strip = Text(no_wrap=True)
    for i in range(0, len(look.windows), every):
        kind = Counter(one.kind for one in look.windows[i : i + every]).most_common(1)[0][0]
        strip.append(*KIND_STYLES[kind])
    if every > 1:
        strip.append(f"   {2 * every} s each", style=QUIET)
    legend = Text()
    for kind, seconds in seconds_by_kind(look.windows).items():
        if seconds:
            legend.append(*KIND_STYLES[kind]).append(f" {KINDS[kind]} {seconds:.0f} s   ")
    return Group(strip, legend)


def _unknowns(look: Inspection) -> Table:
    table = _grid("", "", "before", "after", "")
    for name in MEANING:
        one = look.prospects.unknowns[name]
        scale, unit = (DEGREES_PER_RADIAN, pretty_unit(UNITS[name])) if name in UNITS else (1.0, "")
        before, after = (
            f"± {plain(scale * sd, 2)} {unit}" if name in UNITS or name == "pi1" else percent(sd)
            for sd in (one.before, one.after)
        )
        table.add_row(
            Text(pretty_name(name) if name not in UNITS else ""),
            Text(one.word, style=WORD_STYLES[one.word]),
            *(Text(cell.strip(), no_wrap=True) for cell in (before, after)),
            Text(MEANING[name], style=QUIET),
        )
    return table
