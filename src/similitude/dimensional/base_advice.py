"""BaseAdvice: the valid bases of a set of variables or of a Model, the better ones first, with reasons.

What makes one base better than another, in this order:

    measurability  a variable that nobody measures makes every group it is in unknown
    constancy      drift = rms over the groups of the sd of ln(group) that the base's own spread causes
    conditioning   condition of B^-1 D: the variables' dimensions written in those of the base, B its
                   columns. B alone would not do: its condition changes when force is taken for a base
                   dimension in place of mass, this one does not.

Invariant: a base that is listed is valid, and no verdict or rank depends on the system of units.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, islice, product
from typing import TYPE_CHECKING

from similitude.dimensional.base_check import BaseCheck, check_base, independent_sets, lonely
from similitude.dimensional.base_faults import base_names
from similitude.dimensional.base_ranking import RankedBase, rank_bases
from similitude.dimensional.exact_span import empty_span
from similitude.dimensional.matrix import DimensionMatrix, dimension_matrix
from similitude.errors import ModelError, shown

if TYPE_CHECKING:
    from similitude.model import Model

READ = 'docs/groups.md, "Choosing a base"'


@dataclass(frozen=True)
class BaseAdvice:
    """Valid bases in order of preference, and why others are not valid.

    Parameters
    ----------
    ranked : the valid bases that were looked at, best first.
    complete : whether these are all there are.
    lonely : variables that are in no group, whatever the base.
    matrix : the dimensions of everything the base has to measure.
    candidates : names a base may be made of.
    """

    ranked: tuple[RankedBase, ...]
    complete: bool
    lonely: tuple[str, ...]
    matrix: DimensionMatrix
    candidates: tuple[str, ...]

    @property
    def best(self) -> tuple[str, ...] | None:
        """The first base, or None where no candidates reach every variable."""
        return self.ranked[0].base if self.ranked else None

    def check(self, base: Sequence[str]) -> BaseCheck:
        """Whether a base is valid, which dimensions it spans, and what would complete it.

        Raises
        ------
        ModelError    the base names a variable twice, or one that is not there.
        """
        return check_base(self.matrix, base_names(self.matrix, base), self.candidates)

    def rejected(self) -> Iterator[BaseCheck]:
        """Sets of as many candidates as a base has that are none, each with its reason, one by one."""
        for base in combinations(self.candidates, self.matrix.rank):
            check = check_base(self.matrix, base, self.candidates)
            if not check.valid:
                yield check

    def __str__(self) -> str:
        lines = [self._headline()]
        width = max((len(", ".join(r.base)) for r in self.ranked[:10]), default=0)
        lines += [f"  {', '.join(r.base):{width}}  {r.reason}" for r in self.ranked[:10]]
        if len(self.ranked) > 10:
            lines.append(f"  ... and {len(self.ranked) - 10} more")
        lines += [
            f"{name} [{self.matrix.text(name)}] is in no group: nothing else cancels its dimension"
            for name in self.lonely
        ]
        return "\n".join(lines)

    def _headline(self) -> str:
        if not self.ranked:
            return self._lack()
        found, size = len(self.ranked), self.matrix.rank
        count = f"{found} base{'s are' if found > 1 else ' is'} valid" if self.complete else (
            f"the first {found} valid bases were looked at"
        )  # fmt: skip
        return f"{count}, {size} variable{'' if size == 1 else 's'} each, best first:"

    def _lack(self) -> str:
        check = check_base(self.matrix, self.candidates, self.candidates)
        spans = f"{', '.join(self.candidates) or 'they'} span {', '.join(check.spans) or 'nothing'}"
        far = ", ".join(f"{name} [{text}]" for name, text in check.unreached.items())
        one = next(iter(check.unreached))
        return (
            f"No base: {spans} and do not reach {far}; a parameter is missing to measure by, such as a"
            f" nominal {one}"
        )


def advise_base(
    system: Mapping[str, str] | Model,
    *,
    angle: bool = False,
    spread: Mapping[str, float] | None = None,
    measured: Collection[str] | None = None,
    sought: Collection[str] = (),
    most: int = 2000,
) -> BaseAdvice:
    """Find the valid bases, explain and rank them.

    Parameters
    ----------
    system : name -> unit of every variable; or a Model, or a System for the sake of its model. The base
        is then made of parameters (those that no constraint gives) and has to measure states, inputs,
        outputs and time as well.
    angle : whether the radian is a base dimension.
    spread : sd of ln(variable) over the systems or moments that are compared [-], such as 0.25; a base
        that holds still is preferred. A variable not named here comes after those that are.
    measured : the variables whose value is known; a base of these alone is preferred. Left out: nothing
        is said about any.
    sought : variables that shall stand in one group each, so in no base: what is looked for.
    most : how many valid bases are ranked at most. Candidates that are measured, spread little and have
        simple dimensions are tried first.

    Returns
    -------
    BaseAdvice

    Raises
    ------
    UnitError     a unit cannot be read.
    ModelError    ``spread``, ``measured`` or ``sought`` name what is not there, or a spread is no sd.
    """
    matrix, candidates = _variables(system, angle)
    for what, names in (("spread", spread or ()), ("measured", measured or ()), ("sought", sought)):
        _known(matrix, what, names)
    _sds(spread or {})
    candidates = tuple(name for name in candidates if name not in sought)
    first = sorted(candidates, key=lambda name: _preference(matrix, name, spread, measured))
    bases = list(islice(_bases(matrix, first), most + 1))
    ordered = [tuple(sorted(base, key=candidates.index)) for base in bases[:most]]
    return BaseAdvice(
        ranked=rank_bases(matrix, ordered, candidates, spread=spread, measured=measured),
        complete=len(bases) <= most,
        lonely=lonely(matrix),
        matrix=matrix,
        candidates=candidates,
    )


def _variables(system: Mapping[str, str] | Model, angle: bool) -> tuple[DimensionMatrix, tuple[str, ...]]:
    system = getattr(system, "model", system)
    if not hasattr(system, "parameters"):
        matrix = dimension_matrix(system, angle=angle)
        return matrix, matrix.names
    units = {q.name: q.unit for q in system.quantities}
    if system.states:  # a static model has no time to measure
        units |= {"time" if "time" not in units else "the time": system.time_unit}
    free = (q.name for q in system.parameters if q.name not in system.constraints)
    return dimension_matrix(units, angle=angle), tuple(free)


def _bases(matrix: DimensionMatrix, names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Valid bases, those first that differ in more than which of two lengths they take."""
    alike: dict[tuple, list[str]] = {}
    for name in names:
        alike.setdefault(matrix.column(name), []).append(name)
    first, nothing = [own[0] for own in alike.values()], empty_span(len(matrix.rows))
    for others in (False, True):
        for kinds in independent_sets(matrix, first, nothing):
            choices = product(*(alike[matrix.column(name)] for name in kinds))
            yield from islice(choices, 1, None) if others else islice(choices, 1)


def _preference(matrix: DimensionMatrix, name: str, spread, measured) -> tuple:
    """What is tried first: measured, of stated and small spread, of a plain dimension."""
    unmeasured = measured is not None and name not in measured
    unstated = spread is not None and name not in spread
    column = matrix.column(name)
    return unmeasured, unstated, (spread or {}).get(name, 0.0), sum(map(abs, column))


def _known(matrix: DimensionMatrix, what: str, names: Collection[str]) -> None:
    strange = [name for name in names if name not in matrix.names]
    if isinstance(names, str) or strange:
        named = shown(names if isinstance(names, str) else strange[0])
        raise ModelError(
            f"{what} names {named}, which is none of the variables ({', '.join(matrix.names)})",
            usually="the name was misspelt, or one text was passed in place of several names.",
            paste=f"advise_base(..., {what}={'{' if what == 'spread' else '['}{matrix.names[0]!r}"
            f"{': 0.1}' if what == 'spread' else ']'})"
            if matrix.names
            else "advise_base({'m': 'kg'})",
            read=READ,
        )


def _sds(spread: Mapping[str, float]) -> None:
    for name, sd in spread.items():
        if not 0 <= sd < float("inf"):
            raise ModelError(
                f"spread of {shown(name)} is {sd!r}, which is no standard deviation",
                usually="a variance, a ratio in per cent or a missing value was passed.",
                paste=f"spread={{{name!r}: 0.1}}   # sd of ln({name}): 10 %",
                read=READ,
            )
