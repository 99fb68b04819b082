"""A correct rewriting is proven, in symbols too, and a wrong one is caught with the difference."""

import dataclasses

import pytest
import sympy as sp

from similitude.rewriting.equivalence import prove_equivalence
from similitude.rewriting.rewritten import rewrite
from similitude.systems.bicycle import BICYCLE
from similitude.systems.saturating_bicycle import SATURATING_BICYCLE

BASE = ("m", "L", "U")


@pytest.mark.parametrize("model", [BICYCLE, SATURATING_BICYCLE], ids=lambda m: m.name)
def test_the_bicycles_are_proven_exactly_and_in_symbols(model):
    proof = prove_equivalence(rewrite(model, base=BASE))

    assert proof.holds and proof.exact and proof.not_shown == ()
    assert proof.in_symbols == ("rate of v", "rate of r", "output r")


def test_a_base_with_roots_is_proven_exactly():
    assert prove_equivalence(rewrite(BICYCLE, base=("m", "L", "Caf"))).exact


def test_a_rate_that_was_rewritten_wrongly_is_named():
    right = rewrite(BICYCLE, base=BASE)
    spoilt = {**right.groups.rates, "v": right.groups.rates["v"] + sp.Symbol("pi3", real=True) / 1000}
    wrong = dataclasses.replace(right, groups=dataclasses.replace(right.groups, rates=spoilt))

    assert list(prove_equivalence(wrong).wrong) == ["rate of v"]
