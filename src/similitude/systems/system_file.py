"""Find the model that a command line means: a shipped system, or the Model that a Python file makes.

Invariant: a file is run once, under its own folder, and one Model is found in it by its type; none and
several are errors that say what there is.
"""

from __future__ import annotations

import difflib
import importlib.util
import sys
import traceback
from dataclasses import dataclass
from pathlib import Path

from similitude.errors import ModelError, SimilitudeError, UsageError
from similitude.model import Model
from similitude.systems.shipped import SHIPPED, shipped_system
from similitude.systems.system import System

READ = 'docs/analyze.md, "A model of your own"'
ONE_MODEL = "LAG = Model(name='lag', states=..., rates={'x': '(u - x)/T'}, ...)"


@dataclass(frozen=True)
class FoundModel:
    """A model, the base its author chose for it if any, and the author's words for groups."""

    model: Model
    base: tuple[str, ...] | None = None
    meanings: dict[str, str] | None = None


def find_model(text: str) -> FoundModel:
    """The model that an argument of the command line names.

    Parameters
    ----------
    text : a shipped system's name, ``FILE.py``, or ``FILE.py:NAME`` where a file makes several.

    Raises
    ------
    UsageError    no shipped system and no file has the name.
    ModelError    the file fails, or does not make exactly one Model.
    """
    if text in SHIPPED:
        return _of(shipped_system(text))
    file, _, name = text.rpartition(":") if ".py:" in text else (text, "", "")
    path = Path(file)
    if path.suffix != ".py" or not path.is_file():
        raise _nothing(text, path)
    found = _models(_run(path))
    if name:
        if name not in found:
            raise ModelError(
                f"{file} makes no Model called {name!r} (it makes {', '.join(found) or 'none'})",
                usually="the name was misspelt; it is that of the variable, not the model's own.",
                paste=f"similitude analyze {file}:{next(iter(found), 'MODEL')}",
                read=READ,
            )
        return _of(found[name])
    distinct = {id(_of(one).model): variable for variable, one in reversed(found.items())}
    if len(distinct) != 1:
        raise _not_one(file, sorted(distinct.values()))
    systems = [one for one in found.values() if isinstance(one, System)]
    return _of(systems[0] if systems else next(iter(found.values())))


def _of(found: Model | System) -> FoundModel:
    if isinstance(found, System):
        return FoundModel(found.model, found.base, dict(found.meanings))
    return FoundModel(found)


def _models(namespace: dict[str, object]) -> dict[str, Model | System]:
    return {name: value for name, value in namespace.items() if isinstance(value, Model | System)}


def _run(path: Path) -> dict[str, object]:
    """What a file defines, run as a module of its own with its folder on the path."""
    spec = importlib.util.spec_from_file_location(f"_analyzed_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(path.parent.resolve()))
    sys.modules[spec.name] = module  # dataclasses and pickles look there
    try:
        spec.loader.exec_module(module)
    except SimilitudeError:
        raise  # it says already what is wrong with the model
    except (Exception, SystemExit) as error:
        raise _fails(path, error) from error
    finally:
        sys.path.remove(str(path.parent.resolve()))
        sys.modules.pop(spec.name, None)
    return dict(vars(module))


def _fails(path: Path, error: BaseException) -> ModelError:
    lines = [
        frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)
    ]
    line = error.lineno if isinstance(error, SyntaxError) else lines[-1] if lines else None
    where = f", line {line}" if line else ""
    said = (str(error) or "no further words").splitlines()[0]
    return ModelError(
        f"{path}{where}: {type(error).__name__}: {said}",
        usually="the file does not run by itself either: a name or an import is missing.",
        paste=f"python {path}",
        read=READ,
    )


def _not_one(file: str, names: list[str]) -> ModelError:
    if not names:
        return ModelError(
            f"{file} makes no Model",
            usually="the model is made inside a function, or only its parts are in the file.",
            paste=ONE_MODEL,
            read=READ,
        )
    return ModelError(
        f"{file} makes {len(names)} Models: {', '.join(names)}",
        usually="a model was made from another, or imported; say which is meant.",
        paste=f"similitude analyze {file}:{names[0]}",
        read=READ,
    )


def _nothing(text: str, path: Path) -> UsageError:
    near = difflib.get_close_matches(text, SHIPPED, n=1, cutoff=0.4) or SHIPPED[:1]
    if path.suffix == ".py":
        what = f"there is no file '{text}' (looked in {Path.cwd()})"
    elif path.exists():
        what = f"'{text}' is no Python file"
    else:
        what = f"there is no shipped system '{text}' (there are {', '.join(SHIPPED)})"
    return UsageError(
        what,
        usually="the name was misspelt; a model of your own is a file that ends in .py.",
        paste=f"similitude analyze {near[0]}",
        read=READ,
    )
