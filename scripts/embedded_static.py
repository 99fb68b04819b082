"""Static evidence for the exported C: warnings, MISRA, sanitizers, branches, absence of run-time errors.

Each check runs where its tool is present and says so in a line where it is not:

    warnings      gcc and clang at -O2, every warning an error
    MISRA         cppcheck --addon=misra: no rule but those of docs/embedded.md, "Deviations"
    sanitizers    address and undefined behaviour over a million random samples
    branches      gcov over the self-test and 300,000 random samples
    Frama-C Eva   no alarm for any bits of a sample, for ever; and an alarm in a file made to have one;
                  numbers of `paper` and `band` that stay finite, and an alarm without a gate

    python scripts/embedded_static.py [--only ESTIMATOR] [--no-eva]
"""

from __future__ import annotations

import argparse
import contextlib
import io
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from similitude.embedded.configuration import find_numbers
from similitude.embedded.finiteness import FINITE, finite_text
from similitude.embedded.fixed_profile import FIXED
from similitude.embedded.folder import export
from similitude.embedded.state_bounds import BOUNDS
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.targets import CONTRACT_OFF, STRICT
from similitude.embedded.texts import step_end

HERE = Path(__file__).parent
BASE = ["-std=c99", "-ffp-contract=off", f"-D{CONTRACT_OFF}", "-I."]
DEVIATIONS = {"2.3", "2.4", "2.5", "8.7", "12.1"}  # advisory, each with its reason in docs/embedded.md
FIXED_DEVIATIONS = {"7.2", "10.1", "10.7"}  # of the fixed profile besides, likewise
SANITIZED, COVERED = 1_000_000, 300_000  # random samples
BRANCHES_LEAST = 75.0  # % of the branches of a file that were taken
ADDON = ("--addon=misra", "--std=c99", "--quiet", f"-D{CONTRACT_OFF}")
ASLEEP = ("bicycle_monitor",)  # fed by a filter, not by random samples
EVA = ("bicycle_paper", "bicycle_band", "bicycle_population", "bicycle_small_population")
_EVA_MAIN = """\
#include "{name}_config.h"

volatile unsigned int any;

static float any_bits(void)
{{
    union {{ unsigned int bits; float value; }} word;
    word.bits = any;
    return word.value;
}}

int main(void)
{{
    {name}_state state;
    {name}_output output;
    {name}_init(&{name}_numbers, &state);
    while (any != 0u) {{
        {name}_sample sample;
{fields}
        (void){name}_step(&{name}_numbers, &state, &sample{step_end}
    }}
    return 0;
}}
"""


def run(command: list[str], cwd: Path) -> subprocess.CompletedProcess:
    """Run a tool, its words kept."""
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)


def warnings(name: str, folder: Path) -> list[str]:
    """What gcc and clang complain of."""
    faults = []
    for compiler in ("gcc", "clang"):
        if shutil.which(compiler) is None:
            print(f"{name:30} warnings: skipped, {compiler} is missing; apt-get install {compiler}")
            continue
        for file in (f"{name}.c", f"{name}_self_test.c"):
            done = run([compiler, *BASE, "-O2", *STRICT, "-c", file, "-o", "warned.o"], folder)
            faults += [f"{name}: {compiler}: {done.stderr.splitlines()[0]}"] if done.returncode else []
        print(f"{name:30} warnings: {compiler}, {len(STRICT) - 1} kinds, none")
    return faults


def misra(name: str, folder: Path) -> list[str]:
    """Rules of MISRA C 2012 that are broken and not among the deviations."""
    if shutil.which("cppcheck") is None:
        print(f"{name:30} MISRA: skipped, cppcheck is missing; apt-get install cppcheck")
        return []
    done = run(["cppcheck", *ADDON, f"{name}.c"], folder)
    broken = set(re.findall(r"\[misra-c2012-([\d.]+)\]", done.stderr))
    print(f"{name:30} MISRA: deviations {', '.join(sorted(broken, key=_number)) or 'none'}")
    known = DEVIATIONS | FIXED_DEVIATIONS if name.endswith("_fixed") else DEVIATIONS
    return [f"{name}: MISRA rule {rule}" for rule in sorted(broken - known)]


def _number(rule: str) -> tuple[int, ...]:
    return tuple(map(int, rule.split(".")))


def sanitizers(name: str, folder: Path) -> list[str]:
    """What address and undefined-behaviour sanitizers say over random samples."""
    flags = [
        "-O1",
        "-g",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
        f"-DSAMPLES={SANITIZED}",
    ]
    return _random(name, folder, "sanitizers", flags)[0]


def _random(name: str, folder: Path, what: str, flags: list[str]) -> tuple[list[str], str]:
    storm = "embedded_random_fixed.c" if name.endswith("_fixed") else "embedded_random.c"
    files = [str(HERE / storm), f"{name}.c", f"{name}_self_test.c"]
    built = run(["gcc", *BASE, *flags, f"-DNAME={name}", *files, "-o", what], folder)
    if built.returncode:
        return [f"{name}: {what} do not build: {built.stderr.splitlines()[0]}"], ""
    done = run([f"./{what}"], folder)
    print(f"{name:30} {what}: {done.stdout.strip()}")
    return ([f"{name}: {what}: {done.stdout} {done.stderr[:300]}"] if done.returncode else []), done.stdout


def branches(name: str, folder: Path) -> list[str]:
    """Branches of the C file that self-test and random samples take."""
    if shutil.which("gcov") is None:
        print(f"{name:30} branches: skipped, gcov is missing; apt-get install gcc")
        return []
    faults, _ = _random(name, folder, "covered", ["-O0", "--coverage", f"-DSAMPLES={COVERED}"])
    done = run(["gcov", "-b", "-o", f"covered-{name}.gcda", f"{name}.c"], folder)
    part = done.stdout.partition(f"File '{name}.c'")[2]
    share = float(re.search(r"Taken at least once:([\d.]+)%", part).group(1))
    count = re.search(r"Taken at least once:[\d.]+% of (\d+)", part).group(1)
    lines = re.search(r"Lines executed:([\d.]+)%", part).group(1)
    print(f"{name:30} branches: {share} % of {count} taken, {lines} % of the lines")
    return faults + (
        [f"{name}: {share} % of branches taken, {BRANCHES_LEAST} wanted"] if share < BRANCHES_LEAST else []
    )


def eva(name: str, folder: Path) -> list[str]:
    """Alarms of Frama-C Eva for any bits of any sample; and none missing in a file made to have one."""
    if shutil.which("frama-c") is None:
        print(f"{name:30} Eva: skipped, frama-c is missing; apt-get install frama-c-base")
        return []
    alarms = _alarms(name, folder, f"{name}.c")
    text = (folder / f"{name}.c").read_text()
    wrong = re.sub(r"\b(\w+(?:->\w+)?)\[1\]", r"\1[1001]", text, count=1)
    (folder / "wrong.c").write_text(wrong)
    control = _alarms(name, folder, "wrong.c")
    print(f"{name:30} Eva: {alarms} alarms for any samples; {control} in the control that goes past an array")
    faults = [f"{name}: {alarms} alarms"] if alarms != 0 else []
    return faults + ([f"{name}: the control raises no alarm"] if not control else [])


def _alarms(name: str, folder: Path, file: str) -> int:
    from similitude.embedded.system import find_source

    system, _, estimator = name.partition("bicycle_")
    library = find_source(f"{system}bicycle", estimator).library()
    lines = "\n".join(f"        sample.{row[0]} = any_bits();" for row in library.layout.SAMPLE)
    (folder / "eva_main.c").write_text(_EVA_MAIN.format(name=name, fields=lines, step_end=step_end(library)))
    flags = [
        "-eva",
        "-eva-precision",
        "1",
        "-eva-auto-loop-unroll",  # init's loops over arrays, so that each element is seen to be set
        "128",
        "-warn-special-float",
        "none",
        f"-cpp-extra-args=-D{CONTRACT_OFF}",
    ]
    done = run(["frama-c", *flags, str(folder / "eva_main.c"), str(folder / file)], folder)
    found = re.search(r"(\d+) alarms? generated", done.stdout)
    return int(found.group(1)) if found else -1


def finite(name: str, folder: Path, system: str, estimator: str) -> list[str]:
    """That every number of a step stays finite (`similitude.embedded.finiteness`), and a gate's worth."""
    if estimator not in BOUNDS or shutil.which("frama-c") is None:
        return []
    source = find_source(system, estimator)
    numbers = find_numbers(source, vehicle=None, sample_time=None)
    bounds = BOUNDS[estimator](source.library(), numbers.values)
    (folder / FINITE).write_text(finite_text(source.library(), numbers.values, bounds))
    text = (folder / f"{name}.c").read_text()
    (folder / "ungated.c").write_text(text.replace("config->input_limit", "R(3.4e38)"))
    within = _finite_alarms(folder, f"{name}.c", "non-finite", "-cpp-extra-args=-DGATED")
    anything = _finite_alarms(folder, f"{name}.c", "none")
    control = _finite_alarms(folder, "ungated.c", "none")
    print(
        f"{name:30} Eva: {within} alarms or open assertions on finite numbers within the gates, {anything} "
        f"for any numbers; {control} in the control without a gate"
    )
    faults = [f"{name}: {n} alarms on finite numbers" for n in (within, anything) if n != 0]
    return faults + ([f"{name}: the control without a gate raises no alarm"] if control <= 0 else [])


def _finite_alarms(folder: Path, file: str, special: str, *more: str) -> int:
    flags = ["-eva", "-eva-precision", "5", "-warn-special-float", special, *more]
    files = [str(folder / FINITE), str(folder / file)]
    done = run(["frama-c", *flags, f"-cpp-extra-args=-D{CONTRACT_OFF}", *files], folder)
    found = re.search(r"(\d+) alarms? generated", done.stdout)
    left = re.search(r"Assertions +\d+ valid +(\d+) unknown +(\d+) invalid", done.stdout)
    if found is None or left is None:
        return -1
    return int(found.group(1)) + int(left.group(1)) + int(left.group(2))


def examine(system: str, estimator: str, real: str, with_eva: bool) -> tuple[str, list[str]]:
    """Every check of one estimator: what they say, and what failed."""
    name = f"{system}_{estimator}_fixed" if real == "fixed" else f"{system}_{estimator}"
    said = io.StringIO()
    with tempfile.TemporaryDirectory(prefix="similitude-") as place, contextlib.redirect_stdout(said):
        folder = Path(place, name)
        export(system, estimator=estimator, real=real, target="host", out=folder)
        faults = [*warnings(name, folder), *misra(name, folder)]
        if name not in ASLEEP:
            faults += [*sanitizers(name, folder), *branches(name, folder)]
        if name in EVA and with_eva:
            faults += [*eva(name, folder), *finite(name, folder, system, estimator)]
    return said.getvalue(), faults


def main() -> int:
    """Run what can be run, as many estimators at a time as there are processors; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", help="one estimator, such as bicycle_paper")
    parser.add_argument("--no-eva", action="store_true", help="leave Frama-C out")
    asked = parser.parse_args()
    every = [(system, estimator, "float") for system, names in SHIPPED.items() for estimator in names]
    every += [("bicycle", estimator, "fixed") for estimator in FIXED]
    names = ["_".join(one[: 2 if one[2] == "float" else 3]) for one in every]
    wanted = [one for one, name in zip(every, names, strict=True) if asked.only in (None, name)]
    faults: list[str] = []
    with ProcessPoolExecutor() as pool:
        jobs = [pool.submit(examine, *one, not asked.no_eva) for one in wanted]
        for said, found in (job.result() for job in jobs):
            print(said, end="", flush=True)
            faults += found
    for fault in faults:
        print(f"FAILED {fault}")
    print("failed" if faults else "nothing found")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
