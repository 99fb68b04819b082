"""The files of a fixed-point folder: formats in the header, words from the twin, the self-test passes."""

import numpy as np
import pytest

from similitude.embedded.fixed_profile import FIXED, fixed_profile
from similitude.embedded.fixed_texts import expected_words, fixed_texts, integer_rows, self_test_drive
from similitude.embedded.folder import export
from similitude.embedded.verify import verify_folder

PROFILE = fixed_profile("bicycle", "paper")


def test_the_header_tells_format_range_and_step_of_every_field():
    texts, _ = fixed_texts(PROFILE, "0")
    header = texts["bicycle_paper_fixed.h"]

    for f in (*PROFILE.fixed.sample, *PROFILE.fixed.output):
        assert f"BICYCLE_PAPER_FIXED_{f.name.upper()}_BITS = {f.format.fraction}" in header
        assert f"int32_t {f.name};" in header
    assert "in steps of" in header and "[m/s] Q" in header
    assert "float" not in texts["bicycle_paper_fixed.c"] and "double" not in texts["bicycle_paper_fixed.c"]


def test_values_become_words_and_what_is_missing_is_marked():
    rows = np.array([[0.01, 0.1, 20.0, np.nan], [1e9, -1e30, np.inf, 0.5]])
    found = integer_rows(PROFILE, rows)
    steps = [f.format.step for f in PROFILE.fixed.sample]

    assert found[0, :3] * steps[:3] == pytest.approx(rows[0, :3], abs=1e-6)
    assert found[0, 3] == found[1, 2] == -(2**31)
    assert found[1, 0] == 2**31 - 1 and found[1, 1] == -(2**31)


def test_an_exported_folder_passes_its_self_test(tmp_path):
    out = tmp_path / "firmware"
    done = export("bicycle", estimator="paper", real="fixed", target="host", out=out)
    verified = verify_folder(out)

    assert verified.words > 1000
    assert done.name == "bicycle_paper_fixed"
    page = (out / "README.md").read_text()
    assert "BICYCLE_PAPER_FIXED_MISSING" in page and "NaN" not in page


@pytest.mark.parametrize("name", FIXED)
def test_the_self_test_learns_and_meets_every_fault(name):
    profile = fixed_profile("bicycle", name)
    status = expected_words(profile, integer_rows(profile, self_test_drive(profile))).status
    learnt = np.isin(status, [0, 2])  # ok, or used outside the linear range

    assert learnt.sum() > 30
    assert {1, 4, 5, 7} <= set(status.tolist())
