"""The table of units agrees with an independent one."""

import pytest

from similitude import unit_table

PINT_NAME = {
    "gn": "standard_gravity", "kn": "knot", "Ω": "ohm", "rev": "turn", "hp": "horsepower",
    "fps": "foot/second", "dps": "degree/second", "grad": "gon", "L": "liter",
    "mps": "meter/second",
    "kgf": "kilogram_force", "lbf": "pound_force", "h": "hour", "d": "day", "t": "metric_ton",
    "g": "gram", "min": "minute", "in": "inch", "%": "percent",
}  # fmt: skip


@pytest.mark.parametrize("name", sorted({*unit_table._PLAIN, *unit_table._PREFIXED}))
def test_every_factor_agrees_with_pint(name):
    pint = pytest.importorskip("pint")

    entry = unit_table.find(name)

    theirs = pint.get_application_registry()(PINT_NAME.get(name, name)).to_base_units()
    # pint's base of mass is the kilogram; its own constants carry about 1e-12
    assert entry.factor == pytest.approx(theirs.magnitude, rel=1e-9)
    ours = {f"[{base}]": float(power) for base, power in entry.dimension.exponents.items()}
    ours = {key.replace("amount", "substance"): power for key, power in ours.items()}
    assert ours == {key: float(power) for key, power in dict(theirs.dimensionality).items()}


def test_prefixes_do_not_shadow_names():
    assert unit_table.find("min").factor == 60.0
    assert unit_table.find("cd").dimension.exponents == {"luminosity": 1}
    assert unit_table.find("ft").factor == 0.3048
    assert unit_table.find("kg").factor == 1.0
    assert unit_table.find("Pa").factor == 1.0


def test_unknown_and_offset_names_give_none():
    assert unit_table.find("furlonk") is None
    assert unit_table.find("degC") is None
