"""Identify physical systems with the fewest unknowns physics allows.

Importing this package loads nothing else; a name is fetched from its file when it is first used.
"""

import importlib

# public name -> file that holds it
_ROOMS = {
    "Estimate": "any_model.estimate",
    "Estimator": "any_model.estimator",
    "Log": "log",
    "Model": "model",
    "Quantity": "model",
    "Run": "run",
    "SimilitudeError": "errors",
    "System": "systems.system",
    "Vehicle": "vehicle_file",
    "advise_base": "dimensional.base_advice",
    "analyze_model": "analysis.analysis",
    "bicycle_response": "simulate",
    "check_system": "systems.check",
    "euler_rows": "invariance.invariances",
    "from_control": "linear.control",
    "identifiable": "symmetry.identifiability",
    "identify": "identification",
    "into_groups": "rewriting.scaling",
    "invariances": "invariance.invariances",
    "make_estimator": "any_model.estimator",
    "mismatches_of": "model",
    "out_of_groups": "rewriting.scaling",
    "pi_groups": "dimensional.pi_groups",
    "prove_equivalence": "rewriting.equivalence",
    "read_log": "log",
    "read_population": "populations.population",
    "reduce": "directions",
    "rehearse": "any_model.rehearsal",
    "relate": "populations.relations",
    "read_scenario": "simulation.scenario",
    "read_vehicle": "vehicle_file",
    "reparameterize": "groups",
    "rewrite": "rewriting.rewritten",
    "run_scenario": "simulation.recording",
    "scaling_symmetries": "symmetry.scalings",
    "shipped_system": "systems.shipped",
    "state_space_model": "linear.construction",
    "to_control": "linear.control",
    "trajectory": "invariance.trajectory",
    "transfer_function": "linear.matrices",
    "transfer_function_model": "linear.construction",
}

__all__ = sorted(_ROOMS)


def __getattr__(name: str):
    if name not in _ROOMS:
        raise AttributeError(f"module 'similitude' has no attribute {name!r}")
    value = getattr(importlib.import_module(f"similitude.{_ROOMS[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_ROOMS})
