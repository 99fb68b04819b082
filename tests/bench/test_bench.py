"""The bench measures what it says: both sides of a ratio give the same answer. Not their speed."""

import json

import numpy as np
import pytest
from bench.drives import CAR, road_drive
from bench.kernels import P_START
from bench.measurements import QUICK, Bound, Row, compiled, compiled_kernels, scripted_actions
from bench.page import record
from bench.timing import interleave
from bench.whole_process import processes

from similitude.program.library import shipped
from similitude.status import STATUS


@pytest.fixture(scope="module")
def kernels():
    found = compiled_kernels(4000)
    for kernel in found.values():
        kernel.run()
    return found


def test_hand_written_paper_and_generated_paper_agree_to_rounding(kernels):
    own, generated = kernels["paper, hand-written C"], kernels["paper, generated C"]
    scale = np.abs(generated.result).max(axis=0)

    np.testing.assert_array_equal(own.status, generated.status)
    # 4000 updates of some 50 roundings each, in the worst case all of one sign.
    assert (np.abs(own.result - generated.result) <= 4000 * 50 * 1.1e-16 * scale).all()
    assert np.mean(generated.status < STATUS["no_measurement"]) == 1  # every sample counts
    assert np.mean(generated.status != STATUS["not_excited"]) > 0.5  # and most teach


def test_hand_written_paper_holds_missing_values_as_the_generated_one_does(monkeypatch):
    rough = _rough_square()
    monkeypatch.setattr("bench.measurements.square_drive", lambda n: rough)
    found = compiled_kernels(4000)
    for kernel in found.values():
        kernel.run()
    own, generated = found["paper, hand-written C"], found["paper, generated C"]

    np.testing.assert_array_equal(own.status, generated.status)
    assert set(generated.status) >= {STATUS["no_measurement"], STATUS["too_slow"], STATUS["ok"]}
    np.testing.assert_allclose(own.result, generated.result, rtol=1e-9, atol=1e-9)


def _rough_square():
    from bench.drives import square_drive

    drive = square_drive(4000)
    drive.steer[1000:1003] = np.nan
    drive.yaw_rate[1500] = np.inf
    drive.yaw_rate[2000] += 5.0  # a jump no car makes
    drive.U[2500:2520] = 0.1
    drive.U[3000] = np.nan
    return drive


def test_textbook_least_squares_agrees_with_the_batch_solution(kernels):
    from bench.kernels import FORGETTING, regression

    phi, y = regression(4000)
    weights = FORGETTING ** np.arange(3999, -1, -1.0)
    start = FORGETTING**4000 / P_START  # what the start still weighs

    expected = np.sum(weights * phi * y) / (np.sum(weights * phi * phi) + start)
    np.testing.assert_allclose(kernels["textbook RLS, C"].result[-1], expected, rtol=1e-9)


def test_padasip_runs_the_same_least_squares(kernels):
    pytest.importorskip("padasip")
    from bench.kernels import regression
    from bench.python_filters import padasip_rls

    phi, y = regression(4000)
    theta = padasip_rls(phi[:500], y[:500])
    np.testing.assert_allclose(theta, kernels["textbook RLS, C"].result[:500], rtol=1e-9)


def test_kalman_filter_of_filterpy_finds_the_same_stiffness():
    pytest.importorskip("filterpy")
    from bench.python_filters import Ekf

    drive = road_drive(3000)
    ekf = Ekf(CAR["L"], np.deg2rad(0.15))
    ln_K = ekf.run(drive.samples())

    # Both rest on the same half minute: within two sd of the truth, and near each other.
    sd = np.sqrt(ekf.filter.P[3, 3])
    assert sd < 0.2
    assert abs(ln_K[-1] - np.log(CAR["K"])) < 2 * sd


def test_population_loop_and_its_twin_end_alike():
    pytest.importorskip("filterpy")
    pytest.importorskip("padasip")
    kernel = compiled_kernels(60)["population, generated C"]
    kernel.run()
    outputs, status = scripted_actions(60)["population, Python twin"]()

    # The same seed, but a drive of its own length: only the loop may not differ.
    np.testing.assert_array_equal(outputs, kernel.result)
    np.testing.assert_array_equal(status, kernel.status)


def test_actions_are_timed_in_turn_and_the_first_round_is_not_counted():
    seen = []
    ticks = iter(range(100))
    times = interleave({"a": lambda: seen.append("a"), "b": lambda: seen.append("b")}, 2, lambda: next(ticks))

    assert seen == list("ababab")
    assert times["a"].all == (1, 1)


def test_record_is_json_and_says_which_bounds_hold():
    bounds = [Bound("x", "a", "b", 2.0, 1.9, 1.5), Bound("y", "a", "b", 1.0, 1.2, 1.5)]
    found = json.loads(json.dumps(record([Row("a", "sample", 1.0, 0.9)], bounds)))

    assert [bound["holds"] for bound in found["bounds"]] == [False, True]
    assert found["times"][0]["name"] == "a"


def test_compiled_measurements_name_their_bounds():
    rows, bounds = compiled(QUICK)

    assert {bound.over for bound in bounds} <= {row.name for row in rows}
    assert [bound.bound for bound in bounds] == [12.0, 16.0, 1.3]
    assert all(row.median_us > 0 for row in rows)


def test_identify_writes_its_report_as_a_process():
    with processes(3000) as actions:
        actions["identify"]()  # raises when a file is missing


def test_reference_takes_the_configuration_by_name():
    from bench.kernels import PAPER_ORDER

    assert sorted(PAPER_ORDER) == sorted(shipped("bicycle_paper").names("config"))


def test_the_chains_of_reactions_have_the_scalings_of_time_and_amount():
    from bench.model_analysis import chain, saturating_chain

    from similitude import scaling_symmetries

    for make in (chain, saturating_chain):
        found = scaling_symmetries(*make(5))
        assert found.count == 2
        assert found.verify()


def test_the_bench_times_scalings_and_says_when_they_take_too_long():
    from bench.measurements import structural

    rows, bounds = structural(QUICK)

    assert [row.per for row in rows] == ["system", "system"]
    assert bounds[0].bound == 1.0
    assert bounds[0].ratio == pytest.approx(rows[0].median_us / 2e6)
