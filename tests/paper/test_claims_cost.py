"""Operations counted in the twin, and in the C by another count."""

import re
from pathlib import Path

from similitude.paper.claims_cost import RECURSION, cost_claims, counted, operations
from similitude.program.library import shipped

from .pinned import check


def test_claims_are_the_pinned_ones():
    check("Cost", cost_claims())


def test_the_recursion_in_the_c_has_as_many():
    """The three lines as text: signs between spaces, stars and strokes."""
    source = Path(shipped("bicycle_paper").layout.__file__).with_suffix(".c").read_text()
    pattern = rf"(?:const bicycle_paper_real |state->)?(?:{'|'.join(RECURSION)}) = (.+);"
    right = [found[1] for found in re.finditer(pattern, source) if "phi" in found[1]]
    count = sum(len(re.findall(r"[*/]| [+-] ", text)) for text in right)

    assert len(right) == 3 and count == operations("bicycle_paper", RECURSION) == 9


def test_parts_are_less_than_the_whole():
    n = counted()
    assert n["recursion"] + n["regressor"] + n["high-pass"] < n["paper"] < n["linear filter"] < n["filter"]
    for name, key in (("bicycle_paper", "paper"), ("saturating_bicycle_population", "filter")):
        assert n[key] <= shipped(name).layout.OPERATIONS  # which counts comparisons too
