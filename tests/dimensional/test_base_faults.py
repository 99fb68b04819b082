"""Every fault of a base is refused with its reason, and what is offered for pasting works."""

import pytest

from similitude import pi_groups
from similitude.errors import ModelError

PIPE = {"dp": "Pa", "L": "m", "D": "m", "V": "m/s", "rho": "kg/m^3", "mu": "Pa s"}
WARM = PIPE | {"T": "K"}


@pytest.mark.parametrize(
    ("variables", "base", "said"),
    [
        (PIPE, ["rho", "V", "Dia"], ["'Dia'", "none of the variables", "dp, L, D, V, rho, mu"]),
        (PIPE, ["Rho", "V", "D"], ["did you mean 'rho'"]),
        (PIPE, [], ["too few variables, 0 where these need 3", "does not reach dp"]),
        (PIPE, ["V", "D", "V"], ["'V' more than once"]),
        (PIPE, "rho V D", ["is the text 'rho V D'"]),
        (PIPE, ["rho", "V", "D", "mu"], ["dependent", "mu/(rho V D) has no dimension"]),
        (PIPE, ["D", "V", "L"], ["L/D has no dimension", "spans m, s", "does not reach dp", "rank is 2"]),
        (PIPE, ["rho", "V"], ["too few variables, 2 where these need 3", "spans kg s^-3, m s^-1", "L [m]"]),
        (WARM, ["rho", "V", "D"], ["does not reach T [K]", "no other variable", "T can be in no group"]),
        ({"a": "1", "l": "m"}, ["a"], ["a has no dimension"]),
    ],
)
def test_the_message_names_the_fault_and_the_base_it_offers_is_valid(variables, base, said):
    with pytest.raises(ModelError) as caught:
        pi_groups(variables, base)

    error = caught.value
    assert [part for part in said if part not in error.what] == []
    assert error.usually and 'docs/groups.md, "A base that cannot be one"' in error.read
    offered = {}
    exec(error.paste, offered)
    if base not in (["V", "D", "V"], ["rho", "V", "Dia"]):  # there only the names are mended
        pi_groups(variables, offered["base"])


def test_a_dimension_that_one_variable_carries_is_legal_where_it_stands_in_the_way_of_nothing():
    assert pi_groups(WARM) == pi_groups(PIPE)
    assert pi_groups(WARM, ["rho", "V", "D", "T"]) == pi_groups(PIPE, ["rho", "V", "D"])


def test_a_variable_may_be_lonely_without_a_dimension_of_its_own():
    """The second stands in F alone, and the kilogram in two columns, of which neither is of use."""
    with pytest.raises(ModelError, match=r"F \[kg m s\^-2\], so F can be in no group"):
        pi_groups({"F": "N", "m": "kg", "l": "m", "d": "m"}, ["m", "l"])
    assert pi_groups({"F": "N", "m": "kg", "l": "m", "d": "m"}) == [{"l": 1, "d": -1}]
