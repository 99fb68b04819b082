"""Is the stiffness of the vehicle file that of an axle, or that of one tyre?

Invariant: only said; neither the vehicle nor the estimate is changed.

    Caf cornering stiffness of the front axle, both tyres together [N/rad]
"""

from __future__ import annotations

from similitude.run import Estimate
from similitude.vehicle_file import Vehicle

# Road, tyre and load move a stiffness by a third; the estimate must be sharper than that to tell, and
# nearer to two than to one on the scale of logarithms.
SHARP = 0.15  # sd of ln K
TWO = (1.6, 2.6)


def stiffness_doubts(vehicle: Vehicle, K: Estimate) -> tuple[str, ...]:
    """Compare the estimate with the Caf of the vehicle file.

    Parameters
    ----------
    vehicle : Vehicle   with Caf [N/rad], m [kg] and L [m], else nothing is said
    K : Estimate        Caf L/m at the end of the log [m^2/s^2]

    Returns
    -------
    tuple of str        a warning where the two differ by two: a file per tyre, or twice per axle
    """
    if vehicle.Caf is None or vehicle.m is None or vehicle.L is None or K.std > SHARP * K.value:
        return ()
    stated = vehicle.Caf.value * vehicle.L.value / vehicle.m.value
    ratio = K.value / stated
    if not TWO[0] <= max(ratio, 1 / ratio) <= TWO[1]:
        return ()
    cause = "of one tyre" if ratio > 1 else "of both axles, or counted twice"
    return (
        f"the estimate of Caf is {ratio:.2g} times that of the vehicle file ({vehicle.Caf.value:.4g} N/rad): "
        f"usually the file states that {cause}; Caf is that of the front axle, both tyres together",
    )
