import numpy as np
import pytest

from similitude.report import html_tables
from similitude.status import STATUS


@pytest.fixture
def rows(strict_html):
    """Cells of a table, row by row, heading included."""
    return lambda markup: strict_html(markup).rows


def test_the_answer_with_and_without_the_mass(example_run, rows):
    with_mass = rows(html_tables.answer_table(example_run(500)))
    without = rows(html_tables.answer_table(example_run(500, with_mass=False)))

    assert [row[0] for row in with_mass] == ["", "K", "π3", "Caf"]
    assert [row[0] for row in without] == ["", "K", "π3"]
    assert with_mass[1][4] == "m²/s²"


def test_handling_is_in_degrees_with_its_interval(example_run, rows):
    (_, first, *_) = rows(html_tables.handling_table(example_run(300).handling))

    assert first[:5] == ["understeer gradient", "0.179", "0.023", "0.133 … 0.225", "deg/(m/s²)"]


def test_a_handling_number_nobody_thought_of_is_shown(rows):
    found = {"value": 1.0, "std": 0.1, "lo": 0.8, "hi": 1.2, "unit": "-", "meaning": "new"}
    (_, row) = rows(html_tables.handling_table({"very_new": found}))

    assert row == ["very new", "1.00", "0.10", "0.80 … 1.20", "–", "new"]


def test_groups_stand_beside_the_population(example_run, rows):
    (_, pi1, eta, rho) = rows(html_tables.groups_table(example_run(300).groups))

    assert (pi1[0], eta[0], rho[0]) == ("π1", "η", "ρ")
    assert eta[1:3] == ["1.395 ± 0.094", "1.42 ± 0.18"]
    assert eta[4] == "48 %"  # 1 - (0.094/1.395)/(0.185/1.42)


def test_a_prediction_that_could_not_be_judged_is_a_dash(rows):
    prediction = {"unit": "rad/s", "rms": {"estimate": None, "batch": 0.01, "frozen_averages": 0.02}}
    (_, estimate, batch, frozen) = rows(html_tables.prediction_table(prediction))

    assert estimate[1:3] == ["–", "–"]
    assert batch[1:4] == ["0.573", "1.00", "deg/s"]
    assert frozen[2] == "2.00"


def test_the_shares_of_the_rows_add_up(rows):
    status = np.array([STATUS["ok"]] * 5 + [STATUS["too_slow"]] * 3, np.int32)
    found = rows(html_tables.status_table(status))[1:]

    assert [row[:3] for row in found] == [["ok", "5", "62 %"], ["too slow", "3", "38 %"]]
    assert rows(html_tables.status_table(status[:5]))[1][2] == "100 %"


def test_the_record_is_told_with_all_digits(rows):
    record = {"a": {"b": 0.1234567890123456, "c": None}, "d": [1, 2.5], "e": "x < y"}

    assert rows(html_tables.record_table(record))[1:] == [
        ["a.b", "0.1234567890123456"],
        ["a.c", "null"],
        ["d", "[1, 2.5]"],
        ["e", "x < y"],
    ]


def test_what_was_given_and_what_came_alongside(example_run, rows):
    run = example_run(300)
    given = {row[0]: row[1] for row in rows(html_tables.assumed_table(run.assumed))}
    alongside = {row[0]: row[1:] for row in rows(html_tables.nuisance_table(run.nuisance))}

    assert (given["L"], given["Iz"], given["population"]) == ("2.69 m", "–", "passenger_cars")
    assert given["yaw_rate_noise"] == "0.1501 deg/s"
    assert alongside["yaw bias"] == ["−0.122", "0.010", "deg/s"]
