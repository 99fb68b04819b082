"""Every equation of its part fails by no more than its tolerance."""

import pytest

from similitude.paper.equations_control import TABLE


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"eq {row[0]}")
def test_the_equation_holds_in_the_code_that_is_named(row):
    tolerance = row[4] if len(row) > 4 else 1e-9

    assert row[3]() <= tolerance
