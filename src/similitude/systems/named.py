"""Systems by name, or from a Python file: the model, its base, and what tables call its parameters.

Invariant: a file is run as the user's own program, and only because the user named it.
"""

from __future__ import annotations

import runpy
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from similitude.errors import ModelError, UsageError, shown
from similitude.groups import Groups, reparameterize
from similitude.model import Model

READ = 'docs/populations.md, "The command"'
# What tables of vehicles call the parameters of the bicycle; a name that a table lacks is passed over.
VEHICLE_COLUMNS = {
    "Iz": "Izz",
    "a*b": "ab",
    "L": "wheelbase",
    "m": "mass",
    "a/L": "center_to_front_ratio",
}


@dataclass(frozen=True)
class NamedSystem:
    """A model with its base, and product of parameters -> usual column name."""

    groups: Groups
    columns: Mapping[str, str] = field(default_factory=dict)


def named_system(name: str, *, base: Sequence[str] | None = None) -> NamedSystem:
    """Find a system.

    Parameters
    ----------
    name : "bicycle", "saturating_bicycle", or the path of a Python file that holds one `Model` or `Groups`.
    base : repeating variables; the system's own where left out.

    Returns
    -------
    NamedSystem

    Raises
    ------
    UsageError    there is no such system, the file holds no model, or a base is missing.
    """
    if name == "bicycle":
        from similitude.systems.bicycle import BICYCLE

        return NamedSystem(reparameterize(BICYCLE, base=tuple(base or ("m", "L", "U"))), VEHICLE_COLUMNS)
    if name == "saturating_bicycle":
        from similitude.systems.saturating_bicycle import SATURATING_BICYCLE as MODEL

        return NamedSystem(reparameterize(MODEL, base=tuple(base or ("m", "L", "U"))), VEHICLE_COLUMNS)
    if Path(name).suffix == ".py" and Path(name).is_file():
        return NamedSystem(_of_file(Path(name), base))
    raise UsageError(
        f"system {shown(name)} is not known; there are bicycle and saturating_bicycle, or a file "
        "such as crane.py",
        usually="the name was misspelt, or the file lies in another folder.",
        paste="--system bicycle",
        read=READ,
    )


def _of_file(path: Path, base: Sequence[str] | None) -> Groups:
    try:
        names = runpy.run_path(str(path))
    except ModelError:
        raise
    except Exception as error:  # whatever the user's program does wrong
        raise UsageError(
            f"{path.name} cannot be run: {type(error).__name__}: {error}"[:300],
            usually="the file has a mistake of its own; run it by itself to see where.",
            paste=f"python {path}",
            read=READ,
        ) from error
    groups = [one for one in names.values() if isinstance(one, Groups)]
    models = [one for one in names.values() if isinstance(one, Model)]
    if groups and not base:
        return groups[-1]
    if not models and not groups:
        raise UsageError(
            f"{path.name} holds no model",
            usually="the model was made inside a function; give it a name at the top level of the file.",
            paste="crane = Model(name='crane', ...)",
            read=READ,
        )
    model = models[-1] if models else groups[-1].model
    base = base or names.get("BASE") or names.get("base")
    if not base:
        raise UsageError(
            f"{path.name} says no base for model {model.name!r} "
            f"(parameters: {', '.join(q.name for q in model.parameters)})",
            usually="one parameter for each of mass, length and time is wanted.",
            paste=f"--base {','.join(q.name for q in model.parameters[:3])}",
            read=READ,
        )
    return reparameterize(model, base=tuple(base))
