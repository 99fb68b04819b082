"""Pi groups against the textbooks, against SymPy's null space, and against changes of units and order."""

from fractions import Fraction
from math import gcd

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from similitude import pi_groups
from similitude.dimensional.matrix import dimension_matrix
from similitude.errors import ModelError, UnitError
from similitude.units import Dimension, parse_unit

from .classical import CASES


def matrix_of(groups, names) -> sp.Matrix:
    rows = [[sp.Rational(g.get(n, 0).numerator, g.get(n, 0).denominator) for n in names] for g in groups]
    return sp.Matrix(len(rows), len(names), [x for row in rows for x in row])


def same_span(some, others, names) -> bool:
    if not some or not others:
        return not some and not others
    a, b = matrix_of(some, names), matrix_of(others, names)
    return a.rank() == b.rank() == a.col_join(b).rank()


def fractions(groups):
    return [{name: Fraction(x) for name, x in group.items()} for group in groups]


@pytest.mark.parametrize("name", CASES)
def test_groups_of_a_base_are_those_of_the_textbook(name):
    case = CASES[name]
    found = pi_groups(case.variables, case.base)

    assert found == fractions(case.groups)
    assert [list(group) for group in found] == [
        [own, *(b for b in case.base if b in group)]
        for own, group in zip((n for n in case.variables if n not in case.base), found, strict=True)
    ]
    assert all(type(x) is Fraction for group in found for x in group.values())


@pytest.mark.parametrize("name", CASES)
def test_without_a_base_the_span_is_the_same_and_the_famous_groups_are_in_it(name):
    case = CASES[name]
    found, names = pi_groups(case.variables), list(case.variables)

    assert same_span(found, fractions(case.groups), names)
    assert same_span(found, [*found, *fractions(case.known)], names)
    assert_smallest(found, names)


def assert_smallest(groups, names):
    for group in groups:
        powers = list(group.values())
        assert all(x.denominator == 1 and x for x in powers)
        assert gcd(*(int(x) for x in powers)) == 1 and powers[0] > 0
        assert list(group) == [name for name in names if name in group]


UNITS = ["kg", "m", "s", "N", "Pa", "m/s", "kg/m^3", "Pa s", "W", "J/K", "K", "V", "A", "ohm", "1", "rad"]
UNITS += ["m^(1/2)", "kg^(2/3) s", "mol/m^3", "deg/s", "N/rad", "cd"]
some_variables = st.lists(st.sampled_from(UNITS), max_size=9).map(
    lambda units: {f"x{i}": unit for i, unit in enumerate(units)}
)


@settings(max_examples=80, deadline=None)
@given(some_variables, st.booleans())
def test_any_variables_give_the_null_space_of_their_dimensions(variables, angle):
    groups, names = pi_groups(variables, angle=angle), list(variables)
    columns = dimension_matrix(variables, angle=angle).columns

    assert_smallest(groups, names)
    assert groups == pi_groups(dict(variables), None, angle)  # the same again
    rank = 0
    if columns:
        D = sp.Matrix([[sp.Rational(x.numerator, x.denominator) for x in c] for c in columns]).T
        rank = D.rank()
        if groups:
            assert not any(D * matrix_of(groups, names).T)
    assert len(groups) == len(names) - rank
    if groups:
        assert matrix_of(groups, names).rank() == len(groups)


@settings(max_examples=60, deadline=None)
@given(some_variables, st.randoms(use_true_random=False))
def test_another_order_of_the_variables_keeps_the_span(variables, rng):
    names = list(variables)
    rng.shuffle(names)

    assert same_span(pi_groups(variables), pi_groups({n: variables[n] for n in names}), names)


@pytest.mark.parametrize("name", CASES)
def test_another_order_permutes_the_groups_of_a_base(name):
    case = CASES[name]
    names = list(case.variables)[::-1]
    found = pi_groups({n: case.variables[n] for n in names}, case.base)

    assert found == pi_groups(case.variables, case.base)[::-1]


# the same quantities in other units: US customary, centimetre-gram-second, prefixes
OTHER = {
    "Pa": ("psi", "dyn/cm^2", "kPa"), "m": ("ft", "cm", "mi"), "m/s": ("mph", "cm/s", "kn"),
    "J": ("ft lbf", "erg"),
    "kg/m^3": ("slug/ft^3", "g/cm^3", "lb/ft^3"), "Pa s": ("poise", "lbf s/ft^2", "mPa s"), "mm": ("in",),
    "N": ("lbf", "dyn"), "W": ("hp", "kW"), "kg": ("lb", "oz", "t"), "s": ("h", "ms"),
    "m/s^2": ("gn", "ft/s^2"),
    "m^2/s": ("ft^2/s", "stokes"), "W/K": ("kW/K",), "rad": ("deg", "rev"), "N/m": ("lbf/ft",), "V": ("mV",),
    "ohm": ("kohm",), "F": ("uF",), "H": ("mH",), "kg m^2": ("slug ft^2",), "N/rad": ("lbf/deg",),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_another_system_of_units_changes_no_group(name):
    case = CASES[name]
    for k in range(3):
        other = {n: OTHER.get(u, (u,))[k % len(OTHER.get(u, (u,)))] for n, u in case.variables.items()}

        assert pi_groups(other, case.base) == pi_groups(case.variables, case.base)
        assert pi_groups(other) == pi_groups(case.variables)


@settings(max_examples=40, deadline=None)
@given(some_variables, st.lists(st.lists(st.integers(-2, 2), min_size=7, max_size=7), min_size=7, max_size=7))
def test_other_base_dimensions_change_no_group(variables, change):
    """Counting force, energy ... as basic in place of mass, length ...: D becomes C D, C regular."""
    assume(sp.Matrix(change).det() != 0)
    old = {name: parse_unit(unit).dimension for name, unit in variables.items()}
    new = {
        name: Dimension(*(sum(c * x for c, x in zip(row, d.powers, strict=True)) for row in change))
        for name, d in old.items()
    }

    assert pi_groups(new) == pi_groups(old)


@pytest.mark.parametrize(
    ("variables", "count"),
    [
        ({}, 0),
        ({"a": "1"}, 1),
        ({"a": "m"}, 0),
        ({"a": "1", "b": "-", "c": "rad"}, 3),  # all dimensionless
        ({"m": "kg", "l": "m", "t": "s"}, 0),  # as many dimensions as variables
        ({"p": "Pa", "tau": "Pa", "E": "GPa"}, 2),  # rank below the number of dimensions
        ({"T": "K", "l": "m", "d": "m"}, 1),  # a temperature that nothing cancels
        ({f"x{i}": "m^(1/7)" for i in range(5)}, 4),
    ],
)
def test_whatever_is_legal_gives_groups_or_none(variables, count):
    assert len(pi_groups(variables)) == count


def test_dimensionless_variables_are_groups_by_themselves():
    assert pi_groups({"a": "1", "l": "m", "angle": "deg", "d": "m"}) == [
        {"a": 1}, {"angle": 1}, {"l": 1, "d": -1},
    ]  # fmt: skip
    assert pi_groups({"a": "1", "angle": "deg"}, []) == [{"a": 1}, {"angle": 1}]
    assert pi_groups({}, []) == []


def test_an_angle_counts_as_a_dimension_only_on_demand():
    car = {"m": "kg", "L": "m", "U": "m/s", "Caf": "N/rad", "delta": "rad"}

    assert pi_groups(car, ["m", "L", "U"])[0] == {"Caf": 1, "m": -1, "L": 1, "U": -2}
    with pytest.raises(ModelError, match=r"rad"):
        pi_groups(car, ["m", "L", "U"], angle=True)
    assert pi_groups(car, ["m", "L", "U", "delta"], angle=True) == [
        {"Caf": 1, "m": -1, "L": 1, "U": -2, "delta": 1}
    ]
    assert pi_groups({"w": "rpm", "t": "s", "turn": "rev"}, angle=True) == [{"w": 1, "t": 1, "turn": -1}]


def test_a_base_may_be_anything_that_holds_names():
    case = CASES["pipe flow"]
    expected = pi_groups(case.variables, ["D", "V", "rho"])

    for base in (("D", "V", "rho"), iter(["D", "V", "rho"]), {"D": 0, "V": 0, "rho": 0}):
        assert pi_groups(case.variables, base) == expected
    assert list(pi_groups(case.variables, {"rho", "V", "D"})[0]) == ["dp", "V", "rho"]  # variables' order


def test_units_may_have_been_read_before():
    drag = {"F": "N", "D": "m", "V": "m/s", "rho": "kg/m^3", "mu": "Pa s"}
    read = {name: parse_unit(unit) for name, unit in drag.items()}
    bare = {name: unit.dimension for name, unit in read.items()}

    assert pi_groups(read) == pi_groups(bare) == pi_groups(drag)


def test_a_unit_that_cannot_be_read_is_named_with_its_variable():
    with pytest.raises(UnitError, match=r"'V'.*'m//s'") as caught:
        pi_groups({"L": "m", "V": "m//s"})
    assert "docs/units.md" in str(caught.value)
    for unit in (3, "", None):
        with pytest.raises(UnitError, match=f"'V' has {unit!r} for a unit") as caught:
            pi_groups({"V": unit})
        assert caught.value.paste == '{"V": "1"}'


def test_what_is_no_mapping_of_names_is_refused():
    with pytest.raises(ModelError, match="a list, not a mapping"):
        pi_groups(["m", "s"])
    with pytest.raises(ModelError, match="3 is no name"):
        pi_groups({3: "m"})
