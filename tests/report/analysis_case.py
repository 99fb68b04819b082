"""The analyses that the tests of their pages share, made once."""

from functools import cache

from similitude.analysis.analysis import Analysis, analyze_model
from similitude.model import Model, Quantity
from similitude.systems.shipped import shipped_system

NASTY = "<b>&\"'"


@cache
def analysed(name: str) -> Analysis:
    """A shipped system looked over with its own base."""
    system = shipped_system(name)
    return analyze_model(
        system.model, base=system.base, base_origin="the system's own", meanings=system.meanings
    )


@cache
def decay() -> Analysis:
    """A model without a base of parameters, with words that are no markup."""
    return analyze_model(
        Model(
            name="decay",
            states=(Quantity("x", "m", NASTY),),
            inputs=(),
            outputs=(Quantity("x", "m"),),
            parameters=(Quantity("a", "1/s", NASTY), Quantity("b", "1/s")),
            rates={"x": "-(a + b)*x"},
            output_map={"x": "x"},
            source=NASTY,
        )
    )
