"""The record and its Fisher information."""

import numpy as np
import pytest

from similitude.paper import printed, seven


def test_coordinates_and_parameters_are_the_same_car():
    found = seven.of_coordinates(seven.true_coordinates())

    assert found == pytest.approx(printed.TEST_VEHICLE)


def test_slopes_add_up_to_nothing_along_mass():
    s = seven.slopes(seven.seven_model, printed.TEST_VEHICLE)
    along = dict(zip(seven.PARAMETERS, s.T, strict=True))

    assert np.abs(along["m"] + along["Iz"] + along["Caf"] + along["Car"]).max() < 1e-6 * np.abs(s).max()


def test_four_directions_of_seven_and_four_of_four():
    assert seven.rank(seven.information(printed.TEST_VEHICLE, seven.seven_model)) == 4
    assert seven.rank(seven.information(seven.true_coordinates(), seven.four_model)) == 4
