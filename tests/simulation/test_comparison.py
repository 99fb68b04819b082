"""An estimate against the truth: the numbers of a made-up pair, and what is refused."""

import numpy as np
import pytest

from similitude.errors import LogError, UsageError
from similitude.simulation.comparison import compare
from similitude.simulation.recording_files import write_table

T = np.arange(0, 100, 0.1)


@pytest.fixture
def pair(tmp_path):
    """K 100, 50 from 60 s on; the estimate is 10 % high and follows 2 s late; its interval is ± 20 %."""
    K = np.where(T >= 60, 50.0, 100.0)
    estimate = 1.1 * np.where(T >= 62, 50.0, 100.0)
    (tmp_path / "out").mkdir()
    write_table({"t [s]": T, "K [m^2/s^2]": K}, tmp_path / "truth.csv", suffix=".csv")
    write_table(
        {"t [s]": T + 0.01, "K [m^2/s^2]": estimate, "K_lo [m^2/s^2]": estimate * 0.8,
         "K_hi [m^2/s^2]": estimate * 1.2},
        tmp_path / "out" / "estimate.parquet", suffix=".parquet")  # fmt: skip
    return tmp_path


def test_error_coverage_and_delay(pair):
    found = compare(pair / "out", pair / "truth.csv")
    assert found.rms_end == pytest.approx(np.log(1.1)) and found.bias_end == pytest.approx(np.log(1.1))
    rows = np.count_nonzero(T > 10)
    off = 20 / rows  # two seconds of ten rows
    assert found.coverage == pytest.approx(1 - off, abs=2 / rows)
    assert found.rms == pytest.approx(
        np.sqrt((1 - off) * np.log(1.1) ** 2 + off * np.log(2.2) ** 2), rel=0.02
    )
    assert (found.truth_end, found.estimate_end) == (50, pytest.approx(55))
    (change,) = found.changes
    assert change.t == pytest.approx(60, abs=0.02) and (change.before, change.after) == (100, 50)
    assert change.half_way == pytest.approx(2.0, abs=0.11)


def test_a_change_that_is_never_followed(pair):
    write_table({"t [s]": T, "K [m^2/s^2]": np.where(T >= 60, 20.0, 100.0)}, pair / "deep.csv", suffix=".csv")
    assert compare(pair / "out", pair / "deep.csv").changes[0].half_way == pytest.approx(2.0, abs=0.11)
    write_table({"t [s]": T, "K [m^2/s^2]": np.where(T >= 60, 300.0, 100.0)}, pair / "up.csv", suffix=".csv")
    assert compare(pair / "out", pair / "up.csv").changes[0].half_way is None


def test_what_cannot_be_compared_is_refused(pair):
    with pytest.raises(UsageError, match="no file"):
        compare(pair, pair / "truth.csv")
    with pytest.raises(LogError, match="K_lo"):
        compare(pair / "truth.csv", pair / "truth.csv")
    write_table({"t [s]": T + 500, "K [m^2/s^2]": T}, pair / "late.csv", suffix=".csv")
    with pytest.raises(UsageError, match="share no time"):
        compare(pair / "out", pair / "late.csv")
