"""A verdict follows from numbers; values keep digits that no machine changes."""

import numpy as np
import pytest

from similitude.paper.claim import CONDITION, FAILS, HOLDS, claim, identity_claim, number_claim, rounded


@pytest.mark.parametrize(
    ("ours", "conditioned", "verdict"),
    [(1.0, None, HOLDS), (2.0, 1.05, CONDITION), (2.0, 1.2, FAILS), (2.0, None, FAILS)],
)
def test_the_verdict_follows_from_the_numbers(ours, conditioned, verdict):
    made = number_claim(
        "x", "eq 0", "one", printed=1.0, ours=ours, tolerance=0.1, conditioned=conditioned, condition="c"
    )

    assert made.verdict == verdict
    assert made.condition == ("c" if verdict == CONDITION else "")


def test_an_identity_is_met_to_rounding_or_not_at_all():
    assert identity_claim("x", "eq 0", "i", 3e-15).ours == 0.0
    assert identity_claim("x", "eq 0", "i", 3e-3).verdict == FAILS


def test_digits_are_kept_not_decimals():
    assert rounded(0.00123456, 3) == 0.00123
    assert rounded([1234567.0, np.float64(0.1)], 2) == [1200000, 0.1]
    assert rounded("text") == "text" and rounded(float("nan")) is None and rounded(True) is True


def test_a_record_has_what_programs_read():
    record = claim("x", "eq 0", "s", printed=1, ours=2.0, holds=False, tolerance=0).record

    assert list(record)[:6] == ["id", "where", "printed", "ours", "verdict", "tolerance"]
