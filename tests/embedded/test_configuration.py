"""Numbers of an export: from the vehicle file, the user's CONFIG, or a reference car that is named."""

import numpy as np
import pytest

from similitude.embedded.configuration import REFERENCE_L, find_numbers
from similitude.embedded.folder import export
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.verify import verify_folder
from similitude.errors import UsageError

from ..small_systems import spring

FILE = """\
from similitude.groups import reparameterize
{model}
CONFIG = {config}
"""
NAMES = [(system, estimator) for system, all_of in SHIPPED.items() for estimator in all_of]


@pytest.mark.parametrize(("system", "estimator"), NAMES)
def test_every_shipped_estimator_has_numbers_and_says_where_from(system, estimator):
    numbers = find_numbers(find_source(system, estimator), vehicle=None, sample_time=None)

    assert np.isfinite(numbers.values).all()
    assert numbers.assumed["L"][0] == REFERENCE_L
    assert all("reference" in origin or "population" in origin for _, _, origin in numbers.assumed.values())


def test_a_vehicle_file_replaces_the_reference(tmp_path):
    path = tmp_path / "car.toml"
    path.write_text('L = "2.5 m"\n[sensor]\nyaw_rate_noise = "0.2 deg/s"\n')
    numbers = find_numbers(find_source("bicycle", "paper"), vehicle=path, sample_time=0.02)

    assert numbers.assumed["L"] == (2.5, "m", "vehicle file car.toml")
    assert numbers.assumed["sample_time"][2] == "--sample-time"


def spring_file(tmp_path, config):
    """A file of the spring of small_systems, as a user would write it."""
    path = tmp_path / "spring.py"
    path.write_text(
        f"import pathlib\nfrom tests.small_systems import spring\nREDUCTION = spring().reduction\nCONFIG = {config!r}\n"
    )
    return path


def spring_config():
    case = spring()
    prior = np.array([case.prior[u.name] for u in case.reduction.unknowns])
    config = {name: case.truth[name] for name in ("m", "reach", "tau")}
    config |= {
        "stiffness_prior": 1.0, "damping_prior": 0.6, "P_prior": [float(prior[0, 1] ** 2), 0.0, float(prior[1, 1] ** 2)],
        "prior_information": 1 / 0.09, "stiffness_low": 0.1, "stiffness_high": 1.9, "damping_low": 0.25,
        "damping_high": 1.5, "input_scale_sd": 1e-3, "input_scale_low": 0.9, "input_scale_high": 1.1,
        "x_star_sd": 1.0, "v_star_sd": 1.0, "noise_variance": 4e-8, "input_limit": 200.0, "output_limit": 1.0,
        "signal_limit": 1.0, "validity_limit": 1.0, "input_offset_sd": 2e-3, "output_bias_sd": 2e-4,
        "bias_drift": 0.0, "disturbance_floor": 2e-3,
    }  # fmt: skip
    return config


def test_a_system_of_the_users_own_is_exported_and_passes(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(__import__("pathlib").Path(__file__).parents[2]))
    path = spring_file(tmp_path, spring_config())
    done = export(str(path), estimator="population", real="float", target="host", out=tmp_path / "firmware")

    assert done.name == "spring_population"
    assert "that of a car" in done.numbers.assumed["gap"][2]
    assert verify_folder(done.folder).words > 1000


def test_open_numbers_are_listed_with_their_units(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(__import__("pathlib").Path(__file__).parents[2]))
    config = spring_config()
    del config["tau"], config["disturbance_floor"]
    source = find_source(str(spring_file(tmp_path, config)), "population")
    with pytest.raises(UsageError, match="leaves 2 numbers of spring_population open") as caught:
        find_numbers(source, vehicle=None, sample_time=None)
    assert "'tau': ...,  # [s] a time to measure by" in caught.value.what
