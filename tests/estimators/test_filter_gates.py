"""What a sample must be before it is used, and what starting anew leaves of what was known."""

import math

import pytest

from similitude.estimators.filter_fields import Layout
from similitude.estimators.filter_gates import anew_lines, gates, restart
from similitude.status import STATUS
from similitude.systems.bicycle import bicycle_reduction

from ..run_statements import run_statements

LAYOUT = Layout(bicycle_reduction(), errors=("output_bias",), followed=False, fine=False, lean=True)
BEFORE = {"last_input": 0.01, "last_U": 20.0, "age": 0.0, "started": 1.0, "status": 0, "gap": 1.0}
LIMITS = {"input_limit": 1.3, "signal_limit": 150.0, "output_limit": 12.0, "K_prior": 140.0}
GOOD = {"dt": 0.01, "input": 0.02, "U": 21.0, "measured": 0.1}


def gated(**changes):
    return run_statements([*gates(LAYOUT), *restart(LAYOUT)], {**BEFORE, **LIMITS, **GOOD, **changes})


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, 1e9])
@pytest.mark.parametrize("field", ["input", "U", "measured"])
def test_a_value_beyond_belief_is_held_and_teaches_nothing(field, bad):
    done = gated(**{field: bad})

    assert done["usable"] == 0 and done["status"] == STATUS["no_measurement"] and done["anew"] == 0
    assert done["u_now"] == (BEFORE["last_input"] if field == "input" else GOOD["input"])
    assert done["U_now"] == (BEFORE["last_U"] if field == "U" else GOOD["U"])


def test_a_gap_and_a_walk_start_anew():
    assert gated()["anew"] == 0 and gated()["usable"] == 1
    late = gated(age=1.0)
    assert late["anew"] == 1 and late["usable"] == 1 and late["status"] == STATUS["restarted"]
    unseen = gated(age=1.0, measured=math.nan)
    assert unseen["anew"] == 1 and unseen["status"] == STATUS["no_measurement"]
    slow = gated(U=3.0)  # pi3 = K/U^2 above ten
    assert slow["anew"] == 1 and slow["usable"] == 0 and slow["status"] == STATUS["too_slow"]


def test_what_is_slow_outlives_a_start_anew():
    P = LAYOUT.covariance
    known = {name: 2.0 for name in (*LAYOUT.coordinates, "surprise", "heard")}
    known |= {P.target(i, j): 1.0 for i in range(P.n) for j in range(i, P.n)}
    config = {"v_star_sd": 0.1, "r_star_sd": 0.2, "disturbance_scale": 1.0, "disturbance_floor": 1e-3}

    done = run_statements(anew_lines(LAYOUT), {**known, **config})

    assert done["v_star"] == done["r_star"] == done["disturbance"] == done["heard"] == 0
    assert done["K"] == 2.0 and done["surprise"] == 1
    assert [done[P.target(i, i)] for i in range(3)] == pytest.approx([0.01, 0.04, 1e-6])
    assert done[P.target(0, 3)] == 0 and done[P.target(3, 4)] == 1.0
