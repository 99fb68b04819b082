"""Claims about the regulator; its gain once more from the Hamiltonian matrix."""

import numpy as np
import pytest

from similitude.paper import printed
from similitude.paper.claims_controller import car_and_driver, controller_claims, least_damping
from similitude.simulation.lqr import lqr_gain, path_matrices

from .pinned import check


def test_claims_are_the_pinned_ones():
    check("The controller", controller_claims())


def test_the_gain_by_the_stable_eigenvectors():
    car, _ = car_and_driver()
    A, B = np.zeros((5, 5)), np.zeros(5)
    A[0, 1] = 1
    A[1:, 1:], B[1:] = path_matrices(car, 3.0)
    H = np.block([[A, -np.outer(B, B)], [-np.diag(printed.WEIGHTS), -A.T]])
    values, vectors = np.linalg.eig(H)
    stable = vectors[:, values.real < 0]
    P = np.real(stable[5:] @ np.linalg.inv(stable[:5]))

    assert np.round(B @ P, 4).tolist() == list(printed.GAIN)


def test_a_softer_road_damps_less_and_scheduling_gives_some_back():
    car, driver = car_and_driver()
    fixed = [least_damping(lqr_gain(car, driver), 4.0, s) for s in (1.0, 0.5, 0.2)]
    scheduled = [least_damping(lqr_gain(car, driver, stiffness=s), 4.0, s) for s in (0.5, 0.2)]

    assert fixed[0] > fixed[1] > fixed[2]
    assert scheduled[0] > fixed[1] and scheduled[1] > fixed[2]
    assert fixed[2] == pytest.approx(0.23, abs=0.01)
