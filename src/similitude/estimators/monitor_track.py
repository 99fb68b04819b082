"""What a monitor follows: the held filter, and the drives that the steer alone would have caused.

The held filter is a small Kalman filter of dynamic states and disturbance with every unknown held at
its reference. Beside it run three copies of the model along the steer alone: one with the reference,
two with other values of the first unknown. What the held filter would have missed had one of those
been the vehicle (its ``signature``) is what it is looked for in its innovations.

A signature knows nothing of gusts and kerbs, so these cannot look like it but by chance.

Invariant: nothing but the monitor's own states is written.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import sympy as sp

from similitude.estimators.filter_fields import DISTURBANCE, Layout
from similitude.program.ir import Assign, Field, Statement
from similitude.program.symmetric import Shared, Symmetric, column, predict, reduce_by
from similitude.sampling import implicit_step

KINDS = ("fall", "rise")


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


@dataclass(frozen=True)
class Tracks:
    """Names and statements of the held filter and of the drives along the steer alone."""

    layout: Layout

    def of(self, which: str) -> tuple[str, ...]:
        """Dynamic states called ``<state>_<which>``."""
        return tuple(f"{name}_{which}" for name in self.layout.fast)

    @property
    def covariance(self) -> Symmetric:
        """Covariance of the held filter's dynamic states and disturbance."""
        return Symmetric("P", len(self.layout.fast) + 1)

    @property
    def missing(self) -> dict[str, tuple[str, ...]]:
        """For each kind, how far the held filter would be from the steer's own drive."""
        return {k: (*self.of(f"miss_{k}"), f"{DISTURBANCE}_miss_{k}") for k in KINDS}

    @property
    def fields(self) -> tuple[Field, ...]:
        """What is remembered."""
        unit = self.layout.input.unit
        fields = [Field(n, "-", "dynamic state of the held filter") for n in self.of("held")]
        fields.append(Field(f"{DISTURBANCE}_held", unit, "disturbance of the held filter"))
        fields.append(self.covariance.field("-", "covariance of the above, upper triangle by rows"))
        fields += [Field(n, "-", "state along the steer alone") for n in self.of("plain")]
        for k in KINDS:
            fields += [Field(n, "-", f"the same after a {k}") for n in self.of(k)]
            fields += [Field(n, "-", f"the held filter's error after a {k}") for n in self.missing[k]]
        return tuple(fields)

    def anew(self) -> list[Statement]:
        """Nothing is known of the dynamics."""
        P, n = self.covariance, len(self.layout.fast)
        lines: list[Statement] = [
            Assign(s.name, sp.Integer(0)) for f in self.fields for s in f.symbols if f.name != "P"
        ]
        lines += [Assign(P.target(i, j), sp.Integer(0)) for i in range(P.n) for j in range(i + 1, P.n)]
        lines += [Assign(P.target(i, i), S(f"{x}_sd") ** 2) for i, x in enumerate(self.layout.fast)]
        return [*lines, Assign(P.target(n, n), S("disturbance_now"))]

    def advance(self) -> list[Statement]:
        """Time update of everything; ``response`` is the held filter's prediction without the bias."""
        lines: list[Statement] = []
        for which in ("held", "plain", *KINDS, *(f"miss_{k}" for k in KINDS)):
            lines += [
                Assign(x, S(x) * S(f"ratio_{n}"))
                for x, n in zip(self.of(which), self.layout.fast, strict=True)
            ]
        unit = self.layout.inverted(1 / self.layout.reduction.groups.scale[self.layout.input.name])
        lines += [
            Assign("u_plain", (S("steer") + S("input_offset_held")) * unit, "the steer alone [-]"),
            Assign("u_held", S("u_plain") + S(f"{DISTURBANCE}_held") * unit),
        ]
        lines += self._held(unit)
        for k in KINDS:
            lines += self._other(k, unit)
        lines.append(Assign("lean", sp.Min(1, S("dt") * S("companion_rate"))))
        for which in ("plain", *KINDS):
            lines += [
                Assign(x, S(x) + S("lean") * (S(y) - S(x)))
                for x, y in zip(self.of(which), self.of("held"), strict=True)
            ]
        return lines

    def _held(self, unit: sp.Expr) -> list[Statement]:
        P, n = self.covariance, len(self.layout.fast)
        held, plain = self.of("held"), self.of("plain")
        step = implicit_step(
            self._rates("held", S(f"{self.layout.target}_held")),
            [S(x) for x in held],
            parameters={"u_held": unit},
            companion={S(a): S(b) for a, b in zip((*held, "u_held"), (*plain, "u_plain"), strict=True)},
            ramp=("u_held", S("steer_change")),
        )
        k = range(n)
        F = [[step.by_state[i, j] * S(f"ratio_{self.layout.fast[j]}") for j in k] for i in k]
        to_u = step.by_parameter["u_held"]
        lines: list[Statement] = list(step.statements)
        lines += predict(
            P,
            {i: {j: F[i][j] for j in k} for i in k},
            Shared({n: sp.Integer(1)}, {i: to_u[i] for i in k}),
            decay={n: S("keep_w")},
            noise={n: S("disturbance_now") * (1 - S("keep_w") ** 2)},
        )
        lines += [Assign(x, step.after[i]) for i, x in enumerate(held)]
        lines += [Assign(x, step.companion_after[i]) for i, x in enumerate(plain)]
        lines.append(Assign(f"{DISTURBANCE}_held", S("keep_w") * S(f"{DISTURBANCE}_held")))
        for kind, miss in self.missing.items():
            new = [S(f"new{i}_{kind}") for i in k]
            lines += [
                Assign(
                    new[i].name,
                    sp.Add(*(step.by_state[i, j] * S(miss[j]) for j in k), to_u[i] * S(miss[n])),
                )
                for i in k
            ]
            lines += [Assign(miss[i], new[i]) for i in k]
            lines.append(Assign(miss[n], S("keep_w") * S(miss[n])))
        return lines

    def _other(self, kind: str, unit: sp.Expr) -> list[Statement]:
        names = self.of(kind)
        step = implicit_step(
            self._rates(kind, S(f"{self.layout.target}_{kind}"), "u_plain"),
            [S(x) for x in names],
            parameters={"u_plain": unit},
            ramp=("u_plain", S("steer_change")),
        )
        lines: list[Statement] = list(step.statements)
        lines += [Assign(x, step.after[i]) for i, x in enumerate(names)]
        return _own(lines, kind, keep=set(names))

    def measure(self) -> list[Statement]:
        """Innovation of the held filter, its variance, and the two signatures."""
        H = self._gradient()
        lines: list[Statement] = list(column(self.covariance, H, "c"))
        lines += [
            Assign("innovation", S("measured") - S("output_bias_held") - self._output("held")),
            Assign("spread", sp.Add(*(e * S(f"c_{i}") for i, e in H.items())) + S("noise_now")),
            Assign("inv_spread", 1 / S("spread")),
        ]
        for kind, miss in self.missing.items():
            seen = sp.Add(*(e * S(miss[i]) for i, e in H.items()))
            lines.append(
                Assign(f"signature_{kind}", self._output(kind) - self._output("plain") - seen,
                       f"what would be missed after a {kind}")
            )  # fmt: skip
        return lines

    def correct(self) -> list[Statement]:
        """Update by the innovation; the errors after a change by their signatures."""
        P, n = self.covariance, len(self.layout.fast)
        names = (*self.of("held"), f"{DISTURBANCE}_held")
        lines: list[Statement] = [
            Assign(f"gain_{i}", S(f"c_{i}") * S("inv_spread") * S("weight")) for i in range(n + 1)
        ]
        lines += reduce_by(P, {i: S(f"gain_{i}") for i in range(n + 1)}, dict.fromkeys(range(n + 1), 0), "c")
        lines += [Assign(x, S(x) + S(f"gain_{i}") * S("innovation")) for i, x in enumerate(names)]
        for kind, miss in self.missing.items():
            lines += [Assign(x, S(x) + S(f"gain_{i}") * S(f"signature_{kind}")) for i, x in enumerate(miss)]
        return lines

    def _rates(self, which: str, target: sp.Symbol, u: str | None = None) -> list[sp.Expr]:
        model = self.layout.reduction.groups.model
        replace = self._unknowns(target) | self._states(which)
        replace[self.layout.input.symbol] = S(u or f"u_{which}")
        rates = self.layout.reduction.rates
        return [self.layout.inverted(rates[q.name]).xreplace(replace) for q in model.states]

    def _output(self, which: str) -> sp.Expr:
        """The output without its bias."""
        target = S(f"{self.layout.target}_{which if which in KINDS else 'held'}")
        output = self.layout.inverted(self.layout.reduction.output_map[self.layout.output.name])
        return S("output_scale") * output.xreplace(self._states(which) | self._unknowns(target))

    def _gradient(self) -> dict[int, sp.Expr]:
        slopes = {i: self._output("held").diff(S(x)) for i, x in enumerate(self.of("held"))}
        return {i: slope for i, slope in slopes.items() if slope != 0}

    def _states(self, which: str) -> dict[sp.Symbol, sp.Expr]:
        states = self.layout.reduction.groups.model.states
        return {q.symbol: S(x) for q, x in zip(states, self.of(which), strict=True)}

    def _unknowns(self, target: sp.Symbol) -> dict[sp.Symbol, sp.Expr]:
        first, *others = self.layout.reduction.unknowns
        return {first.symbol: target, **{u.symbol: S(f"{u.name}_held") for u in others}}


def _own(body: Iterable[Statement], name: str, *, keep: set[str]) -> list[Statement]:
    """The statements with every working value called ``<value>_<name>``."""
    lines = [s for s in body if isinstance(s, Assign)]
    working = {s.target for s in lines} - keep
    swap: Mapping[sp.Basic, sp.Basic] = {S(x): S(f"{x}_{name}") for x in working}
    return [
        Assign(
            f"{s.target}_{name}" if s.target in working else s.target, s.expression.xreplace(swap), s.comment
        )
        for s in lines
    ]
