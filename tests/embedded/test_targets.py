"""Targets and what they can hold."""

import pytest

from similitude.embedded.targets import TARGETS, flags_of, target_named
from similitude.errors import UsageError


@pytest.mark.parametrize(
    ("name", "real", "said"),
    [
        ("stm32f4", "float", "is not known"),
        ("avr", "double", "four bytes"),
        ("cortex-m0", "int32", "is not exported"),
    ],
)
def test_what_a_target_cannot_be_or_hold_is_said(name, real, said):
    with pytest.raises(UsageError, match=said) as caught:
        target_named(name, real=real)
    assert caught.value.paste.startswith("--")


@pytest.mark.parametrize("target", TARGETS.values(), ids=TARGETS)
def test_no_target_may_fuse_or_reorder(target):
    assert "-ffp-contract=off" in flags_of(target)
    assert not {"-ffast-math", "-Ofast"} & set(flags_of(target))
