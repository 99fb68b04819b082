"""The adviser finds all valid bases, explains the others, and prefers what holds still and is known."""

import pytest
import sympy as sp

from similitude import advise_base, pi_groups
from similitude.dimensional.base_check import check_base
from similitude.errors import ModelError
from similitude.groups import reparameterize
from similitude.model import Model, Quantity
from similitude.systems.bicycle import BICYCLE

from .classical import CASES

PIPE = CASES["pipe flow"].variables


@pytest.mark.parametrize("name", CASES)
def test_every_base_it_lists_gives_groups_and_the_textbooks_is_among_them(name):
    case = CASES[name]
    advice = advise_base(case.variables)

    for ranked in advice.ranked:
        pi_groups(case.variables, ranked.base)
    assert advice.complete
    assert sorted(case.base) in [sorted(ranked.base) for ranked in advice.ranked]


def test_a_base_that_is_measured_comes_before_one_that_is_not():
    advice = advise_base(PIPE, measured=["D", "V", "rho"])

    assert advice.best == ("D", "V", "rho")
    assert "is not measured" in advice.ranked[1].reason


def test_a_base_that_holds_still_comes_before_one_that_varies():
    spread = {name: 1.0 for name in PIPE} | {"L": 0.01, "rho": 0.01, "mu": 0.01}

    assert advise_base(PIPE, spread=spread).best == ("L", "rho", "mu")


def test_what_is_sought_is_in_no_base():
    assert all("dp" not in ranked.base for ranked in advise_base(PIPE, sought=["dp"]).ranked)


def test_units_and_order_change_no_rank():
    feet = {"dp": "psi", "L": "ft", "D": "in", "V": "mph", "rho": "lb/ft^3", "mu": "lbf s/ft^2", "eps": "ft"}
    one, other = advise_base(PIPE), advise_base(feet)

    assert [r.base for r in one.ranked] == [r.base for r in other.ranked]
    assert [r.reason for r in one.ranked] == [r.reason for r in other.ranked]
    backwards = advise_base(dict(reversed(PIPE.items())))
    assert {frozenset(r.base) for r in backwards.ranked} == {frozenset(r.base) for r in one.ranked}
    assert set(backwards.best) & set(one.best)


def test_the_base_of_a_model_measures_its_signals_and_its_time_too():
    advice = advise_base(BICYCLE, measured=["m", "L", "U"])

    assert advice.best == ("m", "L", "U")
    for ranked in advice.ranked:
        reparameterize(BICYCLE, base=ranked.base)
    assert not any("b" in ranked.base for ranked in advice.ranked)  # L - a gives it
    assert not advice.check(["m", "L", "a"]).valid
    assert advice.check(["L", "U"]).completions == (("m",), ("Caf",), ("Car",), ("Iz",))


def test_a_model_without_a_base_says_what_it_lacks():
    T, k = sp.symbols("T k", real=True)
    body = Quantity("T", "K", "temperature")
    model = Model("cooling", (body,), (), (body,), (Quantity("k", "1/s"),), {"T": -k * T}, {"T": T})
    advice = advise_base(model)

    assert advice.best is None and advice.ranked == ()
    assert str(advice).startswith("No base: k span s and do not reach T [K]")


def test_a_static_model_needs_no_measure_of_time():
    dT, flow, Ch, Cc = (Quantity(n, u) for n, u in (("dT", "K"), ("q", "W"), ("Ch", "W/K"), ("Cc", "W/K")))
    nominal = Quantity("d", "K")
    model = Model("mixer", (), (dT,), (flow,), (Ch, Cc, nominal), {}, {"q": "dT*Ch*Cc/(Ch + Cc)"})

    assert {ranked.base for ranked in advise_base(model).ranked} == {("Ch", "d"), ("Cc", "d")}
    assert reparameterize(model, base=("Ch", "d")).time_scale == 1


def test_an_invalid_base_is_explained():
    check = advise_base(PIPE).check(["L", "D", "V"])

    assert not check.valid
    assert check.spans == ("m", "s")
    assert check.completions == (("dp",), ("rho",), ("mu",))
    assert check == check_base(advise_base(PIPE).matrix, ["L", "D", "V"])


def test_every_set_is_either_listed_or_rejected_with_a_reason():
    advice = advise_base(PIPE)
    rejected = list(advice.rejected())

    assert len(rejected) + len(advice.ranked) == 35  # three of seven
    for check in rejected:
        assert "has no dimension" in check.reason or "does not reach" in check.reason
        assert all(advice.check([*check.kept, *more]).valid for more in check.completions)


@pytest.mark.parametrize("variables", [{}, {"a": "1"}, {"a": "m"}, {"T": "K", "l": "m", "d": "m"}])
def test_any_variables_can_be_asked_about(variables):
    advice = advise_base(variables)

    assert advice.ranked and str(advice)
    pi_groups(variables, advice.best)


def test_a_lonely_variable_is_named():
    advice = advise_base({"T": "K", "l": "m", "d": "m"})

    assert advice.lonely == ("T",) and "T [K] is in no group" in str(advice)


def test_many_variables_are_bounded_and_the_answer_says_so():
    units = ("kg", "m", "s", "A", "K", "N", "Pa", "m/s", "W", "V")
    many = {f"x{i}": units[i % 10] for i in range(120)}
    advice = advise_base(many, most=50, measured=["x110", "x111", "x112", "x113", "x114"])

    assert len(advice.ranked) == 50 and not advice.complete
    assert advice.best == ("x110", "x111", "x112", "x113", "x114")
    assert "the first 50 valid bases were looked at" in str(advice)


@pytest.mark.parametrize(
    ("keywords", "said"),
    [
        ({"measured": ["Q"]}, "measured names 'Q'"),
        ({"measured": "D"}, "measured names 'D'"),
        ({"spread": {"Q": 0.1}}, "spread names 'Q'"),
        ({"spread": {"D": -0.1}}, "no standard deviation"),
        ({"spread": {"D": float("nan")}}, "no standard deviation"),
        ({"sought": ["Q"]}, "sought names 'Q'"),
    ],
)
def test_what_is_said_of_a_variable_that_is_not_there_is_refused(keywords, said):
    with pytest.raises(ModelError, match=said):
        advise_base(PIPE, **keywords)
