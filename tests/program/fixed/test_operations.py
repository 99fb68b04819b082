"""Operations are counted along both ways of a guard."""

from tests.program.fixed.lowered import tiny_fixed

from similitude.program.fixed.operations import operations, used


def test_the_longer_way_counts_more_and_all_kinds_are_found():
    step = tiny_fixed().step

    assert operations(step, most=True) > operations(step, most=False) > 0
    assert {"mulw", "add", "const", "name"} <= used(step)
