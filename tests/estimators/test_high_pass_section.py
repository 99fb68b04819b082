"""The high-pass as differences: the same numbers as the filter it stands for, and none that are large."""

import numpy as np
import pytest
import sympy as sp
from scipy import signal

from similitude.estimators.bessel import bessel_sections
from similitude.estimators.high_pass_section import moved_on, poles_fields, section_fields, sections
from similitude.estimators.paper_design import high_pass_biquad, section_gain, section_poles

STEP = sp.Symbol("step", real=True)


def passed(biquads, x, start=0.0):
    """First and second difference of what the sections hand on, without their gain, and all memory."""
    poles = [section_poles(row) for row in biquads]
    values = {f"poles_{k + 1}_{j}": p for k, pair in enumerate(poles) for j, p in enumerate(pair)}
    memory = [f.name for f in section_fields("output", "rad/s")]
    values |= dict.fromkeys(memory, 0.0)
    functions = [
        (line.target, sp.lambdify([s := sorted(line.expression.free_symbols, key=str)], line.expression), s)
        for line in (*sections(STEP, "output"), *moved_on("output"))
    ]
    changes, bends, seen, last = [], [], [], start
    for now in x:
        values["step"], last = now - last, now
        before = values["output_2_change"]
        for target, function, symbols in functions:
            values[target] = function([values[s.name] for s in symbols])
        changes.append(values["output_2_change"])
        bends.append(values["output_2_now"] - before)
        seen.append([values[name] for name in memory])
    return np.array(changes), np.array(bends), np.array(seen)


@pytest.mark.parametrize("sample_time", [1e-3, 1e-2, 5e-2])
def test_differences_are_those_of_the_filters_output(sample_time):
    biquads = bessel_sections("high", 45.0, sample_time)
    x = np.random.default_rng(1).standard_normal(200)
    out = signal.sosfilt(np.insert(biquads, 3, 1.0, axis=1), x) / section_gain(biquads)
    changes, bends, _ = passed(biquads, x)

    assert changes == pytest.approx(np.diff(out, prepend=0.0), abs=1e-10)
    assert bends == pytest.approx(np.diff(out, 2, prepend=[0.0, 0.0]), abs=1e-10)


def test_a_constant_leaves_nothing_and_nothing_is_large():
    biquads = bessel_sections("high", 45.0, 1e-3)
    _, bends, memory = passed(biquads, np.full(400, 1e3), start=1e3)
    assert (bends == 0).all() and (memory[:, 1:] == 0).all()

    swing = np.sin(2 * np.pi * np.arange(3000) * 1e-3)
    assert abs(passed(biquads, swing)[2]).max() < 40  # a biquad of other forms holds thousands


def test_two_numbers_are_the_section():
    for biquad in bessel_sections("high", 45.0, 2e-3):
        assert high_pass_biquad(*section_poles(biquad)) == pytest.approx(tuple(biquad), rel=1e-9)


def test_the_small_number_is_formed_without_loss():
    """1 + a1 + a2 of poles near one: seven digits would leave three of it."""
    _, _, _, a1, a2 = bessel_sections("high", 45.0, 1e-4)[0]
    exact = float(sp.Rational(1) + sp.Rational(float(a1)) + sp.Rational(float(a2)))

    assert section_poles([0, 0, 0, a1, a2])[0] == exact
    assert abs(np.float32(1) + np.float32(a1) + np.float32(a2) - exact) > 1e-4 * exact


def test_fields_say_what_they_hold():
    assert [(f.name, f.size) for f in poles_fields()] == [("poles_1", 2), ("poles_2", 2)]
    assert section_fields("input", "rad")[0].name == "last_input"
    assert all(f.unit == "rad" and f.meaning for f in section_fields("input", "rad"))
