"""The command line with a made-up core: arguments, streams, exit codes, what stays on the disk."""

import importlib.util
import json
import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from similitude.cli import main
from similitude.errors import LogError, VehicleError

HERE = Path(__file__).parent
OURS = {"estimate.parquet", "plot.png", "report.html", "summary.json"}


@pytest.fixture
def core(monkeypatch, tmp_path):
    """Put a reader and an estimator that do no work in place; record how they were called."""
    spec = importlib.util.spec_from_file_location("example", HERE / "report" / "example_run.py")
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    calls = SimpleNamespace(read=[], identified=[], fixes=[])

    def read_vehicle(path):
        if "bad" in Path(path).name:
            raise VehicleError("b = -1 m", usually="a sign.", paste="b = 1 m", read="docs")
        return SimpleNamespace(name="car")

    def read_log(path, *, vehicle, mapping, fixes):
        calls.read.append((str(path), vehicle.name, mapping))
        calls.fixes.append(fixes)
        if "bad" in path.name:
            raise LogError(f"{path}: no column", usually="that.", paste="r [rad/s]", read="docs")
        return SimpleNamespace(path=path)

    def identify(log, vehicle, *, estimator, spacing):
        calls.identified.append(estimator)
        run = example.example_run(200, verdict="not_excited")
        run.log.path = str(log.path)
        return run

    fakes = {
        "similitude.vehicle_file": SimpleNamespace(read_vehicle=read_vehicle, NEW_VEHICLE="L = 1\n"),
        "similitude.log": SimpleNamespace(read_log=read_log),
        "similitude.identification": SimpleNamespace(identify=identify),
    }
    for name, fake in fakes.items():
        monkeypatch.setitem(sys.modules, name, fake)
    monkeypatch.chdir(tmp_path)
    Path("car.toml").write_text("")
    return calls


def _run(capsys, *words):
    before = signal.getsignal(signal.SIGTERM)
    try:
        with pytest.raises(SystemExit) as left:
            main(words)
    finally:
        signal.signal(signal.SIGTERM, before)
    out, err = capsys.readouterr()
    return left.value.code, out, err


def _files(folder="."):
    return {str(p.relative_to(folder)) for p in Path(folder).rglob("*") if p.is_file()}


def test_a_run_ends_with_0_whatever_the_verdict_and_says_where_the_files_are(core, capsys):
    code, out, err = _run(capsys, "identify", "a/drive.csv", "--vehicle", "car.toml")
    assert (code, err) == (0, "")
    assert "not excited" in out
    assert "similitude-out/drive/plot.png" in out
    assert {Path(name).name for name in _files("similitude-out/drive")} == OURS
    assert core.identified == ["population"]


def test_json_prints_one_object_a_log_and_nothing_else(core, capsys):
    code, out, err = _run(
        capsys, "identify", "a.csv", "b.csv", "--vehicle", "car.toml", "--json", "--out", "res"
    )
    assert (code, err) == (0, "")
    records = [json.loads(line) for line in out.splitlines()]
    assert [record["log"] for record in records] == ["a.csv", "b.csv"]
    for stem, record in zip("ab", records, strict=True):
        assert json.loads(Path(f"res/{stem}/summary.json").read_text("utf-8")) == record
        assert {Path(path) for path in record["files"].values()} == {Path("res", stem, name) for name in OURS}


def test_one_bad_log_does_not_stop_the_others(core, capsys):
    code, out, err = _run(capsys, "identify", "a.csv", "bad.csv", "c.csv", "--vehicle", "car.toml", "--json")
    assert code == 3
    assert [json.loads(line)["log"] for line in out.splitlines()] == ["a.csv", "c.csv"]
    assert err.startswith("LogError: bad.csv")
    assert len(err.splitlines()) == 4
    assert {path.name for path in Path("similitude-out").iterdir()} == {"a", "c"}


def test_a_bad_vehicle_file_is_a_bad_input_and_no_log_is_read(core, capsys):
    Path("bad.toml").write_text("")
    code, out, err = _run(capsys, "identify", "a.csv", "--vehicle", "bad.toml")
    assert (code, out) == (3, "")
    assert err.startswith("VehicleError: b = -1 m")
    assert core.read == []


def test_options_reach_the_core(core, capsys):
    words = ["--map", "delta=SWA", "--map", "r = yaw [deg/s]", "--estimator", "paper"]
    _run(capsys, "identify", "a.csv", "--vehicle", "car.toml", *words)
    assert core.read == [("a.csv", "car", {"delta": "SWA", "r": "yaw [deg/s]"})]
    assert core.identified == ["paper"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ["a.csv"],
            "echo 'L = \"2.69 m\"' > car.toml && similitude identify a.csv --vehicle car.toml",
        ),
        (["my drive.csv"], "similitude identify 'my drive.csv' --vehicle"),
        (["a.csv", "--vehicle", "none.toml"], "similitude vehicle --new > none.toml"),
        (
            ["a.csv", "--vehicle", "car.toml", "--estimator", "bond"],
            "robust and output_error and band and paper",
        ),
        (["a.csv", "--vehicle", "car.toml", "--estimator", "papr"], "--estimator paper"),
        (["a.csv", "--vehicle", "car.toml", "--map", "delta"], "--map 'delta'"),
        (["a.csv", "--vehicle", "car.toml", "--map", "=x"], "--map '=x'"),
        (["a.csv", "--vehicle", "car.toml", "--map", "r=x", "--map", "r=y"], "'x' and 'y'"),
        (["a.csv", "--vehicle", "car.toml", "--out", "car.toml"], "--out 'car.toml' is a file"),
    ],
)
def test_wrong_usage_ends_with_2_before_any_log_is_read(core, capsys, words, said):
    code, out, err = _run(capsys, "identify", *words)
    assert (code, out) == (2, "")
    assert err.startswith("UsageError: ")
    assert [line.split()[0] for line in err.splitlines()[1:]] == ["Usually", "Paste:", "Read:"]
    assert said in err
    assert core.read == []
    assert _files() == {"car.toml"}


@pytest.mark.parametrize("name", ["band", "output_error", "robust"])
def test_every_rung_of_the_ladder_is_reached(core, capsys, name):
    code, _, _ = _run(capsys, "identify", "a.csv", "--vehicle", "car.toml", "--estimator", name)
    assert code == 0 and core.identified == [name]


def test_an_unknown_option_or_no_log_at_all_ends_with_2(core, capsys):
    assert _run(capsys, "identify", "--nonsense")[0] == 2
    assert _run(capsys, "identify")[0] == 2
    assert _run(capsys, "nonsense")[0] == 2


def test_results_that_cannot_be_written_end_with_2_and_the_next_log_is_tried(core, capsys):
    Path("res").mkdir()
    Path("res/a").write_text("in the way")
    words = ["a.csv", "b.csv", "--vehicle", "car.toml", "--out", "res"]
    code, _, err = _run(capsys, "identify", *words)
    assert code == 2
    assert "res/a" in err
    assert {Path(name).name for name in _files("res/b")} == OURS


def test_vehicle_new_prints_the_template_and_only_that(core, capsys):
    assert _run(capsys, "vehicle", "--new") == (0, "L = 1\n", "")
    code, out, err = _run(capsys, "vehicle")
    assert (code, out) == (2, "")
    assert "similitude vehicle --new > car.toml" in err


def test_version_is_one_line(capsys):
    code, out, _ = _run(capsys, "--version")
    assert code == 0
    assert out.startswith("similitude")
    assert len(out.splitlines()) == 1


def _python(code, **options):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    return subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(code)], env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options,
    )  # fmt: skip


@pytest.mark.parametrize("words", [["--help"], ["identify", "--help"], ["--version"], ["identify", "a"]])
def test_help_and_wrong_usage_load_nothing_heavy(words):
    process = _python(f"""
        import sys
        from similitude.cli import main
        try:
            main({words!r})
        except SystemExit:
            pass
        heavy = ["numpy", "sympy", "pint", "matplotlib", "scipy", "pyarrow"]
        print("loaded:", [name for name in heavy if name in sys.modules])
        """)
    assert process.communicate()[0].splitlines()[-1] == "loaded: []"


def test_the_report_loads_neither_pyplot_nor_symbolic_algebra():
    process = _python("""
        import sys, similitude.report.files, similitude.report.terminal
        heavy = ["matplotlib.pyplot", "sympy", "pint", "scipy", "pandas"]
        print([name for name in heavy if name in sys.modules])
        """)
    assert process.communicate()[0].strip() == "[]"


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("killed_by", [signal.SIGTERM, signal.SIGINT])
def test_a_run_that_is_stopped_while_writing_leaves_nothing(tmp_path, killed_by):
    process = _python(
        f"""
        import signal, sys, time
        from types import SimpleNamespace as Fake
        signal.signal(signal.SIGINT, signal.default_int_handler)  # which what runs behind a shell ignores
        sys.path.insert(0, {str(HERE / "report")!r})
        from example_run import example_run
        def slow(run, path):
            open(path, "w").write("half")
            print("writing", flush=True)
            time.sleep(30)
        sys.modules["similitude.vehicle_file"] = Fake(read_vehicle=lambda path: Fake(name="car"))
        sys.modules["similitude.log"] = Fake(read_log=lambda path, **more: path)
        sys.modules["similitude.identification"] = Fake(identify=lambda log, car, **more: example_run(100))
        import similitude.report.files
        similitude.report.files.save_plot = slow
        from similitude.cli import main
        main(["identify", "a.csv", "--vehicle", "car.toml", "--out", "res/deep"])
        """,
        cwd=tmp_path,
    )
    (tmp_path / "car.toml").write_text("")
    assert process.stdout.readline().strip() == "writing"
    start = time.monotonic()
    process.send_signal(killed_by)
    process.communicate(timeout=20)
    assert time.monotonic() - start < 20
    assert process.returncode != 0
    assert {path.name for path in tmp_path.iterdir()} == {"car.toml"}


def test_repairs_are_handed_on_listed_and_checked(core, capsys):
    Path("a.csv").write_text("")
    words = ("identify", "a.csv", "--vehicle", "car.toml", "--fix", "sort_time", "--fix", "drop_spikes")

    assert _run(capsys, *words)[0] == 0
    assert core.fixes == [("sort_time", "drop_spikes")]
    code, out, _ = _run(capsys, "identify", "--fix", "list")
    assert code == 0
    assert "flip_steer_sign " in out
    code, _, err = _run(capsys, *words, "--fix", "sort_tims")
    assert code == 2
    assert "--fix sort_time" in err
