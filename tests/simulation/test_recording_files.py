"""Files of a drive: what `identify` reads, the same bytes for the same seed, all or nothing."""

import numpy as np
import pyarrow.parquet
import pytest

from similitude.errors import UsageError
from similitude.log import read_log
from similitude.simulation.recording import run_scenario
from similitude.simulation.recording_files import file_names, write_recording
from similitude.simulation.scenario import read_scenario, shipped
from similitude.vehicle_file import read_vehicle

CHANGES = {"run.duration": "5 s", "sensors.r.lost": "0.02", "sensors.U.rate": "20 Hz"}


@pytest.fixture(scope="module")
def recording():
    return run_scenario(read_scenario("slalom", changes=CHANGES), [1])[0]


@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_a_log_is_read_as_it_was_written(recording, tmp_path, suffix):
    files = write_recording(recording, tmp_path / f"drive{suffix}")
    log = read_log(files["log"], vehicle=read_vehicle(files["vehicle"]))

    np.testing.assert_allclose(log.t, recording.log["t [s]"], atol=1e-9)
    np.testing.assert_allclose(log.delta, recording.log["delta [rad]"], rtol=1e-8)
    there = np.isfinite(recording.log["r [rad/s]"])
    np.testing.assert_allclose(log.r[there], recording.log["r [rad/s]"][there], rtol=1e-8)
    assert log.ay is not None and 0 < np.count_nonzero(~there) < 40


def test_the_same_seed_gives_the_same_bytes(recording, tmp_path):
    again = run_scenario(read_scenario("slalom", changes=CHANGES), [1])[0]
    first, second = write_recording(recording, tmp_path / "a.csv"), write_recording(again, tmp_path / "b.csv")
    for kind in first:
        assert open(first[kind], "rb").read() == open(second[kind], "rb").read()


def test_the_truth_stands_beside_the_log_or_where_it_is_wanted(recording, tmp_path):
    files = write_recording(recording, tmp_path / "deep" / "drive.csv", truth=tmp_path / "real.parquet")
    assert files["vehicle"].endswith("deep/drive.toml")
    table = pyarrow.parquet.read_table(files["truth"])
    np.testing.assert_array_equal(table["K [m^2/s^2]"].to_numpy(), recording.truth["K [m^2/s^2]"])
    assert file_names("x/drive.csv")["truth"].name == "drive_truth.csv"
    assert sorted(path.name for path in (tmp_path / "deep").iterdir()) == ["drive.csv", "drive.toml"]


def test_names_that_cannot_be_are_refused(recording, tmp_path):
    for out, truth, says in (
        ("a.txt", None, "--out"),
        ("a.csv", "b.xlsx", "--truth"),
        ("a.csv", "a.csv", "itself"),
    ):
        with pytest.raises(UsageError, match=says):
            write_recording(recording, tmp_path / out, truth=truth and tmp_path / truth)
    (tmp_path / "file").write_text("")
    with pytest.raises(UsageError, match="cannot be written"):
        write_recording(recording, tmp_path / "file" / "drive.csv")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("name", sorted(shipped().keys() - {"multi_body", "drift"}))
def test_a_shipped_scenario_writes_a_log_that_is_read(name, tmp_path):
    scenario = read_scenario(name, changes={"run.duration": "4 s"})
    files = write_recording(run_scenario(scenario, [1])[0], tmp_path / f"{name}.csv")

    log = read_log(files["log"], vehicle=read_vehicle(files["vehicle"]))
    assert log.duration == pytest.approx(4) and np.ptp(log.r) > 0
