"""A step program ready to run: its layout, and its C (or, without a compiler, its scalar twin).

Invariant: a struct is a float64 array in the order of the layout, so a state can be copied,
saved and restored as an array; the twin and the C do the same operations on it.
"""

from __future__ import annotations

import ctypes
import importlib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from similitude.errors import CompileError, ProgramError
from similitude.program.compile import load_library

GENERATED = "similitude.generated"


@dataclass(frozen=True, eq=False)
class Library:
    """An estimator's compiled step.

    ``layout`` is the twin module; ``c`` the loaded library, None where there is no compiler.
    ``why_slow`` says in one line why the twin is used, empty otherwise.
    """

    name: str
    layout: ModuleType
    c: ctypes.CDLL | None
    why_slow: str = ""

    def names(self, struct: str) -> list[str]:
        """Names of the reals of ``config``, ``state``, ``sample`` or ``output``, in order."""
        rows = getattr(self.layout, struct.upper())
        return [name if size == 1 else f"{name}_{i}" for name, _, _, size in rows for i in range(size)]

    def index(self, struct: str, name: str) -> int:
        """Place of a real (or of an array's first) in a struct."""
        at = 0
        for field, _, _, size in getattr(self.layout, struct.upper()):
            if field == name:
                return at
            at += size
        raise ProgramError(
            f"{self.name} has no {struct} field {name!r}",
            usually="The name was misspelt, or belongs to another estimator.",
            paste=f"library.names({struct!r})",
            read='docs/architecture.md, "Step programs"',
        )

    def config(self, values: Mapping[str, ArrayLike]) -> NDArray[np.float64]:
        """The flat configuration from named values in the units of the layout.

        Raises
        ------
        ProgramError    a value is missing, is not a field, or has the wrong size.
        """
        flat: list[float] = []
        for name, unit, meaning, size in self.layout.CONFIG:
            value = np.asarray(values.get(name, np.nan), dtype=float).ravel().tolist()
            if len(value) != size or not all(map(math.isfinite, value)):
                raise ProgramError(
                    f"{self.name}: configuration {name!r} [{unit}], {meaning}, needs {size} finite "
                    f"value(s), got {values.get(name)!r}",
                    usually="A design constant or a prior was left out.",
                    paste=f"values[{name!r}] = ...",
                    read='docs/architecture.md, "Step programs"',
                )
            flat += value
        unknown = sorted(set(values) - {row[0] for row in self.layout.CONFIG})
        if unknown:
            raise ProgramError(
                f"{self.name} has no configuration {', '.join(unknown)}",
                usually="The name was misspelt, or belongs to another estimator.",
                paste="library.names('config')",
                read='docs/architecture.md, "Step programs"',
            )
        return np.array(flat)

    def start(self, config: NDArray[np.float64]) -> NDArray[np.float64]:
        """The flat state before the first sample."""
        if self.c is None:
            return np.array(self.layout.init(config.tolist()))
        state = np.zeros(self._sizes["state"])
        getattr(self.c, f"{self.name}_init")(_pointer(config), _pointer(state))
        return state

    def run(
        self, config: NDArray[np.float64], state: NDArray[np.float64], samples: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Step over samples; the state is changed in place.

        Parameters
        ----------
        config, state : flat structs.
        samples : (n, sample fields) in the units of the layout.

        Returns
        -------
        outputs, status : (n, output fields) and (n,).

        Raises
        ------
        ProgramError    an array has not the size of its struct, or is not contiguous float64.
        """
        samples = np.ascontiguousarray(samples, dtype=np.float64)
        self._check(config=config, state=state, sample=samples)
        n = len(samples)
        outputs = np.empty((n, len(self.layout.OUTPUT)))
        status = np.empty(n, dtype=np.int32)
        if self.c is None:
            flat, settings = state.tolist(), config.tolist()
            for i, row in enumerate(samples.tolist()):
                status[i], outputs[i] = self.layout.step(settings, flat, row)
            state[:] = flat
            return outputs, status
        getattr(self.c, f"{self.name}_batch")(
            _pointer(config), _pointer(state), n, _pointer(samples), _pointer(outputs), _pointer(status)
        )
        return outputs, status

    def _check(self, **structs: NDArray[np.float64]) -> None:
        """Refuse arrays the C would read or write beyond their end."""
        for struct, array in structs.items():
            size = self._sizes[struct]
            plain = array.dtype == np.float64 and array.flags.c_contiguous
            if not plain or array.shape[array.ndim - 1 :] != (size,):
                raise ProgramError(
                    f"{self.name}: {struct} has shape {array.shape} and type {array.dtype}; "
                    f"contiguous float64 with {size} reals is needed",
                    usually="An array of another estimator, or a slice of a larger one, was given.",
                    paste=f"library.names({struct!r})",
                    read='docs/architecture.md, "Step programs"',
                )

    @cached_property
    def _sizes(self) -> dict[str, int]:
        structs = ("config", "state", "sample")
        return {struct: len(self.names(struct)) for struct in structs}


def _pointer(array: NDArray) -> int:
    return array.ctypes.data  # an address; the caller's own name keeps the array alive


def assemble(layout: ModuleType, source: str) -> Library:
    """Compile C source and bind it to its layout; fall back to the twin without a compiler."""
    name = layout.NAME
    try:
        c = load_library(source, name=name)
    except CompileError as error:
        reason = error.what.splitlines()[0]
        return Library(name, layout, None, f"about a hundred times slower: {reason}")
    init = getattr(c, f"{name}_init")
    init.argtypes, init.restype = [ctypes.c_void_p] * 2, None
    batch = getattr(c, f"{name}_batch")
    batch.argtypes = [ctypes.c_void_p] * 2 + [ctypes.c_long] + [ctypes.c_void_p] * 3
    batch.restype = ctypes.c_long
    return Library(name, layout, c)


@lru_cache
def shipped(name: str) -> Library:
    """A shipped estimator, such as ``bicycle_population``, compiled on first use."""
    layout = importlib.import_module(f"{GENERATED}.{name}")
    source = Path(layout.__file__).with_suffix(".c").read_text(encoding="utf-8")
    return assemble(layout, source)
