"""The enzyme against conservation, and against the law that is named after its authors."""

import numpy as np
import pytest

from similitude.systems.michaelis_menten import SYSTEM

from .held_run import held_run


def test_no_substrate_is_lost():
    run = held_run(SYSTEM)

    # 0.1 mol/m^3 at the start, 1 mol/(m^3 s) fed
    np.testing.assert_allclose(run["s"] + run["c"] + run["p"], 0.1 + 1.0 * run["t"], rtol=1e-8)


def test_the_numbers_make_the_michaelis_constant_of_the_source():
    p = SYSTEM.numbers()

    assert (p["koff"] + p["kcat"]) / p["kon"] == pytest.approx(0.05)  # mol/m^3, 50 umol/L


def test_with_little_enzyme_the_rate_is_vmax_s_over_km_plus_s():
    run = held_run(SYSTEM, e0="0.01 umol/L", feed="0 mol/(m^3 s)", duration="1 s")
    p = SYSTEM.numbers()
    law = p["kcat"] * 1e-5 * run["s"] / (0.05 + run["s"])  # mol/(m^3 s)

    # the error of the law is e0/(Km + s) = 1e-4 and smaller
    np.testing.assert_allclose(p["kcat"] * run["c"][1:], law[1:], rtol=2e-4)


def test_groups_compare_rates_within_a_turnover():
    groups = {g.parameter: dict(g.exponents) for g in SYSTEM.groups().groups}

    assert groups == {"kon": {"kon": 1, "e0": 1, "kcat": -1}, "koff": {"koff": 1, "kcat": -1}}
