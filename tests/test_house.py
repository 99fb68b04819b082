"""The rules of the house, computed from the source text: sizes, names, imports, docstrings.

`FLOW` is the order in which data flows and in which the package is read. A file may import from
the lines above its own and, without going in circles, from its own line.
"""

import ast
import os
import pathlib
import re
import statistics
from functools import cache

import pytest

ROOT = pathlib.Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "similitude"
FLOW = (
    "errors dimension unit unit_table unit_grammar units status",
    "program",
    "saturation elementary model_text_faults model_text",
    "homogeneity model_formulas",
    "model dimensional groups population reduction",
    "symmetry",
    "linear invariance rewriting",
    "analysis",
    "matrix_function sampling sampled_linearity output_sensitivity directions",
    "estimators generated",
    "vehicle_values vehicle_checks vehicle_file noise",
    "finding readers log_quantities log_names log_columns log_time log_cells log_plausibility",
    "signal_faults log_following log_sensors log_speed log_response log_fixes",
    "log_survey log",
    "populations",
    "accelerometer vehicle_prior filter_config coarse_log slow_bus servo filter_run steer_lag",
    "steer_servo steer_passes",
    "batch_pass batch_slopes batch_fit",
    "run verdict prediction handling stiffness_doubt",
    "monitor_config change_alarm information_meter time_scales saved_state drive_memory",
    "identify_setup",
    "inspection steer_scale_doubt speed_unit_doubt",
    "ladder_passes cross_check",
    "identify_population identify_batch identify_paper identify_ladder",
    "distance_sampling identification",
    "report",
    "simulate systems generate",
    "simulation",
    "benchmark",
    "embedded",
    "any_model",
    "paper",
    "cli_complaint cli_usage",
    "cli_analyze cli_inspect cli_population cli_simulate cli_compare cli_export cli_estimate cli_paper",
    "cli_bench",
    "cli",
)
DRAWERS = {"utils", "util", "helpers", "helper", "common", "misc", "core"}
PRIVATE = (
    r"(?<![\w.~-])/(?:work|root|home|Users)/\w",  # somebody's own folders
    r"\b(?:10\.\d+|192\.168|172\.(?:1[6-9]|2\d|3[01]))\.\d+\.\d+\b",  # somebody's own network
    r"\b[\w-]+\.(?:internal|intranet|corp|lan)\b",
    r"-(?:-extra)?-index-url|-[-]find-links",
    r"-{5}BEGIN [A-Z ]*PRIVATE",
    r"\b(?:[Ii]ssue|[Ss]ession) #?\d",
)
SKIPPED = {".git", ".venv", "__pycache__", "build", "dist", "demo-out", "similitude-out"}


def files(*suffixes: str, under: pathlib.Path = ROOT) -> list[pathlib.Path]:
    """Files of the repository, without what a .gitignore leaves out."""
    found = []
    for folder, inner, names in os.walk(under):
        inner[:] = [name for name in inner if not _is_skipped(name)]
        found += [pathlib.Path(folder, name) for name in names]
    return sorted(path for path in found if path.suffix in suffixes)


def _is_skipped(name: str) -> bool:
    return name in SKIPPED or name.endswith(("_cache", ".egg-info"))


def written(*, under: pathlib.Path = PACKAGE) -> list[pathlib.Path]:
    """Python files that people wrote; generated ones answer to their generator's tests."""
    return [path for path in files(".py", under=under) if "generated" not in path.parts]


def tree(path: pathlib.Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"), str(path))


def short(path: pathlib.Path) -> str:
    return path.relative_to(ROOT).as_posix()


def functions(module: ast.AST) -> list[ast.FunctionDef | ast.AsyncFunctionDef]:
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef)
    return [node for node in ast.walk(module) if isinstance(node, kinds)]


def module_name(path: pathlib.Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def imports() -> dict[str, set[str]]:
    """Module to modules of this package that it imports anywhere, functions included."""
    known = {module_name(path): path for path in files(".py", under=PACKAGE)}
    edges: dict[str, set[str]] = {}
    for name, path in known.items():
        package = name if path.name == "__init__.py" else name.rpartition(".")[0]
        asked = {wanted for node in ast.walk(tree(path)) for wanted in _asked(node, package)}
        edges[name] = {_nearest(wanted, known) for wanted in asked} - {name, None}
    return edges


def _asked(node: ast.AST, package: str) -> list[str]:
    """Dotted names one import statement may mean, deepest meaning included."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if not isinstance(node, ast.ImportFrom):
        return []
    base = node.module or ""
    if node.level:
        above = package.split(".")[: len(package.split(".")) - node.level + 1]
        base = ".".join([*above, *([node.module] if node.module else [])])
    return [f"{base}.{alias.name}" for alias in node.names]


def _nearest(wanted: str, known: dict[str, pathlib.Path]) -> str | None:
    """The module of this package that a dotted name leads to."""
    while wanted and wanted not in known:
        wanted = wanted.rpartition(".")[0]
    return wanted or None


def line_of(module: str) -> int | None:
    """The line of FLOW on which a module stands; None for the package's own front page."""
    if module == "similitude":
        return None
    room = module.split(".")[1]
    for number, line in enumerate(FLOW):
        if room in line.split():
            return number
    raise AssertionError(f"{module} has no place in FLOW: give '{room}' the line where it belongs")


@pytest.mark.parametrize("room", ["src", "tests", "scripts", "bench", "fuzz"])
def test_no_file_is_longer_than_400_lines(room):
    lengths = {short(p): len(p.read_text().splitlines()) for p in written(under=ROOT / room)}

    assert {name: length for name, length in lengths.items() if length > 400} == {}
    if room == "src":
        assert statistics.median(lengths.values()) <= 200


def test_nine_functions_in_ten_are_shorter_than_45_lines():
    lengths = {
        f"{short(path)}:{node.lineno} {node.name}": node.end_lineno - node.lineno + 1
        for path in written()
        for node in functions(tree(path))
    }
    long = {name: length for name, length in lengths.items() if length >= 45}

    assert len(long) <= len(lengths) / 10, long


def test_no_file_is_named_after_a_drawer():
    words = {short(path): set(path.stem.strip("_").split("_")) for path in files(".py", ".c", ".h")}

    assert [name for name, used in words.items() if used & DRAWERS] == []


def test_imports_follow_the_flow():
    against = [
        f"{module} imports {wanted}"
        for module, asked in imports().items()
        for wanted in asked
        if line_of(module) is not None and (line_of(wanted) is None or line_of(wanted) > line_of(module))
    ]

    assert sorted(against) == []


def test_every_name_in_the_flow_exists():
    rooms = {module.split(".")[1] for module in imports() if "." in module}
    named = [name for line in FLOW for name in line.split()]

    assert len(named) == len(set(named))
    assert set(named) - rooms == set()


def test_no_imports_go_in_circles():
    left = imports()
    while free := {module for module, asked in left.items() if not asked & left.keys()}:
        left = {module: asked for module, asked in left.items() if module not in free}

    assert {module: sorted(asked & left.keys()) for module, asked in left.items()} == {}


def test_every_source_file_has_a_test_file():
    untested = []
    for path in written():
        inside = path.relative_to(PACKAGE)
        if path.name != "__init__.py" and not _tests_of(inside):
            untested.append(f"{short(path)}: tests/{inside.with_name(f'test_{inside.name}')}")

    assert untested == []


def _tests_of(inside: pathlib.Path) -> list[pathlib.Path]:
    """tests/<room>/test_<file>.py, or parts of it: test_<file>_<part>.py."""
    folder = ROOT / "tests" / inside.parent
    return [*folder.glob(f"test_{inside.stem}.py"), *folder.glob(f"test_{inside.stem}_*.py")]


def test_every_file_class_and_function_that_is_public_says_what_it_is():
    silent = []
    for path in written():
        module = tree(path)
        if not ast.get_docstring(module):
            silent.append(short(path))
        for owner in [module, *(n for n in module.body if isinstance(n, ast.ClassDef))]:
            for node in owner.body:
                is_named = isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
                if is_named and not node.name.startswith("_") and not ast.get_docstring(node):
                    silent.append(f"{short(path)}:{node.lineno} {node.name}")

    assert silent == []


def test_nothing_speaks_of_private_places():
    texts = [*files(".py", ".md", ".toml", ".c", ".h", ".yml"), ROOT / "Makefile", ROOT / ".ci/run"]
    spoken = [
        f"{short(path)}: {found.group()}"
        for path in texts
        for pattern in PRIVATE
        for found in re.finditer(pattern, path.read_text(encoding="utf-8"))
    ]

    assert spoken == []
