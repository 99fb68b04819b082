"""What is stated is what is known; a table moves along with it."""

import numpy as np
import pytest

from similitude import shipped_system
from similitude.any_model.knowledge import gather_knowledge
from similitude.errors import SimilitudeError, UnitError, UsageError
from similitude.groups import reparameterize
from similitude.populations.population import populate
from similitude.populations.table import PopulationTable

MOTOR = shipped_system("dc_motor")


def known(**more):
    return gather_knowledge(MOTOR.model, values=MOTOR.numbers(), **more)


def test_percent_and_absolute_spread_are_the_same():
    one, two = (known(prior={"J": text}) for text in ("0.01 kg m^2 +- 30 %", "0.01 +- 0.003 kg m^2"))

    assert one.uncertain == two.uncertain == ("J",)
    np.testing.assert_allclose(one.covariance, two.covariance, rtol=1e-12)
    assert one.origins["J"] == "stated" and "exact" in one.origins["R"]


def test_units_of_the_text_do_not_matter():
    assert known(prior={"J": "100 kg cm^2 +- 30 %"}).values["J"] == pytest.approx(0.01, rel=1e-12)


def test_a_negative_value_keeps_its_sign():
    aircraft = shipped_system("aircraft_short_period")
    found = gather_knowledge(aircraft.model, values=aircraft.numbers(), prior={"Cma": "-0.7 1/rad +- 20 %"})

    assert found.values["Cma"] == pytest.approx(-0.7)
    assert (found.draw(50, seed=1)["Cma"] < 0).all()


def test_a_stated_value_moves_what_the_table_ties_to_it():
    rng = np.random.default_rng(0)
    size = rng.normal(0, 0.5, 200)
    value = np.exp(np.column_stack([size, 2 * size + 0.05 * rng.standard_normal(200)]))
    groups = reparameterize(MOTOR.model, base=MOTOR.base)
    table = PopulationTable(
        "motors", MOTOR.model, ({"J": 1}, {"b": 1}), value, np.full((200, 2), np.nan), np.ones(200),
        tuple("r" * 200), tuple("s" * 200),
    )  # fmt: skip
    population = populate(groups, table)
    free, told = (known(population=population, prior=p) for p in (None, {"J": "2 kg m^2"}))

    assert set(free.uncertain) == {"J", "b"} and told.uncertain == ("b",)
    assert told.values["b"] == pytest.approx(4, rel=0.1)  # b goes with the square of J
    i = told.names.index("b")
    # the covariance of 200 rows is drawn towards its diagonal by a few of them
    assert told.covariance[i, i] < 0.1 * free.covariance[i, i]


@pytest.mark.parametrize(
    ("prior", "kind", "said"),
    [
        ({"X": "1 m"}, UsageError, "'X', which is no free parameter"),
        ({"J": "0.01 m +- 10 %"}, UnitError, "prior of 'J'"),
        ({"J": "0 kg m^2"}, UsageError, "does not say its sign"),
        ({"J": "0.01 kg m^2 +- 400 %"}, UsageError, "within a factor"),
        ({"J": 0.01}, SimilitudeError, "J"),
    ],
)
def test_what_cannot_be_known_is_refused_with_its_name(prior, kind, said):
    with pytest.raises(kind, match=said):
        known(prior=prior)


def test_nothing_is_assumed_of_a_parameter_nobody_stated():
    with pytest.raises(UsageError, match="nothing is known of parameter 'R'"):
        gather_knowledge(MOTOR.model, values={})
