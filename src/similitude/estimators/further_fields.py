"""Fields of a population filter for outputs measured besides the first.

measured = model's output + bias        noise of each sample alike for ``time``, a share of the output in it
"""

from __future__ import annotations

from similitude.model import Quantity
from similitude.program.ir import Field


def further_config(q: Quantity) -> tuple[Field, ...]:
    """What the filter is told once of a further output."""
    n, unit = q.name, q.unit
    return (
        Field(f"{n}_bias_sd", unit, f"prior sd of the bias of {n}"),
        Field(f"{n}_bias_drift", f"({unit})^2/s", f"random walk of the bias of {n}"),
        Field(f"{n}_variance", f"({unit})^2", f"white noise of {n} a sample"),
        Field(f"{n}_share", "-", f"structural error of {n} as a share of it"),
        Field(f"{n}_time", "s", f"correlation time of what {n} holds besides the model"),
        Field(f"{n}_noise_scale_low", "-", f"least noise variance of {n} against nominal"),
        Field(f"{n}_noise_scale_high", "-", f"greatest noise variance of {n} against nominal"),
        Field(f"{n}_limit", unit, f"greatest believable {n}"),
    )


def further_state(q: Quantity, *, coordinates: int = 0) -> tuple[Field, ...]:
    """What the filter remembers of a further output; a small one its covariance with all coordinates, too."""
    n, unit = q.name, q.unit
    small = (
        Field(f"{n}_with", unit, f"covariance of {n} with the coordinates", coordinates),
        Field(f"{n}_spread", f"({unit})^2", f"variance of {n} predicted"),
        Field(f"last_{n}", unit, f"{n} of the sample before"),
    )
    return (
        *(small if coordinates else ()),
        Field(f"{n}_bias", unit, f"bias of {n}"),
        Field(f"{n}_activity", f"({unit})^2", f"mean square of {n} predicted"),
        Field(f"{n}_noise_scale", "-", f"noise variance of {n} against nominal"),
    )


def further_sample(q: Quantity) -> Field:
    """The measurement itself; a NaN where there is none."""
    return Field(f"{q.name}_measured", q.unit, f"measured {q.meaning}")


def further_variables(q: Quantity, *, lean: bool) -> tuple[Field, ...]:
    """Working values that outlive a guard."""
    n, unit = q.name, q.unit
    spread = Field(f"{n}_inv_spread", f"1/({unit})^2", f"1/variance the innovation of {n} counts with")
    if not lean:
        return (spread,)
    return (
        spread,
        Field(
            f"{n}_innovation", unit, f"measured minus predicted {n} that the first output does not explain"
        ),
        Field(f"{n}_after", f"1/({unit})", f"what the first output has said of {n}"),
        Field(f"{n}_odd", "-", f"by how much {n} is not as expected"),
    )
