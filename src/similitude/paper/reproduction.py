"""Everything of the paper at once: claims, equations and figures.

Invariant: equal code gives equal results: seeds are fixed, and values are rounded to digits that do not
depend on the machine.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from similitude.errors import CompileError
from similitude.filter_run import POPULATION
from similitude.paper.ahead import compute_ahead
from similitude.paper.claim import VERDICTS, Claim
from similitude.paper.claims_controller import controller_claims
from similitude.paper.claims_cost import cost_claims
from similitude.paper.claims_discrete import discrete_claims
from similitude.paper.claims_figure_5 import figure_5_claims
from similitude.paper.claims_figure_7 import figure_7_claims, grip_alone, wet_lane_runs
from similitude.paper.claims_groups import group_claims
from similitude.paper.claims_invariance import invariance_claims
from similitude.paper.claims_noise import noise_claims
from similitude.paper.claims_population import population_claims
from similitude.paper.claims_seven import seven_claims
from similitude.paper.drives import belt, belt_scheduled, belt_soft, belt_softest, belt_told, square
from similitude.paper.equations import EQUATIONS, Equation
from similitude.program.library import shipped

SUBJECTS: dict[str, Callable[[], list[Claim]]] = {
    "Sensitivity invariance": invariance_claims,
    "Model, groups, scale": group_claims,
    "Populations": population_claims,
    "The z-transform and the regression": discrete_claims,
    "The controller": controller_claims,
    "Seven parameters at once": seven_claims,
    "Noise and averages": noise_claims,
    "Cost": cost_claims,
    "Figure 5": figure_5_claims,
    "Figure 7 and the scheduled gain": figure_7_claims,
}
LONG = (wet_lane_runs, belt_scheduled, belt, belt_told, belt_soft, belt_softest, grip_alone, square)


@dataclass(frozen=True, eq=False)
class Reproduction:
    """What was computed.

    ``subjects`` subject -> claims; ``residuals`` of the equations; ``pictures`` file name -> PNG.
    """

    subjects: dict[str, list[Claim]]
    residuals: list[tuple[Equation, float]]
    pictures: dict[str, bytes]

    @property
    def claims(self) -> list[Claim]:
        """All claims, in the order of the paper."""
        return [claim for claims in self.subjects.values() for claim in claims]

    @property
    def records(self) -> list[dict[str, Any]]:
        """The claims as JSON objects."""
        return [claim.record for claim in self.claims]

    def count(self) -> dict[str, int]:
        """Number of claims of each verdict."""
        return {word: sum(claim.verdict == word for claim in self.claims) for word in VERDICTS}


def reproduce(begin: Callable[[str], None] = lambda text: None, *, drawn: bool = True) -> Reproduction:
    """Compute every claim and equation, and draw every figure.

    Parameters
    ----------
    begin : called with the name of each part before it is computed. drawn : figures as well.

    Returns
    -------
    Reproduction

    Raises
    ------
    CompileError   there is no C compiler; the scalar twin would take too long for drives of 1 kHz
    """
    _check_compiler()
    begin("drives")
    compute_ahead(LONG)
    subjects = {}
    for name, claims in SUBJECTS.items():
        begin(name)
        subjects[name] = claims()
    begin("equations")
    residuals = [(equation, float(equation.check())) for equation in EQUATIONS]
    pictures: dict[str, bytes] = {}
    if drawn:
        from similitude.paper.pictures import draw_all

        pictures = draw_all(begin)
    return Reproduction(subjects, residuals, pictures)


def _check_compiler() -> None:
    library = shipped(POPULATION)
    if library.c is None:
        raise CompileError(
            f"the paper cannot be reproduced without a C compiler: {library.why_slow}",
            usually="there is none on this machine, or SIMILITUDE_CC names one that does not work.",
            paste="pip install 'similitude[cc]'",
            read='docs/paper.md, "The command"',
        )
