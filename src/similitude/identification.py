"""The one call of the library: a log and a vehicle in, a Run out.

Invariant: an estimator is imported when it is asked for, so none pays for another.
"""

from __future__ import annotations

from similitude.errors import UsageError
from similitude.log import Log
from similitude.run import Run
from similitude.vehicle_file import Vehicle


def identify(log: Log, vehicle: Vehicle, *, estimator: str = "population") -> Run:
    """Identify the tyre stiffness of a vehicle from a log.

    Parameters
    ----------
    log : Log            t [s], delta [rad], r [rad/s], U [m/s].
    vehicle : Vehicle    with a wheelbase.
    estimator : ``population`` (default) or ``paper``.

    Returns
    -------
    Run                  the estimate over time, its worth, and what it rests on.

    Raises
    ------
    UsageError           the wheelbase is missing or the estimator has another name.

    References
    ----------
    Brennan & Alleyne 2004 for the method; docs/identify.md for what the numbers mean.
    """
    if estimator == "population":
        from similitude.identify_population import identify_population

        return identify_population(log, vehicle)
    if estimator == "paper":
        from similitude.identify_paper import identify_paper

        return identify_paper(log, vehicle)
    raise UsageError(
        f"there is no estimator {estimator!r} (there are population, paper)",
        usually="the name was misspelt.",
        paste='identify(log, vehicle, estimator="population")',
        read='docs/identify.md, "Estimators"',
    )
