import re

import numpy as np
import pytest

from similitude.report.html_chart import Chart, Line
from similitude.report.html_page import (
    TONES,
    Html,
    anchor,
    aside,
    badge,
    bullets,
    details,
    facts,
    figure,
    interval,
    joined,
    lead,
    markup,
    page,
    paragraph,
    picture,
    section,
    strong,
    table,
)

EVIL = '</script><img src=x onerror="alert(1)">&amp; \'q\' "d" é 漢 \u202e {0} {title}'


@pytest.fixture
def chart():
    return Chart("Speed", "speed", np.arange(30.0), (Line(EVIL, np.arange(30.0)),), unit="m/s")


def _everything(text, chart):
    parts = [
        lead(paragraph(badge(text, "good"), strong(text), aside(text)), paragraph(text, quiet=True)),
        section("Facts", facts({text: text, "b": strong(text)}), bullets([text, strong(text)])),
        section("Table", table(["", text], [[text, text], [text, strong(text)]], numeric=[1])),
        section("Chart", figure("speed", chart), text),
    ]
    return page(text, parts, {"speed": chart})


def test_text_of_users_is_shown_as_it_is_and_is_never_markup(chart, strict_html):
    said = strict_html(_everything(EVIL, chart))

    assert said.text.count(" ".join(EVIL.split())) == 17
    assert "<img" not in _everything(EVIL, chart)
    assert said.data["charts"]["speed"]["lines"][0]["label"] == EVIL


@pytest.mark.parametrize(
    "text", ["", " ", "\x00\x1b[31m", "\ud800 lone", "a\nb", "]]>", "<!--", "{", "%s", "\u2028"]
)
def test_odd_text_leaves_a_valid_page(text, chart, strict_html):
    source = _everything(text, chart)

    assert strict_html(source)
    assert re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]", source) is None
    assert source.encode("utf-8")


def test_markup_is_escaped_once():
    assert markup("a & b") == "a &amp; b"
    assert markup(markup("a & b")) == "a &amp; b"
    assert joined([strong("<"), "<"], " & ") == "<strong>&lt;</strong> &amp; &lt;"
    assert isinstance(joined([]), Html)


def test_a_page_loads_nothing_and_equal_parts_give_equal_bytes(chart, strict_html):
    first, second = _everything("x", chart), _everything("x", chart)
    own = re.sub(r"/\*!.*?\*/", "", first)

    assert first == second
    assert strict_html(first)
    assert "default-src 'none'" in first
    assert not re.search(r"""(?:@import|url\(|fetch\(|XMLHttpRequest|import\()""", own)


def test_a_chart_without_a_place_is_a_mistake_of_ours(chart):
    with pytest.raises(KeyError, match="speed"):
        page("x", [paragraph("no chart")], {"speed": chart})


def test_a_badge_has_one_of_the_tones():
    assert all(f'class="badge {tone}"' in badge("ok", tone) for tone in TONES)
    with pytest.raises(KeyError):
        badge("ok", "purple")


def test_rows_of_a_table_are_as_long_as_its_head():
    with pytest.raises(ValueError):
        table(["a", "b"], [["only one"]])


@pytest.mark.parametrize(
    ("title", "wanted"),
    [("Handling", "handling"), ("The log, at a glance", "the-log-at-a-glance"), ("漢", "section")],
)
def test_the_anchor_of_a_section(title, wanted):
    assert anchor(title) == wanted
    assert f'<section id="{wanted}">' in section(title)


def test_a_caption_says_when_extremes_stand_for_samples(chart):
    long = Chart("Speed", "speed", np.arange(9000.0), (Line("v", np.arange(9000.0)),))

    assert "9000 samples by their extremes" in figure("speed", long)
    assert "extremes" not in figure("speed", chart)
    assert "speed [m/s]" in figure("speed", chart)


def test_a_bar_lies_within_the_picture_on_one_scale(strict_html):
    drawn = interval((2.0, 4.0), (0.0, 8.0))

    assert strict_html(drawn)
    assert re.findall(r' (?:x|width)="([\d.]+)"', drawn) == ["0.00", "100.00", "25.00", "25.00"]
    assert strict_html(interval((1.0, 1.0), (1.0, 1.0)))


def test_details_are_closed(strict_html):
    closed = details("<more>", paragraph("inside"))

    assert strict_html(closed).text == "<more> inside"
    assert "open" not in closed


def test_a_picture_is_part_of_the_page_and_its_words_are_escaped(strict_html):
    made = page("p", [section("s", picture(b"png", EVIL, EVIL, "note"))], {})
    said = strict_html(made)

    assert 'src="data:image/png;base64,cG5n"' in made
    assert said.text.count(" ".join(EVIL.split())) == 2 and "<img src=x" not in made
