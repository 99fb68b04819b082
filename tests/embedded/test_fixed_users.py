"""A system of a user's own in fixed point: numbers of CONFIG, what follows from them, an honest folder."""

import pytest

from similitude.embedded.folder import export
from similitude.embedded.verify import verify_folder
from similitude.errors import UsageError

CAR = """
from similitude.systems.bicycle import bicycle_reduction

REDUCTION = bicycle_reduction()
CONFIG = {
    "L": 2.5, "pi1": 0.45, "pi4_slope": 1.1, "pi5": 0.25,
    "K_start": 120.0, "K_low": 20.0, "K_limit": 5000.0,
    "dead_zone": 0.05, "noise_variance": 4e-6, "settle_samples": 20,
    "U_least": 5.0, "input_limit": 1.0, "output_limit": 3.0, "output_jump": 0.6, "signal_limit": 80.0,
    "validity_limit": 3.0,
}
"""


def test_a_users_system_is_lowered_from_its_own_numbers(tmp_path):
    path = tmp_path / "mine.py"
    path.write_text(CAR)
    done = export(
        str(path), estimator="paper", real="fixed", target="host", out=tmp_path / "out", sample_time=0.005
    )

    assert verify_folder(done.folder).words > 1000
    listed = (done.folder / "bicycle_paper_fixed_config.h").read_text()
    assert "K_start = 120 m^2/s^2" in listed and "sample_time = 0.005 s" in listed
    assert "1 - 2^-14" in listed


def test_what_its_numbers_leave_open_is_named(tmp_path):
    path = tmp_path / "mine.py"
    path.write_text(CAR.replace('"dead_zone": 0.05, ', ""))
    with pytest.raises(UsageError, match="leaves 1 numbers of bicycle_paper_fixed open"):
        export(str(path), estimator="paper", real="fixed", target="host", out=tmp_path / "out")
