"""Numbers as people read them."""

import math

from similitude.benchmark.wording import (
    ALARM,
    COLUMNS,
    MEANING,
    TERMINAL,
    bare,
    over_bound,
    percent,
    seconds,
    summary_line,
)

from .small_result import small_result


def test_shares_and_delays():
    assert [percent(x) for x in (None, 0.0, 0.0123, 1.0, -0.02)] == ["", "0 %", "1.2 %", "100 %", "-2.0 %"]
    assert percent(0.02, sign=True) == "+2.0 %" and bare(0.0123) == "1.2"
    assert [seconds(x) for x in (None, 1.234, math.inf)] == ["", "1.23 s", "never"]


def test_every_column_of_every_row_can_be_said():
    record = small_result().record
    for row in record["totals"]:
        assert all(isinstance(make(row), str) for make in {**COLUMNS, **ALARM, **TERMINAL}.values())


def test_every_column_is_explained():
    assert set(COLUMNS) <= set(MEANING)


def test_how_much_was_driven_is_said():
    assert summary_line(small_result().record).startswith("2 cells, 2 drives of 80 s (1 seeds a cell")


def test_the_bound_is_a_ratio_where_there_is_one():
    row = small_result().rows(estimator="population")[0]

    assert over_bound(row, None) == "" and over_bound(row, {"rms": 0.04}) == "1.25"
