"""The change alarm over a log: the monitor's step on what the filter's pass handed out, row by row.

Invariant: the monitor sees the samples the filter saw and nothing else, so an alarm at a row rests on
that row and those before it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.filter_run import Pass
from similitude.monitor_config import monitor_config
from similitude.program.library import Library, shipped
from similitude.run import Z95

KINDS = {1: "stiffness_drop", 2: "stiffness_rise"}
HANDED_ON = 5  # sample fields that are not outputs of the filter: dt, input, U, measured, code


@dataclass(frozen=True)
class Alarm:
    """A change of the tyre stiffness, decided at ``t``.

    ``onset`` when it began [s]; ``change`` of K, -0.5 for half of it, with its sd and 95 % interval.
    """

    t: float
    onset: float
    kind: str
    change: float
    std: float
    lo: float
    hi: float

    @property
    def record(self) -> dict[str, float | str]:
        """The alarm as JSON has it."""
        names = ("t", "onset", "kind", "change", "std", "lo", "hi")
        return {name: getattr(self, name) for name in names}


@dataclass(frozen=True, eq=False)
class Watch:
    """What the monitor said of a log; arrays (n,) and the state after the last row.

    ``reference`` K before a change as the monitor follows it [m^2/s^2];  ``armed`` rows at which a change
    would be found;  ``evidence`` the larger of both kinds over its threshold [-];  ``information_rate``
    about ln K with everything else given [1/s].
    """

    alarms: tuple[Alarm, ...]
    reference: NDArray[np.float64]
    armed: NDArray[np.bool_]
    evidence: NDArray[np.float64]
    information_rate: NDArray[np.float64]
    state: NDArray[np.float64]

    @property
    def armed_share(self) -> float:
        """Share of the rows at which a change would have been found."""
        return float(np.mean(self.armed))


def watch(
    done: Pass, state: NDArray[np.float64] | None = None, changes: Mapping[str, float] | None = None
) -> Watch:
    """Run the monitor over the rows of a pass.

    Parameters
    ----------
    done : Pass                 of the population filter over a log.
    state : (m,)                where an earlier log left the monitor; None: from the start.
    changes : constants of the monitor to replace, by name.

    Returns
    -------
    Watch                       alarms in the order of time, and the state after the last row.
    """
    library = shipped("bicycle_monitor")
    config = monitor_config(library, L=done.setup.L, **(changes or {}))
    state = library.start(config) if state is None else state.copy()
    outputs, _ = library.run(config, state, monitored(library, done))
    column = {name: outputs[:, i] for i, name in enumerate(library.names("output"))}
    threshold = {name: config[library.index("config", f"threshold_{name}")] for name in ("fall", "rise")}
    evidence = [column[f"evidence_of_{name}"] / threshold[name] for name in threshold]
    t = done.setup.log.t
    return Watch(
        alarms=tuple(_alarm(t, column, int(row)) for row in np.flatnonzero(column["alarm"] > 0)),
        reference=column["reference"],
        armed=column["armed"] > 0,
        evidence=np.maximum(np.maximum(*evidence), 0.0),
        information_rate=column["information_rate"],
        state=state,
    )


def monitored(library: Library, done: Pass) -> NDArray[np.float64]:
    """Samples of the monitor, (n, fields): the filter's, its status, and what it handed out."""
    names = library.names("sample")
    handed_out = [done.output(name) for name in names[HANDED_ON:]]
    own = done.setup.samples()[:, : HANDED_ON - 1]  # a further measurement is nothing to it
    return np.column_stack([own, done.status.astype(float), *handed_out])


def _alarm(t: NDArray[np.float64], column: Mapping[str, NDArray[np.float64]], row: int) -> Alarm:
    ln, sd = float(column["change"][row]), float(np.sqrt(column["change_variance"][row]))
    factor = float(np.exp(ln))
    return Alarm(
        t=float(t[row]),
        onset=max(float(t[row] - column["onset_age"][row]), float(t[0])),
        kind=KINDS[int(column["alarm"][row])],
        change=factor - 1,
        std=factor * sd,
        lo=float(np.exp(ln - Z95 * sd)) - 1,
        hi=float(np.exp(ln + Z95 * sd)) - 1,
    )
