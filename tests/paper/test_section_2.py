"""Paper, section 2: state matrices and transfer function of the shipped bicycle (eqs 1-4)."""

import sympy as sp

from similitude.systems.bicycle import BICYCLE, Caf, Car, Iz, L, U, a, b, delta, m, r, v

x = sp.Matrix([v, r])
f = sp.Matrix([BICYCLE.rates[q.name] for q in BICYCLE.states])
A, B = f.jacobian(x), f.jacobian(sp.Matrix([delta]))


def same(left, right) -> bool:
    return sp.simplify(sp.Matrix([left]) - sp.Matrix([right])) == sp.zeros(*sp.Matrix([left]).shape)


def test_the_rates_are_linear_with_the_stated_matrices():
    assert same(f, A * x + B * delta)
    assert same(A[0, 0], -(Caf + Car) / (m * U))
    assert same(A[0, 1], (b * Car - a * Caf) / (m * U) - U)
    assert same(A[1, 0], (b * Car - a * Caf) / (Iz * U))
    assert same(A[1, 1], -(a**2 * Caf + b**2 * Car) / (Iz * U))
    assert same(B, sp.Matrix([Caf / m, a * Caf / Iz]))


def test_path_error_coordinates_give_the_matrices_of_equations_2_and_3():
    """y' = v + U psi, psi' = r: the four states y, y', psi, psi' of the paper."""
    dy, psi = sp.symbols("dy psi", real=True)
    seen = {v: dy - U * psi}
    y_rate = f[0].subs(seen) + U * r  # y'' = v' + U psi'
    yaw_rate = f[1].subs(seen)
    states = sp.Matrix([sp.Symbol("y", real=True), dy, psi, r])
    found = sp.Matrix([dy, y_rate, r, yaw_rate])
    moment = b * Car - a * Caf
    expected = sp.Matrix(
        [
            [0, 1, 0, 0],
            [0, -(Caf + Car) / (m * U), (Caf + Car) / m, moment / (m * U)],
            [0, 0, 0, 1],
            [0, moment / (Iz * U), -moment / Iz, -(a**2 * Caf + b**2 * Car) / (Iz * U)],
        ]
    )

    assert same(found.jacobian(states), expected)
    assert same(found.jacobian(sp.Matrix([delta])), sp.Matrix([0, Caf / m, 0, a * Caf / Iz]))


def test_the_transfer_function_is_equation_4():
    s = sp.Symbol("s")
    found = (sp.Matrix([[0, 1]]) * (s * sp.eye(2) - A).inv() * B)[0]
    over = a * Caf / Iz * s + Caf * Car * L / (m * Iz * U)
    damping = (Caf + Car) / (m * U) + (a**2 * Caf + b**2 * Car) / (Iz * U)
    under = s**2 + damping * s + Caf * Car * L**2 / (m * Iz * U**2) - (a * Caf - b * Car) / Iz

    assert same(found.subs(L, a + b), (over / under).subs(L, a + b))
