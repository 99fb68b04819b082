"""One derivative for one car in floats and for many in arrays: the functions that differ.

A plant is written once with the operators of Python and these functions. One car runs in plain
floats, which is ten times faster than arrays of one; many cars run as arrays, one entry a car.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Arithmetic:
    """Functions on floats, or on arrays entry by entry.

    Parameters
    ----------
    sqrt, sin, cos, atan, sign : of one value
    minimum, maximum : of two values
    where : (condition, value if so, value if not)
    any : whether a condition holds for some car
    """

    sqrt: Callable[[Any], Any]
    sin: Callable[[Any], Any]
    cos: Callable[[Any], Any]
    atan: Callable[[Any], Any]
    sign: Callable[[Any], Any]
    minimum: Callable[[Any, Any], Any]
    maximum: Callable[[Any, Any], Any]
    where: Callable[[Any, Any, Any], Any]
    any: Callable[[Any], bool]


FLOATS = Arithmetic(
    math.sqrt,
    math.sin,
    math.cos,
    math.atan,
    lambda x: math.copysign(1.0, x) if x else 0.0,
    lambda x, y: x if x < y else y,
    lambda x, y: x if x > y else y,
    lambda so, x, y: x if so else y,
    bool,
)
ARRAYS = Arithmetic(
    np.sqrt, np.sin, np.cos, np.arctan, np.sign, np.minimum, np.maximum, np.where, lambda x: bool(np.any(x))
)


def arithmetic_for(*values: Any) -> Arithmetic:
    """Return FLOATS where every value is one number, else ARRAYS."""
    return ARRAYS if any(np.ndim(value) for value in values) else FLOATS
