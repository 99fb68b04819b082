"""A Run as one page on the terminal: the answer first, then what it rests on.

Invariant: fits 80 columns; every number that entered without being measured is listed with where it
came from.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from rich.console import Console, Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from similitude.report.alarm_words import alarm_lines, known_lines
from similitude.report.cost_curve import cost_curve
from similitude.report.numerals import (
    for_people,
    narrower,
    plain,
    pretty_name,
    pretty_unit,
    stated,
    uncertain,
)

if TYPE_CHECKING:
    from similitude.run import Run

VERDICT_STYLES = {
    "identified": "bold white on green4",
    "weak": "bold black on orange3",
    "not_excited": "bold white on grey42",
    "outside_model": "bold white on dark_orange3",
    "outside_population": "bold white on purple4",
    "bad_data": "bold white on dark_red",
    "diverged": "bold white on dark_red",
}
PREDICTORS = {
    "estimate": "the estimate of that moment",
    "frozen_averages": "the average vehicle, offset and bias followed",
    "averages_with_lag": "the same with this log's steer lag",
    "batch": "one car fitted to the whole log, offset and bias too",
    "kinematic": "U δ / L, tyres that do not slip",
}
HEADING, QUIET, VALUE = "bold cyan", "dim", "bold"


def print_run(run: Run, console: Console, *, files: Mapping[str, str] | None = None) -> None:
    """Print the page.

    Parameters
    ----------
    run : Run
        A finished identification.
    console : rich.console.Console
        Where to print; its width decides the line breaks.
    files : mapping of str to str, optional
        Kind of file to the path it was written to.
    """
    console.print(page(run, files=files))


def page(run: Run, *, files: Mapping[str, str] | None = None) -> Group:
    """Compose the page: verdict, answer, handling, groups, nuisances, lag, assumed, warnings.

    Parameters
    ----------
    run : Run
        A finished identification.
    files : mapping of str to str, optional
        Kind of file to the path it was written to.

    Returns
    -------
    rich.console.Group
        Renderable at any width from 80 columns.
    """
    parts = [_title(run), _verdict(run), _section("Front tyres", _answer(run))]
    if run.alarms:
        parts.append(_section("Changes", _bullets(alarm_lines(run)), style="bold red"))
    if run.information:
        parts.append(_section("Known so far", _bullets(known_lines(run))))
    if run.handling:
        parts.append(_section("Handling", _handling(run.handling)))
    if run.groups:
        parts.append(_section("Groups", _groups(run)))
    if run.nuisance:
        parts.append(_section("Estimated alongside", _nuisance(run)))
    parts.append(_section("Steering lag", cost_curve(run.lag)))
    if run.prediction:
        parts.append(_section("Prediction of the yaw rate", _prediction(run.prediction)))
    if run.assumed:
        parts.append(_section("Taken as given", _assumed(run)))
    if run.log.fixes:
        parts.append(_section("Repaired as asked", _bullets(run.log.fixes), style="bold yellow"))
    if run.warnings:
        parts.append(_section("Warnings", _bullets(run.warnings), style="bold yellow"))
    if files:
        parts.append(_section("Written", _files(files)))
    return Group(*parts)


def _title(run: Run) -> Text:
    about = f"  {run.vehicle.name} · {run.log.duration:.1f} s at {run.log.rate:.0f} Hz"
    about += f" · {run.estimator}"
    return Text.assemble(("\n" + str(run.log.name), VALUE), (about, QUIET))


def _verdict(run: Run) -> Table:
    """The verdict as a coloured word; the reason beside it, wrapped under itself."""
    table = Table.grid(padding=(0, 2, 0, 0))
    style = VERDICT_STYLES.get(run.verdict, "bold reverse")
    table.add_row(Text(f" {run.verdict.replace('_', ' ')} ", style=style), Text(run.reason))
    return table


def _section(title: str, body, *, style: str = HEADING) -> Group:
    return Group(Text("\n" + title, style=style), Padding(body, (0, 0, 0, 2)))


def _answer(run: Run) -> Table:
    table = _grid(header=True)
    for title in ("", "value ± sd", "95 %", ""):
        table.add_column(title, header_style=QUIET)
    _add_estimate(table, "K", run.K, "= Caf L / m at the end of the log")
    value, std = uncertain(run.pi3["value"], run.pi3["std"])
    at_speed = f"= K / U² at {run.pi3['at_speed']:.1f} m/s"
    table.add_row(Text("π3"), _plus_minus(value, std, ""), "", Text(at_speed, style=QUIET))
    if run.batch is not None and run.estimator != "batch":
        _add_estimate(table, "K, all", run.batch.K, "one car fitted to the whole log")
    if run.cross_check is not None:
        _add_estimate(table, "K, 2nd", run.cross_check.K, "from what a steer does at once")
    if run.Caf is not None:
        _add_estimate(table, "Caf", run.Caf, "both front tyres, given m, L")
    return table


def _add_estimate(table: Table, name: str, found, meaning: str) -> None:
    value, std = uncertain(found.value, found.std)
    low, high = (uncertain(edge, found.std)[0] for edge in (found.lo, found.hi))
    table.add_row(
        Text(name),
        _plus_minus(value, std, pretty_unit(found.unit)),
        Text(f"{low} … {high}", no_wrap=True),
        Text(meaning, style=QUIET),
    )


def _handling(handling: Mapping) -> Table:
    table = _grid(header=True)
    for title in ("", "value ± sd", "95 %"):
        table.add_column(title, header_style=QUIET, no_wrap=True)
    table.add_column()
    for name, found in handling.items():
        low, high = (uncertain(found[edge], found["std"])[0] for edge in ("lo", "hi"))
        table.add_row(
            Text(pretty_name(name)),
            _quantity(found["value"], found["std"], found["unit"]),
            Text(f"{low} … {high}", no_wrap=True),
            Text(found["meaning"], style=QUIET),
        )
    return table


def _groups(run: Run) -> Table:
    table = _grid(header=True)
    for title in ("", "now", "population", "narrower", "meaning"):
        table.add_column(title, header_style=QUIET)
    for name, group in run.groups.items():
        table.add_row(
            Text(pretty_name(name)),
            _plus_minus(*uncertain(group.value, group.std), ""),
            _plus_minus(*uncertain(group.prior_value, group.prior_std), "", style=""),
            Text(f"{100 * narrower(group):.0f} %", justify="right"),
            Text(group.meaning, style=QUIET),
        )
    return table


def _nuisance(run: Run) -> Table:
    table = _grid()
    for name, found in run.nuisance.items():
        table.add_row(Text(pretty_name(name)), _quantity(found.value, found.std, found.unit))
    return table


def _prediction(prediction: Mapping) -> Table:
    """Error of the yaw rate predicted over the horizon, a row for each that predicted."""
    table = _grid(header=True)
    horizon = f"rms error {plain(prediction['horizon_s'], 2)} s ahead"
    for title in ("", horizon, f"{prediction['predictions']} times"):
        table.add_column(title, header_style=QUIET)
    for name, rms in prediction["rms"].items():
        value, unit = (None, "") if rms is None else for_people(rms, prediction["unit"])
        shown = Text("–") if value is None else Text(f"{plain(value)} {pretty_unit(unit)}", style=VALUE)
        table.add_row(Text(pretty_name(name)), shown, Text(PREDICTORS.get(name, ""), style=QUIET))
    return table


def _assumed(run: Run) -> Table:
    table = _grid()
    for name, given in run.assumed.items():
        table.add_row(Text(name), _given(given), Text(given.origin, style=QUIET))
    return table


def _given(given) -> Text:
    if given.value is None:
        return Text("–")
    if isinstance(given.value, str):
        return Text(given.value)
    number, unit = for_people(float(given.value), given.unit)
    return Text(f"{stated(number)} {pretty_unit(unit)}".rstrip(), no_wrap=True)


def _bullets(lines) -> Table:
    table = Table.grid(padding=(0, 1, 0, 0))
    for line in lines:
        table.add_row("•", Text(line))
    return table


def _files(files: Mapping[str, str]) -> Table:
    table = _grid()
    for kind, path in files.items():
        table.add_row(Text(kind), Text(str(path), overflow="fold"))
    return table


def _grid(*, header: bool = False) -> Table:
    return Table(box=None, show_header=header, padding=(0, 2, 0, 0), pad_edge=False)


def _quantity(value: float, std: float, unit: str) -> Text:
    shown, unit_shown = for_people(value, unit)
    return _plus_minus(*uncertain(shown, for_people(std, unit)[0]), pretty_unit(unit_shown))


def _plus_minus(value: str, std: str, unit: str, *, style: str = VALUE) -> Text:
    return Text.assemble((value, style), f" ± {std} {unit}".rstrip(), no_wrap=True)
