"""Operations counted in the twin, and in the C by another count."""

import re
from pathlib import Path

from tests.paper.pinned import check

from similitude.paper.claims_cost import RECURSION, cost_claims, counted, operations
from similitude.program.library import shipped


def test_claims_are_the_pinned_ones():
    check("Cost", cost_claims())


def test_the_recursion_in_the_c_has_as_many():
    source = Path(shipped("bicycle_paper").layout.__file__).with_suffix(".c").read_text()
    lines = [re.sub(r"/\*.*?\*/", "", x).strip() for x in source.splitlines()]
    pattern = rf"(?:const real )?(?:s->|state->)?({'|'.join(RECURSION)})\s*=\s*(.+);"
    right = [
        found for found in (re.fullmatch(pattern, x) for x in lines) if found and "ratio" not in found[2]
    ]
    block = [m[2] for m in right if re.search(r"gain|residual|phi", m[2])]
    ops = sum(
        len(re.findall(r"[*/]|(?<=[\w)]) ?[+-] ?(?=[\w(])", re.sub(r"->", ".", text))) for text in block
    )

    assert block and ops == operations("bicycle_paper", RECURSION) == 13


def test_parts_are_less_than_the_whole():
    n = counted()
    assert n["recursion"] + n["regressor"] + n["high-pass"] < n["paper"] < n["linear filter"] < n["filter"]
    for name, key in (("bicycle_paper", "paper"), ("saturating_bicycle_population", "filter")):
        assert n[key] <= shipped(name).layout.OPERATIONS  # which counts comparisons too
