"""The filter as its user sees it: what each kind of sample does, and that nothing breaks it."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from similitude.errors import ProgramError
from similitude.estimators.population_filter import WORKING, population_filter
from similitude.program.ir import Assign, walk
from similitude.simulate import bicycle_response
from similitude.status import STATUS
from similitude.systems.bicycle import bicycle_reduction

from ..filter_rig import CAR, NOISE, car, car_config, covariance
from ..small_systems import spring

LIBRARY = car()
CONFIG = car_config(LIBRARY)
TRUTH = {"L": 2.7, "K": 130.0, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}
DT, STEER, SPEED, YAW = range(4)


def good_drive(samples, *, seed=0, speed=25.0):
    """A lane-changing car, 6 mrad of steer at 0.4 Hz."""
    t = np.arange(samples) * 0.01
    steer = 6e-3 * np.sin(2 * np.pi * 0.4 * t) + 3e-3 * np.sin(2 * np.pi * 0.17 * t)
    yaw, _ = bicycle_response(t, steer, speed, **TRUTH)
    yaw += NOISE * np.random.default_rng(seed).standard_normal(samples)
    return np.column_stack([np.full(samples, 0.01), steer, np.full(samples, speed), yaw])


DRIVE = good_drive(4000)


def after(rows):
    """A state after the rows from the start."""
    state = LIBRARY.start(CONFIG)
    LIBRARY.run(CONFIG, state, rows)
    return state


LEARNT = after(DRIVE[:3000])


def feed(rows, *, state=LEARNT):
    """Outputs, statuses and the state after, from a copy of a state."""
    state = state.copy()
    outputs, status = LIBRARY.run(CONFIG, state, np.atleast_2d(rows))
    return outputs, status, state


def named(state, name):
    return state[LIBRARY.index("state", name)]


def assert_sound(outputs, state):
    """Every number finite, every variance positive, every unknown inside its limits."""
    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert (outputs[:, 1] > 0).all() and (outputs[:, 4] > 0).all()
    assert (np.diag(covariance(LIBRARY, state)) > 0).all()
    for name in CAR.names:
        low, high = (CONFIG[LIBRARY.index("config", f"{name}_{end}")] for end in ("low", "high"))
        assert low <= named(state, name) <= high


def test_the_state_before_the_first_sample_is_the_prior():
    state = LIBRARY.start(CONFIG)
    P = covariance(LIBRARY, state)
    at = [LIBRARY.layout.COORDINATES.index(n) for n in CAR.names]

    assert [named(state, n) for n in CAR.names] == CAR.mean.tolist()
    assert np.array_equal(P[np.ix_(at, at)], CAR.covariance)
    assert named(state, "v_star") == named(state, "started") == 0


def test_a_good_drive_is_learnt_from_and_the_truth_is_found():
    outputs, status, _ = feed(DRIVE[3000:])

    sd = np.sqrt(outputs[-1, 1])
    assert (status == STATUS["ok"]).all()
    assert sd < 0.15 and abs(np.log(outputs[-1, 0] / TRUTH["K"])) < 3 * sd


def test_a_missing_yaw_rate_is_predicted_over():
    rows = DRIVE[3000:3050].copy()
    rows[:, YAW] = np.nan
    outputs, status, state = feed(rows)

    assert (status == STATUS["no_measurement"]).all()
    assert (outputs[:, 3] == 0).all()
    # half a second without a measurement: the model alone is still within its structural error
    assert np.abs(outputs[:, 2] - DRIVE[3000:3050, YAW]).max() < 5 * NOISE
    assert outputs[-1, 0] == pytest.approx(named(LEARNT, "K"), rel=1e-3)
    assert named(state, "age") == pytest.approx(0.5)


@pytest.mark.parametrize("column", [STEER, SPEED])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e9, -1e9])
def test_a_missing_input_is_held(column, value):
    row, held = DRIVE[3000].copy(), DRIVE[3000].copy()
    row[column] = value
    held[column] = DRIVE[2999, column]
    held[YAW] = np.nan

    ours, theirs = feed(row), feed(held)

    assert ours[1][0] == theirs[1][0] == STATUS["no_measurement"]
    assert ours[2].tobytes() == theirs[2].tobytes()


@pytest.mark.parametrize("dt", [0.0, -0.01, np.nan, -np.inf, 1e-9, 5e-324])
def test_a_sample_that_does_not_advance_changes_nothing(dt):
    row = DRIVE[3000].copy()
    row[DT] = dt

    _, status, state = feed(row)

    assert status[0] == STATUS["bad_sample"]
    assert state.tobytes() == LEARNT.tobytes()


@pytest.mark.parametrize("dt", [np.inf, 1e6, 1e300])
def test_after_an_endless_pause_the_dynamics_start_anew(dt):
    rows = DRIVE[3000:3002].copy()
    rows[0, DT] = dt

    _, status, _ = feed(rows)

    assert status.tolist() == [STATUS["bad_sample"], STATUS["restarted"]]


@pytest.mark.parametrize("pause", [1.5, 60.0, 9e5])
def test_a_gap_restarts_the_dynamics_and_keeps_no_more_than_is_known(pause):
    rows = DRIVE[3000:3200].copy()
    rows[0, DT] = pause

    outputs, status, state = feed(rows)

    assert status[0] == STATUS["restarted"] and (status[1:] != STATUS["restarted"]).all()
    assert outputs[0, 1] <= CAR.covariance[0, 0] * 1.001  # at most the population's variance
    assert outputs[0, 4] > (0.5 * rows[0, SPEED] / 2.7 * 0.1) ** 2  # the yaw rate is unknown
    assert_sound(outputs, state)


def test_a_long_loss_of_the_gyro_is_no_measurement_then_one_restart():
    rows = DRIVE[2000:3000].copy()
    rows[300:600, YAW] = np.nan  # three seconds; the gap is one

    _, status, _ = feed(rows, state=after(DRIVE[:2000]))

    assert (status[300:600] == STATUS["no_measurement"]).all()
    assert np.nonzero(status == STATUS["restarted"])[0].tolist() == [600]


@pytest.mark.parametrize("speed", [0.0, -3.0, 0.5, 3.5])
def test_too_slow_to_show_the_dynamics(speed):
    rows = DRIVE[3000:3300].copy()
    rows[:, SPEED] = speed
    outputs, status, state = feed(rows)

    assert (status == STATUS["too_slow"]).all()
    assert (outputs[:, 3] == 0).all()
    # three seconds: at most 3 s x 2e-3/s more variance, and next to no pull
    assert outputs[-1, 0] == pytest.approx(named(LEARNT, "K"), rel=0.01)
    assert_sound(outputs, state)
    assert feed(DRIVE[3000], state=state)[1][0] == STATUS["restarted"]


def test_beyond_the_linear_range_is_said():
    rows = good_drive(600, speed=25.0)
    rows[:, [STEER, YAW]] *= 8  # 0.05 rad at 25 m/s: over 1 g

    _, status, _ = feed(rows)

    assert (status == STATUS["outside_linear"]).mean() > 0.5


def test_an_unknown_outside_the_population_stays_at_its_limit():
    rows = good_drive(6000)
    rows[:, YAW] = 3.0 * rows[:, STEER] * rows[:, SPEED] / 2.7  # no car of the population does that

    outputs, status, state = feed(rows, state=LIBRARY.start(CONFIG))

    assert (status == STATUS["at_limit"]).any()
    assert_sound(outputs, state)


def test_the_physical_yaw_rate_and_slip_survive_a_change_of_speed():
    """One millisecond after a jump of speed the state is the same in physical units."""
    row = DRIVE[3000].copy()
    row[DT], row[SPEED], row[YAW] = 1e-5, 20.0, np.nan
    _, _, state = feed(row)

    before, now = (
        [named(s, "r_star") * speed / 2.7, named(s, "v_star") * speed]
        for s, speed in ((LEARNT, 25.0), (state, 20.0))
    )
    # in 1e-5 s at 30/s the state moves by 3e-4 of its size, here 0.1 rad/s and 1 m/s
    assert now == pytest.approx(before, abs=1e-3)


def test_going_on_from_a_saved_state_is_going_on():
    whole = after(DRIVE)
    saved = after(DRIVE[:1234]).tolist()
    _, _, state = feed(DRIVE[1234:], state=np.array(saved))

    assert state.tobytes() == whole.tobytes()


def bits_to_floats(bits):
    return np.array(bits, dtype=np.uint64).view(np.float64).reshape(-1, 4)


any_bits = st.integers(0, 2**64 - 1)
near = st.floats(-50, 50).map(lambda v: int(np.float64(v).view(np.uint64)))
rows_of_anything = st.lists(st.tuples(*[st.one_of(any_bits, near)] * 4), min_size=1, max_size=25)


def as_bits(*rows):
    return [tuple(int(v) for v in np.array(row, dtype=float).view(np.uint64)) for row in rows]


# one wild row before anything is known
FIRST_ROW = as_bits(*[(0, 0, 0, 0)] * 6, (0.77, 0, 17.5, 0.37))
# the state was scaled up to a crawl, and not back down again when the car moved on
STOP_AND_GO = as_bits(*[(0, 0, 0, 0)] * 8, (4.12, 0, 0, 0), (1, 0, 3.82, 0), (1, 0, 0, 0))


@settings(max_examples=150, deadline=None)
@given(rows_of_anything, st.booleans())
@example(STOP_AND_GO, False)
@example(FIRST_ROW, True)
def test_no_bits_whatever_break_the_state(bits, fresh):
    start = LIBRARY.start(CONFIG) if fresh else LEARNT
    garbage = bits_to_floats(bits)

    outputs, status, state = feed(garbage, state=start)

    assert_sound(outputs, state)
    assert set(status.tolist()) <= set(STATUS.values())
    outputs, status, state = feed(DRIVE[3000:3500], state=state)
    assert_sound(outputs, state)
    # a few good seconds later (a first row that is wild makes the noise large, and that is forgotten
    # over seconds) it predicts the yaw rate again: within 5 of its own sd, and the sd is
    # no more than a tenth of the yaw rate's swing (0.15 rad/s) above the gyro's
    late = outputs[400:]
    assert np.abs(late[:, 3] / np.sqrt(late[:, 4])).mean() < 2
    assert np.sqrt(np.mean(late[:, 3] ** 2)) < 5 * NOISE + 0.015


@pytest.mark.slow
@settings(max_examples=5000, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_no_bits_whatever_break_the_state_however_many(seed):
    random = np.random.default_rng(seed)
    garbage = random.integers(0, 2**64, (1000, 4), dtype=np.uint64).view(np.float64)
    tame = random.random((1000, 4)) < 0.7
    garbage[tame] = (DRIVE[random.integers(0, 4000, 1000)] * random.normal(1, 2, (1000, 4)))[tame]

    outputs, _, state = feed(garbage)

    assert_sound(outputs, state)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_any_sensible_configuration_is_sound_over_a_rough_minute(seed):
    """Noise, lengths and priors over several orders of magnitude."""
    random = np.random.default_rng(seed)
    changes = {
        "noise_variance": 10 ** random.uniform(-10, -3),
        "gap": 10 ** random.uniform(-1, 2),
        "input_scale_sd": 10 ** random.uniform(-4, -0.5),
        "disturbance_floor": 10 ** random.uniform(-5, -2),
    }
    config = car_config(LIBRARY, L=10 ** random.uniform(-1, 1))
    for name, value in changes.items():
        config[LIBRARY.index("config", name)] = value
    rows = DRIVE.copy()
    rows[:, [STEER, YAW]] *= 10 ** random.uniform(-2, 1.5)
    rows[random.random(len(rows)) < 0.01, YAW] += random.normal(0, 3)
    state = LIBRARY.start(config)

    outputs, _ = LIBRARY.run(config, state, rows)

    assert np.isfinite(outputs).all() and np.isfinite(state).all()
    assert (outputs[:, 1] > 0).all() and (np.diag(covariance(LIBRARY, state)) > 0).all()


def test_an_unknown_may_not_have_the_name_of_a_working_value():
    case = spring().reduction
    first = replace(case.unknowns[0], name="p")
    taken = replace(
        case,
        unknowns=(first, case.unknowns[1]),
        substitution=case.substitution | {"pi1": sp.Symbol("p", real=True)},
    )
    with pytest.raises(ProgramError, match="uses p for something else"):
        population_filter(taken)


def test_the_list_of_working_values_is_complete():
    """Every temporary whose name holds no name of the model is reserved."""
    program = population_filter(bicycle_reduction())
    fields = (program.config, program.state, program.sample, program.output, program.variables)
    declared = {s.name for kind in fields for f in kind for s in f.symbols}
    temporaries = {s.target for s in walk(program.step) if isinstance(s, Assign)} - declared
    model = {"v_star", "r_star", "U", "L", "delta", "r", *CAR.names, "input_scale"}
    own = {
        t
        for t in temporaries
        if t.isalpha() or (not any(t.endswith(f"_{n}") for n in model) and not t[-1].isdigit())
    }

    assert {t for t in own if not t.startswith(("d_", "f_", "F_"))} <= WORKING
