"""The page: whole, strict HTML, every claim on it."""

import html
import re

import pytest

from similitude.paper import companion as page
from similitude.paper.claim import claim
from similitude.paper.companion import shown

from .reproduced import small


@pytest.fixture
def made(monkeypatch):
    """The page of a small reproduction; errata and the last section rest on claims it does not have."""
    monkeypatch.setattr(page, "ERRATA", ())
    monkeypatch.setattr(page, "_today", lambda done: page.section("What the paper's idea becomes today"))
    return page.companion(small())


def test_every_claim_and_equation_is_on_the_page(made):
    assert all(one.id in made and one.verdict in made for one in small().claims)
    assert made.count("data:image/png;base64,") == 9 and "eq 32" in made


def test_the_page_loads_nothing(made):
    assert re.findall(r'(?:src|href)="(?!data:|#)', made) == []
    assert "default-src 'none'" in made


def test_numbers_are_written_for_people():
    assert shown([-1.5, 2]) == "−1.5, 2" and shown("text") == "text"
    assert shown(2.5e-7) == "2.5 × 10⁻⁷" and shown(1e-9) == "10⁻⁹"


def test_text_is_escaped():
    made = claim("a<b", "eq 1", "x & y", printed="<i>", ours=1, holds=True, tolerance=0)
    assert "&lt;i&gt;" in page._subject("s", [made]) and "<i>" not in page._subject("s", [made])


def test_delays_and_changes_are_said_in_words():
    assert page._delay({"half_way": 0.0871}) == "0.09 s"
    assert page._delay({"half_way": float("inf")}) == "longer than the 10 s between two changes"
    assert page._percent(-0.449) == "−45 %" and page._percent(0.09) == "+9 %"


def test_minus_signs_in_reasons_are_true_ones():
    made = claim("a", "eq 1", "x", printed=0, ours=1, holds=True, tolerance=0, why="-1.3 at eqs 15-16, a2-1")
    assert "−1.3 at eqs 15-16, a2-1" in page._reason(made)


@pytest.mark.slow
def test_the_last_section_is_all_computed():
    """Each gain has its row, and what the regression cannot do is a number."""
    made = page._today(small())
    assert all(html.escape(words) in made for words in page.GAINS.values())
    assert "between two changes" in made and "not usable" not in made
    assert made.count("data:image/png;base64,") == 2
