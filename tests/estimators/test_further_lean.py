"""A second measurement on a small part: its covariance, a dense Kalman update, no harm without it."""

import numpy as np
import pytest
import sympy as sp

from similitude.accelerometer import Accelerometer
from similitude.errors import ProgramError
from similitude.estimators.filter_fields import BIAS, Layout
from similitude.estimators.further_lean import by_rates, forget
from similitude.estimators.small_population import small_population_filter
from similitude.filter_config import filter_config
from similitude.program.library import shipped
from similitude.status import STATUS
from similitude.systems.bicycle_with_accelerometer import (
    bicycle_with_accelerometer_reduction,
    small_accelerometer_reduction,
)

from ..banked_drive import BEHIND, banked_drive
from ..filter_rig import CAR, NOISE, Float32, covariance, twin_of
from .test_further_output import rough_with_ay

WITH = shipped("bicycle_with_accelerometer_small_population")
WITHOUT = shipped("bicycle_small_population")
NAMES = WITH.layout.COORDINATES
LOGS = ("K", "eta", "rho")
L, U = 2.65, 25.0
SHORT = 1e-3  # s: so short that the derivative of a step is that of its rates, to a part in a thousand


def config_of(library, **changes):
    meter = Accelerometer(BEHIND, 0.05, 0.1)
    return filter_config(
        library, CAR, L=L, noise_std=NOISE, input_scale_sd=0.02, accelerometer=meter, **changes
    )


def drive(**more):
    log, _ = banked_drive(**more)
    return np.column_stack([np.full(log.samples, 0.01), log.delta, log.U, log.r, log.ay])


def get(state, name):
    return state[WITH.index("state", name)]


def layout_of(reduction):
    return Layout(reduction, errors=(BIAS,), monitored=False, followed=False, fine=False, lean=True)


def test_lateral_acceleration_is_a_sum_of_rates_and_states():
    """ay = v' + U r + ahead r'."""
    layout = layout_of(small_accelerometer_reduction())

    a, b = by_rates(layout, layout.further[0])

    assert a == (1, sp.Symbol("lead", real=True)) and b == (0, 1)


def test_an_output_that_is_none_is_refused():
    with pytest.raises(ProgramError, match="no place for its output ay"):
        small_population_filter(bicycle_with_accelerometer_reduction())


def test_what_is_forgotten_is_beyond_belief():
    (line,) = forget(layout_of(small_accelerometer_reduction()))

    assert line.target == "last_ay" and line.expression.subs(sp.Symbol("ay_limit", real=True), 60) == 120


@pytest.mark.parametrize("nothing", [np.nan, 1e9, np.inf])
def test_without_the_measurement_it_is_the_filter_without(nothing):
    rows = drive(seconds=20)
    plain, config = config_of(WITHOUT), config_of(WITH)
    expected, codes = WITHOUT.run(plain, WITHOUT.start(plain), rows[:, :4])
    rows[:, 4] = nothing

    found, status = WITH.run(config, WITH.start(config), rows)

    assert np.allclose(found, expected, rtol=1e-9, atol=1e-15) and (status == codes).all()


def settled():
    """State of a filter in the middle of a drive, and the row that comes next."""
    rows, config = drive(seconds=12, bank=0.2), config_of(WITH)
    state = WITH.start(config)
    WITH.run(config, state, rows[:1100])
    state[WITH.index("state", "unlearnt")], state[WITH.index("state", "excited")] = 1.0, 1.0
    state[WITH.index("state", "turn")] = 2.0  # a turn that touches neither noise nor disturbance
    row = rows[1100:1101].copy()
    row[0, 0] = SHORT
    return config, state, row


def one(config, state, row):
    after = state.copy()
    out, _ = WITH.run(config, after, row)
    return out[0], after


def values(state):
    return np.array([get(state, name) for name in NAMES])


def mean_ay(before, after):
    """Mean of v' + U r + ahead r' over the sample, and the bias of the sensor [m/s^2]."""
    (v, r), (v1, r1) = ([get(s, f"{n}_star") for n in "vr"] for s in (before, after))
    ahead = get(before, "lead") * L
    return U * (v1 - v) / SHORT + ahead * U / L * (r1 - r) / SHORT + U * U / L * (r + r1) / 2


def moved(state, i, by):
    state, name = state.copy(), NAMES[i]
    state[WITH.index("state", name)] += by * (get(state, name) if name in LOGS else 1.0)
    return state


def slopes(config, state, blind):
    """F and the output's slopes by differences, in coordinates."""
    by, n = 1e-6, len(NAMES)
    base = one(config, state, blind)[1]
    F, h = np.eye(n), np.zeros(n)
    for i in range(n):
        start = moved(state, i, by)
        end = one(config, start, blind)[1]
        F[:, i] = (values(end) - values(base)) / by / np.where(np.isin(NAMES, LOGS), values(state), 1.0)
        h[i] = (mean_ay(start, end) - mean_ay(state, base)) / by + (NAMES[i] == "ay_bias")
    return F, h, base


def test_its_covariance_is_that_of_the_mean_over_the_sample():
    """To a thousandth of what it could be at most: the derivative of a step is that of its scheme."""
    config, state, row = settled()
    row[0, 3:] = np.nan
    F, h, base = slopes(config, state, row)
    P, at = covariance(WITH, state), WITH.index("state", "ay_with")

    spread, found = h @ P @ h, base[at : at + len(NAMES)]

    most = np.sqrt(np.diag(covariance(WITH, base)) * spread)
    assert get(base, "ay_spread") == pytest.approx(spread, rel=1e-3)
    assert (np.abs(found - F @ P @ h) < 1e-3 * most).all()


def test_both_updates_are_kalmans():
    """Gains, states and covariance against dense algebra, the yaw rate first."""
    config, state, row = settled()
    blind = row.copy()
    blind[0, 3:] = np.nan
    base = one(config, state, blind)[1]
    row[0, 4] = 2 * (mean_ay(state, base) + get(state, "ay_bias") + 0.02) - get(state, "last_ay")

    out, after = one(config, state, row)

    P, at, lead = covariance(WITH, base), WITH.index("state", "ay_with"), NAMES.index("lead")
    H = np.zeros(len(NAMES))
    H[NAMES.index("r_star")], H[NAMES.index("output_bias")] = U / L, 1.0
    first, nu = P @ H, out[WITH.index("output", "innovation")]
    spread = out[WITH.index("output", "innovation_variance")]
    both = H @ base[at : at + len(NAMES)]
    second, other = base[at : at + len(NAMES)] - first * both / spread, 0.02 - both / spread * nu
    share = config[WITH.index("config", "ay_share")]
    size = config[WITH.index("config", "ay_variance")] + share**2 * get(after, "ay_activity")
    noise = (
        2 * config[WITH.index("config", "ay_time")] / SHORT * get(state, "ay_noise_scale") * size
    )  # alike for so long
    left = get(base, "ay_spread") + noise - both**2 / spread
    expected = P - np.outer(first, first) / spread - np.outer(second, second) / left
    expected[lead, lead] = P[lead, lead]  # considered, not learnt
    gain = first / spread * nu + second / left * other
    gain[lead] = 0.0
    for i, name in enumerate(NAMES):
        x, y = values(base)[i], values(after)[i]
        assert (np.log(y / x) if name in LOGS else y - x) == pytest.approx(gain[i], rel=1e-4, abs=1e-9), name
    assert np.allclose(covariance(WITH, after), expected, rtol=1e-4, atol=1e-12)


def estimates(rows):
    """Errors of ln K and the filter's sd at the end (2, 2): with lateral acceleration, without."""
    found = []
    for library, columns in ((WITH, 5), (WITHOUT, 4)):
        config = config_of(library)
        outputs, _ = library.run(config, library.start(config), rows[:, :columns])
        found.append((np.log(outputs[-1, 0] / 110.0), np.sqrt(outputs[-1, 1])))
    return np.array(found).T


def test_a_banked_road_costs_less_with_it():
    roads = [estimates(drive(seconds=60, rms=3e-3, bank=0.3, seed=seed)) for seed in range(8)]
    (with_it, without), (narrow, wide) = np.array(roads).transpose(1, 2, 0)
    assert np.mean(with_it**2) < np.mean(without**2)
    assert (narrow < 0.8 * wide).all() and (np.abs(with_it) < 3 * narrow).all()


def test_a_steer_angle_that_is_not_true_costs_less_with_it():
    """Read 3 % large and 10 mrad off, of which the small filter knows nothing."""
    found = []
    for seed in range(8):
        rows = drive(seconds=60, rms=3e-3, bank=0.3, gust=0.1, seed=seed)
        rows[:, 1] = 1.03 * rows[:, 1] + 0.010
        found.append(estimates(rows)[0])
    with_it, without = np.array(found).T
    assert np.mean(with_it**2) < np.mean(without**2) / 2


@pytest.mark.parametrize("seed", range(2))
def test_the_same_bits_in_c_and_twin_and_nothing_but_numbers_out(seed):
    config, rows = config_of(WITH), rough_with_ay(6_000, seed)
    mine, theirs = WITH.start(config), twin_of(WITH).start(config)

    out, status = WITH.run(config, mine, rows)
    again, codes = twin_of(WITH).run(config, theirs, rows)

    assert out.tobytes() == again.tobytes() and mine.tobytes() == theirs.tobytes()
    assert (status == codes).all() and len(np.unique(status)) > len(STATUS) // 2
    assert np.isfinite(out).all() and np.isfinite(mine).all()
    assert np.linalg.eigvalsh(covariance(WITH, mine)).min() > -1e-9


def test_single_precision_keeps_its_variances_positive_at_any_rate():
    for factor in (1.0, 0.1, 0.01, 1e-4):
        rows = np.tile(drive(seconds=30, bank=0.2, gust=0.05), (3, 1))
        rows[:, 0] *= factor
        outputs, _, state = Float32(WITH).run(config_of(WITH), rows)
        assert np.isfinite(outputs).all() and (np.diag(covariance(WITH, state)) > 0).all()
        assert (outputs[:, WITH.index("output", "innovation_variance")] > 0).all()
