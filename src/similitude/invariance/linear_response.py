"""Frequency response, sampled response, poles, zeros and gain of a model that is linear or linearised.

    G(s) = C (sI - A)^-1 B + D        dG = dC X + Y dA X + Y dB + dD,  X = (sI - A)^-1 B, Y = C (sI - A)^-1
    G(z): the same with Phi, Gamma of a held input,  [Phi Gamma; 0 I] = exp([A B; 0 0] Ts)
    pole  dp = w dA v/(w v) with left and right eigenvectors w, v        zero  dq = -(dN)/(dN/ds)

Arguments are the parameters, s [1/time] or z [-] and Ts [time] where there is one, and, of a model that is
not linear, states and inputs of the operating point.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import NONE, Measure
from similitude.invariance.compiled import compiled, log_slope
from similitude.invariance.model_equations import READ, Equations
from similitude.invariance.response import Certificate, Response
from similitude.linear.matrices import LinearParts, linear_parts, transfer_polynomials

Values = Mapping[str, float]
MOST_STATES = 6  # beyond, determinants in symbols grow large, and the rates stand proof in their place


def frequency_response(eq: Equations, given: str | None) -> Response:
    """G(s), s the Laplace variable."""
    linear = _Linear(eq, eq.input_named(given))
    s = sp.Symbol(eq.free("s"))
    measures = {**linear.measures, s.name: NONE / eq.time}
    about = f"{eq.name}/{linear.given} at {s.name}"
    response = linear.response("frequency", about, {s.name}, _at(s.name), measures)
    if not linear.is_plain:
        return response
    N, M = linear.polynomials(s)
    return replace(response, certificates=linear.polynomial_proof(N, M), formula=N / M)


def gain_response(eq: Equations, given: str | None) -> Response:
    """G(0), the output per input at rest."""
    linear = _Linear(eq, eq.input_named(given))
    about = f"{eq.name}/{linear.given} at rest"
    response = linear.response("dc_gain", about, set(), _at(None), linear.measures)
    if not linear.is_plain:
        return response
    s = sp.Symbol(eq.free("s"))
    N, M = (p.subs(s, 0) for p in linear.polynomials(s))
    if sp.expand(M) == 0:
        raise _no_gain(eq)
    formula = sp.cancel(N / M)
    left = {symbol.name for symbol in formula.free_symbols}
    arguments = {n: m for n, m in linear.measures.items() if n in left}
    proof = linear.polynomial_proof(N, M)
    return replace(response, arguments=arguments, certificates=proof, formula=formula)


def sampled_response(eq: Equations, given: str | None) -> Response:
    """G(z) of the model sampled every Ts with its input held between samples."""
    linear = _Linear(eq, eq.input_named(given))
    z, Ts = eq.free("z"), eq.free("Ts")
    about = f"{eq.name}/{linear.given} at {z}, sampled every {Ts}"
    measures = {**linear.measures, z: NONE, Ts: eq.time}
    return linear.response("z", about, {z, Ts}, _at(z, sampled=Ts), measures)


def pole_response(eq: Equations) -> Response:
    """The eigenvalues of A, in increasing order of their real, then imaginary part."""
    linear = _Linear(eq, None)
    certificates = eq.certificates
    if linear.is_plain:
        s = sp.Symbol(eq.free("s"))
        M = (s * sp.eye(linear.n) - linear.parts.A).det(method="berkowitz")
        certificates = (Certificate("characteristic polynomial", M, eq.time**-linear.n),)

    def evaluate(numbers: _Numbers) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        poles, right = np.linalg.eig(numbers.A)
        order = np.lexsort((poles.imag, poles.real))
        poles, right = poles[order], right[:, order]
        left = np.linalg.inv(right)
        moved = {n: np.einsum("ij,jk,ki->i", left, dA, right) for n, (dA, *_) in numbers.slopes.items()}
        return poles, moved

    return linear.response(
        "poles", "poles", set(), evaluate, linear.measures, output=NONE / eq.time, certificates=certificates
    )


def zero_response(eq: Equations, given: str | None) -> Response:
    """The roots of the transfer function's numerator; there may be none."""
    linear = _Linear(eq, eq.input_named(given))
    if linear.n > MOST_STATES:
        raise ModelError(
            f"model {eq.model.name!r} has {linear.n} states; zeros are found for {MOST_STATES} at most",
            usually="A large model was meant to be reduced first.",
            paste="invariances(model, response='poles')",
            read=READ,
        )
    s = sp.Symbol(eq.free("s"))
    N, M = linear.polynomials(s)
    poly = sp.Poly(N, s)
    measures = {n: m for n, m in linear.measures.items() if sp.Symbol(n, real=True) in N.free_symbols}
    symbols = [sp.Symbol(n, real=True) for n in measures]
    coefficients = poly.all_coeffs()
    functions: list[Callable] = []

    def evaluate(values: Values) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        if not functions:
            slopes = [log_slope(c, p) for p in symbols for c in coefficients]
            functions.append(compiled(symbols, [*coefficients, *slopes]))
        numbers = np.array(functions[0](*(values[p.name] for p in symbols)), dtype=float)
        table = numbers.reshape(len(symbols) + 1, -1)
        roots = np.roots(table[0])
        roots = roots[np.lexsort((roots.imag, roots.real))]
        slope = np.polyval(np.polyder(table[0]), roots)
        return roots, {
            p.name: -np.polyval(row, roots) / slope for p, row in zip(symbols, table[1:], strict=True)
        }

    return Response(
        kind="zeros",
        about=f"zeros of {eq.name}/{linear.given}",
        arguments=measures,
        output=NONE / eq.time,
        symbols=linear.symbols | {s: NONE / eq.time},
        certificates=linear.polynomial_proof(N, M)[:1] if linear.is_plain else eq.certificates,
        evaluate=evaluate,
    )


class _Numbers:
    """Matrices at given values, and their slopes in the logarithms of the arguments."""

    def __init__(self, table: np.ndarray, names: list[str], n: int, values: Values) -> None:
        blocks = [(t[:n, :n], t[:n, n:], t[n:, :n], t[n:, n:]) for t in table]
        self.A, self.B, self.C, self.D = blocks[0]
        self.slopes = dict(zip(names, blocks[1:], strict=True))
        self.values = values


class _Linear:
    """One output and one input of a linear model, in symbols."""

    def __init__(self, eq: Equations, given: int | None) -> None:
        self.eq = eq
        parts = linear_parts(eq.model, outputs=[eq.output])
        self.n = parts.A.rows
        column = [] if given is None else [given]
        B, D = parts.B.extract(list(range(self.n)), column), parts.D.extract([0], column)
        self.parts = LinearParts(parts.A, B, parts.C, D, parts.is_linear)
        self.given = None if given is None else eq.model.inputs[given].name
        of_input = NONE if given is None else eq.measures[self.given]
        self.gain = eq.output_measure / of_input
        used = {s.name for m in (parts.A, *((B, parts.C, D) if column else ())) for s in m.free_symbols}
        self.measures = {n: m for n, m in eq.measures.items() if n in used}
        self.symbols = {sp.Symbol(n, real=True): m for n, m in eq.measures.items()}
        self.functions: list[Callable] = []

    @property
    def is_plain(self) -> bool:
        """Linear, and small enough for determinants in symbols."""
        return self.parts.is_linear and self.n <= MOST_STATES

    def polynomials(self, s: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
        """Numerator and characteristic polynomial."""
        return transfer_polynomials(self.parts, 0, 0, s)

    def polynomial_proof(self, N: sp.Expr, M: sp.Expr) -> tuple[Certificate, ...]:
        """Both polynomials as certificates: where each is homogeneous, so are their ratio and their roots."""
        below = self.eq.time**-self.n
        numerator = Certificate("numerator", N, self.gain * below)
        return numerator, Certificate("characteristic polynomial", M, below)

    def numbers(self, values: Values) -> _Numbers:
        """The matrices at values of the arguments, with slopes."""
        p = self.parts
        whole = p.A.row_join(p.B).col_join(p.C.row_join(p.D))
        symbols = [sp.Symbol(n, real=True) for n in self.measures]
        if not self.functions:
            slopes = [log_slope(e, q) for q in symbols for e in whole]
            self.functions.append(compiled(symbols, [*whole, *slopes]))
        # what cancels from a gain is no argument of it, and any number will do
        given = (values.get(q.name, 1.0) for q in symbols)
        flat = np.array(self.functions[0](*given), dtype=float)
        return _Numbers(flat.reshape(len(symbols) + 1, *whole.shape), list(self.measures), self.n, values)

    def response(
        self,
        kind: str,
        about: str,
        variables: set[str],
        of: Callable,
        measures: Mapping[str, Measure],
        **other,
    ) -> Response:
        """A response computed from the matrices; ``variables`` are its arguments beside the model's."""
        output, certificates = other.get("output", self.gain), other.get("certificates", self.eq.certificates)
        symbols = self.symbols | {sp.Symbol(n): m for n, m in measures.items() if n in variables}
        if kind == "poles":
            symbols |= {sp.Symbol(self.eq.free("s")): NONE / self.eq.time}
        return Response(
            kind=kind,
            about=about,
            arguments=measures,
            output=output,
            symbols=symbols,
            certificates=certificates,
            evaluate=lambda values: of(self.numbers(values)),
        )


def _at(variable: str | None, *, sampled: str | None = None) -> Callable:
    """G at one or many values of its variable, with slopes; sampled first where ``sampled`` names Ts."""

    def evaluate(numbers: _Numbers) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        if sampled is not None:
            numbers = _held(numbers, sampled)
        if variable is None:
            gain, slopes = _transfer(numbers, 0.0, None)
            return np.asarray(gain), {n: np.asarray(d) for n, d in slopes.items()}
        points = np.asarray(numbers.values[variable], dtype=complex)
        found = [_transfer(numbers, point, variable) for point in points.reshape(-1)]
        y = np.array([g for g, _ in found]).reshape(points.shape)
        return y, {n: np.array([d[n] for _, d in found]).reshape(points.shape) for n in found[0][1]}

    return evaluate


def _transfer(m: _Numbers, s: complex, variable: str | None) -> tuple[complex, dict[str, complex]]:
    resolvent = s * np.eye(len(m.A)) - m.A
    X = np.linalg.solve(resolvent, m.B)
    Y = np.linalg.solve(resolvent.T, m.C.T).T
    slopes = {n: (dC @ X + Y @ dA @ X + Y @ dB + dD)[0, 0] for n, (dA, dB, dC, dD) in m.slopes.items()}
    if variable is not None:
        slopes[variable] = -s * (Y @ X)[0, 0]
    return (m.C @ X + m.D)[0, 0], slopes


def _held(m: _Numbers, Ts: str) -> _Numbers:
    """The matrices of the sampled model, exactly, with their slopes; also in ln Ts."""
    from scipy.linalg import expm, expm_frechet

    n, period = len(m.A), m.values[Ts]
    block = _over_zeros(m.A, m.B) * period
    table = [_under(expm(block), m.C, m.D, n)]
    for dA, dB, dC, dD in m.slopes.values():
        moved = expm_frechet(block, _over_zeros(dA, dB) * period, compute_expm=False)
        table.append(_under(moved, dC, dD, n))
    table.append(_under(block @ expm(block), 0 * m.C, 0 * m.D, n))
    return _Numbers(np.array(table), [*m.slopes, Ts], n, m.values)


def _over_zeros(A: np.ndarray, B: np.ndarray) -> np.ndarray:
    n, inputs = B.shape
    return np.block([[A, B], [np.zeros((inputs, n + inputs))]])


def _under(held: np.ndarray, C: np.ndarray, D: np.ndarray, n: int) -> np.ndarray:
    return np.vstack([held[:n], np.hstack([C, D])])


def _no_gain(eq: Equations) -> ModelError:
    return ModelError(
        f"model {eq.model.name!r} has no gain at rest: a pole lies at zero",
        usually="It integrates; only its rate settles, or a frequency response has to be asked for.",
        paste="invariances(model, response='frequency')",
        read=READ,
    )
