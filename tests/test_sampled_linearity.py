"""Sampled coefficients against the paper's eq 22, against SciPy, and against a case that is no line."""

import dataclasses

import numpy as np
import pytest
from scipy.signal import cont2discrete

from similitude.errors import UsageError
from similitude.sampled_linearity import sampled_linearity
from similitude.systems.bicycle import bicycle_reduction

REDUCTION = bicycle_reduction()
P1, K43, P5 = 0.4431, 1.0977, 0.2510
# The paper's averages, m = L = U = 1: then K is pi3 and the step is T.
AVERAGES = {
    "K": 0.5, "pi1": P1, "eta": K43 * (1 - P1) / P1, "rho": P5 / (P1 * (1 - P1)),
    "m": 1.0, "L": 1.0, "U": 1.0,
}  # fmt: skip


@pytest.fixture(scope="module")
def figure_4():
    return sampled_linearity(REDUCTION, AVERAGES, step=0.011, between=(0.1, 1.4))


@pytest.mark.parametrize(
    ("pi3", "b1", "a1_2", "a2_1"),
    [
        (0.1, 0.00193999, 0.00466240, -0.00464903),
        (1.0, 0.0192318, 0.0461259, -0.0455297),
        (1.4, 0.0268208, 0.0642696, None),
    ],
)  # fmt: skip
def test_exact_coefficients_are_those_computed_by_hand(pi3, b1, a1_2, a2_1):
    one = sampled_linearity(REDUCTION, AVERAGES, step=0.011, between=(pi3, 2 * pi3))

    assert one.exact["b1"][0] == pytest.approx(b1, rel=1e-5)
    assert one.exact["a1"][0] + 2 == pytest.approx(a1_2, rel=1e-5)
    if a2_1 is not None:
        assert one.exact["a2"][0] - 1 == pytest.approx(a2_1, rel=1e-5)


def test_the_line_is_equation_22(figure_4):
    m1 = P1 / P5 * 0.011
    m2 = (1 + K43 + (P1**2 + (1 - P1) ** 2 * K43) / P5) * 0.011

    assert figure_4.line["b1"][-1] == pytest.approx(1.4 * m1, rel=2e-3)
    assert figure_4.line["a1"][-1] + 2 == pytest.approx(1.4 * m2, rel=2e-3)


def test_the_worst_error_of_figure_4_is_small_and_a_regression_follows(figure_4):
    assert 0.05 < figure_4.worst < 0.06  # b2, where eq 22 leaves out most
    assert figure_4.error["b1"] == pytest.approx(0.0271862 / 0.0268208 - 1, rel=1e-3)
    assert figure_4.estimator == "regression"
    assert "K from 0.1 to 1.4 at T = 0.011" in figure_4.text


def test_a_full_size_car_at_100_Hz_is_no_line():
    """T = 0.09: the science of it says 12 to 54 %."""
    values = {**AVERAGES, "K": 145.68, "m": 1500.0, "L": 2.7, "U": 25.0}
    one = sampled_linearity(REDUCTION, values, step=0.01, spread=0.5)

    assert one.T == pytest.approx(0.0926, rel=1e-3)
    assert one.worst > 0.12 and one.estimator == "population"


def test_thesampled_transfer_function_is_scipys():
    from similitude.sampled_linearity import sampled_transfer

    rng = np.random.default_rng(0)
    A, B, C = rng.normal(size=(3, 3)), rng.normal(size=(3, 1)), rng.normal(size=(1, 3))
    from scipy.signal import ss2tf

    F, G, H, D, _ = cont2discrete((A, B, C, np.zeros((1, 1))), 0.1)
    num, den = ss2tf(F, G, H, D)
    assert sampled_transfer(A, B, C, 0.1) == pytest.approx(np.concatenate([num[0, 1:], den[1:]]), abs=1e-10)


def test_a_range_given_twice_or_a_scale_left_out_is_said():
    with pytest.raises(UsageError, match="twice"):
        sampled_linearity(REDUCTION, AVERAGES, step=0.01, spread=0.5, between=(1, 2))
    short = {k: v for k, v in AVERAGES.items() if k != "L"}
    with pytest.raises(UsageError, match="needs a value of L"):
        sampled_linearity(REDUCTION, short, step=0.01, spread=0.5)
    assert dataclasses.is_dataclass(sampled_linearity(REDUCTION, AVERAGES, step=0.01, spread=0.5))
