"""`--verify` passes what was exported and finds what was changed since."""

import pytest

from similitude.embedded.folder import export
from similitude.embedded.verify import SelfTestError, verify_folder
from similitude.errors import CompileError, UsageError


@pytest.fixture(scope="module")
def firmware(tmp_path_factory):
    out = tmp_path_factory.mktemp("exported") / "firmware"
    export("bicycle", estimator="band", real="float", target="host", out=out)
    return out


def test_a_fresh_export_passes(firmware):
    done = verify_folder(firmware)

    assert done.name == "bicycle_band" and done.words > 1000


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("bicycle_band_config.h", "2.69e+00f", "2.70e+00f"),
        ("bicycle_band.c", "R(1.0)", "R(1.0000001)"),
        ("bicycle_band.c", "to[i] = bytes[8UL + i];", "to[i] = 0u;"),
    ],
)
def test_one_changed_number_or_operation_is_found(firmware, file, old, new):
    path = firmware / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    try:
        with pytest.raises(SelfTestError, match="words of bicycle_band differ"):
            verify_folder(firmware)
    finally:
        path.write_text(text)


def test_a_file_that_does_not_compile_is_a_compile_error(firmware):
    path = firmware / "bicycle_band.c"
    text = path.read_text()
    path.write_text(text + "int bicycle_band_more(;\n")
    try:
        with pytest.raises(CompileError):
            verify_folder(firmware)
    finally:
        path.write_text(text)


def test_a_folder_of_something_else_is_refused(tmp_path):
    with pytest.raises(UsageError, match=r"evidence\.json"):
        verify_folder(tmp_path)
