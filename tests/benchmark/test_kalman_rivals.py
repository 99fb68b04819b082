"""The Kalman rivals: slopes by hand against differences, and a stiffness they can find."""

import numpy as np

from similitude.benchmark.kalman_rivals import RATIO, _motion, dual_ekf, nine_state

from .linear_drive import K, linear_drive


def test_the_slopes_of_the_nine_states_are_those_of_the_step():
    step = _motion(2.7, 0.44, 1.4, 1.02)
    x = np.array([0.9, RATIO, 0.01, 0.02, 22.0, 0.3, 0.2, 0.4, 0.03])
    F = step(x, 0.05)[1].copy()
    moved = [step(x + h, 0.05)[0] - step(x - h, 0.05)[0] for h in 1e-5 * np.eye(9)]

    # Central differences err by the third derivative times h²: far below 1e-6 here.
    assert np.allclose(np.array(moved).T / 2e-5, F, atol=1e-6)


def test_the_nine_states_at_rest_stay_at_rest():
    step = _motion(2.7, 0.44, 1.4, 1.02)
    x = np.array([1.0, RATIO, 0, 0, 22.0, 0, 0, 0, 0])

    assert np.array_equal(step(x, 0.05)[0], x)


def test_the_dual_filter_comes_near_the_stiffness_of_a_car_near_the_average():
    drive, _ = linear_drive(factor=1.0)
    answer = dual_ekf(drive)

    assert abs(np.log(answer.K[-2000:].mean() / K)) < 0.3


def test_the_nine_state_filter_is_slow_as_its_process_noise_says():
    """5e-4 a root second moves the stiffness by 0.3 % in 30 s: half of it lost cannot be followed."""
    drive, _ = linear_drive()
    answer = nine_state(drive)

    assert answer.K[-1] > 0.8 * answer.K[4900]
    assert (answer.ln_K_std[2000:] < 0.05).all()
