"""The heat exchanger against effectiveness and number of transfer units, and the textbook's example."""

import numpy as np
import pytest

from similitude.systems.heat_exchanger import SYSTEM, UA, Cc, Ch, Th, q

from .held_run import held_run


def test_the_oil_cooler_of_the_textbook_gives_8524_watts():
    """The source rounds U, so its length is good to three digits."""
    assert held_run(SYSTEM)["q"][0] == pytest.approx(8524, rel=5e-3)


@pytest.mark.parametrize(("hot", "cold"), [(213.1, 835.6), (835.6, 213.1), (1.0, 0.99)])
@pytest.mark.parametrize("conductance", [1.0, 200.0, 5000.0])
def test_the_flow_is_effectiveness_times_the_smaller_flow(hot, cold, conductance):
    least, most = min(hot, cold), max(hot, cold)
    ratio, units = least / most, conductance / least
    with np.errstate(under="ignore"):
        x = np.exp(-units * (1 - ratio))
    effectiveness = (1 - x) / (1 - ratio * x)  # counterflow
    point = {Ch: hot, Cc: cold, UA: conductance, Th: 1.0, "T": 0.0}
    flow = q.subs({s: point.get(s, point.get(str(s))) for s in q.free_symbols})

    assert float(flow) == pytest.approx(effectiveness * least, rel=1e-9)


def test_the_store_warms_up_exponentially():
    run, p = held_run(SYSTEM), SYSTEM.numbers()
    gain = run["q"][0] / 70.0  # W/K

    np.testing.assert_allclose(run["T"], 70 * (1 - np.exp(-gain * run["t"] / p["M"])), atol=1e-6)


def test_the_groups_are_transfer_units_and_the_ratio_of_flows():
    groups = {g.parameter: dict(g.exponents) for g in SYSTEM.groups().groups}

    assert groups == {"UA": {"UA": 1, "Cc": -1}, "Ch": {"Ch": 1, "Cc": -1}}
