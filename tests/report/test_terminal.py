import io
from types import SimpleNamespace

import numpy as np
import pytest
from rich.console import Console

from similitude.report.cost_curve import BARS, cost_curve
from similitude.report.terminal import print_run

FILES = {"estimate": "similitude-out/ring_road/estimate.parquet"}


def _page(run, width=80, **options):
    console = Console(file=io.StringIO(), width=width, **options)
    print_run(run, console, files=FILES)
    return console.file.getvalue()


@pytest.mark.parametrize("width", [80, 120])
def test_the_page_holds_every_finding_and_stays_within_its_width(example_run, width):
    run = example_run(3000)
    text = _page(run, width)
    words = " ".join(text.split())
    assert max(map(len, text.splitlines())) <= width
    for expected in (
        "identified", run.reason, "m²/s²", "π3", "N/rad", "understeer gradient", "deg/(m/s²)", "η",
        "yaw bias", "40 ms scanned", "vehicle file estate.toml", "1480 fresh samples",
        "a gap of 1.8 s",
        "similitude-out/ring_road/estimate.parquet", "passenger_cars",
    ):  # fmt: skip
        assert expected in words


def test_nothing_given_leaves_no_empty_section(example_run):
    run = example_run(500, with_mass=False, scanned=False)
    run.handling, run.nuisance, run.groups, run.prediction, run.assumed = {}, {}, {}, {}, {}
    run.warnings = ()
    text = _page(run)
    for title in ("Handling", "Groups", "Estimated", "Prediction", "Taken", "Warnings", "N/rad"):
        assert title not in text


def test_square_brackets_of_the_user_are_text_not_colour(example_run):
    run = example_run(500)
    run.warnings = ("column [bold] of SWA [deg] is empty",)
    assert "column [bold] of SWA [deg] is empty" in _page(run)


def test_every_verdict_is_printed_in_words(example_run, verdicts):
    for verdict in verdicts:
        assert verdict.replace("_", " ") in _page(example_run(200, verdict=verdict))


def test_a_value_that_is_not_finite_is_a_dash(example_run):
    run = example_run(200)
    run.K.value = run.K.std = run.K.lo = run.K.hi = np.nan
    run.prediction["rms"]["estimate"] = None
    run.pi3["std"] = np.inf
    assert "nan" not in _page(run).lower()


def test_the_lowest_bar_of_the_cost_curve_is_the_chosen_lag(example_run):
    text = cost_curve(example_run(200).lag).plain
    bars = [c for c in text if c in BARS]
    assert len(bars) == 21  # lags 0 to 200 ms in steps of 10 ms
    assert bars[4] == BARS[0]  # 40 ms
    assert bars[-1] == BARS[-1]


def test_a_flat_cost_curve_is_said_to_tell_nothing(example_run):
    lag = example_run(200).lag
    lag.cost = np.full(21, 0.3)
    assert "cannot tell" in cost_curve(lag).plain


def test_a_long_scan_is_shortened_and_keeps_its_minimum(example_run):
    lag = example_run(200).lag
    lag.lags = np.linspace(0, 0.5, 501)
    lag.cost = 1e4 * (lag.lags - 0.133) ** 2
    lag.chosen = 0.133
    bars = [c for c in cost_curve(lag).plain if c in BARS]
    assert len(bars) <= 40
    assert BARS[0] in bars


def test_a_lag_from_the_vehicle_file_has_no_curve(example_run):
    text = cost_curve(example_run(200, scanned=False).lag).plain
    assert text == "40 ms   vehicle file"


def test_the_second_opinion_stands_beside_the_first(example_run):
    run = example_run(500)
    K = SimpleNamespace(value=118.0, std=9.0, lo=101.0, hi=137.0, unit="m^2/s^2")
    run.cross_check = SimpleNamespace(K=K)

    assert "K, 2nd" in _page(run) and "118" in _page(run)
