"""The printed C needs nothing but a C99 compiler, says what it costs, and works as written."""

import ctypes
import re
import shutil
import subprocess

import numpy as np
import pytest
import sympy as sp

from similitude.estimators.population_filter import population_filter
from similitude.program.c import names_read, names_written, operations, print_c
from similitude.program.compile import compile_source, load_library
from similitude.program.ir import Assign, When
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction

from .tiny import mean, rate, reporting_program, tiny_program, x

PROGRAMS = {
    "tiny": tiny_program,
    "reporting": reporting_program,
    "bicycle": lambda: population_filter(bicycle_reduction()),
}
needs_cc = pytest.mark.skipif(shutil.which("cc") is None, reason="asks the compiler for warnings")


@pytest.fixture(scope="module", params=sorted(PROGRAMS))
def program(request):
    return PROGRAMS[request.param]()


def test_the_file_is_plain_ascii_without_header_heap_or_library(program):
    source = print_c(program)

    assert source.isascii() and source.endswith("}\n")
    assert "#include" not in source and "\t" not in source
    forbidden = r"\b(?:malloc|free|sqrt|pow|exp|log|fabs|sin)\b|\bstatic\b(?! inline)"
    without_comments = re.sub(r"/\*.*?\*/", "", source, flags=re.DOTALL)
    assert re.findall(forbidden, without_comments) == []


@needs_cc
@pytest.mark.parametrize("real", ["double", "float"])
def test_a_strict_compiler_has_nothing_to_say(program, real, tmp_path):
    path = tmp_path / "program.c"
    path.write_text(print_c(program))
    flags = "-std=c99 -pedantic -Wall -Wextra -Wshadow -Wno-unused-parameter -Werror -O2 -c".split()
    real_flag = f"-DSIMILITUDE_REAL={real}"

    done = subprocess.run(
        ["cc", *flags, real_flag, str(path), "-o", str(tmp_path / "program.o")],
        capture_output=True,
        text=True,
        check=False,
    )

    assert done.returncode == 0, done.stderr[:2000]


@pytest.mark.skipif(shutil.which("nm") is None, reason="asks nm for the symbols")
def test_it_needs_no_symbol_and_exports_only_its_own(program):
    library = compile_source(print_c(program), name=program.name)
    listed = subprocess.run(
        ["nm", "-D", str(library)], capture_output=True, text=True, check=True
    ).stdout.split("\n")
    own = sorted(line.split()[-1] for line in listed if " T " in line)
    asked = [line.split()[-1] for line in listed if " U " in line]

    verbs = ("batch", "init", "step", *(["report"] if program.report else []))
    assert own == sorted(f"{program.name}_{verb}" for verb in verbs)
    assert asked == []  # weak ones of the C start-up files apart


def test_every_field_is_declared_with_unit_and_meaning(program):
    source = print_c(program)
    for kind in ("config", "state", "sample", "output"):
        for field in getattr(program, kind):
            size = rf"\[{field.size}\]" if field.size > 1 else ""
            comment = re.escape(f"/* [{field.unit}] {field.meaning} */")
            assert re.search(rf"_real {field.name}{size};\s+{comment}", source), field.name
    for name, code in program.status.items():
        assert f"{program.name.upper()}_{name.upper()} = {code}" in source


def test_the_header_counts_operations_along_the_longest_and_the_shortest_way():
    program = tiny_program()

    # condition 2; weight: product, comparison, its product again, select; mean: 3 / nothing else
    assert operations(program.step, most=True) == 2 + 4 + 3
    assert operations(program.step, most=False) == 2
    assert "step 9 at most, 2 at least" in print_c(program)
    assert names_read(program.step) == {"x", "dt", "rate", "mean", "weight", "last_0"}
    assert names_written(program.init) == {"mean", "last_0", "last_1"}


def run_tiny(source, samples):
    library = load_library(source, name="average")
    config, state = np.array([2.0]), np.full(3, np.nan)
    outputs, status = np.full((len(samples), 1), np.nan), np.full(len(samples), -1, np.int32)
    rows = np.ascontiguousarray(samples)
    at = [ctypes.c_void_p(a.ctypes.data) for a in (config, state, rows, outputs, status)]
    library.average_init(at[0], at[1])
    library.average_batch(at[0], at[1], ctypes.c_long(len(rows)), *at[2:])
    return outputs[:, 0], status, state


def test_the_batch_steps_through_the_samples_in_order():
    samples = np.array([[0.1, 1.0], [0.1, np.nan], [5.0, 3.0], [0.1, 99.0]])

    shown, status, state = run_tiny(print_c(tiny_program()), samples)

    assert status.tolist() == [0, 7, 0, 7]
    assert shown.tolist() == [0.2, 0.2, 3.0, 3.0]  # 2/s x 0.1 s; held; all new after 5 s; held
    assert state.tolist() == [3.0, 3.0, 1.0]


def test_a_guard_with_nothing_in_its_first_way_is_turned_round():
    otherwise = When(x > 0, (), (Assign("mean", -rate),))
    program = tiny_program(step=(Assign("status", sp.Integer(0)), otherwise, Assign("shown", mean)))

    shown, _, _ = run_tiny(print_c(program), np.array([[1.0, 5.0], [1.0, np.nan], [1.0, 5.0]]))

    assert shown.tolist() == [0.0, -2.0, -2.0]


def test_a_report_follows_every_step_of_the_batch_as_of_the_twin():
    program, samples = reporting_program(), np.array([[0.1, 1.0], [0.1, np.nan], [5.0, 3.0]])
    twin: dict = {}
    exec(print_python(program), twin)
    flat = twin["init"]([2.0])
    told = [twin["step"]([2.0], flat, row) for row in samples.tolist()]

    shown, status, state = run_tiny(print_c(program), samples)

    assert shown.tolist() == [0.4 - 1.0, 0.4 - 1.0, 6.0 - 3.0] == [y for _, (y,) in told]
    assert status.tolist() == [0, 7, 0] and state.tolist() == flat
    assert twin["REPORTS"] and "const average_sample *sample)\n" in print_c(program)
