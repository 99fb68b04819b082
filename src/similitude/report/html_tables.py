"""The tables of a Run's HTML report, each one function of what it shows.

Invariant: a number is rounded to what its deviation justifies, as on the terminal; angles are in
degrees; `record_table` alone repeats the summary with every digit.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from similitude.report.html_page import Html, interval, joined, strong, table
from similitude.report.numerals import (
    for_people,
    narrower,
    plain,
    pretty_name,
    pretty_unit,
    stated,
    uncertain,
)
from similitude.report.table import WIDEST, Z95
from similitude.report.terminal import PREDICTORS
from similitude.status import MEANING, NAMES

if TYPE_CHECKING:
    from similitude.run import Assumed, CrossCheck, Estimate, Group, Nuisance, Run


def answer_table(run: Run) -> Html:
    """K, pi3 and, where the mass is known, Caf at the end of the log."""
    rows = [_estimate_row("K", run.K, "Caf L/m at the end of the log")]
    value, std = uncertain(run.pi3["value"], run.pi3["std"])
    at_speed = f"K/U² at {run.pi3['at_speed']:.1f} m/s"
    rows.append(("π3", strong(value), std, "", "", at_speed))
    if run.Caf is not None:
        rows.append(_estimate_row("Caf", run.Caf, "both front tyres, with the stated m and L"))
    return table(["", "value", "± sd", "95 %", "unit", "meaning"], rows, numeric=(1, 2, 3))


def cross_check_table(check: CrossCheck) -> Html:
    """The filter's K over the last stretch and that of the estimator of another kind."""
    rows = [
        _estimate_row("population", check.population, "the filter, over the same stretch"),
        _estimate_row(
            "robust", check.K, f"from what a change of steer does at once; {check.unknowns} unknowns"
        ),
    ]
    return table(["", "value", "± sd", "95 %", "unit", "meaning"], rows, numeric=(1, 2, 3))


def _estimate_row(name: str, found: Estimate, meaning: str) -> tuple:
    value, std = uncertain(found.value, found.std)
    return name, strong(value), std, _from_to(found.lo, found.hi, found.std), pretty_unit(found.unit), meaning


def _from_to(low: float, high: float, std: float) -> str:
    return " … ".join(uncertain(edge, std)[0] for edge in (low, high))


def handling_table(handling: Mapping[str, Mapping[str, Any]]) -> Html:
    """What the car does, as a test report states it: value, sd, 95 % and unit of each quantity."""
    rows = []
    for name, found in handling.items():
        value, std, low, high = (
            for_people(found[key], found["unit"])[0] for key in ("value", "std", "lo", "hi")
        )
        unit = pretty_unit(for_people(0.0, found["unit"])[1]) or "–"
        shown, deviation = uncertain(value, std)
        rows.append(
            (pretty_name(name), strong(shown), deviation, _from_to(low, high, std), unit, found["meaning"])
        )
    return table(["quantity", "value", "± sd", "95 %", "unit", "what it is"], rows, numeric=(1, 2, 3))


def groups_table(groups: Mapping[str, Group]) -> Html:
    """Each slow unknown beside what the population said, and how much narrower it became."""
    rows = [
        (
            pretty_name(name),
            joined((strong(now), f" ± {now_std}")),
            f"{before} ± {before_std}",
            interval(_inside(group.value, group.std), _inside(group.prior_value, group.prior_std)),
            f"{100 * narrower(group):.0f} %",
            group.meaning,
        )
        for name, group in groups.items()
        for now, now_std in [uncertain(group.value, group.std)]
        for before, before_std in [uncertain(group.prior_value, group.prior_std)]
    ]
    head = ["", "now", "population", "95 % now over the population's", "narrower", "meaning"]
    return table(head, rows, numeric=(1, 2, 4))


def _inside(value: float, std: float) -> tuple[float, float]:
    """95 % interval of the logarithm, which is what is learnt of a positive group."""
    half = min(Z95 * std / value, WIDEST)
    return math.log(value) - half, math.log(value) + half


def nuisance_table(nuisance: Mapping[str, Nuisance]) -> Html:
    """What had to be estimated alongside."""
    rows = []
    for name, found in nuisance.items():
        value, unit = for_people(found.value, found.unit)
        shown, std = uncertain(value, for_people(found.std, found.unit)[0])
        rows.append((pretty_name(name), strong(shown), std, pretty_unit(unit) or "–"))
    return table(["", "value", "± sd", "unit"], rows, numeric=(1, 2))


def prediction_table(prediction: Mapping[str, Any]) -> Html:
    """Error of the yaw rate predicted over the horizon, a row for each that predicted."""
    rms = {name: value for name, value in prediction["rms"].items() if value is not None}
    best = min(rms.values(), default=None)
    rows = []
    for name in prediction["rms"]:
        value, unit = for_people(rms.get(name, np.nan), prediction["unit"])
        against = f"{rms[name] / best:.2f}" if best and name in rms else "–"
        cells = strong(plain(value)), against, pretty_unit(unit)
        rows.append((pretty_name(name), *cells, PREDICTORS.get(name, "")))
    return table(["predicted by", "rms error", "against the best", "unit", "which is"], rows, numeric=(1, 2))


def assumed_table(assumed: Mapping[str, Assumed]) -> Html:
    """Every number that was not in the log, and where it came from."""
    return table(["", "value", "from"], [(name, _given(one), one.origin) for name, one in assumed.items()])


def _given(given: Assumed) -> str:
    if given.value is None or isinstance(given.value, str):
        return given.value or "–"
    number, unit = for_people(float(given.value), given.unit)
    return f"{stated(number)} {pretty_unit(unit)}".rstrip()


def status_table(status: np.ndarray) -> Html:
    """What the rows of the log could teach: the share of each status that occurred."""
    count = np.bincount(status, minlength=len(NAMES))
    rows = [
        (
            name.replace("_", " "),
            f"{count[code]}",
            f"{plain(100 * count[code] / status.size, 2)} %",
            MEANING[name],
        )
        for code, name in enumerate(NAMES)
        if count[code]
    ]
    return table(["rows that were", "count", "share", "meaning"], rows, numeric=(1, 2))


def record_table(record: Mapping[str, Any]) -> Html:
    """Every entry of a summary with all its digits, under the path of its key."""
    return table(["key", "value"], list(_entries(record)))


def _entries(part: Any, path: str = "") -> Iterator[tuple[str, str]]:
    if isinstance(part, Mapping):
        for key, inner in part.items():
            yield from _entries(inner, f"{path}.{key}" if path else str(key))
    else:
        yield path, part if isinstance(part, str) else json.dumps(part, ensure_ascii=False)
