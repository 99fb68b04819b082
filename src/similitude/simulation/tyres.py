"""Lateral force of an axle or a tyre against its slip angle: linear, cubic onset, brush.

Invariant: all three have the slope C at no slip, and none but the linear one exceeds its limit.

    C    cornering stiffness [N/rad]      alpha  slip angle [rad], positive gives positive force
    F_m  largest lateral force [N]
"""

from __future__ import annotations

from typing import Any

from similitude.simulation.arithmetic import Arithmetic

TYRES = ("linear", "cubic", "brush")


def lateral_force(tyre: str, C: Any, alpha: Any, F_m: Any, on: Arithmetic) -> Any:
    """Return the force of a tyre [N].

    Math: linear C α;  cubic onset C α/√(1 + (C α/F_m)²);  brush, with z = C |α|/(3 F_m):
    F_m (3 z − 3 z² + z³) up to z = 1, F_m beyond.

    Parameters
    ----------
    tyre : str            "linear", "cubic" or "brush"
    C, alpha, F_m : float or (cars,)   stiffness [N/rad], slip angle [rad], limit [N]
    on : Arithmetic

    References
    ----------
    Cubic onset: docs/filter.md. Brush: Fiala 1954, as in H. Pacejka, Tire and Vehicle Dynamics,
    section 3.2, with α for tan α.
    """
    wanted = C * alpha
    if tyre == "linear":
        return wanted
    if tyre == "cubic":
        share = wanted / F_m
        return wanted / on.sqrt(1.0 + share * share)
    z = on.minimum(abs(wanted) / (3.0 * F_m), 1.0)
    return on.sign(wanted) * F_m * z * (3.0 - 3.0 * z + z * z)
