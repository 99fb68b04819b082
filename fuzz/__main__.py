"""Fuzz the readers: `python -m fuzz --seconds 600` shares that processor time between the targets.

Each target starts from the bundled logs cut short, the vehicle files and a dictionary of what stands in
real ones. What made a target fail is kept in `fuzz-failures/` and named; the exit status is then 1.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random

ROOT = Path(__file__).parents[1]
FAILURES = ROOT / "fuzz-failures"
SHARES = {"text": 0.4, "signals": 0.3, "parquet": 0.15, "vehicle": 0.15}
ROWS, EVERY = 60, 4  # of each bundled log: five seconds in few bytes, so that mutations reach far
WORKERS = 2
SLOWEST = 10  # s for one file of a few kilobytes
MEMORY = 2048  # MB
SHIFT = 300  # s of one process: the instrumentation keeps 80 kB of every file tried, the readers nothing
TOKENS = (
    *("t [s]", "time [ms]", "delta [rad]", "steering_wheel [deg]", "r [deg/s]", "yaw_rate [rad/s]"),
    *("U [km/h]", "speed [m/s]", "ay [g]", "nan", "NaN", "N/A", "#REF!", "inf", "-1e308", "1e400"),
    *("1,234.5", "0,05", ";", "\\x09", "\\xef\\xbb\\xbf", "\\x0d\\x0a", "\\x00", '\\"', "\\xff\\xfe"),
    *("2024-05-01T12:00:00Z", "12:30:01.5", "L = ", "\\xc2\\xb1 5 kg", "+- ", "[sensor]", "yaw_rate_noise"),
    *(
        "m = ",
        "a = ",
        "b = ",
        "Iz = ",
        "Caf = ",
        "steering_ratio = ",
        "population = ",
        "population = [",
        "mm",
        "1e-400",
    ),
)


def main() -> int:
    """Run every target, two at a time; 1 when one failed."""
    parser = argparse.ArgumentParser(prog="python -m fuzz", description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=int, default=600, help="processor time of all targets together")
    asked = parser.parse_args()
    FAILURES.mkdir(exist_ok=True)
    with ThreadPoolExecutor(WORKERS) as pool:
        times = [max(1, int(share * asked.seconds)) for share in SHARES.values()]
        failed = [name for name, status in zip(SHARES, pool.map(run, SHARES, times), strict=True) if status]
    if not any(FAILURES.iterdir()):
        FAILURES.rmdir()
    for name in failed:
        print(f"{name}: failed; the file is in {FAILURES.relative_to(ROOT)}/", file=sys.stderr)
    return 1 if failed else 0


def run(name: str, seconds: int) -> int:
    """Fuzz one target for so many seconds; its exit status."""
    with tempfile.TemporaryDirectory(prefix="similitude-corpus-") as folder:
        corpus, words = Path(folder) / "corpus", Path(folder) / "words"
        corpus.mkdir()
        for i, seed in enumerate(seeds(name)):
            (corpus / f"seed{i}").write_bytes(seed)
        words.write_text("".join(f'"{token}"\n' for token in TOKENS), encoding="utf-8")
        options = [f"-timeout={SLOWEST}", f"-rss_limit_mb={MEMORY}"]
        options += [f"-dict={words}", f"-artifact_prefix={FAILURES}/{name}-", "-max_len=8192"]
        options += ["-print_final_stats=1", "-verbosity=0", str(corpus)]
        command = [sys.executable, "-m", "fuzz.target", name, *options]
        tried = 0
        for begun in range(0, seconds, SHIFT):
            shift = f"-max_total_time={min(SHIFT, seconds - begun)}"
            done = subprocess.run(
                [*command, shift], cwd=ROOT, capture_output=True, text=True, errors="replace"
            )
            tried += _tried(done.stderr)
            if done.returncode:
                break
    print(f"{name}: {seconds} s, {tried} files tried")
    if done.returncode:
        print(done.stdout[-4000:], done.stderr[-2000:], sep="\n", file=sys.stderr)
    return done.returncode


def seeds(name: str) -> list[bytes]:
    """Real files to start from; the targets that make their own tables take any bytes."""
    if name == "vehicle":
        return [path.read_bytes() for path in sorted((ROOT / "data").glob("*.toml"))]
    if name == "signals":  # long enough for a dozen spoilt stretches
        return [Random(number).randbytes(200) for number in range(40)]
    logs = [path.read_bytes() for path in sorted((ROOT / "data").glob("*.csv"))]
    lines = [log.split(b"\n") for log in logs]
    return [b"\n".join([header, *rows[::EVERY][:ROWS], b""]) for header, *rows in lines]


def _tried(stderr: str) -> int:
    for line in stderr.splitlines():
        if line.startswith("stat::number_of_executed_units:"):
            return int(line.split()[-1])
    return 0


if __name__ == "__main__":
    sys.exit(main())
