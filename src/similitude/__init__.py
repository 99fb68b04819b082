"""Identify physical systems with the fewest unknowns physics allows.

Importing this package loads nothing else; a name is fetched from its file when it is first used.
"""

import importlib

# public name -> file that holds it
_ROOMS = {
    "Log": "log",
    "Run": "run",
    "SimilitudeError": "errors",
    "Vehicle": "vehicle_file",
    "bicycle_response": "simulate",
    "identify": "identification",
    "read_log": "log",
    "read_population": "populations.population",
    "reduce": "directions",
    "relate": "populations.relations",
    "read_scenario": "simulation.scenario",
    "read_vehicle": "vehicle_file",
    "run_scenario": "simulation.recording",
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
