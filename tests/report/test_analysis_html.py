"""The page of an analysis as HTML: well formed, escaped, typeset, and alone."""

import re
from xml.dom import minidom

import pytest

from similitude.report.analysis_html import analysis_html

from .analysis_case import NASTY, analysed, decay


@pytest.mark.parametrize("find", [lambda: analysed("bicycle"), lambda: analysed("saturating_bicycle"), decay])
def test_every_formula_is_well_formed(find):
    formulas = re.findall(r"<math.*?</math>", analysis_html(find()))

    assert len(formulas) >= 20
    for formula in formulas:
        minidom.parseString(re.sub(r"&(\w+);", "?", formula))


def test_groups_and_rates_are_typeset():
    page = analysis_html(analysed("bicycle"))

    assert "<msub><mi>π</mi><mn>3</mn></msub>" in page
    assert "<mfrac><mrow><mi>d</mi><msup><mi>v</mi><mo>*</mo></msup></mrow>" in page


def test_words_of_the_model_are_text():
    page = analysis_html(decay())

    assert NASTY not in page
    assert "&lt;b&gt;&amp;" in page


def test_nothing_is_loaded_and_equal_analyses_give_equal_bytes():
    page = analysis_html(analysed("bicycle"))

    assert not re.search(r"(?:src|href)\s*=|url\(|@import", page.split("<main>")[1].split("</main>")[0])
    assert page == analysis_html(analysed("bicycle"))
