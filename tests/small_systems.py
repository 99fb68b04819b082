"""Four systems that are no bicycle, each with a plant that does not know how they were rewritten.

heater      one state, no signals, first unknown a logarithm
spring      two states, no signals, first unknown linear
drive       three states (two inertias and a shaft), no signals
aircraft    two states, airspeed as a signal, measured output depends on the unknown
"""

from dataclasses import dataclass, field

import numpy as np
import sympy as sp
from scipy.linalg import expm

from similitude.groups import reparameterize
from similitude.model import Model, Quantity
from similitude.program.library import Library
from similitude.reduction import Reduction, Unknown

from .filter_rig import design


def _symbols(names: str):
    return sp.symbols(names, real=True)


@dataclass
class Case:
    """A reduction, the truth of one plant, and what the filter is told of it."""

    reduction: Reduction
    truth: dict[str, float]  # SI values of every parameter but signals
    signals: dict[str, tuple[float, float]] = field(default_factory=dict)  # range
    prior: dict[str, tuple[float, float]] = field(default_factory=dict)  # mean, sd of coordinate
    force: float = 1.0  # amplitude of the input
    noise: float = 1e-3  # of the output
    step: float = 0.01  # s
    pace: tuple[float, float] = (0.1, 0.8)  # Hz, slowest and fastest sine of the input

    @property
    def model(self) -> Model:
        return self.reduction.groups.model

    def config(self, library: Library) -> np.ndarray:
        """Design constants scaled to this system's input and output."""
        layout, names = library.layout, [u.name for u in self.reduction.unknowns]
        sd = np.array([self.prior[n][1] for n in names])
        values = {row[0]: 0.0 for row in layout.CONFIG if row[3] == 1} | design(library)
        paced = {"1/s": 0.01 / self.step, "s": self.step / 0.01}  # the constants suit 100 Hz
        values |= {row[0]: values[row[0]] * paced[row[1]] for row in layout.CONFIG if row[1] in paced}
        values |= {n: v for n, v in self.truth.items() if n in values}
        values |= {
            "P_prior": np.diag(sd**2)[np.triu_indices(len(names))],
            "prior_information": sd[0] ** -2,
            "noise_variance": self.noise**2,
            "input_scale_sd": 1e-3,
            "input_scale_low": 0.9,
            "input_scale_high": 1.1,
            "input_offset_sd": 1e-3 * self.force,
            "output_bias_sd": self.noise,
            "disturbance_floor": 1e-3 * self.force,
            "bias_drift": 0.0,
            "timing_error": 0.0,
            "structure_share": 0.001,
            "slow_doubt": 0.0,  # as for any model: its priors are the truth's
            "gap": 100 * self.step,
            "input_limit": 100 * self.force,
            "output_limit": 1e6 * self.noise,
            "signal_limit": 3 * max([1.0, *(high for _, high in self.signals.values())]),
        }
        values |= {row[0]: 1.0 for row in layout.CONFIG if row[0].endswith("_star_sd")}
        for u in self.reduction.unknowns:
            mean, wide = self.prior[u.name][0], 3 * self.prior[u.name][1]
            ends = (mean * np.exp(-wide), mean * np.exp(wide)) if u.kind == "log" else ()
            low, high = ends or (mean - wide, mean + wide)
            values |= {f"{u.name}_prior": mean, f"{u.name}_low": low, f"{u.name}_high": high}
        return library.config(values)

    def log(self, samples: int, *, seed: int) -> np.ndarray:
        """Rows (dt, input, signals, measured) of the plant under a few slow sines."""
        rng = np.random.default_rng(seed)
        t = np.arange(samples) * self.step
        pace = np.geomspace(*self.pace, 5)[:, None] * rng.uniform(0.9, 1.1, (5, 1))
        phase = rng.uniform(0, 2 * np.pi, (5, 1))
        u = self.force * np.sin(2 * np.pi * pace * t + phase).sum(axis=0) / 2
        signals = {
            name: np.repeat(rng.uniform(low, high, samples // 400 + 1), 400)[:samples]
            for name, (low, high) in self.signals.items()
        }
        y = self._respond(u, signals) + self.noise * rng.standard_normal(samples)
        return np.column_stack([np.full(samples, self.step), u, *signals.values(), y])

    def _respond(self, u, signals) -> np.ndarray:
        """The exact response, dimensional, input straight between samples; the model is linear."""
        model, names = self.model, list(signals)
        x, output = sp.Matrix([q.symbol for q in model.states]), model.outputs[0].name
        rates = sp.Matrix([model.rates[q.name] for q in model.states]).subs(self._known())
        y = sp.sympify(model.output_map[output]).subs(self._known())
        free = [model.quantity(n).symbol for n in names]
        A = sp.lambdify(free, rates.jacobian(x), "numpy")
        B = sp.lambdify(free, rates.jacobian([model.inputs[0].symbol]), "numpy")
        C = sp.lambdify(free, sp.Matrix([y]).jacobian(x), "numpy")
        now, result, last = np.zeros(len(x)), np.zeros(len(u)), None
        for k in range(1, len(u)):
            at = tuple(values[k] for values in signals.values())
            if at != last:
                E = _blocks(np.array(A(*at), float), np.array(B(*at), float), self.step)
                c, last = np.array(C(*at), float)[0], at
            now = E[0] @ now + E[1] * u[k - 1] + E[2] * u[k]
            result[k] = c @ now
        return result

    def _known(self) -> dict:
        return {self.model.quantity(n).symbol: v for n, v in self.truth.items()}

    def true_value(self) -> float:
        """The first unknown of the plant, from its group's definition."""
        first = self.reduction.unknowns[0]
        named = {name for name, e in self.reduction.substitution.items() if e == first.symbol}
        known = {**dict.fromkeys(self.signals, 1.0), **self.truth}
        return self.reduction.groups.value(known)[named.pop()]


def _blocks(A, B, step):
    n = len(A)
    block = np.zeros((n + 2, n + 2))
    block[:n, :n], block[:n, n], block[n, n + 1] = A * step, B[:, 0] * step, 1.0
    E = expm(block)
    return E[:n, :n], E[:n, n] - E[:n, n + 1], E[:n, n + 1]


def heater() -> Case:
    """A lumped body heated by P, cooling through k: C T' = P - k T."""
    T, P, C, k = _symbols("T P C k")
    model = Model(
        name="heater",
        states=(Quantity("T", "K", "temperature above ambient"),),
        inputs=(Quantity("P", "W", "heating power"),),
        outputs=(Quantity("T", "K", "temperature above ambient"),),
        parameters=(
            Quantity("C", "J/K", "heat capacity"),
            Quantity("warm", "K", "a temperature to measure by"),
            Quantity("tau", "s", "a time to measure by"),
            Quantity("k", "W/K", "conductance"),
        ),
        rates={"T": (P - k * T) / C},
        output_map={"T": T},
    )
    unknown = Unknown("loss", "-", "log", "identify", "k tau/C")
    groups = reparameterize(model, base=("C", "warm", "tau"))
    reduction = Reduction(groups, (unknown,), {"pi1": unknown.symbol}, sp.true)
    truth = {"C": 500.0, "warm": 10.0, "tau": 60.0, "k": 6.5}
    prior = {"loss": (1.0, 0.5)}
    return Case(reduction, truth, prior=prior, force=50.0, noise=0.05, step=1.0, pace=(0.0005, 0.005))


def spring() -> Case:
    """A mass on a spring with a damper: m v' = F - k x - d v."""
    x, v, F, m, k, d = _symbols("x v F m k d")
    model = Model(
        name="spring",
        states=(Quantity("x", "m", "deflection"), Quantity("v", "m/s", "speed")),
        inputs=(Quantity("F", "N", "force"),),
        outputs=(Quantity("x", "m", "deflection"),),
        parameters=(
            Quantity("m", "kg", "mass"),
            Quantity("reach", "m", "a length to measure by"),
            Quantity("tau", "s", "a time to measure by"),
            Quantity("k", "N/m", "stiffness"),
            Quantity("d", "N s/m", "damping"),
        ),
        rates={"x": v, "v": (F - k * x - d * v) / m},
        output_map={"x": x},
    )
    stiffness = Unknown("stiffness", "-", "linear", "identify", "k tau^2/m")
    damping = Unknown("damping", "-", "log", "estimate", "d tau/m")
    substitution = {"pi1": stiffness.symbol, "pi2": damping.symbol}
    groups = reparameterize(model, base=("m", "reach", "tau"))
    reduction = Reduction(groups, (stiffness, damping), substitution, sp.true)
    truth = {"m": 2.0, "reach": 0.1, "tau": 0.2, "k": 60.0, "d": 7.0}
    prior = {"stiffness": (1.0, 0.3), "damping": (0.6, 0.3)}
    return Case(reduction, truth, prior=prior, force=2.0, noise=2e-4)


def drive() -> Case:
    """Motor and load on a soft shaft: three states, the shaft's stiffness unknown."""
    w, wl, twist, M, J, Jl, c, d = _symbols("w wl twist M J Jl c d")
    model = Model(
        name="drive",
        states=(
            Quantity("w", "rad/s", "motor speed"),
            Quantity("wl", "rad/s", "load speed"),
            Quantity("twist", "rad", "twist of the shaft"),
        ),
        inputs=(Quantity("M", "N m", "motor torque"),),
        outputs=(Quantity("w", "rad/s", "motor speed"),),
        parameters=(
            Quantity("J", "kg m^2", "motor inertia"),
            Quantity("tau", "s", "a time to measure by"),
            Quantity("Jl", "kg m^2", "load inertia"),
            Quantity("c", "N m/rad", "shaft stiffness"),
            Quantity("d", "N m s/rad", "bearing friction of the load"),
        ),
        rates={"w": (M - c * twist) / J, "wl": (c * twist - d * wl) / Jl, "twist": w - wl},
        output_map={"w": w},
    )
    shaft = Unknown("shaft", "-", "log", "identify", "c tau^2/J")
    load = Unknown("load", "-", "log", "estimate", "Jl/J")
    friction = Unknown("friction", "-", "log", "consider", "d tau/J")
    substitution = {"pi1": load.symbol, "pi2": shaft.symbol, "pi3": friction.symbol}
    groups = reparameterize(model, base=("J", "tau"))
    reduction = Reduction(groups, (shaft, load, friction), substitution, sp.true)
    truth = {"J": 0.02, "tau": 0.1, "Jl": 0.06, "c": 2.6, "d": 0.11}
    prior = {"shaft": (1.0, 0.5), "load": (2.7, 0.2), "friction": (0.5, 0.2)}
    return Case(reduction, truth, prior=prior, force=0.3, noise=0.02)


def aircraft() -> Case:
    """Short period of an aircraft: vertical acceleration from elevator at changing airspeed."""
    alpha, q, de, m, c, V = _symbols("alpha q de m c V")
    z, ma, mq, md, Iy = _symbols("z ma mq md Iy")
    model = Model(
        name="aircraft",
        states=(Quantity("alpha", "rad", "angle of attack"), Quantity("q", "rad/s", "pitch rate")),
        inputs=(Quantity("de", "rad", "elevator angle"),),
        outputs=(Quantity("nz", "m/s^2", "normal acceleration"),),
        parameters=(
            Quantity("m", "kg", "mass"),
            Quantity("c", "m", "wing chord"),
            Quantity("V", "m/s", "airspeed"),
            Quantity("z", "kg/m", "lift per dynamic pressure and angle"),
            Quantity("ma", "kg", "static stability"),
            Quantity("mq", "kg", "pitch damping"),
            Quantity("md", "kg", "elevator effectiveness"),
            Quantity("Iy", "kg m^2", "pitch inertia"),
        ),
        rates={
            "alpha": q - z * V / m * alpha,
            "q": V**2 * (md * de - ma * alpha - mq * c / V * q) / Iy,
        },
        output_map={"nz": z * V**2 / m * alpha},
        signals=("V",),
    )
    unknowns = (
        Unknown("lift", "-", "log", "identify", "z c/m"),
        Unknown("stable", "-", "log", "estimate", "ma/m"),
        Unknown("damped", "-", "log", "consider", "mq/m"),
        Unknown("elevator", "-", "log", "estimate", "md/m"),
        Unknown("gyration", "-", "log", "consider", "Iy/(m c^2)"),
    )
    groups = reparameterize(model, base=("m", "c", "V"))
    substitution = {f"pi{i + 1}": u.symbol for i, u in enumerate(unknowns)}
    reduction = Reduction(groups, unknowns, substitution, V > 10)
    truth = {"m": 1000.0, "c": 1.5, "z": 9.0, "ma": 9.5, "mq": 55.0, "md": 21.0, "Iy": 1900.0}
    prior = {
        "lift": (0.0100, 0.5),
        "stable": (0.010, 0.2),
        "damped": (0.055, 0.1),
        "elevator": (0.020, 0.2),
        "gyration": (0.84, 0.1),
    }
    signals = {"V": (40.0, 70.0)}
    return Case(reduction, truth, signals, prior, force=0.02, noise=0.05, step=0.02, pace=(0.1, 1.0))


CASES = {case.__name__: case for case in (heater, spring, drive, aircraft)}
