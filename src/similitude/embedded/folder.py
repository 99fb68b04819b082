"""An exported folder, written whole or not at all.

Invariant: the folder is built beside its place and moved there; the same command writes the same bytes.
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import tempfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from similitude.embedded.configuration import Numbers, find_numbers
from similitude.embedded.costs import Cost, costs_of, missing_tools
from similitude.embedded.drive import self_test_rows
from similitude.embedded.guard import Guard, check_sections
from similitude.embedded.machine import EMULATED, harness, row_bytes
from similitude.embedded.page import page_text
from similitude.embedded.source import print_sources
from similitude.embedded.system import Source, find_source
from similitude.embedded.targets import BYTES, CONTRACT_OFF, Target, target_named
from similitude.embedded.texts import config_text, example_text, self_test_texts
from similitude.embedded.vectors import Vectors, expected
from similitude.embedded.verify import MANIFEST
from similitude.errors import UsageError

SCHEMA = 1


@dataclass(frozen=True, eq=False)
class Export:
    """A folder that was written: its files, the numbers taken, and what it costs on the target."""

    folder: Path
    name: str
    files: tuple[str, ...]
    numbers: Numbers
    cost: Cost | None
    missing: tuple[str, ...]  # tools without which it could not be measured
    advice: str  # what rounding does to the filters, where it shows


def export(
    system: str,
    *,
    estimator: str | None,
    real: str,
    target: str,
    out: Path,
    vehicle: Path | None = None,
    sample_time: float | None = None,
) -> Export:
    """Write an estimator as a folder of C for a firmware.

    Parameters
    ----------
    system : a shipped system, or a Python file that holds one.
    estimator, real, target : as the command has them.
    out : the folder; one that an earlier export wrote is replaced.
    vehicle : vehicle file of a shipped system; a reference car where left out.
    sample_time : [s]; 10 ms where left out.

    Returns
    -------
    Export        what was written and taken.

    Raises
    ------
    UsageError    something named does not exist, or ``out`` holds something else.
    ModelError, ProgramError, VehicleError    the system or the vehicle cannot be used.
    """
    target_named(target, real=real)
    _free_or_raise(out)
    if real == "fixed":
        from similitude.embedded.fixed_profile import fixed_profile

        profile = fixed_profile(system, estimator, vehicle=vehicle, sample_time=sample_time)
        return export_profile(profile, target=target, out=out)
    source = find_source(system, estimator)
    numbers = find_numbers(source, vehicle=vehicle, sample_time=sample_time)
    return export_source(source, numbers, real=real, target=target, out=out)


def export_profile(profile: Any, *, target: str, out: Path) -> Export:
    """Write a `fixed_profile.Profile` that is at hand; arguments and errors as of `export`."""
    from similitude.embedded.fixed_guard import check_profile
    from similitude.embedded.fixed_texts import fixed_texts

    place = target_named(target, real="fixed")
    _free_or_raise(out)
    texts, vectors = fixed_texts(profile, _version())
    return _written(
        profile.source, profile.numbers, "fixed", place, out, texts, vectors, check_profile(profile)
    )


def export_source(source: Source, numbers: Numbers, *, real: str, target: str, out: Path) -> Export:
    """Write an estimator that is at hand.

    Parameters
    ----------
    source : Source      C and twin.    numbers : Numbers    its configuration.
    real, target, out : as `export` takes them.

    Raises
    ------
    UsageError    no such target, or ``out`` holds something else.
    """
    place = target_named(target, real=real)
    _free_or_raise(out)
    estimator = source.estimator
    texts, vectors = _texts(source, numbers, real)
    guard = check_sections(
        source.library(), numbers.values, estimator=estimator, real=real, sample_time=numbers.sample_time
    )
    return _written(source, numbers, real, place, out, texts, vectors, guard)


def _written(
    source: Source,
    numbers: Numbers,
    real: str,
    place: Target,
    out: Path,
    texts: Mapping[str, str],
    vectors: Vectors,
    guard: Guard | None,
) -> Export:
    with _beside(out) as part:
        for name, text in texts.items():
            (part / name).write_text(text, encoding="utf-8")
        if place.name != "host":
            (part / EMULATED).mkdir()
            for name, raw in harness(place).items():
                (part / EMULATED / name).write_bytes(raw)
            if place.name == "avr":  # its firmware has no room for the self-test's samples
                (part / EMULATED / "rows.bin").write_bytes(row_bytes(real, vectors.samples))
        cost = costs_of(part, source, real, place, vectors)
        told = _manifest(source, numbers, real, place, texts, cost)
        told["filters"] = None if guard is None else asdict(guard)
        (part / "README.md").write_text(page_text(told, source.library(), place), encoding="utf-8")
        (part / MANIFEST).write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")
        files = tuple(sorted(path.name for path in part.iterdir() if path.is_file()))
        _move(part, out)
    return Export(out, source.name, files, numbers, cost, missing_tools(place), guard.advice if guard else "")


def _texts(source: Source, numbers: Numbers, real: str) -> tuple[dict[str, str], Vectors]:
    library = source.library()
    states = len(library.names("state"))
    sources = print_sources(
        source.c, source.name, real=real, states=states, status=library.layout.STATUS, version=_version()
    )
    rows = self_test_rows(source, library, numbers.values, numbers.sample_time)
    vectors = expected(source.twin, real, numbers.values, rows)
    example = example_text(
        library, numbers, real, contract=CONTRACT_OFF, state_bytes=states * BYTES[real], row=rows[20]
    )
    texts = {
        f"{source.name}.h": sources.header,
        f"{source.name}.c": sources.source,
        f"{source.name}_config.h": config_text(library, numbers, real),
        **self_test_texts(library, vectors, real),
        "example_main.c": example,
    }
    return texts, vectors


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("similitude")
    except PackageNotFoundError:
        return "run from its source"


def _manifest(
    source: Source, numbers: Numbers, real: str, target: Target, texts: Mapping[str, str], cost: Cost | None
) -> dict:
    import hashlib
    import re

    counts = re.search(r"SAMPLES = (\d+), \w+ = (\d+)", texts[f"{source.name}_self_test.h"])
    return {
        "schema": SCHEMA,
        "name": source.name,
        "system": source.system,
        "estimator": source.estimator,
        "real": real,
        "target": target.name,
        "state_reals": len(source.library().names("state")),
        "self_test": {"samples": int(counts.group(1)), "words": int(counts.group(2))},
        "assumed": {k: {"value": float(v), "unit": u, "from": o} for k, (v, u, o) in numbers.assumed.items()},
        "missing": list(missing_tools(target)),
        "cost": None if cost is None else cost.record,
        "sha256": {name: hashlib.sha256(text.encode()).hexdigest() for name, text in sorted(texts.items())},
    }


def _free_or_raise(out: Path) -> None:
    if not out.exists() or (out.is_dir() and (not any(out.iterdir()) or (out / MANIFEST).is_file())):
        return
    raise UsageError(
        f"--out '{out}' is there and holds something that no export wrote",
        usually="the folder of the firmware was named; the estimator gets a folder of its own.",
        paste=f"--out {shlex.quote(str(out / 'estimator'))}",
        read='docs/embedded.md, "The command"',
    )


class _beside:
    """A folder beside ``out`` that is gone when the block ends, unless it was moved."""

    def __init__(self, out: Path) -> None:
        self.out = out

    def __enter__(self) -> Path:
        parent = self.out.absolute().parent
        try:
            parent.mkdir(parents=True, exist_ok=True)
            self.part = Path(tempfile.mkdtemp(prefix=".similitude-", dir=parent))
        except OSError as fault:
            raise UsageError(
                f"--out '{self.out}' cannot be written: {fault.strerror or fault}",
                usually="the folder belongs to somebody else, or a part of the path is a file.",
                paste="--out firmware",
                read='docs/embedded.md, "The command"',
            ) from fault
        os.chmod(self.part, 0o755)
        return self.part

    def __exit__(self, *_) -> None:
        shutil.rmtree(self.part, ignore_errors=True)


def _move(part: Path, out: Path) -> None:
    if out.exists():
        old = Path(tempfile.mkdtemp(prefix=".similitude-", dir=out.absolute().parent))
        os.replace(out, old / "old")
        os.replace(part, out)
        shutil.rmtree(old, ignore_errors=True)
    else:
        os.replace(part, out)
