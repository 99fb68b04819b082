"""Numbers of an export: from the vehicle file, the user's CONFIG, or a reference car that is named."""

import re
from pathlib import Path

import numpy as np
import pytest

from similitude.embedded.configuration import REFERENCE_L, find_numbers
from similitude.embedded.folder import export
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.verify import verify_folder
from similitude.errors import UsageError

PAGE = Path(__file__).parents[2] / "docs" / "embedded.md"
NAMES = [(system, estimator) for system, all_of in SHIPPED.items() for estimator in all_of]


@pytest.mark.parametrize(("system", "estimator"), NAMES)
def test_every_shipped_estimator_has_numbers_and_says_where_from(system, estimator):
    numbers = find_numbers(find_source(system, estimator), vehicle=None, sample_time=None)

    assert np.isfinite(numbers.values).all()
    assert numbers.assumed["L"][0] == REFERENCE_L
    assert all(
        any(w in origin for w in ("reference", "population", "average"))
        for _, _, origin in numbers.assumed.values()
    )


def test_a_vehicle_file_replaces_the_reference(tmp_path):
    path = tmp_path / "car.toml"
    path.write_text('L = "2.5 m"\n[sensor]\nyaw_rate_noise = "0.2 deg/s"\n')
    numbers = find_numbers(find_source("bicycle", "paper"), vehicle=path, sample_time=0.02)

    assert numbers.assumed["L"] == (2.5, "m", "vehicle file car.toml")
    assert numbers.assumed["sample_time"][2] == "--sample-time"


def spring_file(tmp_path, *without):
    """The spring of docs/embedded.md, its CONFIG without some numbers."""
    (text,) = re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.S)
    for name in without:
        text, found = re.subn(rf'"{name}": [^,]+,', "", text)
        assert found == 1
    path = tmp_path / "spring.py"
    path.write_text(text)
    return path


def test_a_system_of_the_users_own_is_exported_and_passes(tmp_path):
    path = spring_file(tmp_path)
    done = export(str(path), estimator="population", real="float", target="host", out=tmp_path / "firmware")

    assert done.name == "spring_population"
    assert "that of a car" in done.numbers.assumed["gap"][2]
    assert verify_folder(done.folder).words > 1000


def test_open_numbers_are_listed_with_their_units(tmp_path):
    source = find_source(str(spring_file(tmp_path, "tau", "bias_drift")), "population")
    with pytest.raises(UsageError, match="leaves 2 numbers of spring_population open") as caught:
        find_numbers(source, vehicle=None, sample_time=None)
    assert "'tau': ...,  # [s] a time to measure by" in caught.value.what
