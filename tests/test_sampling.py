"""The implicit step against the exact matrix exponential, and its Jacobians against differences."""

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from similitude.sampling import implicit_step

from .run_statements import evaluate, run_statements

NAMES = ("x", "y", "z")
u, p = sp.symbols("u p", real=True)
seeds = st.integers(0, 2**32 - 1)


def test_one_whole_step_is_its_approximant_and_exact_at_rest():
    x, a = sp.symbols("x a", real=True)
    made = implicit_step([a * x + u], [x], parameters={"u": sp.Integer(1)}, halves=1)
    for z in (-0.1, -0.5, -1.0, -5.0, -1e6, 0.3):
        scope = run_statements(made.statements, {"x": 1.0, "a": z, "u": -z, "h": 1.0})
        M, G = (float(evaluate(e, scope)) for e in (made.by_state[0], made.by_parameter["u"][0]))

        assert M == pytest.approx((1 + z / 3) / (1 - 2 * z / 3 + z * z / 6), rel=1e-9, abs=1e-12)
        assert float(evaluate(made.after[0], scope)) == pytest.approx(1.0, rel=1e-9)  # x = 1 is at rest
        assert G == pytest.approx((M - 1) / z, rel=1e-6)
        if -1 <= z < 0:
            assert M == pytest.approx(np.exp(z), rel=0.012)  # 1.2 % at |h lambda| = 1
        if -0.5 <= z < 0:
            assert M == pytest.approx(np.exp(z), rel=0.001)


class Step:
    """An implicit step on numbers."""

    def __init__(self, rates, n, parameters=(), ramp=None):
        self.states = sp.symbols(NAMES[:n], real=True)
        chain = dict.fromkeys(parameters, sp.Integer(1))
        self.step = implicit_step(rates(*self.states), list(self.states), parameters=chain, ramp=ramp)

    def __call__(self, x, h, **values):
        """State after, dx+/dx and {parameter: dx+/dp}."""
        known = dict(zip(NAMES, map(float, x), strict=False)) | values | {"h": h}
        scope = run_statements(self.step.statements, known)

        def number(matrix):
            return np.array([evaluate(e, scope) for e in matrix]).reshape(matrix.shape)

        by = {name: number(column)[:, 0] for name, column in self.step.by_parameter.items()}
        return number(self.step.after)[:, 0], number(self.step.by_state), by


def linear(n):
    """x' = A x + B u with symbols a00, a01, ..., b0, ..."""
    A = sp.Matrix(n, n, lambda i, j: sp.Symbol(f"a{i}{j}", real=True))
    B = sp.Matrix(n, 1, lambda i, j: sp.Symbol(f"b{i}", real=True))
    return Step(lambda *x: list(A * sp.Matrix(x) + B * u), n)


LINEAR = {n: linear(n) for n in (1, 2, 3)}


def entries(A, B):
    named = {f"a{i}{j}": float(A[i, j]) for i in range(len(A)) for j in range(len(A))}
    return named | {f"b{i}": float(b) for i, b in enumerate(B)}


def exact(A, B, x, held, h):
    """(transition, state after) of x' = A x + B held."""
    n = len(A)
    block = np.zeros((n + 1, n + 1))
    block[:n, :n], block[:n, n] = A * h, B * held * h
    E = expm(block)
    return E[:n, :n], E[:n, :n] @ x + E[:n, n]


def normal_matrix(rng, n, *, radius):
    """A real normal A, all |lambda| <= radius and one equal to it, half-plane given by its sign.

    Normal, so that the error of the step is that of its stability function on the eigenvalues.
    """
    angles = rng.uniform(np.pi / 2, 3 * np.pi / 2, n)
    lengths = abs(radius) * np.append(1.0, rng.uniform(0, 1, n - 1))
    real = lengths * np.cos(angles)
    A = np.diag(real)
    if n > 1:  # a pair of complex ones
        A[1, 1] = A[0, 0] = real[0]
        A[0, 1] = lengths[0] * np.sin(angles[0])
        A[1, 0] = -A[0, 1]
    if n == 1:
        A[0, 0] = -abs(radius)
    Q, _ = np.linalg.qr(rng.standard_normal((n, n)))
    return np.sign(radius) * Q @ A @ Q.T


@settings(max_examples=80, deadline=None)
@given(st.sampled_from([1, 2, 3]), seeds, st.floats(0.001, 1.0))
def test_below_one_percent_of_the_exponential_at_lambda_h_up_to_one(n, seed, radius):
    """The square of the (1,2) Pade approximant is within 0.0018 of exp on the left half disc."""
    rng = np.random.default_rng(seed)
    A, B, x = normal_matrix(rng, n, radius=radius), rng.standard_normal(n), rng.standard_normal(n)
    transition, after = exact(A, B, x, 0.7, 1.0)

    found, M, _ = LINEAR[n](x, 1.0, u=0.7, **entries(A, B))

    assert np.linalg.norm(M - transition, 2) < 0.002
    # x+ = M (x - rest) + rest, so the error is that of M on the distance from rest
    away = np.linalg.norm(x + np.linalg.lstsq(A, B * 0.7, rcond=None)[0])
    assert np.linalg.norm(found - after) < 0.002 * away + 1e-9


@settings(max_examples=60, deadline=None)
@given(st.sampled_from([1, 2, 3]), seeds, st.floats(1.0, 1e4))
def test_bounded_and_settled_at_lambda_h_of_a_hundred_and_beyond(n, seed, radius):
    """L-stable: never larger than before, and 1.2 % of it or less at 100 on the real axis."""
    rng = np.random.default_rng(seed)
    A, x = normal_matrix(rng, n, radius=radius), rng.standard_normal(n)

    found, M, _ = LINEAR[n](x, 1.0, u=0.0, **entries(A, np.zeros(n)))

    assert np.linalg.norm(M, 2) <= 1 + 1e-9
    assert np.linalg.norm(found) <= np.linalg.norm(x) * (1 + 1e-9)


@pytest.mark.parametrize("stiff", [0.1, 1.0, 10.0, 100.0, 1e6])
def test_a_decay_keeps_its_sign_and_only_gets_smaller(stiff):
    """Real negative lambda: the factor stays in (0, 1) (a square), and goes to zero as 144/z^2 / 12."""
    _, M, _ = LINEAR[1]([1.0], 1.0, u=0.0, a00=-stiff, b0=0.0)

    assert 0 < M[0, 0] < 1
    if stiff >= 100:
        assert M[0, 0] < 0.002 * (100 / stiff) ** 2


@settings(max_examples=40, deadline=None)
@given(st.sampled_from([1, 2, 3]), seeds, st.floats(1e-3, 1e3))
def test_a_state_at_rest_stays_there_whatever_the_step(n, seed, h):
    rng = np.random.default_rng(seed)
    A, B = normal_matrix(rng, n, radius=1.0) - 0.1 * np.eye(n), rng.standard_normal(n)
    rest = -np.linalg.solve(A, B)

    found, _, _ = LINEAR[n](rest, h, u=1.0, **entries(A, B))

    # at rest the rate is zero but for a few roundings of |A||x|, seen through G = O(1/A), cond <= 20
    assert np.abs(found - rest).max() <= 1e-12 * max(1.0, np.abs(rest).max())


@pytest.mark.parametrize(("growth", "h"), [(0.5, 1.0), (1.0, 1.0), (3.0, 0.1)])
def test_an_unstable_mode_grows_as_it_should(growth, h):
    """An oversteering car above its critical speed: one real eigenvalue to the right."""
    A = np.array([[growth, 0.4], [0.0, -2.0]])
    x = np.array([0.1, 0.3])
    transition, after = exact(A, np.zeros(2), x, 0.0, h)

    found, M, _ = LINEAR[2](x, h, u=0.0, **entries(A, np.zeros(2)))

    # at z = 1 the approximant is 2.7128 for e = 2.7183, 0.2 %; the stable one 1.3 % of 0.135
    assert np.abs(M - transition).max() < 0.01
    assert np.abs(found - after).max() < 0.005


def pendulum(x, y):
    """sin by its series: a soft spring with damping and drive, p its stiffness."""
    return [y, -p * (x - x**3 / 6 + x**5 / 120) - 0.3 * y + u]


def cubic(x):
    return [-p * x - x**3 + u]


def chain(x, y, z):
    return [-p * x + y * z, u - y - 0.5 * x * y, p * (y - z) - z**3]


NONLINEAR = {"cubic": (cubic, 1), "pendulum": (pendulum, 2), "chain": (chain, 3)}
STEPS = {name: Step(f, n, ("p", "u")) for name, (f, n) in NONLINEAR.items()}
START = (0.9, -0.4, 0.3)


def truth(name, x, time, **values):
    f, n = NONLINEAR[name]
    rates = sp.lambdify([sp.symbols(NAMES[:n], real=True), u, p], f(*sp.symbols(NAMES[:n], real=True)))
    solved = solve_ivp(lambda t, s: rates(s, values["u"], values["p"]), (0, time), x, rtol=1e-12, atol=1e-13)
    return solved.y[:, -1]


@pytest.mark.parametrize("name", NONLINEAR)
def test_the_error_of_a_nonlinear_system_is_of_second_order(name):
    """Halving the step over the same time divides the error by four, give or take the next order."""
    n, values, errors = NONLINEAR[name][1], {"u": 0.5, "p": 2.0}, []
    expected = truth(name, START[:n], 1.0, **values)
    for steps in (20, 40, 80):
        x = np.array(START[:n])
        for _ in range(steps):
            x, _, _ = STEPS[name](x, 1.0 / steps, **values)
        errors.append(np.abs(x - expected).max())

    assert errors[-1] < 1e-3
    assert all(3.3 < a / b < 5.0 for a, b in pairwise(errors)), errors


@pytest.mark.parametrize("name", NONLINEAR)
@pytest.mark.parametrize("h", [0.02, 0.01])
def test_jacobians_are_those_of_the_step(name, h):
    """Against central differences; what the Jacobians leave out is of order h^2.

    d(G f)/dx holds dG/dx f as well, and G = h + h^2 J/2 + ..., so the difference is h^2 |dJ/dx f|/2;
    second derivatives and rates of these systems are below 6 each.
    """
    n, values = NONLINEAR[name][1], {"u": 0.5, "p": 2.0}
    x, tiny = np.array(START[:n]), 1e-6
    _, M, by = STEPS[name](x, h, **values)

    def difference(change):
        up, down = change(tiny), change(-tiny)
        return (STEPS[name](up[0], h, **up[1])[0] - STEPS[name](down[0], h, **down[1])[0]) / 2 / tiny

    for j, e in enumerate(np.eye(n)):
        moved = difference(lambda d, e=e: (x + d * e, values))
        assert np.abs(M[:, j] - moved).max() < 18 * h**2
    for parameter, column in by.items():
        moved = difference(lambda d, q=parameter: (x, values | {q: values[q] + d}))
        assert np.abs(column - moved).max() < 18 * h**2


@settings(max_examples=30, deadline=None)
@given(seeds, st.floats(0.01, 50))
def test_sensitivity_of_a_linear_system_at_rest_is_exact(seed, h):
    """Stepping on with dx+/dx and dx+/dp from rest leads to d(rest)/dp, whatever the step."""
    rng = np.random.default_rng(seed)
    stiffness, force = rng.uniform(0.5, 2, 2)
    step = Step(lambda x: [u - p * x], 1, ("p",))
    rest = force / stiffness

    _, M, by = step([rest], h, u=force, p=stiffness)

    settled = by["p"][0] / (1 - M[0, 0])  # s = M s + by_parameter
    assert settled == pytest.approx(-force / stiffness**2, rel=1e-9)


def test_a_companion_moves_on_its_own_path_with_the_same_matrices():
    x, y, x2, u2 = sp.symbols("x y x_plain u_plain", real=True)
    y2 = sp.Symbol("y_plain", real=True)
    path = {x: x2, y: y2, u: u2}
    made = implicit_step(pendulum(x, y), [x, y], parameters={"p": sp.Integer(1)}, companion=path)
    known = {"x": 0.2, "y": 0.1, "x_plain": 0.2, "y_plain": 0.1, "u": 0.3, "u_plain": 0.3}
    known |= {"p": 2.0, "h": 0.1}

    scope = run_statements(made.statements, known)

    after = [evaluate(e, scope) for e in made.after]
    assert [evaluate(e, scope) for e in made.companion_after] == after


def ramped(n):
    """x' = A x + B u where u rises by ``rise`` over the step and has the mean u."""
    A = sp.Matrix(n, n, lambda i, j: sp.Symbol(f"a{i}{j}", real=True))
    B = sp.Matrix(n, 1, lambda i, j: sp.Symbol(f"b{i}", real=True))
    rates = lambda *x: list(A * sp.Matrix(x) + B * u)  # noqa: E731
    return Step(rates, n, parameters=("u",), ramp=("u", sp.Symbol("rise", real=True)))


RAMPED = {n: ramped(n) for n in (1, 2, 3)}


def straight_line(A, B, begin, end, h):
    """State after h from rest under an input that goes from ``begin`` to ``end``, exactly."""
    n = len(A)
    block = np.zeros((n + 2, n + 2))
    block[:n, :n], block[:n, n], block[n, n + 1] = A, B, 1.0
    return (expm(block * h) @ np.concatenate([np.zeros(n), [begin, (end - begin) / h]]))[:n]


@settings(max_examples=60, deadline=None)
@given(st.sampled_from([1, 2, 3]), seeds, st.floats(0.01, 1.0))
def test_an_input_that_rises_is_met_to_third_order(n, seed, h):
    """The local error of two Radau IIA halves is h^4/576 of the forcing, times 1 + h |lambda|/2 + ..."""
    rng = np.random.default_rng(seed)
    A, B = normal_matrix(rng, n, radius=1.0), rng.standard_normal(n)
    begin, slope = rng.standard_normal(2)

    after, _, _ = RAMPED[n](np.zeros(n), h, u=begin + slope * h / 2, rise=slope * h, **entries(A, B))

    error = np.linalg.norm(after - straight_line(A, B, begin, begin + slope * h, h))
    assert error < h**4 / 200 * np.linalg.norm(B) * (abs(begin) + abs(slope)) + 1e-12


@settings(max_examples=60, deadline=None)
@given(st.sampled_from([1, 2, 3]), seeds)
def test_a_vehicle_faster_than_the_log_follows_the_input_without_delay(n, seed):
    rng = np.random.default_rng(seed)
    A, B = normal_matrix(rng, n, radius=1.0) - 0.5 * np.eye(n), rng.standard_normal(n)
    begin, end = rng.standard_normal(2)

    after, _, _ = RAMPED[n](np.zeros(n), 1e4, u=(begin + end) / 2, rise=end - begin, **entries(A, B))

    # what is left are terms in 1/(h lambda) with |lambda| >= 0.5
    settled = -np.linalg.solve(A, B * end)
    assert np.linalg.norm(after - settled) < 1e-2 * np.linalg.norm(B) * (abs(begin) + abs(end))
