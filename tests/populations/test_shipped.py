"""Shipped populations load fast, are proper, and are named with the line to write."""

import subprocess
import sys

import numpy as np
import pytest

from similitude.errors import UsageError
from similitude.populations.shipped import shipped_names, shipped_population


@pytest.mark.parametrize("name", shipped_names())
def test_every_prior_is_proper(name):
    prior = shipped_population(name).prior

    assert np.all(np.linalg.eigvalsh(prior.covariance) > 0) and np.all(prior.mean > 0)
    assert prior.names == ("m", "L", "K", "pi1", "eta", "rho")


def test_a_small_car_keeps_its_stiffness_over_weight_and_length():
    small = shipped_population("small_cars_1to10")
    assert small.of_length(0.5).mean[2] == pytest.approx(1.22 * 9.80665 * 0.5)
    assert shipped_population("passenger_cars").of_length(3.0).mean[2] == 145.68


def test_an_unknown_name_is_refused_with_the_known_ones():
    with pytest.raises(UsageError, match="all_vehicles"):
        shipped_population("tractors")


def test_loading_imports_neither_sympy_nor_scipy_nor_pint():
    code = (
        "import sys; from similitude.populations.shipped import shipped_population as s; "
        "s('passenger_cars'); print([m for m in ('sympy', 'scipy', 'pint', 'pyarrow') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
