"""Speed profiles."""

import numpy as np

from similitude.simulation.speed import SPEEDS, Constant, Logged, Ramp, Sinusoid

T = np.arange(0, 40, 0.1)


def test_constant_ramp_and_sinusoid():
    assert (Constant(value=20.0).at(T) == 20).all()
    ramp = Ramp(first=30.0, last=15.0, begin=10.0, duration=3.0).at(T)
    assert (ramp[T <= 10] == 30).all() and (ramp[T >= 13.05] == 15).all()
    np.testing.assert_allclose(np.diff(ramp)[102:128] / 0.1, -5.0)
    sway = Sinusoid(mean=25.0, amplitude=5.0, period=20.0).at(T)
    assert sway.max() <= 30 and sway.min() >= 20 and abs(sway[0] - sway[200]) < 1e-9


def test_a_log_s_speed_is_held_beyond_its_ends():
    speed = Logged(at_least=3.0, times=np.array([1.0, 2.0]), speeds=np.array([1.0, 12.0])).at(
        np.array([0.0, 1.5, 9.0])
    )
    assert speed.tolist() == [3, 6.5, 12] and set(SPEEDS) == {"constant", "ramp", "sinusoid", "log"}
