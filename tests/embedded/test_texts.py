"""Numbers in the exported C read back to the same bits."""

import re

import numpy as np
import pytest

from similitude.embedded.configuration import find_numbers
from similitude.embedded.system import find_source
from similitude.embedded.texts import config_text
from similitude.embedded.vectors import TYPES


@pytest.mark.parametrize("real", ["float", "double"])
@pytest.mark.parametrize("estimator", ["paper", "band", "population"])
def test_a_configuration_reads_back_to_its_bits(estimator, real):
    source = find_source("bicycle", estimator)
    numbers = find_numbers(source, vehicle=None, sample_time=None)
    text = config_text(source.library(), numbers, real)
    body = re.sub(r"/\*.*?\*/", "", text.partition("_numbers = {")[2].partition("};")[0])
    values = [TYPES[real](word.rstrip("f")) for word in re.findall(r"-?\d[\d.e+-]*f?", body)]

    assert np.array_equal(values, numbers.values.astype(TYPES[real]))
