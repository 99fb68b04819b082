"""The loss of a relation is the change of the output when it is imposed."""

import dataclasses

import numpy as np
import pytest

from similitude.output_sensitivity import sampled_response
from similitude.populations.output_loss import _groups_as_unknowns, output_losses
from similitude.populations.population import populate
from similitude.populations.relations import relate
from similitude.systems.bicycle import bicycle_groups

from .drawn import planted, table_of

GROUPS = bicycle_groups()
SCALES = {"m": 1500.0, "L": 2.7, "U": 25.0}
STEER = 0.01 * np.sin(2 * np.pi * 0.5 * np.arange(0, 6, 0.01))


def test_the_loss_is_the_rms_change_of_the_output():
    population = populate(GROUPS, table_of(planted(80, 0)), at={"U": 25.0})
    one = output_losses(relate(population), population, STEER, 0.01, scales=SCALES).of("pi3", "pi4")
    mean = dict(zip(population.names, np.exp(population.group_moments[0]), strict=True))
    respond = sampled_response(_groups_as_unknowns(GROUPS), SCALES, STEER, 0.01)
    y = respond(mean)
    off = respond({**mean, "pi4": mean["pi4"] * np.exp(one.scatter)})

    assert one.loss == pytest.approx(np.sqrt(np.mean((off - y) ** 2) / np.mean(y**2)), rel=0.05)


def test_constraints_cost_nothing_and_unknown_groups_say_nothing():
    population = populate(GROUPS, table_of(planted(80, 0)), at={"U": 25.0})
    relations = output_losses(relate(population), population, STEER, 0.01, scales=SCALES)
    assert [one.loss for one in relations.constraints] == [0.0]

    short = planted(40, 1)
    short[:, 3] = np.nan
    population = populate(GROUPS, table_of(short))
    plain = relate(population)
    assert output_losses(plain, population, STEER, 0.01, scales=SCALES) is plain
    assert dataclasses.is_dataclass(plain)
