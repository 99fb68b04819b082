"""A shipped system run with its inputs held, some values changed: columns by name."""

from dataclasses import replace

from similitude.systems.system import System
from similitude.systems.two_forms import simulate_two_forms


def held_run(system: System, *, duration: str | None = None, **changed: str) -> dict:
    """t [s] and every state and output [SI]; ``changed`` are parameters, inputs or states at the start."""
    parts = {}
    for part in ("values", "inputs", "start"):
        known = {
            "values": system.model.parameters,
            "inputs": system.model.inputs,
            "start": system.model.states,
        }[part]
        own = {q.name: changed[q.name] for q in known if q.name in changed}
        parts[part] = {**getattr(system, part), **own}
    system = replace(system, duration=duration or system.duration, **parts)
    both = simulate_two_forms(
        system.groups(),
        values=system.numbers(),
        inputs=system.held_inputs(),
        start=system.starting_states(),
        duration=system.span,
    )
    return {"t": both.t, **dict(zip(both.names, both.dimensional.T, strict=True))}
