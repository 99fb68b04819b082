"""The exported C is the generator's, with the contract around it."""

import re
import subprocess

import numpy as np
import pytest

from similitude.embedded.source import cut, print_sources
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.targets import CONTRACT_OFF
from similitude.errors import ProgramError

NAMES = [(system, estimator) for system, all_of in SHIPPED.items() for estimator in all_of]


def sources(system, estimator, real="float"):
    found = find_source(system, estimator)
    states = len(found.library().names("state"))
    status = found.library().layout.STATUS
    return found, print_sources(found.c, found.name, real=real, states=states, status=status, version="0")


@pytest.mark.parametrize(("system", "estimator"), NAMES)
def test_init_and_step_are_the_bytes_of_the_committed_c(system, estimator):
    found, printed = sources(system, estimator)
    parts = cut(found.c, found.name)

    assert parts.text == found.c
    assert parts.bodies in printed.source
    assert parts.declarations in printed.header
    assert "_batch" not in printed.source


@pytest.mark.parametrize(("system", "estimator"), NAMES)
def test_no_literal_depends_on_how_a_compiler_rounds_it(system, estimator):
    """(float)0.1 may be rounded once or, through double, twice: no literal tells the two apart."""
    from fractions import Fraction

    found, _ = sources(system, estimator)
    for text in set(re.findall(r"R\(([^()]+)\)", found.c)) - {"x"}:
        exact, twice = Fraction(text), np.float32(float(text))
        others = (np.nextafter(twice, np.float32(-np.inf)), np.nextafter(twice, np.float32(np.inf)))
        error = abs(Fraction(float(twice)) - exact)
        assert all(error < abs(Fraction(float(other)) - exact) for other in others), text


def test_another_real_is_another_version_of_the_saved_state():
    words = [
        re.search(r"0x([0-9A-F]{8})UL\); /\* of", sources("bicycle", "paper", r)[1].source)
        for r in ("float", "double")
    ]

    assert words[0].group(1) != words[1].group(1)


@pytest.mark.parametrize(
    ("flags", "complaint"),
    [
        (["-ffast-math", f"-D{CONTRACT_OFF}"], "ffast-math"),
        (["-D__FP_FAST_FMAF=1"], "fuses multiply and add"),
        (["-D__FP_FAST_FMAF=1", f"-D{CONTRACT_OFF}"], ""),
    ],
)
def test_a_build_that_could_change_bits_is_refused(tmp_path, flags, complaint):
    _, printed = sources("bicycle", "paper")
    (tmp_path / "bicycle_paper.h").write_text(printed.header)
    (tmp_path / "bicycle_paper.c").write_text(printed.source)
    command = ["cc", "-std=c99", "-O1", *flags, "-fsyntax-only", "bicycle_paper.c"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)

    assert (done.returncode != 0) == bool(complaint)
    assert complaint in done.stderr


def test_a_text_without_the_generators_marks_is_refused():
    with pytest.raises(ProgramError, match="no longer the four parts"):
        cut("int main(void);", "bicycle_paper")
