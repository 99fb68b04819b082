"""Filters, configuration and linearity of the paper's regression."""

import numpy as np
import pytest
from scipy import signal

from similitude.errors import ProgramError
from similitude.estimators import paper_design as design
from similitude.estimators.paper_model import regression
from similitude.systems.bicycle import bicycle_reduction

from .paper_case import library

CAR = {"sample_time": 0.01, "L": 2.7, "speed": 20.0, "noise_std": 1e-3, **design.PAPER_GROUPS}
PAPER = (0.4431, 1.0977, 0.2510)  # pi1, k, pi5


@pytest.mark.parametrize("sample_time", [1e-3, 5e-3, 1e-2, 5e-2])
def test_the_filter_is_the_bilinear_transform_of_the_analogue_bessel(sample_time):
    biquads = design.bessel_biquads(sample_time)
    w = np.linspace(0.05, 0.95, 40) * np.pi / sample_time
    over, under = signal.bessel(4, 45.0, "highpass", analog=True, norm="phase")
    warped = 2 / sample_time * np.tan(w * sample_time / 2)
    expected = signal.freqs(over, under, warped)[1]
    found = signal.freqz_sos(np.insert(biquads, 3, 1.0, axis=1), w * sample_time)[1]

    assert biquads.shape == (2, 5)
    assert np.allclose(found, expected, rtol=1e-9, atol=1e-12)
    assert np.abs(biquads[:, :3].sum(axis=1)) == pytest.approx(0, abs=1e-9)  # nothing at rest


def test_the_configuration_stands_in_the_order_of_the_struct():
    made = design.paper_config(library(), **CAR, dead_zone=0.2)
    at = dict(zip(library().names("config"), made, strict=True))

    assert made.dtype == np.float64
    assert made.shape == (len(library().names("config")),)
    assert (at["sample_time"], at["dead_zone"]) == (0.01, 0.2)
    assert at["settle_samples"] == 13  # 5/45 s at 100 Hz in whole samples, and the one that may update
    assert at["theta_start"] * at["K_per_theta"] == pytest.approx(0.2 * 20.0**2)
    poles = [made[library().index("config", f"poles_{i}") :][:2] for i in (1, 2)]
    found = np.array([design.high_pass_biquad(*pair) for pair in poles])
    assert found == pytest.approx(design.bessel_biquads(0.01), rel=1e-12)


def test_a_constant_that_is_not_one_is_refused():
    with pytest.raises(ProgramError, match="deadzone"):
        design.paper_config(library(), **CAR, deadzone=0.2)


def test_the_two_numbers_of_the_regressor_are_those_derived_from_the_model():
    values = {**design.PAPER_GROUPS, "L": 2.7, "sample_time": 0.01}
    at = dict(zip(library().names("config"), design.paper_config(library(), **CAR), strict=True))
    found = regression(bicycle_reduction()).constants
    derived = [float(e.subs({s: values[s.name] for s in e.free_symbols})) for e in found]

    assert [at["input_ratio"], at["K_per_theta"]] == pytest.approx(derived, rel=1e-12)


def test_the_slopes_are_those_derived_from_the_model():
    derived = regression(bicycle_reduction())
    values = {"pi1": 0.41, "pi4_slope": 1.3, "pi5": 0.23}
    found = design.slopes(0.02, **values)

    for number, symbols in zip(found, (derived.numerator, derived.denominator), strict=True):
        by_name = {s: values[s.name] for s in symbols.free_symbols}
        assert number == pytest.approx(0.02 * float(symbols.subs(by_name)), rel=1e-12)


def test_T_is_the_way_of_one_sample_in_wheelbases():
    assert design.dimensionless_step(1e-3, 4.0, 0.3652) == pytest.approx(0.010953, abs=5e-7)


def test_the_exact_coefficients_tend_to_the_line():
    """Halving T halves the relative error: the line is the first term of the expansion."""
    errors = [design.linearity_error(T, *PAPER)["worst"] for T in (2e-3, 1e-3, 5e-4)]

    assert errors[0] / errors[1] == pytest.approx(2, rel=0.02)
    assert errors[1] / errors[2] == pytest.approx(2, rel=0.01)


def test_linearity_at_the_papers_step_and_at_a_car_at_100_hz():
    small, large = (design.linearity_error(T, *PAPER) for T in (0.011, 0.0925))

    assert small["b1"] == pytest.approx(0.0271862 / 0.0268208 - 1, rel=2e-3)
    assert small["worst"] == pytest.approx(0.053, abs=5e-4)
    assert (large["least"], large["worst"]) == (
        pytest.approx(0.12, abs=0.005),
        pytest.approx(0.54, abs=0.005),
    )


@pytest.mark.parametrize(("T", "said"), [(0.011, ""), (0.03, ""), (0.0925, "12 to 54 %")])
def test_a_large_step_is_warned_of(T, said):
    text = design.linearity_warning(T, *PAPER)

    assert said in text
    assert bool(text) == bool(said)
