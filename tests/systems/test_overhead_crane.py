"""The crane against Lagrange's equations, written down independently, and against its energy."""

import numpy as np
import sympy as sp

from similitude.systems.overhead_crane import OVERHEAD_CRANE, SYSTEM, F, L, M, b, g, m

from .held_run import held_run


def test_the_rates_are_lagranges_equations():
    t = sp.Symbol("t")
    x, th = (sp.Function(name)(t) for name in ("x", "th"))
    load = sp.Matrix([x + L * sp.sin(th), -L * sp.cos(th)])
    speed = load.diff(t)
    energy = M * x.diff(t) ** 2 / 2 + m * speed.dot(speed) / 2 - m * g * load[1]
    states = {q.symbol: e for q, e in zip(OVERHEAD_CRANE.states, (x, x.diff(t), th, th.diff(t)), strict=True)}
    rates = {n: e.subs(states) for n, e in OVERHEAD_CRANE.rates.items()}
    point = {x.diff(t): sp.Rational(7, 10), th.diff(t): sp.Rational(-4, 3), th: sp.Rational(9, 10), F: 2}
    point |= {M: 3, m: sp.Rational(5, 7), L: sp.Rational(11, 9), g: 5, b: sp.Rational(1, 3)}
    for q, force in ((x, F - b * x.diff(t)), (th, 0)):
        left = energy.diff(q.diff(t)).diff(t) - energy.diff(q) - force
        left = left.subs({x.diff(t, 2): rates["v"], th.diff(t, 2): rates["w"]})
        # of sums of about ten terms near one, to thirty digits
        assert abs(left.subs(point).evalf(30)) < 1e-25


def test_without_friction_and_force_energy_is_kept():
    values = {**SYSTEM.numbers(), "b": 0.0}
    run = held_run(SYSTEM, b="0 N s/m", F="0 N", th="60 deg")
    M, m, L, g = (values[n] for n in ("M", "m", "L", "g"))
    v, th, w = run["v"], run["th"], run["w"]
    kinetic = M * v**2 / 2 + m * ((v + L * w * np.cos(th)) ** 2 + (L * w * np.sin(th)) ** 2) / 2
    energy = kinetic - m * g * L * np.cos(th)

    # integrated to 1e-10 a step; the swing holds m g L/2 of energy
    assert np.ptp(energy) < 1e-6 * m * g * L
    assert np.ptp(th) > 1  # it did swing


def test_the_groups_are_load_and_friction():
    groups = {g.parameter: dict(g.exponents) for g in SYSTEM.groups().groups}

    assert groups["m"] == {"m": 1, "M": -1}
    assert groups["b"] == {"b": 1, "M": -1, "L": sp.Rational(1, 2), "g": -sp.Rational(1, 2)}
