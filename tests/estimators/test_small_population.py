"""The small population filter: the population filter's promises kept with fewer coordinates."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.estimators.population_filter import population_filter
from similitude.estimators.small_population import small_population_filter
from similitude.program.library import shipped
from similitude.simulate import bicycle_response
from similitude.status import STATUS
from similitude.systems.bicycle import bicycle_reduction

from ..filter_rig import NOISE, car_config, covariance, twin_of
from ..rough_drive import rough_drive
from ..small_systems import spring

LIBRARY = shipped("bicycle_small_population")
CONFIG = car_config(LIBRARY)
TRUTH = {"L": 2.7, "K": 130.0, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}


def drive(seconds, truth=TRUTH):
    """A lane-changing car with white noise on its yaw rate, 100 rows a second."""
    t = np.arange(100 * seconds) / 100
    steer = 6e-3 * np.sin(2 * np.pi * 0.4 * t) + 3e-3 * np.sin(2 * np.pi * 0.17 * t)
    yaw, _ = bicycle_response(t, steer, 25.0, **truth)
    yaw += NOISE * np.random.default_rng(0).standard_normal(t.size)
    return np.column_stack([np.full(t.size, 0.01), steer, np.full(t.size, 25.0), yaw])


def test_it_has_eight_coordinates_and_less_of_everything():
    full, small = population_filter(bicycle_reduction()), small_population_filter(bicycle_reduction())

    assert small.coordinates == ("v_star", "r_star", "disturbance", "K", "pi1", "eta", "rho", "output_bias")
    for struct in ("config", "state", "output"):
        names, more = ({f.name for f in getattr(p, struct)} for p in (small, full))
        assert names - {"longest", "turn"} < more  # of its shorter way through a sample
    assert [f.name for f in small.sample] == [f.name for f in full.sample]


def test_it_is_derived_from_any_reduction():
    assert small_population_filter(spring().reduction).name.endswith("_small_population")


def test_k_is_found_within_its_interval():
    state = LIBRARY.start(CONFIG)

    outputs, _ = LIBRARY.run(CONFIG, state, drive(60))

    error, sd = np.log(outputs[-1, 0] / TRUTH["K"]), np.sqrt(outputs[-1, 1])
    assert abs(error) < 3 * sd  # 3 sd: one run in 400 by chance, and this one is fixed
    assert sd < 0.12  # a quarter of the prior's 0.5


def test_twin_and_c_agree_on_every_bit_and_status():
    assert LIBRARY.c is not None, LIBRARY.why_slow
    rows = rough_drive(25_000, 3)
    state, twin = LIBRARY.start(CONFIG), twin_of(LIBRARY).start(CONFIG)

    out, status = LIBRARY.run(CONFIG, state, rows)
    other, codes = twin_of(LIBRARY).run(CONFIG, twin, rows)

    assert out.tobytes() == other.tobytes() and state.tobytes() == twin.tobytes()
    assert np.array_equal(status, codes)
    assert set(STATUS.values()) == set(np.unique(status).tolist())


@settings(max_examples=60, deadline=None)
@given(
    rows=st.lists(
        st.lists(st.floats(allow_nan=True, width=64), min_size=4, max_size=4), min_size=1, max_size=30
    )
)
def test_no_sample_can_disable_it(rows):
    state = LIBRARY.start(CONFIG)
    outputs, _ = LIBRARY.run(CONFIG, state, np.vstack([drive(2), rows]))

    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert (np.diag(covariance(LIBRARY, state)) > 0).all()
    again, status = LIBRARY.run(CONFIG, state, drive(5))
    assert np.isfinite(again).all() and status[-1] not in (STATUS["bad_sample"], STATUS["no_measurement"])


@pytest.mark.parametrize("steer_rms", [0.0, 1e-5])
def test_a_straight_road_teaches_nothing(steer_rms):
    rows = drive(60)
    rows[:, 1] = steer_rms * np.sin(rows[:, 0].cumsum())
    rows[:, 3] = NOISE * np.random.default_rng(1).standard_normal(len(rows))
    outputs, _ = LIBRARY.run(CONFIG, LIBRARY.start(CONFIG), rows)

    assert outputs[-1, 1] > 0.9 * 0.5**2  # the prior's variance
