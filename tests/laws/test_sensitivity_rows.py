"""Laws of invariances over random models: D S = d, exactly and in numbers; after rewriting, nothing."""

import dataclasses

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from similitude.errors import ModelError
from similitude.groups import reparameterize
from similitude.invariance.invariances import invariances
from similitude.invariance.trajectory import trajectory
from similitude.model import Model, mismatches_of
from similitude.rewriting.equivalence import prove_equivalence
from similitude.rewriting.rewritten import rewrite
from similitude.rewriting.scaling import into_groups, out_of_groups

from ..random_models import BASE, models, values_of

CLOSE = 1e-9  # the integrator's 1e-12 of each state's size, over a few steps and a quarter time constant
PHASES = [Phase.explicit, Phase.reuse, Phase.generate]  # an example takes a second; shrinking, an hour
LAWS = settings(deadline=None, max_examples=3, phases=PHASES, suppress_health_check=[HealthCheck.too_slow])
MANY = settings(LAWS, max_examples=15)
FOREIGN = {"kg": "lb", "m": "ft", "s": "min"}


def in_foreign_units(model: Model) -> Model:
    """The same model, its units written in pounds, feet and minutes."""

    def foreign(quantity):
        parts = [part.partition("^") for part in quantity.unit.split()]
        unit = " ".join(FOREIGN.get(name, name) + hat + power for name, hat, power in parts)
        return dataclasses.replace(quantity, unit=unit)

    kinds = {
        k: [foreign(q) for q in getattr(model, k)] for k in ("states", "inputs", "outputs", "parameters")
    }
    return dataclasses.replace(model, **kinds)


def check_rows_of_a_time_response(data):
    model = data.draw(models())
    rows = invariances(model)
    values = data.draw(values_of(model)) | {"t": [0.1, 0.25]}

    assert all(residual == 0 for residual in rows.verify().values())
    assert max(rows.verify(values).values(), default=0.0) < CLOSE


def check_rows_of_linear_responses(data):
    model = data.draw(models(linear=True))
    drawn = data.draw(values_of(model))
    values = {n: v * (1 + k / 97) for k, (n, v) in enumerate(drawn.items())}  # a double pole has no slope
    more = {"frequency": {"s": 1.3j}, "z": {"z": 0.3 + 0.8j, "Ts": 0.1}, "poles": {}, "zeros": {}}
    for kind, at in more.items():
        rows = invariances(model, response=kind)
        given_here = {n: v for n, v in (values | at).items()}
        assert all(residual == 0 for residual in rows.verify().values()), kind
        assert max(rows.verify(given_here).values(), default=0.0) < CLOSE, kind


def check_rewrite_and_back(data):
    model = data.draw(models())
    rewritten = rewrite(model, base=BASE)
    proof = prove_equivalence(rewritten)
    values = data.draw(values_of(model))
    times = np.array([0.0, 0.1, 0.25])

    dimensionless = into_groups(rewritten, {**values, "t": times})
    one = trajectory(model, times, values)
    bare = {n: v for n, v in dimensionless.items() if n != "t"}
    other = trajectory(rewritten.model, dimensionless["t"], bare)
    back = out_of_groups(rewritten, {**bare, **other}, {n: values[n] for n in BASE})

    assert proof.holds and not proof.wrong
    assert mismatches_of(rewritten.back()) == {}
    assert invariances(rewritten.model).rows == ()
    for name, there in {**values, **one}.items():
        size = np.abs(there).max() or 1.0
        assert np.abs(back[name] - there).max() <= CLOSE * size, name


@LAWS
@given(st.data())
def test_rows_of_a_time_response_hold(data):
    check_rows_of_a_time_response(data)


@LAWS
@given(st.data())
def test_rows_of_linear_responses_hold(data):
    check_rows_of_linear_responses(data)


@LAWS
@given(st.data())
def test_rewrite_and_back_is_the_identity(data):
    check_rewrite_and_back(data)


@pytest.mark.slow
@MANY
@given(st.data())
def test_the_same_laws_over_many_models(data):
    check_rows_of_a_time_response(data)
    check_rows_of_linear_responses(data)
    check_rewrite_and_back(data)


@LAWS
@given(st.data())
def test_a_change_of_units_changes_no_group_no_row_and_no_verdict(data):
    model = data.draw(models())
    other = in_foreign_units(model)

    assert reparameterize(other, base=BASE).groups == reparameterize(model, base=BASE).groups
    assert invariances(other).rows == invariances(model).rows
    spoilt = {n: rate * model.parameters[0].symbol for n, rate in model.rates.items()}  # kg too many
    for one in (model, other):
        with pytest.raises(ModelError, match="not homogeneous"):
            dataclasses.replace(one, rates=spoilt)
