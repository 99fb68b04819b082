import numpy as np
import pytest

from similitude.report.html_chart import COLOURS, charts_json
from similitude.report.html_charts import charts_of, fault_spans
from similitude.report.panels import FAULTS
from similitude.status import STATUS


def test_every_chart_over_time_has_the_time_and_the_tint_of_the_trace(example_run):
    run = example_run(3000)
    charts = charts_of(run)
    over_time = [chart for chart in charts.values() if chart.sync == "time"]

    assert list(charts) == ["speed", "steer", "estimate", "yaw-rate", "innovation", "information", "lag"]
    assert len(over_time) == 6
    assert all(np.array_equal(chart.x, run.trace.t) for chart in over_time)
    assert len({chart.spans for chart in over_time}) == 1


def test_the_lines_are_those_of_the_run_in_degrees(example_run):
    run = example_run(500)
    charts = charts_of(run)
    measured, predicted = charts["yaw-rate"].lines

    np.testing.assert_allclose(np.radians(measured.y), run.trace.r_measured)
    np.testing.assert_allclose(np.radians(predicted.y), run.trace.r_predicted)
    np.testing.assert_allclose(np.radians(charts["steer"].lines[0].y), run.log.delta)
    np.testing.assert_allclose(charts["estimate"].lines[0].y, run.trace.K)


def test_the_band_of_K_is_its_95_percent_interval(example_run):
    run = example_run(500)
    band = charts_of(run)["estimate"].bands[-1]
    half = 1.96 * run.trace.ln_K_std

    np.testing.assert_allclose(np.log(band.upper / run.trace.K), half)
    np.testing.assert_allclose(np.log(run.trace.K / band.lower), half)


def test_a_clock_is_drawn_from_the_first_sample(example_run):
    run = example_run(500)
    run.trace.t = run.trace.t + 1.7e9
    chart = charts_of(run)["speed"]

    assert chart.x[0] == 0.0
    assert chart.x_label == "time since t = 1700000000.000 s"


def test_a_lag_that_was_not_scanned_has_no_chart(example_run):
    assert "lag" not in charts_of(example_run(300, scanned=False))


def test_lags_that_could_not_be_judged_are_left_out(example_run):
    run = example_run(300)
    run.lag.cost[:2] = np.inf

    assert charts_json({"lag": charts_of(run)["lag"]}).count("null") == 0
    assert charts_of(run)["lag"].y_range[1] > 0


def test_a_tint_covers_exactly_the_stretches_with_faults():
    t = np.arange(4000) / 100
    status = np.zeros(4000, np.int32)
    status[1000:2000] = STATUS["too_slow"]
    status[3000:3100] = STATUS["outside_linear"]
    slow, hard = fault_spans(t, status)

    assert (slow.colour, hard.colour) == ("too_slow", "outside_linear")
    assert (slow.start, slow.end) == (pytest.approx(10, abs=0.08), pytest.approx(20, abs=0.08))
    assert hard.end - hard.start == pytest.approx(1, abs=0.08)
    assert slow.share == hard.share == 1.0


def test_a_rare_fault_is_still_tinted():
    t = np.arange(60_000) / 100
    status = np.zeros(60_000, np.int32)
    status[30_000] = STATUS["bad_sample"]
    (span,) = fault_spans(t, status)

    assert span.start <= t[30_000] <= span.end
    assert 0 < span.share <= 0.25


def test_a_clean_drive_has_no_tint():
    assert fault_spans(np.arange(100.0), np.zeros(100, np.int32)) == ()


def test_every_fault_has_a_colour_of_the_page():
    assert set(FAULTS) <= set(COLOURS)
