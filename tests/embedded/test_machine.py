"""Emulated boards give the host's bits, and their counts hold against another way of counting."""

import json
import re
import subprocess

import numpy as np
import pytest

from similitude.embedded.configuration import find_numbers
from similitude.embedded.costs import missing_tools
from similitude.embedded.drive import self_test_rows
from similitude.embedded.folder import export
from similitude.embedded.machine import board, compile_line, row_bytes
from similitude.embedded.system import find_source
from similitude.embedded.targets import TARGETS
from similitude.embedded.vectors import expected


def present(name):
    lacking = missing_tools(TARGETS[name])
    if lacking:
        pytest.skip(f"{', '.join(lacking)} missing; apt-get install {TARGETS[name].packages}")


@pytest.mark.slow
@pytest.mark.parametrize("target", ["cortex-m4f", "cortex-m3", "cortex-m0", "rv32", "avr"])
def test_no_word_differs_and_the_readme_can_be_followed(tmp_path, target):
    present(target)
    done = export("bicycle", estimator="paper", real="float", target=target, out=tmp_path / "f")
    assert done.cost.differing == 0
    page = (done.folder / "README.md").read_text()
    (lines,) = re.findall(r"```\n(cd emulated\n.*?)```", page, re.S)
    said = subprocess.run(["sh", "-ec", lines], cwd=done.folder, check=True, capture_output=True, text=True)
    told = dict(re.findall(r"^(.*?): ([\d.]+)$", said.stdout + said.stderr, re.M))
    unit = done.cost.unit

    assert int(told[f"{unit} a sample, most"]) == done.cost.most
    assert float(told[f"{unit} a sample, mean"]) == pytest.approx(done.cost.mean, abs=0.51)
    assert int(told["stack of a step, bytes"]) == done.cost.stack
    assert told.get("words that differ", "0") == "0"


@pytest.mark.slow
def test_instructions_are_those_the_emulator_executes(tmp_path):
    """QEMU's own trace of executed instructions, between entry and return of the step."""
    present("cortex-m4f")
    done = export("bicycle", estimator="paper", real="float", target="cortex-m4f", out=tmp_path / "f")
    inside = done.folder / "emulated"
    subprocess.run(compile_line(done.name, TARGETS["cortex-m4f"]), cwd=inside, check=True)
    nm = ["arm-none-eabi-nm", "-S", "firmware.elf"]
    symbols = subprocess.run(nm, cwd=inside, check=True, capture_output=True, text=True)
    (line,) = (x for x in symbols.stdout.splitlines() if x.endswith(" bicycle_paper_step"))
    begin, size = (int(word, 16) & ~1 for word in line.split()[:2])
    machine = ["qemu-system-arm", "-machine", "mps2-an386", "-display", "none", "-monitor", "none"]
    board_of = ["-serial", "none", "-semihosting-config", "enable=on,target=native"]
    trace = ["-singlestep", "-d", "exec,nochain", "-D", "trace.txt", "-dfilter", f"{begin:#x}+{size:#x}"]
    traced = [*machine, *board_of, *trace, "-kernel", "firmware.elf"]
    subprocess.run(traced, cwd=inside, check=True, capture_output=True)
    addresses = [
        int(x, 16) for x in re.findall(r"Trace \d+: \S+ \[\w+/(\w+)/", (inside / "trace.txt").read_text())
    ]
    starts = [i for i, address in enumerate(addresses) if address == begin]
    calls = np.diff([*starts, len(addresses)])
    samples = json.loads((done.folder / "evidence.json").read_text())["self_test"]["samples"]
    counted = calls[-samples:]  # the firmware's last pass is the measured one

    assert len(starts) == 2 * samples
    # An empty call is two or three instructions and is subtracted; everything else must agree.
    assert abs(counted.max() - done.cost.most) <= 4
    assert abs(counted.mean() - done.cost.mean) <= 4


def test_rows_are_little_endian_words():
    source = find_source("bicycle", "paper")
    numbers = find_numbers(source, vehicle=None, sample_time=None)
    rows = self_test_rows(source, source.library(), numbers.values, numbers.sample_time)[:3]
    words = expected(source.twin, "float", numbers.values, rows).samples

    assert np.array_equal(np.frombuffer(row_bytes("float", words), "<f4"), rows.astype(np.float32).ravel())


def test_every_target_has_a_board():
    assert {board(target) for target in TARGETS.values()} == {"rv32", "cortex_m"}
