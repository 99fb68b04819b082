"""Would the whole log be better explained were its speed in another unit?

A speed too small by 1.6 asks for a car that oversteers, or for stiff tyres, a small inertia and an odd steer
scale at once: each within what the population has, all of them together not. Two whole-log fits compare,

    gain = (c - c')/w + (d^2 - d'^2)/2 + (ln |P'| - ln |P|)/2      [-], log of the odds

    c   cost of the innovations of the rows that both fits used; c' with the other unit
    d^2 squared distance of the fitted car from the middle of its prior, in sd;  P covariance of the fit
    w   by how much the information is overstated (`BatchFit.widened`), the larger of the two

Invariant: only said; nothing is fitted again where the first fit found a usual car that explains the log.
Lateral acceleration is not asked: quick steering at speed makes it 0.7 of U r, and then a speed too small by
1.6 hides.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from similitude.batch_fit import ROUGH_RATE, BatchFit, climb_roughly, fit_batch
from similitude.batch_slopes import OUTLIER, Whitened, whiten
from similitude.errors import shown
from similitude.filter_run import side_by_side
from similitude.finding import Finding
from similitude.identify_setup import Prepared, whole_log
from similitude.log import Log
from similitude.log_quantities import split_header
from similitude.log_response import SPEEDS
from similitude.units import parse_unit

UNUSUAL = 2.0  # d^2: two drives of three; it is 6 on average where a log tells all
UNEXPLAINED = 2.0  # w
USUAL = (
    12.0  # d'^2, or less than d^2: another unit must not need an odder car; of a command, less in any case
)
EXPLAINED = 3.0  # w'
LEAST_GAIN = 2.0  # odds of seven to one, for a word
ROUGH = 2.0  # by how much a rough climb may be against a unit that the fit would be for
SHARED = 0.9  # of the rows that taught; below, the car would be too slow for its tyres to show
LONGEST = 60.0  # s of the log that are fitted again: those in which most was steered

# Speeds that somebody divided by 3.6 because they were to be in km/h: (SI value of 1 m/s of the header, unit)
CONVERTED = ((3.6 * 0.44704, "mph"), (1.852, "knots"))

READ = 'docs/logs.md, "Faults of units and signs"'


def speed_unit_doubts(ready: Prepared, batch: BatchFit | None) -> tuple[Finding, ...]:
    """Fit the whole log with its speed in other units, where the car found is an odd one.

    Parameters
    ----------
    ready : Prepared      the log with prior, noise and lag
    batch : BatchFit      of the log as it stands; None where there is no compiler, and nothing is said

    Returns
    -------
    tuple of Finding      ``speed_unit`` with the unit under which the log is far more likely, or nothing
    """
    if batch is None or _is_plain(batch):
        return ()
    log = ready.setup.log
    if log.duration > LONGEST:
        ready = replace(ready, setup=replace(ready.setup, log=_most_steered(log)))
    others = _worth_a_fit(ready, batch, _others(_claimed(log)))
    if not others:
        return ()
    if log.duration > LONGEST:
        batch = whole_log(ready, ready.setup.run())
    fits = side_by_side([lambda factor=factor: _at_other_speed(ready, factor) for factor, _, _ in others])
    room = distance(batch) if ready.commanded else max(USUAL, distance(batch))
    gains = [gain(batch, fit) if _explains(fit, room) else -np.inf for fit in fits]
    best = int(np.argmax(gains))
    if not gains[best] >= LEAST_GAIN:
        return ()
    fit, (factor, words, fix) = fits[best], others[best]
    again = fit_batch(batch.frozen, fit.x, fit.scales)  # from where the other one ended: no other optimum
    sure = min(gains[best], gain(again, fit))
    if not sure >= LEAST_GAIN:
        return ()
    header = log.sources.get("U", "U [m/s]")
    return (Finding(
        "speed_unit", False,
        f"were column {shown(header)} {words}, the whole log would be {_odds(sure)} times as "
        f"likely: the car would lie {np.sqrt(distance(fit)):.2g} sd from the population's middle instead of "
        f"{np.sqrt(distance(batch)):.2g}, with K {fit.values['K']:.3g} m^2/s^2 instead of "
        f"{batch.values['K']:.3g}",
        "the speed is in another unit than its header says.",
        f"--fix {fix}" if fix else f"log['{header}'] *= {factor:.4g}", READ,
        column=header, value=sure, fix=fix,
    ),)  # fmt: skip


def _worth_a_fit(
    ready: Prepared, batch: BatchFit, others: list[tuple[float, str, str | None]]
) -> list[tuple[float, str, str | None]]:
    """Those of the other units that a rough climb, which is lenient by `ROUGH` odds, does not rule out."""
    ready = replace(ready, setup=ready.setup.at_rate(ROUGH_RATE))  # once for all of them

    def least_cost(factor: float, start: np.ndarray) -> float:
        frozen = replace(batch.frozen, setup=_faster(ready, factor).setup)
        return climb_roughly(frozen, start, batch.scales)[1]

    middle = batch.frozen.middle
    here, *there = side_by_side(
        [lambda: least_cost(1.0, batch.x)]
        + [lambda factor=factor: least_cost(factor, middle) for factor, _, _ in others]
    )
    return [one for one, cost in zip(others, there, strict=True) if (here - cost) / batch.widened > -ROUGH]


def _others(claimed: float) -> list[tuple[float, str, str | None]]:
    """What else the speed may be: factor to multiply it by, words, and repair."""
    others = [
        (size / claimed, f"in {unit}", fix) for size, unit, fix in SPEEDS if not np.isclose(size, claimed)
    ]
    if np.isclose(claimed, 1.0):
        others += [(factor, f"from {unit} that were taken for km/h", None) for factor, unit in CONVERTED]
    return others


def distance(batch: BatchFit) -> float:
    """Squared distance of the fitted car, steer scale and lag from the middle of their prior [-]."""
    away = batch.x - batch.frozen.middle
    return float(away @ np.linalg.solve(batch.frozen.prior.covariance, away))


def gain(batch: BatchFit, other: BatchFit) -> float:
    """Logarithm of the odds of another fit to the same rows against this one [-]; none where it has few."""
    here, there = (whiten(one.frozen, one.x, one.scales) for one in (batch, other))
    both = here.done.used & there.done.used
    if both.sum() < SHARED * here.done.used.sum():
        return -np.inf
    widened = max(batch.widened, other.widened)
    occam = np.linalg.slogdet(other.covariance)[1] - np.linalg.slogdet(batch.covariance)[1]
    data = float(np.sum((_loss(here) - _loss(there))[both])) / widened
    return data + 0.5 * (distance(batch) - distance(other) + float(occam))


def _is_plain(batch: BatchFit) -> bool:
    return distance(batch) < UNUSUAL and batch.widened < UNEXPLAINED


def _explains(fit: BatchFit, room: float) -> bool:
    """Whether a car that is usual enough explains the log; a model wrong elsewhere is mended by no unit."""
    return fit.settled and fit.widened < EXPLAINED and distance(fit) < room


def _most_steered(log: Log) -> Log:
    """The stretch of `LONGEST` in which the steer moved most."""
    steered = np.nan_to_num(log.delta - np.nanmedian(log.delta)) ** 2 * np.maximum(np.nan_to_num(log.U), 0)
    total = np.concatenate([[0.0], np.cumsum(steered)])
    ends = np.searchsorted(log.t, log.t + LONGEST, side="right")
    first = int(np.argmax(total[ends] - total[:-1]))
    rows = slice(first, int(ends[first]))
    columns = {name: getattr(log, name)[rows] for name in ("t", "delta", "r", "U")}
    return replace(log, ay=None if log.ay is None else log.ay[rows], **columns)


def _loss(one: Whitened) -> np.ndarray:
    """Negative log likelihood of each row, an innovation beyond three sd as in the fit, (n,)."""
    size = one.e**2 / one.S
    beyond = np.maximum(size, OUTLIER)
    return 0.5 * (np.minimum(size, OUTLIER) + OUTLIER * np.log(beyond / OUTLIER) + np.log(one.S))


def _faster(ready: Prepared, factor: float) -> Prepared:
    log = ready.setup.log
    return replace(ready, setup=replace(ready.setup, log=replace(log, U=log.U * factor)))


def _at_other_speed(ready: Prepared, factor: float) -> BatchFit:
    ready = _faster(ready, factor)
    return whole_log(ready, ready.setup.run())


def _claimed(log: Log) -> float:
    """The unit in which the speed was read [m/s]: that of the repair asked for, or of its header."""
    header = log.sources.get("U", "").removesuffix(" (--map)")
    unit = split_header(header)[1] or "m/s"
    for said in log.fixes:
        changed, _, other = said.rpartition(" read as ")
        unit = other if changed.endswith(f" of {header}") else unit
    return parse_unit(unit).factor


def _odds(gain: float) -> str:
    return f"{np.exp(gain):.2g}" if gain < 9 else "many thousand"
