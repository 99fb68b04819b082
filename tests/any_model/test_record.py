"""The JSON object holds every unknown and parameter, and can be written."""

import json

from similitude.any_model.record import estimate_record

from .gallery import made


def test_a_record_is_strict_json_with_all_unknowns():
    estimator = made("rlc_circuit")
    record = estimate_record(estimator, estimator.run(estimator.simulate(seed=2)), "log.csv")

    again = json.loads(json.dumps(record, allow_nan=False))
    assert again["unknowns"].keys() == {"pi1"} and again["parameters"].keys() == {"R"}
    assert again["verdict"] == "identified" and again["estimator"] == "regression"
    assert again["parameters"]["R"]["lo"] < again["parameters"]["R"]["value"] < again["parameters"]["R"]["hi"]
