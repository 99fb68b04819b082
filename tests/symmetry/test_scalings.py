"""Worked examples of the literature, each worked out anew by hand and compared by span.

Every row of MONOMIALS was found by setting the degrees of all terms of an equation equal; examples of the
kind that Hubert & Labahn 2013 and the program desr treat, with their own letters where they have any.
"""

import time
from fractions import Fraction

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.equations import equations_of
from similitude.symmetry.scalings import scaling_symmetries, scalings_of
from similitude.systems.bicycle import BICYCLE
from similitude.systems.saturating_bicycle import SATURATING_BICYCLE

# name: rates, parameters, number of scalings, monomials that do not change
EXAMPLES = {
    "logistic growth (Verhulst)": ({"N": "r*N*(1 - N/K)"}, "r K", 2, ["t*r", "N/K"]),
    "predator-prey with saturation (Hubert & Labahn; Murray)": (
        {"n": "n*(r*(1 - n/K) - k*p/(n + d))", "p": "s*p*(1 - h*p/n)"},
        "r K k d s h", 3, ["t*r", "n/d", "h*p/d", "s/r", "k/(h*r)", "K/d"],
    ),
    "Lotka-Volterra": (
        {"x": "a*x - b*x*y", "y": "-c*y + d*x*y"}, "a b c d", 3, ["t*a", "x*d/a", "y*b/a", "c/a"],
    ),
    "Michaelis-Menten, four species": (
        {"S": "-k1*E*S + km*C", "E": "-k1*E*S + (km + k2)*C", "C": "k1*E*S - (km + k2)*C", "P": "k2*C"},
        "k1 km k2", 2, ["t*k2", "S*k1/k2", "E*k1/k2", "C*k1/k2", "P*k1/k2", "km/k2"],
    ),
    "Michaelis-Menten, enzyme conserved": (
        {"S": "-k1*(E0 - C)*S + km*C", "C": "k1*(E0 - C)*S - (km + k2)*C"},
        "k1 km k2 E0", 2, ["t*km", "S*k1/km", "C/E0", "E0*k1/km", "k2/km"],
    ),
    "Michaelis-Menten, quasi-steady": ({"S": "-V*S/(K + S)"}, "V K", 2, ["S/K", "t*V/K"]),
    "epidemic, SIR with the number of people": (
        {"S": "-beta*S*I/N", "I": "beta*S*I/N - gamma*I", "R": "gamma*I"},
        "beta gamma N", 3, ["t*gamma", "S/I", "R/I", "beta*S/(N*gamma)"],
    ),
    "epidemic, SEIR with births": (
        {"S": "mu*N - beta*S*I/N - mu*S", "E": "beta*S*I/N - (sigma + mu)*E",
         "I": "sigma*E - (gamma + mu)*I"},
        "mu beta sigma gamma N", 2, ["t*mu", "S/N", "E/N", "I/N", "beta/mu", "sigma/mu", "gamma/mu"],
    ),
    "Schlögl's first model": (
        {"X": "k1*A*X - k2*X**2 - k3*B*X + k4"}, "k1 A k2 k3 B k4", 4,
        ["t*k1*A", "k2*X/(k1*A)", "k3*B/(k1*A)", "k4*k2/(k1*A)**2"],
    ),
    "Schlögl's second model": (
        {"X": "k1*A*X**2 - k2*X**3 - k3*X + k4*B"}, "k1 A k2 k3 k4 B", 4,
        ["t*k3", "t*k2*X**2", "t*k1*A*X", "t*k4*B/X"],
    ),
    "linear chain": (
        {"x": "-k1*x", "y": "k1*x - k2*y", "z": "k2*y - k3*z"}, "k1 k2 k3", 2,
        ["t*k1", "y/x", "z/x", "k2/k1", "k3/k1"],
    ),
    "Brusselator": (
        {"X": "k1*A - k2*B*X + k3*X**2*Y - k4*X", "Y": "k2*B*X - k3*X**2*Y"},
        "k1 A k2 B k3 k4", 4, ["t*k4", "Y/X", "k2*B/k4", "k3*X**2/k4", "k1*A/(k4*X)"],
    ),
    "Goodwin's oscillator with a Hill function": (
        {"x": "a*K**n/(K**n + z**n) - b*x", "y": "c*x - d*y", "z": "e*y - f*z"},
        "a b c d e f K n", 4,
        ["t*b", "d/b", "f/b", "n", "z/K", "x*b/a", "y*b**2/(a*c)", "z*b**3/(a*c*e)"],
    ),
    "pendulum with drag": (
        {"theta": "w", "w": "-g/l*sin(theta) - c*w"}, "g l c", 2, ["theta", "t*w", "t*c", "g*t**2/l"],
    ),
    "tank that drains": ({"h": "-C*sqrt(2*g*h)"}, "C g", 3, ["t**2*C**2*g/h"]),
    "projectile with quadratic drag": (
        {"x": "v", "v": "-g - k*v*abs(v)"}, "g k", 2, ["x*k", "v*t*k", "g*t/v"],
    ),
    "x' = a - b x^2, which no whole powers measure": ({"x": "a - b*x**2"}, "a b", 2, ["t*x*b", "x**2*b/a"]),
    "rock-paper-scissors without parameters": (
        {"x": "x*(y - z)", "y": "y*(z - x)", "z": "z*(x - y)"}, "", 1, ["t*x", "y/x", "z/x"],
    ),
    "Gompertz's growth, with two logarithms": (
        {"x": "r*x*(log(K) - log(x))"}, "r K", 2, ["t*r", "x/K"],
    ),
    "names of SymPy and of Python": (
        {"E": "lambda*S - gamma*E", "S": "-lambda*S*I*Q/N"}, "lambda gamma I Q N", 5,
        ["t*lambda*S/E", "t*gamma", "t*lambda*I*Q/N"],
    ),
}  # fmt: skip


def exponents(monomial: str) -> dict[str, Fraction]:
    """Exponents of a product of powers, read without the product's own reader."""
    powers: dict[str, Fraction] = {}
    names = sorted(
        {w for w in "".join(c if c.isalnum() else " " for c in monomial).split() if not w.isdigit()}
    )
    safe = {name: sp.Symbol(name + "_", positive=True) for name in names}
    text = monomial.replace("lambda", "lambda_")
    value = sp.sympify(
        text, locals={**safe, "lambda_": safe.get("lambda", sp.Symbol("lambda_", positive=True))}
    )
    for base, power in sp.powdenest(value, force=True).as_powers_dict().items():
        if base.is_Symbol:
            powers[base.name[:-1]] = powers.get(base.name[:-1], 0) + Fraction(int(power.p), int(power.q))
    return powers


def rank(rows: list[dict[str, Fraction]]) -> int:
    names = sorted({name for row in rows for name in row})
    return (
        sp.Matrix([[sp.Rational(str(row.get(n, 0))) for n in names] for row in rows]).rank() if names else 0
    )


def assert_same_span(found: list[dict[str, Fraction]], meant: list[dict[str, Fraction]]) -> None:
    assert rank(meant) == len(meant), "the expected monomials depend on one another"
    assert len(found) == len(meant)
    assert rank([*found, *meant]) == len(meant)


@pytest.mark.parametrize("example", EXAMPLES)
def test_a_worked_example(example):
    rates, parameters, count, monomials = EXAMPLES[example]

    found = scaling_symmetries(rates, parameters.split())

    assert found.count == count
    assert_same_span(found.invariants, [exponents(m) for m in monomials])
    assert len(found.invariants) == 1 + len(rates) + len(parameters.split()) - count
    assert found.verify()


def test_the_linear_bicycle_scales_with_three_units_and_its_signals():
    rates = {
        "v": "(Caf*(delta - (v + a*r)/U) + Car*(b*r - v)/U)/m - U*r",
        "r": "(a*Caf*(delta - (v + a*r)/U) - b*Car*(b*r - v)/U)/Iz",
    }
    parameters = ["m", "Iz", "U", "a", "b", "Caf", "Car"]

    found = scaling_symmetries(rates, parameters, signals=["delta"])
    by_steer = found.reduce(["m", "U", "a", "delta"])

    assert found.count == 4
    assert len(found.invariants) == 11 - 4
    groups = [
        "t*U/a",
        "b/a",
        "Iz/(m*a**2)",
        "Caf*a/(m*U**2)",
        "Car*a/(m*U**2)",
        "r*a/(U*delta)",
        "v/(U*delta)",
    ]
    assert_same_span(found.invariants, [exponents(g) for g in groups])
    assert set(by_steer.rates) == {"v", "r"}
    assert found.verify()


def test_shipped_bicycles_have_four_scalings_each():
    # of the linear one the fourth is linearity; of the saturating one the grip scales with all slip angles
    for model in (BICYCLE, SATURATING_BICYCLE):
        found = scalings_of(equations_of(model))
        assert found.count == 4
        assert found.verify()


def test_invariants_have_whole_exponents_and_every_weight_annihilates_them():
    for rates, parameters, _, _ in EXAMPLES.values():
        found = scaling_symmetries(rates, parameters.split())
        for group in found.invariants:
            assert all(power.denominator == 1 for power in group.values())
            assert all(sum(row.get(n, 0) * p for n, p in group.items()) == 0 for row in found.weights)


def test_the_order_of_names_changes_no_span():
    rates, parameters, _, _ = EXAMPLES["predator-prey with saturation (Hubert & Labahn; Murray)"]
    one = scaling_symmetries(rates, parameters.split())
    other = scaling_symmetries(dict(reversed(rates.items())), parameters.split()[::-1])

    assert_same_span(one.invariants, other.invariants)


def test_a_parameter_in_no_rate_scales_by_itself():
    assert scaling_symmetries({"x": "-k*x"}, ["k", "q"]).count == 3


def test_sixty_reactions_in_a_chain_take_less_than_two_seconds():
    rates = {f"x{i}": (f"k{i - 1}*x{i - 1} - " if i else "-") + f"k{i}*x{i}" for i in range(60)}
    start = time.process_time()  # [s]
    found = scaling_symmetries(rates, [f"k{i}" for i in range(60)])

    assert time.process_time() - start < 2
    assert found.count == 2
    assert len(found.invariants) == 121 - 2


@pytest.mark.parametrize("base", [["r"], ["r", "q"], ["r", "t"]])
def test_a_base_that_cannot_measure_is_refused(base):
    found = scaling_symmetries({"N": "r*N*(1 - N/K)"}, ["r", "K"])

    with pytest.raises(ModelError, match="does not measure") as caught:
        found.reduce(base)
    assert caught.value.paste == "scalings.reduce(['r', 'K'])"


def test_a_system_prints_as_its_scalings_and_what_is_left():
    text = str(scaling_symmetries({"N": "r*N*(1 - N/K)"}, ["r", "K"]))

    for line in (
        "2 scalings",
        "  t^-1, r",
        "  N, K",
        "unchanged: t r,  N K^-1",
        "measured in r, K:",
        "d(N) = N*(1 - N)",
    ):
        assert line in text


@pytest.mark.parametrize("power", ["0.857143", "0.85714", "1.852", "70.0625", "3.141593", "0.000123"])
def test_a_fitted_exponent_is_taken_as_it_is(power):
    """x scales by s, a by s to (1 - power)."""
    found = scaling_symmetries({"x": f"a*x^{power} - b*x"}, ["a", "b"])
    (invariant,) = [one for one in found.invariants if "x" in one]
    n = Fraction(power)

    assert found.count == 2
    # b x / (a x^n) has no scaling
    assert invariant["x"] / invariant["b"] == (1 - n)
    assert invariant["a"] == -invariant["b"]
    check = found.verify()
    assert bool(check)


def test_an_exponent_of_too_many_digits_is_refused():
    with pytest.raises(ModelError, match="seven digits"):
        scaling_symmetries({"x": "k*x^3.14159265 - x"}, ["k"])
