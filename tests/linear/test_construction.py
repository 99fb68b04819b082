"""Models from matrices and from transfer functions, and what does not fit."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.linear.construction import state_space_model, transfer_function_model
from similitude.linear.matrices import transfer_function
from similitude.model import Quantity

s = sp.Symbol("s")
SIGNALS = {
    "states": [Quantity("x", "m"), Quantity("v", "m/s")],
    "inputs": [Quantity("F", "N")],
    "outputs": [Quantity("x", "m")],
    "parameters": [Quantity("m", "kg"), Quantity("k", "N/m"), Quantity("d", "N s/m")],
}
A, B, C = [[0, 1], ["-k/m", "-d/m"]], [[0], ["1/m"]], [[1, 0]]
m, k, d = sp.symbols("m k d", real=True)


def test_a_spring_from_its_matrices():
    model = state_space_model("spring", **SIGNALS, A=A, B=B, C=C)

    assert sp.cancel(transfer_function(model) - 1 / (m * s**2 + d * s + k)) == 0
    assert state_space_model("spring", **SIGNALS, A=sp.Matrix(A), B=sp.Matrix(B), C=sp.Matrix(C)) == model


@pytest.mark.parametrize(
    ("matrices", "said"),
    [
        ({"B": [[0, "1/m"]]}, "B is 1 by 2, and its quantities want 2 by 1"),
        ({"A": [[0, 1], ["-k/m", "-d"]]}, r"-d\*v is in kg m/s\^2"),
        ({"A": [[0, 1], ["-q/m", "-d/m"]]}, "entry 2,1 of A"),
    ],
)
def test_matrices_that_do_not_fit_are_refused(matrices, said):
    with pytest.raises(ModelError, match=said):
        state_space_model("spring", **SIGNALS, **({"A": A, "B": B, "C": C} | matrices))


def of(numerator, denominator):
    return transfer_function_model(
        "lag",
        input=Quantity("u", "V"),
        output=Quantity("w", "rad/s"),
        parameters=[Quantity("K", "rad/(V s)"), Quantity("T", "s"), Quantity("D", "1")],
        numerator=numerator,
        denominator=denominator,
    )


K, T, D = sp.symbols("K T D", real=True)


@pytest.mark.parametrize(
    ("numerator", "denominator"),
    [
        (["K"], ["T", 1]),
        (["K*T", "K"], ["T^2", "2*D*T", 1]),
        (["K*T^2", 0, "K"], ["T^2", "2*D*T", 1]),
        ([0, K], [D * T**3, T**2, T, 1]),
    ],
)
def test_a_transfer_function_comes_back(numerator, denominator):
    def polynomial(row):
        return sum(sp.sympify(e, locals={"K": K, "T": T, "D": D}) * s**i for i, e in enumerate(reversed(row)))

    model = of(numerator, denominator)

    assert sp.cancel(transfer_function(model) - polynomial(numerator) / polynomial(denominator)) == 0


@pytest.mark.parametrize(
    ("numerator", "denominator", "said"),
    [
        (
            ["K"],
            ["T", "2*D*T", 1],
            r"the coefficient of s\^1 in the denominator, 2\*D\*T, is in s, and - is wanted",
        ),
        (["K"], ["1 + T", 1], "is terms of different units"),
        (["K", "K"], ["T"], "numerator of degree 1 over denominator of degree 0"),
        (["T"], ["T", 1], "numerator, T, is in s"),
    ],
)
def test_coefficients_that_do_not_fit_are_refused(numerator, denominator, said):
    with pytest.raises(ModelError, match=said):
        of(numerator, denominator)
