"""Tables of a scenario: what is read, and what every refusal says."""

from dataclasses import dataclass

import pytest

from similitude.dimension import LENGTH, TIME
from similitude.errors import ScenarioError
from similitude.simulation.keys import (
    ANGLE,
    NUMBER,
    Place,
    choice,
    key,
    keys_of,
    read_kind,
    read_table,
    table,
    tables,
)


@dataclass(frozen=True, kw_only=True)
class Wheel:
    radius: float = key('"0.3 m"', LENGTH, "its radius", least=0.1, most=2)


@dataclass(frozen=True, kw_only=True)
class Wagon:
    length: float = key('"4 m"', LENGTH, "its length", least=0)
    angle: float = key('"2 deg"', ANGLE, default=0.0)
    share: float = key("0.5", NUMBER, default=0.5)
    colour: str = choice("red", "green", default="red")
    times: tuple = key('["1 s"]', "numbers", default=(), each=TIME)
    front: Wheel | None = table(Wheel)
    wheels: tuple = tables(Wheel)
    found_out: float = 0.0  # no key


TEXT = '[cart]\nlength = "4 m"\n[cart.front]\nradius = "30 cm"\n'
PLACE = Place("a.toml", TEXT, "cart")


def read(**given):
    return read_table(Wagon, {"length": "4 m"} | given, PLACE)


def test_values_arrive_in_si_and_what_is_not_said_has_its_default():
    wagon = read(
        angle="90 deg", times=["1 s", "20 ms"], front={"radius": "30 cm"},
        wheels=[{"radius": "1 ft"}, {"radius": "0.5 m"}], share=1,
    )  # fmt: skip
    assert wagon.length == 4 and wagon.angle == pytest.approx(1.5708, abs=1e-4)
    assert wagon.times == (1.0, 0.02) and wagon.front == Wheel(radius=0.3) and wagon.share == 1.0
    assert [wheel.radius for wheel in wagon.wheels] == [0.3048, 0.5] and read().wheels == ()
    assert "found_out" not in keys_of(Wagon)


@pytest.mark.parametrize(
    ("given", "says", "paste"),
    [
        ({"lenght": "4 m"}, "did you mean 'length'", 'length = "4 m"'),
        ({"length": 4}, "no value with a unit", 'length = "4 m"'),
        ({"length": "4 kg"}, "length", 'length = "4 m"'),
        ({"length": "four"}, "does not begin with a number", 'length = "4 m"'),
        ({"length": "-1 m"}, "outside 0", 'length = "4 m"'),
        ({"angle": 0.1}, "no value with a unit", 'angle = "2 deg"'),
        ({"angle": "0.1"}, "no value with a unit", 'angle = "2 deg"'),
        ({"colour": "gren"}, "there are red, green", 'colour = "green"'),
        ({"colour": 3}, "is no text", 'colour = "red"'),
        ({"times": "1 s"}, "no value", 'times = ["1 s"]'),
        ({"times": ["1 m"]}, "times", 'times = ["1 s"]'),
        ({"front": "big"}, "is no table", "[cart.front]"),
        ({"front": {}}, "radius is missing (its radius)", 'radius = "0.3 m"'),
        ({"whels": []}, "did you mean 'wheels'", "[[cart.wheels]]"),
        ({"found_out": 1}, "not known", ""),
        ({"share": True}, "no value", "share = 0.5"),
    ],
)  # fmt: skip
def test_a_refusal_says_what_is_wrong_and_what_to_write(given, says, paste):
    with pytest.raises(ScenarioError) as refused:
        read(**given)
    error = refused.value
    assert says in error.what and paste in error.paste and error.usually and "docs/simulate.md" in error.read
    assert error.what.startswith("a.toml")


def test_a_refusal_names_line_and_section():
    assert PLACE.of("length") == "a.toml line 2 [cart]"
    assert PLACE.within("front").of("radius") == "a.toml line 4 [cart.front]"
    assert PLACE.within("front").of("") == "a.toml line 3 [cart.front]"
    assert PLACE.of("elsewhere") == "a.toml line 1 [cart]"


def test_a_kind_says_which_table_it_is():
    kinds = {"wagon": Wagon, "wheel": Wheel}
    assert read_kind(kinds, {"kind": "wheel", "radius": "1 m"}, PLACE) == Wheel(radius=1.0)
    for given, says in (({"kind": "wheal"}, "'wheal' is not known"), ({}, "has no 'kind'"), (3, "no 'kind'")):
        with pytest.raises(ScenarioError, match=says):
            read_kind(kinds, given, PLACE)


@dataclass(frozen=True, kw_only=True)
class Plain:
    """A kind without keys."""


def test_keys_left_beside_a_kind_that_has_none_are_refused():
    with pytest.raises(
        ScenarioError, match="'radius', 'wide' cannot be said of cart kind = 'plain'"
    ) as refused:
        read_kind({"plain": Plain}, {"kind": "plain", "radius": "1 m", "wide": 2}, PLACE)
    assert refused.value.paste == "--set 'cart={ kind = \"plain\" }'" and refused.value.usually
    assert read_kind({"plain": Plain}, {"kind": "plain"}, PLACE) == Plain()
