"""The check passes what is right and fails what is wrong."""

from dataclasses import replace

import sympy as sp

from similitude.symmetry.check import check_scalings
from similitude.symmetry.scalings import scaling_symmetries

FOUND = scaling_symmetries({"S": "-k1*E*S + km*C", "C": "k1*E*S - (km + k2)*C"}, ["k1", "km", "k2", "E"])


def test_what_was_found_passes():
    found = FOUND.verify()

    assert found
    assert (found.scaled < 1e-50, found.restored < 1e-50, found.missed) == (True, True, 0)


def test_a_wrong_weight_is_seen():
    wrong = ({**FOUND.weights[0], "km": 5}, *FOUND.weights[1:])

    assert check_scalings(FOUND.equations, wrong, FOUND.reduced).scaled > 1e-3


def test_a_wrong_reduced_rate_is_seen():
    rates = {name: rate + 1 for name, rate in FOUND.reduced.rates.items()}
    found = check_scalings(FOUND.equations, FOUND.weights, replace(FOUND.reduced, rates=rates))

    assert not found
    assert found.restored > 1e-3


def test_a_scaling_left_out_is_counted():
    assert check_scalings(FOUND.equations, FOUND.weights[1:], FOUND.reduced).missed == 1


def test_a_scaling_that_hides_in_functions_is_counted():
    found = scaling_symmetries({"x": "x*(sin(a*x)**2 + cos(a*x)**2)"}, ["a"])

    assert found.count == 1  # a and x alone cannot be seen to be free: sin and cos are taken one by one
    assert found.verify().missed == 1


def test_a_system_without_rates_that_do_anything():
    found = scaling_symmetries({"x": "0"}, [])

    assert found.count == 2
    assert found.verify()
    assert found.reduced.drifts == {"x": sp.Integer(0), "t": 1}


def test_a_term_too_small_for_floats_still_counts():
    powers = "(" + " + ".join(f"a{i}*x" for i in range(30)) + ")**20"  # about 1e30 times the other term

    assert scaling_symmetries({"x": f"{powers} - b*x"}, [*(f"a{i}" for i in range(30)), "b"]).verify()


def test_a_rate_that_cancels_to_nothing_is_nothing():
    assert scaling_symmetries({"x": "x*(y + z) - x*y - x*z", "y": "-k*y", "z": "y"}, ["k"]).verify()
