"""No more unknowns are learnt than the drive tells directions."""

import numpy as np
import pytest
import sympy as sp

from similitude import shipped_system
from similitude.any_model.untold import rank_told
from similitude.population import Prior
from similitude.reduction import Reduction, Unknown

NAMES = ("x", "y", "z")
UNKNOWNS = tuple(Unknown(n, "-", "log", "estimate", n) for n in NAMES)
GROUPS = shipped_system("quarter_car").groups()
REDUCTION = Reduction(GROUPS, UNKNOWNS, {g.name: sp.Symbol(n, real=True) for g, n in
                                         zip(GROUPS.groups, NAMES, strict=True)}, sp.true)  # fmt: skip
PRIOR = Prior(NAMES, ("log",) * 3, np.ones(3), np.diag([0.3, 0.2, 0.1]) ** 2)


@pytest.mark.parametrize("told", [1, 2, 3])
def test_learnt_unknowns_are_as_many_as_directions_told(told):
    rng = np.random.default_rng(told)
    slopes = rng.standard_normal((400, told)) @ np.linalg.qr(rng.standard_normal((3, 3)))[0][:told] * 30
    ranked = rank_told(REDUCTION, PRIOR, slopes)
    learnt = [one for one in ranked.roles if one.role in ("identify", "estimate")]

    assert len(learnt) == told
    assert {one.chosen for one in ranked.roles} == {"rule"}


def test_the_users_role_stands():
    slopes = np.random.default_rng(0).standard_normal((400, 3)) * [100, 100, 1e-3]
    ranked = rank_told(REDUCTION, PRIOR, slopes, roles={"x": "consider"})

    assert next(one for one in ranked.roles if one.name == "x").chosen == "yours"
