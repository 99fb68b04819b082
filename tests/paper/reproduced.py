"""A small reproduction: the cheap subjects, and pictures of one pixel in place of the figures."""

from similitude.paper.claims_controller import controller_claims
from similitude.paper.equations import EQUATIONS
from similitude.paper.pictures import PICTURES
from similitude.paper.reproduction import Reproduction

PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010806000000"
    "1f15c4890000000d49444154789c6360606060000000050001a5f645400000000049454e44ae426082"
)


def small():
    """A Reproduction of the controller alone."""
    residuals = [(equation, 0.0) for equation in EQUATIONS]
    return Reproduction(
        {"The controller": controller_claims()}, residuals, {p.file: PIXEL for p in PICTURES.values()}
    )
