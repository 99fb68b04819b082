"""The monitor's numbers: a threshold for a wanted time between false alarms."""

import pytest

from similitude.errors import UsageError
from similitude.monitor_config import BETWEEN_FALSE_ALARMS, MEASURED, THRESHOLD, monitor_config, threshold_for
from similitude.program.library import shipped


def test_the_threshold_used_is_the_one_for_the_hours_stated():
    assert threshold_for(BETWEEN_FALSE_ALARMS) == pytest.approx(THRESHOLD, abs=1e-9)


def test_longer_between_false_alarms_takes_a_higher_threshold():
    hours = [h for _, h in MEASURED]
    thresholds = [threshold_for(h) for h in hours]

    assert thresholds == sorted(thresholds)
    assert threshold_for((hours[0] + hours[1]) / 2) > thresholds[0]


@pytest.mark.parametrize("hours", [0.01, 1e6, float("nan")])
def test_what_was_not_measured_is_not_promised(hours):
    with pytest.raises(UsageError) as caught:
        threshold_for(hours)
    assert "make alarms" in str(caught.value)


def test_a_change_replaces_a_constant():
    library = shipped("bicycle_monitor")
    config = monitor_config(library, L=2.7, threshold_fall=9.5)

    assert config[library.index("config", "threshold_fall")] == 9.5
    assert config[library.index("config", "L")] == 2.7
