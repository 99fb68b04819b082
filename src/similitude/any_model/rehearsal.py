"""Rehearsal: the estimator on simulated logs of systems that it has never seen, drawn from its own prior.

Invariant: the plants are the dimensional equations, so a mistake in groups, units or step would show.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from similitude.any_model.estimate import WIDE, estimate_of
from similitude.any_model.estimator import Estimator
from similitude.any_model.plant import respond
from similitude.errors import UsageError

FEWEST = 20  # systems: one more or less is 5 % of coverage


@dataclass(frozen=True)
class Rehearsal:
    """What happened.

    Parameters
    ----------
    systems : int           how many.
    covered : unknown -> share whose 95 % interval at the end holds the truth [-].
    rms : unknown -> rms of ln(estimate/truth) [-].    claimed : unknown -> rms of the sd it states [-].
    before : unknown -> sd before the log [-].
    along : float           share of (system, row) at which the identified unknown's interval holds the truth,
                            the first fifth of the log left out.
    verdicts : verdict -> how many.
    """

    systems: int
    covered: Mapping[str, float]
    rms: Mapping[str, float]
    claimed: Mapping[str, float]
    before: Mapping[str, float]
    along: float
    verdicts: Mapping[str, int]

    @property
    def text(self) -> str:
        """One line an unknown."""
        lines = [
            f"{self.systems} systems; intervals of {next(iter(self.covered))} hold at "
            f"{100 * self.along:.1f} % of all rows; "
            + ", ".join(f"{n} {v}" for v, n in self.verdicts.items())
        ]
        lines += [
            f"  {n:<14} covered {100 * self.covered[n]:.0f} %  rms {100 * self.rms[n]:.3g} %  claimed "
            f"{100 * self.claimed[n]:.3g} %  before {100 * self.before[n]:.3g} %"
            for n in self.covered
        ]
        return "\n".join(lines)


def rehearse(
    estimator: Estimator, *, systems: int = 100, seed: int = 0, u: ArrayLike | None = None
) -> Rehearsal:
    """Try an estimator on systems drawn from its prior.

    Parameters
    ----------
    estimator : Estimator.
    systems : how many, at least 20.    seed : of systems and noise.
    u : (n,) input [SI]; the planned drive where left out.

    Returns
    -------
    Rehearsal

    Raises
    ------
    UsageError    too few systems to say anything.
    """
    if systems < FEWEST:
        raise UsageError(
            f"systems = {systems}: a coverage of so few says nothing",
            usually="a quick look was wanted; a hundred systems take seconds.",
            paste=f"rehearse(estimator, systems={FEWEST})",
            read='docs/estimator.md, "Rehearsal"',
        )
    model, fewest = estimator.model, estimator.fewest
    u = estimator.trial.u if u is None else np.asarray(u, dtype=float)
    drawn = fewest.knowledge.draw(systems, seed=seed)
    clean = respond(model, {**drawn, **fewest.signals}, u, estimator.step, start=estimator.start).output
    rng = np.random.default_rng([seed, 2])
    names, order = estimator.unknowns, [fewest.prior.names.index(n) for n in estimator.unknowns]
    away, sds, held, verdicts = np.empty((systems, len(names))), np.empty((systems, len(names))), [], {}
    signals = [np.full(len(u), v) for v in fewest.signals.values()]
    t = estimator.step * np.arange(len(u))
    for k in range(systems):
        noisy = clean[k] + estimator.doubts.noise * rng.standard_normal(len(u))
        rows = np.column_stack([np.full(len(u), estimator.step), u, *signals, noisy])
        state = estimator.library.start(estimator.config)
        outputs, status = estimator.library.run(estimator.config, state, rows)
        found = estimate_of(estimator, t, outputs, status, state)
        truth = fewest.unknowns_of({n: v[k] for n, v in drawn.items()})[order]
        away[k] = [np.log(found.unknowns[n].value / truth[i]) for i, n in enumerate(names)]
        sds[k] = [found.unknowns[n].sd for n in names]
        held.append(np.mean(((found.low <= truth[0]) & (truth[0] <= found.high))[len(u) // 5 :]))
        verdicts[found.verdict] = verdicts.get(found.verdict, 0) + 1
    inside = np.abs(away) <= WIDE * sds
    return Rehearsal(
        systems,
        dict(zip(names, map(float, inside.mean(axis=0)), strict=True)),
        dict(zip(names, map(float, np.sqrt((away**2).mean(axis=0))), strict=True)),
        dict(zip(names, map(float, np.sqrt((sds**2).mean(axis=0))), strict=True)),
        dict(zip(names, map(float, estimator.prior.std), strict=True)),
        float(np.mean(held)),
        dict(sorted(verdicts.items(), key=lambda pair: -pair[1])),
    )
