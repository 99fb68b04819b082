"""Each log gets a folder of its own."""

from similitude.report.folders import directories


def test_one_log_goes_straight_into_the_folder_named(tmp_path):
    assert [str(p) for p in directories(["a/drive.csv"], "out")] == ["out"]
    assert [p.as_posix() for p in directories(["a/drive.csv"], None)] == ["similitude-out/drive"]


def test_each_of_several_logs_has_a_folder_of_its_own():
    logs = ["a/drive.csv", "b/drive.parquet", "c/Drive.csv", "drive-2.csv", "other.csv"]
    chosen = [path.as_posix() for path in directories(logs, "out")]
    assert chosen == ["out/drive", "out/drive-3", "out/Drive-4", "out/drive-2", "out/other"]
