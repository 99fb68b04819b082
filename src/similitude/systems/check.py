"""check_system: what a contributed system must pass before others can rely on it.

    homogeneous    its equations hold in every system of units
    base           the base is one, and reaches every state, input, output and time
    groups         the rewriting cancels every dimension, and each group is a product without dimension
    equations      at random points the rewritten rates and outputs are the dimensional ones
    values         every value is finite and keeps the constraints
    round trip     values -> groups -> values, and the same groups in foot, pound, minute, rankine
    two forms      a run with units and a run in groups alone agree

A bare Model has no values, so it is tried as far as the equations.

Invariant: every part is reported, those that could not be tried with the reason; nothing is raised for
a system that fails.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from similitude.dimensional.base_advice import advise_base
from similitude.errors import ModelError, SimilitudeError, shown
from similitude.groups import Groups, reparameterize
from similitude.model import Model
from similitude.systems.homogeneity import misfits
from similitude.systems.system import System
from similitude.systems.two_forms import compare_at_points, simulate_two_forms
from similitude.units import Dimension

# of two runs at a relative tolerance of 1e-10 a step: a thousand steps, ten times that for stiff ones
AGREEMENT = 1e-6
POINTWISE = 1e-9  # of sums of some ten terms each rounded some ten times, that cancel to a thousandth
EXACT = 1e-12  # of products of a few powers: some hundred roundings, and some to spare
OTHER_UNITS = {"length": 0.3048, "mass": 0.45359237, "time": 60.0, "temperature": 5 / 9}


@dataclass(frozen=True)
class Part:
    """One part of the suite: ``passed`` is None where it could not be tried."""

    name: str
    passed: bool | None
    said: str


@dataclass(frozen=True)
class SystemCheck:
    """The suite's result for one system; true as a condition when it passed.

    Parameters
    ----------
    system : name of the model.
    base : the base that was used, named by the system or, for a bare Model, advised.
    parts : in the order of the suite.
    """

    system: str
    base: tuple[str, ...]
    parts: tuple[Part, ...]

    @property
    def passed(self) -> bool:
        """Whether nothing was found wrong, and the equations at least could be tried."""
        tried = {part.name for part in self.parts if part.passed}
        return not self.failures and tried >= {"homogeneous", "base", "groups", "equations"}

    @property
    def complete(self) -> bool:
        """Whether every part was tried, the run included."""
        return all(part.passed is not None for part in self.parts)

    @property
    def failures(self) -> tuple[str, ...]:
        """What was found wrong, one text a part."""
        return tuple(f"{part.name}: {part.said}" for part in self.parts if part.passed is False)

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        word = {True: "pass", False: "FAIL", None: "  - "}
        lines = [f"{self.system}, base {', '.join(self.base) or 'none'}"]
        lines += [f"  {word[part.passed]}  {part.name:11}  {part.said}" for part in self.parts]
        return "\n".join(lines)


def check_system(system: System | Model, *, base: Sequence[str] | None = None) -> SystemCheck:
    """Put a system to the suite.

    Parameters
    ----------
    system : System; or a bare Model, of which the last three parts cannot be tried.
    base : repeating variables in place of the system's own; for a bare Model the adviser's first where
        left out.

    Returns
    -------
    SystemCheck

    Raises
    ------
    ModelError    what was given is neither; a system that fails raises nothing.
    """
    if not isinstance(system, System | Model):
        raise ModelError(
            f"check_system was given {shown(system)}, which is neither a System nor a Model",
            usually="a name or a module was passed in place of the system in it.",
            paste="check_system(shipped_system('dc_motor'))",
            read='docs/systems.md, "A system of your own"',
        )
    whole = system if isinstance(system, System) else None
    model = system.model if whole else system
    chosen, base_part = _base(model, base or (whole.base if whole else None))
    parts = [_homogeneous(model), base_part]
    groups = None
    if chosen and base_part.passed:
        groups, part = _groups(model, chosen)
        parts += [part, _equations(groups)] if groups else [part]
    else:
        parts += [Part(name, None, "there is no valid base") for name in ("groups", "equations")]
    missing = (
        "a bare Model has no values: give check_system a System" if whole is None
        else "there are no groups" if groups is None else ""
    )  # fmt: skip
    for name, part in (("values", _values), ("round trip", _round_trip), ("two forms", _two_forms)):
        parts.append(Part(name, None, missing) if missing else Part(name, *part(whole, groups)))
        if name == "values" and parts[-1].passed is False:
            missing = "the values are wrong"
    return SystemCheck(model.name, tuple(chosen or ()), tuple(parts))


def _homogeneous(model: Model) -> Part:
    try:
        found = misfits(model)
    except ArithmeticError as error:
        return Part("homogeneous", False, str(error))
    if found:
        return Part("homogeneous", False, "; ".join(map(str, found[:3])))
    count = len(model.rates) + len(model.output_map) + len(model.constraints)
    return Part("homogeneous", True, f"{count} equations hold in every system of units")


def _base(model: Model, base: Sequence[str] | None) -> tuple[Sequence[str] | None, Part]:
    try:
        advice = advise_base(model)
        if base is None:
            base = advice.best
            said = (
                str(advice).splitlines()[0]
                if base is None
                else f"advised, of {len(advice.ranked)} valid ones"
            )
            return base, Part("base", base is not None, said)
        check = advice.check(base)
    except SimilitudeError as error:
        return base, Part("base", False, error.what)
    others = [name for name in base if name not in {q.name for q in model.parameters}]
    if others:
        return base, Part("base", False, f"{others[0]} is no parameter")
    return base, Part("base", check.valid, check.reason)


def _groups(model: Model, base: Sequence[str]) -> tuple[Groups | None, Part]:
    try:
        groups = reparameterize(model, base=base)
    except SimilitudeError as error:
        return None, Part("groups", False, error.what)
    for group in groups.groups:
        left = Dimension.none
        for name, exponent in group.exponents.items():
            left *= model.quantity(name).dimension ** exponent
        if left != Dimension.none:
            return None, Part("groups", False, f"{group.name} has the dimension {left}")
    said = ", ".join(f"{g.name} of {g.parameter}" for g in groups.groups) or "no parameter is left over"
    return groups, Part("groups", True, said)


def _equations(groups: Groups) -> Part:
    tried, apart = compare_at_points(groups)
    if not tried:
        return Part("equations", False, "they have no finite value at any of the points that were tried")
    said = f"apart by {apart:.1e} at most, at {tried} random points"
    return Part("equations", apart <= POINTWISE, said)


def _values(system: System, groups: Groups) -> tuple[bool, str]:
    numbers = system.numbers()
    symbols = {system.model.quantity(name).symbol: value for name, value in numbers.items()}
    for name, value in numbers.items():
        if not math.isfinite(value) or (name in system.base and value <= 0):
            what = "a base variable has to be positive" if math.isfinite(value) else "it is not finite"
            return False, f"{name} = {value:.4g}: {what}"
    for name, expression in system.model.constraints.items():
        wanted = float(expression.subs(symbols))
        if abs(numbers[name] - wanted) > 1e-6 * max(abs(wanted), abs(numbers[name])):
            return False, f"{name} = {numbers[name]:.6g}, but its constraint {expression} gives {wanted:.6g}"
    rows = [system.numbers(row) for row in system.table]
    return True, f"{len(numbers)} values" + (f", and {len(rows)} more instances in the table" if rows else "")


def _round_trip(system: System, groups: Groups) -> tuple[bool, str]:
    values = system.numbers()
    pi = groups.value(values)
    for group in groups.groups:
        back = pi[group.name]
        for name, exponent in group.exponents.items():
            if name != group.parameter:
                back *= values[name] ** -float(exponent)
        if abs(back - values[group.parameter]) > EXACT * abs(back):
            return False, f"{group.parameter} = {values[group.parameter]!r} comes back as {back!r}"
    other = {name: _in_other_units(system.model.quantity(name).dimension, x) for name, x in values.items()}
    for name, value in groups.value(other).items():
        if abs(value - pi[name]) > EXACT * abs(value):
            return False, f"{name} = {pi[name]!r} in SI, {value!r} in foot, pound and minute"
    return True, ", ".join(f"{name} {value:.4g}" for name, value in pi.items()) or "no groups"


def _in_other_units(dimension: Dimension, si: float) -> float:
    for name, exponent in dimension.exponents.items():
        si /= OTHER_UNITS.get(name, 1.0) ** float(exponent)
    return si


def _two_forms(system: System, groups: Groups) -> tuple[bool, str]:
    try:
        both = simulate_two_forms(
            groups,
            values=system.numbers(),
            inputs=system.held_inputs(),
            start=system.starting_states(),
            duration=system.span,
        )
    except (ArithmeticError, ValueError) as error:
        return False, f"a run failed: {error}"
    moved = both.dimensional[:, : len(system.model.states)]
    if system.model.states and not (abs(moved - moved[0]) > 0).any():
        return False, "nothing moves in the run: give it an input or a start away from rest"
    apart = both.disagreement
    said = f"{len(both.t)} samples over {system.duration}, apart by {apart:.1e} at most"
    if apart > AGREEMENT:
        said += "; where the equations pass, the run is too sensitive to its start: shorten it"
    return apart <= AGREEMENT, said
