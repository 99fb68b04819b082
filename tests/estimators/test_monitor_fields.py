"""Every field of the monitor is named once, with a unit and a meaning, and configured once."""

from similitude.monitor_config import DESIGN
from similitude.program.library import shipped


def test_every_field_has_a_unit_and_a_meaning():
    layout = shipped("bicycle_monitor").layout
    for struct in (layout.CONFIG, layout.STATE, layout.SAMPLE, layout.OUTPUT):
        assert all(unit and meaning for _, unit, meaning, _ in struct)


def test_every_constant_of_the_design_is_a_field_and_none_is_left_out():
    fields = {name for name, *_ in shipped("bicycle_monitor").layout.CONFIG}

    assert fields - set(DESIGN) == {"L", "threshold_fall", "threshold_rise"}
    assert set(DESIGN) <= fields
