import json
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from similitude.report.html_report import TONES, html_report
from similitude.report.summary import summary

EVIL = '</script><script>alert("1")</script> \' & é 漢'
FILES = {"report": "out/report.html", "summary": "out/summary.json"}
ORDER = [
    *("The log at a glance", "Estimate", "Handling", "Groups against the population"),
    *("Estimated alongside", "Steering lag", "Prediction", "Where each number came from"),
    "Files and versions",
]


@pytest.fixture
def told(strict_html):
    """The page of a run, read strictly."""
    return lambda run: strict_html(html_report(run, summary(run, FILES)))


def test_the_page_tells_everything_in_order(example_run, told):
    said = told(example_run(3000)).text
    places = [said.index(title) for title in ORDER]

    assert places == sorted(places)
    assert said.index("identified") < said.index("The drive narrowed K") < said.index("Warnings") < places[0]


def test_every_number_of_the_summary_is_on_the_page(example_run, told):
    run = example_run(800)
    record = json.loads(json.dumps(summary(run, FILES)))
    cells = {row[0]: row[1] for row in told(run).rows if len(row) == 2}

    def check(part, path):
        if isinstance(part, dict):
            for key, inner in part.items():
                check(inner, f"{path}.{key}" if path else key)
        else:
            assert cells[path] == (part if isinstance(part, str) else json.dumps(part, ensure_ascii=False))

    check(record, "")


@pytest.mark.parametrize("verdict", list(TONES))
def test_every_verdict_has_its_badge_and_its_reason(example_run, told, verdict, verdicts):
    run = example_run(300, verdict=verdict)

    assert set(TONES) == set(verdicts)
    assert f"{verdict.replace('_', ' ')} K = " in told(run).text
    assert run.reason in told(run).text


def test_text_of_the_user_is_text(example_run, told):
    run = example_run(300)
    run.log.name = run.vehicle.name = run.reason = EVIL
    run.log.path = f"logs/{EVIL}.csv"
    run.log.sources = {"t": EVIL, EVIL: "r"}
    run.warnings = (EVIL, EVIL)
    run.assumed = {EVIL: SimpleNamespace(value=EVIL, unit="-", origin=EVIL)}
    run.handling = {EVIL: {"value": 1, "std": 1, "lo": 0, "hi": 2, "unit": EVIL, "meaning": EVIL}}
    run.nuisance = {EVIL: SimpleNamespace(value=1.0, std=0.1, unit=EVIL)}
    page = told(run)

    assert len(page.scripts) == 4  # theme, data, uPlot, drawing
    assert page.text.count(EVIL) >= 20
    assert "alert(" not in "".join(page.scripts)


def test_equal_runs_give_equal_bytes(example_run):
    first, second = (html_report(run, summary(run, FILES)) for run in (example_run(500), example_run(500)))

    assert first == second
    assert not re.search(r"20[2-9]\d-\d\d-\d\d", first)


def test_what_a_run_does_not_have_leaves_no_empty_section(example_run, told):
    run = example_run(300, scanned=False, with_mass=False)
    run.handling, run.groups, run.nuisance, run.prediction = {}, {}, {}, {}
    run.assumed, run.warnings = {}, ()
    said = told(run).text

    assert [title for title in ORDER if title in said] == [
        *("The log at a glance", "Estimate", "Steering lag"),
        *("Where each number came from", "Files and versions"),
    ]
    assert "No warnings." in said


def test_a_run_without_a_single_measurement_is_still_told(example_run, told):
    run = example_run(300)
    run.log.r = run.trace.r_measured = run.trace.innovation = np.full(300, np.nan)
    run.log.U = np.full(300, np.nan)

    assert "100 %" in told(run).text


@pytest.mark.parametrize(
    ("low", "high", "word"),
    [(1.0, 2.0, "understeers"), (-2.0, -1.0, "oversteers"), (-1, 1, "cannot be told")],
)
def test_handling_is_said_in_words(example_run, told, low, high, word):
    run = example_run(300)
    run.handling["understeer_gradient"] |= {"lo": low, "hi": high}

    assert word in told(run).text


def test_ten_minutes_make_less_than_a_megabyte_and_a_half(example_run, told):
    run = example_run(60_000)
    source = html_report(run, summary(run, FILES))
    lines = [line for chart in told(run).data["charts"].values() for line in chart["lines"]]

    assert len(source.encode()) < 1.5e6
    assert max(len(line["x"]) for line in lines) <= 4000
    assert "60000 samples by their extremes" in source


@pytest.mark.parametrize("estimator", ["population", "paper"])
def test_a_real_run_is_told_whole(told, estimator):
    from pathlib import Path

    from similitude.identification import identify
    from similitude.log import read_log
    from similitude.vehicle_file import read_vehicle

    data = Path(__file__).parents[2] / "data"
    car = read_vehicle(data / "rav4.toml")
    run = identify(read_log(data / "rav4_straight.csv", vehicle=car), car, estimator=estimator)
    said = told(replace(run, warnings=(*run.warnings, EVIL)))

    assert "Toyota RAV4" in said.text
    assert EVIL in said.text
    assert len(said.data["charts"]["estimate"]["lines"][0]["y"]) > 100


def test_a_cross_check_is_told_with_both_numbers_and_how_far_apart_they_are(example_run, told):
    run = example_run(800)
    assert "Cross-check" not in told(run).text

    K = SimpleNamespace(value=118.0, std=9.0, lo=101.0, hi=137.0, unit="m^2/s^2")
    run.cross_check = SimpleNamespace(
        K=K, population=run.K, apart=-0.31, std=0.2, average_apart=-0.2, average_std=0.11, unknowns=4,
        structure_error=False,
    )  # fmt: skip
    assert "Two estimators of different kinds agree" in told(run).text
    run.cross_check.std = 0.12
    said = told(run).text
    assert "agree" not in said and "2.6 sd apart" in said and "less than what is called" in said
    run.cross_check.std = 0.06
    run.cross_check.structure_error = True
    said = told(run).text
    assert "disagree" in said and "−31.0 %" in said and "5.2 sd" in said
