"""A base is found for any model; what only measures is added where nothing else does."""

from similitude import Model, Quantity, shipped_system
from similitude.any_model.base_choice import choose_base
from similitude.groups import reparameterize

HEATER = Model(
    name="heater",
    states=(Quantity("T", "K"),),
    inputs=(Quantity("P", "W"),),
    outputs=(Quantity("T", "K"),),
    parameters=(Quantity("C", "J/K"), Quantity("k", "W/K")),
    rates={"T": "(P - k*T)/C"},
)


def test_a_linear_model_gets_something_to_measure_its_signals_by():
    model, base, added = choose_base(HEATER, ["C"])

    assert len(added) == 1 and added[0] in base
    assert reparameterize(model, base=base).rates.keys() == {"T"}


def test_what_is_known_exactly_is_preferred():
    crane = shipped_system("overhead_crane").model

    assert set(choose_base(crane, ["M", "L", "g"])[1]) == {"M", "L", "g"}
    assert choose_base(crane, [], base=("M", "L", "g"))[1] == ("M", "L", "g")
