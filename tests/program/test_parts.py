"""Parts of a step: the same bits with and without, and only what can stand on its own."""

import ctypes
import re
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from similitude.errors import ProgramError
from similitude.estimators.small_population import small_population_filter
from similitude.program.c import print_c
from similitude.program.compile import load_library
from similitude.program.ir import Assign, Field, When, walk
from similitude.program.parts import as_part, parts_of, runs
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction

from .tiny import tiny_program

SIZE = 5  # of the state


def S(name):
    return sp.Symbol(name, real=True)


def random_program(seed, marked):
    """Random statements on an array, a good part of them in parts where ``marked``."""
    rng = np.random.default_rng(seed)
    known = ["rate", "x", *(f"v_{i}" for i in range(SIZE))]
    lines, count = [Assign("status", sp.Integer(0))], 0
    for block in range(4):
        kept, inner = list(known), []
        for _ in range(rng.integers(2, 8)):
            a, b, c = (S(name) for name in rng.choice(known, 3))
            value = [a * b + c, a - b * c, a / 3 + b, sp.Piecewise((a, b > c), (c, True)), sp.Max(a, b)]
            value = value[rng.integers(len(value))] / 2  # nothing grows
            target = f"v_{rng.integers(SIZE)}" if rng.random() < 0.6 else f"t{(count := count + 1)}"
            inner.append(Assign(target, value))
            known = known if target in known else [*known, target]
        part = block % 2 == 1
        known = kept if part else known  # what a part works out, it keeps to itself
        lines += as_part(f"block_{block}", inner) if part and marked else inner
    body = tuple(lines[1:])
    return tiny_program(
        state=(Field("mean", "V", "average so far"), Field("v", "V", "values", SIZE)),
        init=(Assign("mean", sp.Integer(0)), *(Assign(f"v_{i}", sp.Rational(i + 1, 7)) for i in range(SIZE))),
        step=(lines[0], When(S("x") > -10, body), Assign("shown", S("v_0"))),
    )


def run(program, real, apart):
    """Words of all states and outputs over random samples, with parts inlined or as functions."""
    source = print_c(program)
    if apart:
        source = "#define SIMILITUDE_PART static __attribute__((noinline))\n" + source
    library = load_library(source, name=program.name, real=real)
    kind = np.float32 if real == "float" else np.float64
    rows = np.random.default_rng(9).standard_normal((50, 2)).astype(kind)
    config, state, out = np.array([0.3], kind), np.zeros(1 + SIZE, kind), np.zeros((50, 1), kind)
    status = np.zeros(50, np.int32)
    at = [ctypes.c_void_p(a.ctypes.data) for a in (config, state, rows, out, status)]
    library.average_init(at[0], at[1])
    library.average_batch(at[0], at[1], ctypes.c_long(50), *at[2:])
    return state.tobytes() + out.tobytes()


@pytest.mark.parametrize("seed", range(4))
def test_a_step_has_the_same_bits_with_and_without_parts(seed):
    plain, marked = random_program(seed, marked=False), random_program(seed, marked=True)

    assert len(parts_of(marked)) == 2 and not parts_of(plain)
    assert print_python(plain) == print_python(marked)  # to the twin they are nothing
    for real in ("double", "float"):
        wanted = run(plain, real, apart=False)
        assert run(marked, real, apart=False) == wanted
        assert run(marked, real, apart=True) == wanted


def test_a_part_takes_what_it_reads_and_no_more():
    part = parts_of(small_population_filter(bicycle_reduction()))["correct"]
    source = print_c(small_population_filter(bicycle_reduction()))

    read = {s.name for line in part.body for s in line.expression.free_symbols}
    assert set(part.arguments) < read and "state" in part.structs
    assert {"inv_spread", "c_3", "innovation"} < set(part.arguments)
    assert len(re.findall(r"\bbicycle_small_population_correct\(", source)) == 2  # its text and one call


def test_parts_may_work_out_values_of_the_same_name():
    """Each is a function of its own: c_4 of `learn` is not the c_4 of `correct`."""
    parts = parts_of(small_population_filter(bicycle_reduction()))
    own = {name: {line.target for line in part.body} for name, part in parts.items()}

    assert "c_4" in own["learn"] & own["correct"]
    assert not any("c_4" in part.arguments for part in parts.values())


def test_runs_keep_the_order():
    body = [Assign("a", sp.Integer(1)), *as_part("p", [Assign("b", S("a")), Assign("c", S("b"))])]

    assert [(name, len(some)) for name, some in runs([*body, *body])] == [("", 1), ("p", 2)] * 2
    assert [s.target for s in walk(body)] == ["a", "b", "c"]


def test_what_a_part_works_out_is_not_to_be_had_outside():
    program = random_program(0, marked=False)
    inside = as_part("p", [Assign("u", S("x") * 2), Assign("v_0", S("u"))])
    step = (program.step[0], *inside, Assign("shown", S("u")))

    with pytest.raises(ProgramError, match="works out u, which is needed outside"):
        parts_of(replace(program, step=step))
    shown = (program.step[0], *as_part("p", [Assign("shown", S("x"))]))
    with pytest.raises(ProgramError, match="works out shown"):
        parts_of(replace(program, step=shown))


def test_a_part_stands_in_one_place():
    program = random_program(0, marked=False)
    line = as_part("p", [Assign("v_0", S("x"))])

    with pytest.raises(ProgramError, match="'p' of a step stands in two places"):
        parts_of(replace(program, step=(*line, program.step[0], *line, Assign("shown", S("x")))))
