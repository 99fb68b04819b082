"""The paper's controller: its printed gain, its path, its loop."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.errors import ScenarioError
from similitude.simulation.car import Car
from similitude.simulation.keys import Place
from similitude.simulation.lqr import STATES, Follower, Lqr, Path, lqr_gain, path_matrices

PAPER = Car(m=5.451, Iz=0.1615, a=0.1461, b=0.2191, Caf=65.0, Car=110.0)
DRIVER = Lqr(weights=(0.03, 5, 0.02, 0.1, 0.001), effort=1.0, design_speed=3.0, limit=0.5)
T = np.arange(0, 10, 0.001)


def test_the_gain_is_the_printed_one_to_every_digit():
    """Brennan & Alleyne (2004), eq 32."""
    assert np.round(lqr_gain(PAPER, DRIVER), 4).tolist() == [0.1732, 2.2871, 0.3275, 1.0179, 0.0722]


def test_the_gain_on_the_integral_is_the_root_of_the_weights():
    """A property of any such design with one input: k1 = √(q1/effort)."""
    assert lqr_gain(PAPER, DRIVER)[0] == pytest.approx(np.sqrt(0.03 / 1), rel=1e-9)


def test_yaw_and_lateral_motion_of_the_matrices_are_those_of_the_plant():
    from similitude.simulation.arithmetic import FLOATS
    from similitude.simulation.plant import Push
    from similitude.simulation.single_track import SingleTrack

    U, y_dot, psi, r, delta = 4.0, 0.02, 1e-6, 0.1, 0.03
    A, B = path_matrices(PAPER, U)
    plant = SingleTrack(PAPER, tyre="linear", height=0.0, on=FLOATS)
    rates = plant.rates([0, 0, psi, y_dot - U * psi, r], Push(delta, U, 0, 0, 0, 0, 1, 1))

    expected = A @ [0, y_dot, psi, r] + B * delta
    assert rates[4] == pytest.approx(expected[3], rel=1e-9)
    # ÿ across the road is v' + U r where the heading is small
    assert rates[3] + U * r == pytest.approx(expected[1], rel=1e-5)


@pytest.mark.parametrize("U", [1.0, 2.0, 3.0, 4.0])
def test_the_loop_is_stable_over_the_paper_s_speeds(U):
    A, B = path_matrices(PAPER, U)
    loop = np.zeros((STATES, STATES))
    loop[0, 1], loop[1:, 1:] = 1, A
    loop -= np.outer(np.concatenate([[0], B]), lqr_gain(PAPER, DRIVER))
    assert np.linalg.eigvals(loop).real.max() < 0


def test_the_path_is_a_square_and_a_line():
    path = Path(square=0.06, period=5.0, until=6.0, times=(6.0, 8.0), offsets=(0.0, 0.4))
    wanted = path.at(np.array([1.0, 3.0, 5.5, 7.0, 9.0]))
    assert wanted.tolist() == pytest.approx([0.06, -0.06, 0.06, 0.2, 0.4])


def test_the_command_is_the_gain_times_the_state_and_stays_within_its_limit():
    follower = Follower(DRIVER, PAPER, T)
    state = (0.01, 0.02, 0.03, 0.04)
    assert follower.command(0, *state) == pytest.approx(-lqr_gain(PAPER, DRIVER)[1:] @ state)
    assert follower.command(1, 1e3, 0, 0, 0) == -0.5
    many = Follower(DRIVER, PAPER, T).command(0, *(np.array([x, 1e3 * x]) for x in state))
    assert many[0] == pytest.approx(-lqr_gain(PAPER, DRIVER)[1:] @ state) and many[1] == -0.5


def test_the_integral_rests_at_the_limit():
    follower, other = Follower(DRIVER, PAPER, T), Follower(DRIVER, PAPER, T)
    for k in range(1000):
        follower.command(k, 10.0, 0, 0, 0)
    assert follower.command(1000, 0.01, 0, 0, 0) == pytest.approx(other.command(0, 0.01, 0, 0, 0), rel=1e-3)


def test_a_scheduled_gain_is_that_of_the_stiffness():
    follower = Follower(replace(DRIVER, schedule="truth"), PAPER, T)
    soft = lqr_gain(PAPER, DRIVER, stiffness=0.5)
    state = np.array([0.01, 0.02, 0.03, 0.04])
    # interpolated over a grid of steps of 12 %: second order in the step
    assert follower.command(0, *state, 0.5) == pytest.approx(-soft[1:] @ state, rel=2e-3)


@pytest.mark.parametrize("stiffness", [0.01, 0.1, 0.31, 1.0, 3.99, 4.0, 90.0])
def test_one_car_and_many_have_the_same_scheduled_gain(stiffness):
    follower = Follower(replace(DRIVER, schedule="truth"), PAPER, T)
    many = np.ravel(follower._scheduled(np.array([stiffness])))

    assert follower._scheduled(stiffness) == pytest.approx(many, rel=1e-12)


def test_weights_and_points_that_do_not_fit_are_refused():
    for wrong, named in (
        ({"weights": (1.0, 2.0)}, "5 states"),
        ({"path": Path(times=(1.0,), offsets=())}, "1 times and 0 offsets"),
        ({"path": Path(times=(1.0, 1.0), offsets=(0.0, 1.0))}, "do not increase"),
    ):
        with pytest.raises(ScenarioError, match=named):
            replace(DRIVER, **wrong).check(Place("a.toml", "", "driver"))
