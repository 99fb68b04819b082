"""Three tyres: one slope, odd, never beyond the limit."""

import numpy as np
import pytest

from similitude.simulation.arithmetic import ARRAYS, FLOATS
from similitude.simulation.tyres import TYRES, lateral_force

C, MOST = 80e3, 6e3
ALPHA = np.linspace(-0.4, 0.4, 801)


@pytest.mark.parametrize("tyre", TYRES)
def test_the_slope_at_no_slip_is_the_stiffness(tyre):
    alpha = 1e-6
    found = lateral_force(tyre, C, alpha, MOST, FLOATS) / alpha

    # onset: cubic loses (C α/F)²/2, brush C α/(3 F): 4e-6 at this slip
    assert found == pytest.approx(C, rel=C * alpha / MOST)


@pytest.mark.parametrize("tyre", TYRES)
def test_the_force_is_odd_and_grows_with_slip(tyre):
    force = lateral_force(tyre, C, ALPHA, MOST, ARRAYS)

    np.testing.assert_allclose(force, -force[::-1], atol=1e-9)
    assert (np.diff(force) >= -1e-9).all()


@pytest.mark.parametrize("tyre", ["cubic", "brush"])
def test_no_force_beyond_the_limit(tyre):
    assert np.abs(lateral_force(tyre, C, 100 * ALPHA, MOST, ARRAYS)).max() <= MOST * (1 + 1e-12)


def test_the_brush_reaches_its_limit_where_the_whole_patch_slides():
    slides = 3 * MOST / C
    assert lateral_force("brush", C, slides, MOST, FLOATS) == pytest.approx(MOST)
    assert lateral_force("brush", C, 0.9 * slides, MOST, FLOATS) < MOST


def test_onsets_are_cubic_and_quadratic():
    """Missing force at half and at full of a small slip: ratio 8 for cubic, 4 for quadratic onset."""
    for tyre, power in (("cubic", 3), ("brush", 2)):
        lost = [C * a - lateral_force(tyre, C, a, MOST, FLOATS) for a in (1e-3, 2e-3)]
        assert np.log2(lost[1] / lost[0]) == pytest.approx(power, abs=0.02)


def test_many_tyres_are_each_the_one():
    many = lateral_force("brush", np.full(3, C), np.array([-0.2, 0.0, 0.05]), np.full(3, MOST), ARRAYS)
    assert many.tolist() == [lateral_force("brush", C, a, MOST, FLOATS) for a in (-0.2, 0.0, 0.05)]
