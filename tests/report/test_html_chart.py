import json

import numpy as np
import pytest

from similitude.report.html_chart import COLOURS, Band, Chart, Line, Span, charts_json

N = 50_000


def _drawn(**changes):
    x = np.arange(200) / 10
    given = {"title": "a", "y_label": "a", "x": x, "lines": (Line("a", np.sin(x)),)} | changes
    return json.loads(charts_json({"it": Chart(**given)}), parse_constant=lambda token: 1 / 0)


def test_values_come_back_to_seven_digits_and_time_to_nine():
    x = 1e6 + np.cumsum(np.full(200, 0.001))
    y = np.random.default_rng(1).standard_normal(200) * 10.0 ** np.arange(-100, 100)
    line = _drawn(x=x, lines=(Line("a", y),))["charts"]["it"]["lines"][0]

    np.testing.assert_allclose(line["y"], y, rtol=5.01e-7)
    np.testing.assert_allclose(line["x"], x, rtol=5.01e-9)


def test_a_gap_is_a_null_between_its_neighbours():
    x = np.concatenate((np.arange(50), 100 + np.arange(50))) / 10.0
    line = _drawn(x=x, lines=(Line("a", x),))["charts"]["it"]["lines"][0]
    (at,) = [i for i, y in enumerate(line["y"]) if y is None]

    assert line["x"][at - 1] < line["x"][at] < line["x"][at + 1]
    assert line["x"] == sorted(set(line["x"]))


def test_missing_values_are_left_out_and_every_extreme_stays():
    y = np.random.default_rng(2).standard_normal(N)
    y[::7] = np.nan
    y[31_111], y[12_345] = 99.0, -99.0
    line = _drawn(x=np.arange(N) / 100, lines=(Line("a", y),))["charts"]["it"]["lines"][0]
    known = [v for v in line["y"] if v is not None]

    assert len(line["y"]) <= 4000
    assert (max(known), min(known)) == (99.0, -99.0)


def test_a_band_is_never_narrower_than_the_truth():
    x = np.arange(N) / 100
    upper = 1 + np.random.default_rng(3).random(N)
    band = _drawn(x=x, lines=(Line("a", x),), bands=(Band("b", -upper, upper),))["charts"]["it"]["bands"][0]

    assert max(band["upper"]) == pytest.approx(upper.max(), rel=1e-6)
    assert len(band["upper"]) <= 2000
    assert band["lower"] == [-v for v in band["upper"]]


def test_a_constant_band_takes_two_points():
    band = _drawn(bands=(Band("b", 1, 2.5),))["charts"]["it"]["bands"][0]

    assert (band["x"], band["lower"], band["upper"]) == ([0.0, 19.9], [1.0, 1.0], [2.5, 2.5])


def test_charts_with_equal_spans_share_one_list():
    x = np.arange(30.0)
    tint = (Span(1.0, 2.0, "too_slow", 0.333),)
    charts = {n: Chart(n, n, x, (Line(n, x),), spans=s) for n, s in [("a", tint), ("b", ()), ("c", tint)]}
    record = json.loads(charts_json(charts))

    assert record["spans"] == [[[1.0, 2.0, "too_slow", 0.33]], []]
    assert [record["charts"][n]["spans"] for n in "abc"] == [0, 1, 0]


def test_json_is_ascii_and_cannot_end_its_script():
    text = charts_json(
        {"a": Chart("</script>é\u2028", "<!--", np.arange(9.0), (Line("&]]>", np.arange(9.0)),))}
    )

    assert text.isascii()
    assert not set(text) & set("<>&")
    assert json.loads(text)["charts"]["a"]["title"] == "</script>é\u2028"


def test_a_line_that_was_never_measured_is_empty():
    line = _drawn(lines=(Line("a", np.full(200, np.nan)),))["charts"]["it"]["lines"][0]

    assert line["x"] == line["y"] == []


def test_every_colour_is_in_the_style_sheet_for_light_and_dark():
    from similitude.report.html_page import page

    style = page("x", [], {})

    assert all(style.count(f"--{name}: #") == 3 for name in COLOURS)
