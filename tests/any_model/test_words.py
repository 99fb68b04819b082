"""What is printed says what was taken, and every unknown with its interval."""

from .gallery import made


def test_an_estimator_says_unknowns_choice_and_what_was_taken():
    said = str(made("dc_motor"))

    assert "2 uncertain parameters (J, b), 2 unknowns" in said
    assert "J*R/K**2" in said and "estimator: population, since" in said and "taken: " in said


def test_an_estimate_says_verdict_and_intervals():
    estimator = made("rlc_circuit")
    said = str(estimator.run(estimator.simulate(seed=2)))

    assert said.startswith("identified: ") and "R " in said and "ohm  95 %" in said
