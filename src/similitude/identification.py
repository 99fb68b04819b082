"""The one call of the library: a log and a vehicle in, a Run out.

Invariant: an estimator is imported when it is asked for, so none pays for another.
"""

from __future__ import annotations

from dataclasses import replace

from similitude.errors import UsageError
from similitude.log import Log
from similitude.run import Assumed, Run
from similitude.saved_state import SavedState
from similitude.slow_bus import bridged, held_columns, without_lines, without_repeats
from similitude.steer_scale_doubt import steer_scale_doubts
from similitude.stiffness_doubt import stiffness_doubts
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import wheelbase


def identify(
    log: Log,
    vehicle: Vehicle,
    *,
    estimator: str = "population",
    spacing: float | None = None,
    state: SavedState | None = None,
) -> Run:
    """Identify the tyre stiffness of a vehicle from a log.

    Parameters
    ----------
    log : Log            t [s], delta [rad], r [rad/s], U [m/s].
    vehicle : Vehicle    with a wheelbase.
    estimator : ``population`` (default), ``batch``, ``robust``, ``output_error``, ``band`` or ``paper``.
    spacing : float      estimate from rows at equal distances of so many metres instead of from
                         those of the log; the Run still has one row for each row of the log.
    state : SavedState   where an earlier drive left the population filter; the Run's ``memory`` is the
                         next one.

    Returns
    -------
    Run                  the estimate over time, its worth, and what it rests on.

    Raises
    ------
    UsageError           the wheelbase is missing, the estimator has another name, or the spacing
                         does not suit the wheelbase, the log or the estimator; a state was given to
                         an estimator or rows that cannot take it up.
    StateError           the state was saved for something else, or after this log.

    References
    ----------
    Brennan & Alleyne 2004 for the method; docs/identify.md for what the numbers mean.
    """
    if state is not None and (estimator != "population" or spacing is not None):
        raise _no_state_there(estimator)
    if spacing is not None:
        return _by_distance(log, vehicle, estimator, spacing)
    run = _by_time(log, vehicle, estimator, state)
    doubts = (*steer_scale_doubts(log, vehicle), *stiffness_doubts(vehicle, run.K))
    return replace(run, warnings=(*run.warnings, *doubts))


def _no_state_there(estimator: str) -> UsageError:
    how = "rows at equal distances" if estimator == "population" else f"--estimator {estimator}"
    return UsageError(
        f"a state was given together with {how}",
        usually="only the population filter by time goes on where an earlier drive stopped.",
        paste="similitude identify log.csv --vehicle car.toml --state car.json",
        read="docs/state.md",
    )


def _by_time(log: Log, vehicle: Vehicle, estimator: str, state: SavedState | None) -> Run:
    if estimator == "population":
        from similitude.identify_population import identify_population

        return identify_population(log, vehicle, state)
    if estimator == "batch":
        from similitude.identify_batch import identify_batch

        return identify_batch(log, vehicle)
    if estimator == "paper":
        from similitude.identify_paper import identify_paper

        return identify_paper(log, vehicle)
    if estimator in ("robust", "output_error", "band"):
        from similitude.identify_ladder import identify_ladder

        return identify_ladder(log, vehicle, estimator=estimator)
    raise UsageError(
        f"there is no estimator {estimator!r} "
        "(there are population, batch, robust, output_error, band, paper)",
        usually="the name was misspelt.",
        paste='identify(log, vehicle, estimator="population")',
        read='docs/identify.md, "Estimators"',
    )


def _by_distance(log: Log, vehicle: Vehicle, estimator: str, spacing: float) -> Run:
    """The same on rows at equal distances, told at the rows of the log."""
    from similitude.distance_sampling import at_rows_of, by_distance

    if estimator in ("paper", "band", "robust"):
        raise UsageError(
            f"the filters of {estimator!r} take rows at equal times only; a spacing was asked for",
            usually="they are designed in Hz; the population filter takes either.",
            paste='identify(log, vehicle, spacing=0.4, estimator="population")',
            read='docs/filter.md, "Sampling by distance"',
        )
    readings = without_lines(log)
    readings = bridged(without_repeats(readings, held_columns(readings)))
    rows = by_distance(readings, spacing, wheelbase=wheelbase(vehicle))
    run = identify(rows, vehicle, estimator=estimator)
    assumed = {**run.assumed, "spacing": Assumed(spacing, "m", "the call: a row for each such distance")}
    return at_rows_of(replace(run, assumed=assumed, memory=None), log)
