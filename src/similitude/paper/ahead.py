"""The long runs of the reproduction, each once, several at a time in processes of their own.

Invariant: a run is the same wherever it was computed; a machine that allows no processes computes them here.
"""

from __future__ import annotations

import functools
import importlib
import multiprocessing
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import Any, TypeVar

Found = TypeVar("Found")
WORKERS = 2
_KEPT: dict[str, Any] = {}


def kept(function: Callable[[], Found]) -> Callable[[], Found]:
    """Decorate a function without arguments: it is called once, here or ahead."""
    name = f"{function.__module__}.{function.__name__}"

    @functools.wraps(function)
    def once() -> Found:
        if name not in _KEPT:
            _KEPT[name] = function()
        return _KEPT[name]

    return once


def compute_ahead(functions: Sequence[Callable[[], Any]], *, workers: int = WORKERS) -> None:
    """Call `kept` functions in other processes and keep what they return.

    Parameters
    ----------
    functions : the longest first. workers : processes at a time.
    """
    names = [f"{function.__module__}.{function.__name__}" for function in functions]
    waiting = [name for name in names if name not in _KEPT]
    if not waiting:
        return
    try:
        context = multiprocessing.get_context("spawn")  # a fork would copy threads of compiled libraries
        with ProcessPoolExecutor(min(workers, len(waiting)), mp_context=context) as pool:
            for name, found in zip(waiting, pool.map(_call, waiting), strict=True):
                _KEPT[name] = found
    except (OSError, BrokenProcessPool):  # no processes here: each is computed where it is needed
        return


def _call(name: str) -> Any:
    module, _, function = name.rpartition(".")
    return getattr(importlib.import_module(module), function)()
