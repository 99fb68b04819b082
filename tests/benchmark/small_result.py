"""A result of the benchmark made without a drive."""

import math

import numpy as np

from similitude.benchmark.running import Result
from similitude.benchmark.scoring import Score
from similitude.benchmark.tally import tally


def small_result():
    """Two estimators on two cells; one never finds the change."""
    rows, totals = [], []
    for name, found in (("population", 1.0), ("<b>mine</b>", math.inf)):
        one = Score(
            "", rms=0.05, bias=-0.01, coverage=0.97, half_way=found, found=found, hours=0.1,
            identified=True, largest=0.1, late=np.full(60, 2.0), seconds=1.0, rows=8000,
            step_seconds=0.008, operations=10,
        )  # fmt: skip
        row = tally([one], 0.2)
        totals.append({"estimator": name, "threshold": 0.2, "sound_hours": 1.0, "faults": [], **row})
        rows += [
            {"manoeuvre": "slalom", "plant": "linear", "fault": fault, "estimator": name, **row}
            for fault in ("none", "bias")
        ]
    record = {
        "schema": 1, "seed": 1, "quick": True, "seconds": 1.0, "processes": 2, "foreign": None,
        "notes": ["left out"], "false_per_hour": 1.0, "cells": 2, "drives": 2, "seeds": [1],
        "about": {"population": "ours"}, "totals": totals, "rows": rows,
    }  # fmt: skip
    return Result(record)
