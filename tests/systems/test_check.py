"""The suite passes what is shipped, and finds every fault that is put into a system."""

from dataclasses import replace

import pytest
import sympy as sp

from similitude import System, check_system, shipped_system
from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.systems.dc_motor import DC_MOTOR, SYSTEM, K, L, R, i, u, w
from similitude.systems.shipped import SHIPPED


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_system_passes_and_explains_its_groups(name):
    system = shipped_system(name)
    check = check_system(system)

    assert check.passed and check.complete, str(check)
    assert check.base == system.base and bool(check)
    assert set(system.meanings) == {group.parameter for group in system.groups().groups}
    assert system.source and system.model.source
    assert all(quantity.meaning for quantity in system.model.quantities)
    for row in system.table:
        assert system.groups().value(system.numbers(row))


def failing(system, **more):
    check = check_system(system, **more)
    assert not check
    return {part.name: part.said for part in check.parts if part.passed is False}


def test_a_term_of_another_dimension_is_found_and_named(monkeypatch):
    monkeypatch.setattr(Model, "_check_homogeneity", lambda self: None)  # else no such Model is made
    wrong = replace(DC_MOTOR, rates={**DC_MOTOR.rates, "i": (u - R * i - K * w) / L - R * i})

    assert "-R*i" in failing(replace(SYSTEM, model=wrong))["homogeneous"]


def test_a_base_that_is_none_is_explained():
    said = failing(replace(SYSTEM, base=("R", "K", "b"), meanings={}))["base"]

    assert "R b/K^2 has no dimension" in said and "does not reach i [A]" in said
    assert "has no dimension" in failing(SYSTEM, base=("R", "L", "K", "J"))["base"]
    assert "none of the variables" in failing(SYSTEM, base=("R", "L", "Q"))["base"]
    assert "w is no parameter" in failing(SYSTEM, base=("R", "K", "w"))["base"]


def test_an_error_in_the_rewriting_shows_at_points_and_in_the_run(monkeypatch):
    """A group too little in one rate: nothing but the comparison of the two forms can see it."""
    wrong = SYSTEM.groups()
    wrong.rates["w"] += sp.Symbol("i", real=True) / 1000
    monkeypatch.setattr("similitude.systems.check.reparameterize", lambda model, base: wrong)
    said = failing(SYSTEM)

    assert set(said) == {"equations", "two forms"}


def test_values_that_break_a_constraint_are_found():
    car = shipped_system("bicycle")

    assert "b = 0.3" in failing(replace(car, values={**car.values, "b": "0.3 m"}))["values"]


def test_a_measure_of_no_size_is_found():
    said = failing(replace(SYSTEM, values={**SYSTEM.values, "K": "0 N m/A"}))

    assert "K = 0" in said["values"]


def test_a_run_in_which_nothing_moves_is_no_proof():
    assert "nothing moves" in failing(replace(SYSTEM, inputs={}))["two forms"]


def test_a_run_that_blows_up_is_reported_and_not_raised():
    said = failing(replace(SYSTEM, values={**SYSTEM.values, "b": "-1e9 N m s/rad"}))

    assert "a run failed" in said["two forms"]


def test_a_bare_model_is_tried_as_far_as_it_goes():
    check = check_system(DC_MOTOR)

    assert check.passed and not check.complete  # nothing wrong, but not all was tried
    assert [part.name for part in check.parts if part.passed is None] == ["values", "round trip", "two forms"]
    assert len(check.base) == 3 and "give check_system a System" in str(check)


def test_a_bare_model_without_a_base_is_explained():
    x = sp.Symbol("x", real=True)
    state = Quantity("x", "K")
    lost = replace(
        DC_MOTOR,
        states=(state,),
        inputs=(),
        outputs=(state,),
        parameters=(Quantity("k", "1/s"),),
        rates={"x": -sp.Symbol("k", real=True) * x},
        output_map={"x": x},
    )

    assert "do not reach x [K]" in failing(lost)["base"]


def test_a_static_system_is_checked_without_a_run():
    model = Model(
        "exchanger",
        states=(),
        inputs=(Quantity("dT", "K"),),
        outputs=(Quantity("q", "W"),),
        parameters=(Quantity("C", "W/K"), Quantity("d", "K"), Quantity("UA", "W/K")),
        rates={},
        output_map={"q": "C*(1 - exp(-UA/C))*dT"},  # a condenser: effectiveness 1 - exp(-NTU)
    )
    values = {"C": "2 W/K", "d": "1 K", "UA": "3 W/K"}
    system = System(model, ("C", "d"), values, "", duration="1 s", inputs={"dT": "10 K"})

    check = check_system(system)
    assert check.passed and check.complete, str(check)


def test_what_is_no_system_is_refused():
    with pytest.raises(ModelError, match="given 'bicycle', which is neither"):
        check_system("bicycle")
