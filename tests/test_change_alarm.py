"""Alarms over a log: their record, and a log told in two parts."""

from dataclasses import replace

import numpy as np

from similitude.change_alarm import KINDS, watch
from similitude.program.library import shipped

from .montecarlo.alarms import passes
from .montecarlo.road import road


def halved(lateral=0.8):
    cars = road(
        81, cars=1, kind="highway", duration=80.0, events=False, changes=((60.0, 0.5),), lateral=lateral
    )
    return next(passes(cars))


def test_an_alarm_is_a_record_as_the_json_has_it():
    (alarm,) = watch(halved()).alarms
    record = alarm.record

    assert set(record) == {"t", "onset", "kind", "change", "std", "lo", "hi"}
    assert record["kind"] in KINDS.values() and record["onset"] < record["t"]
    assert -1 < record["lo"] < record["change"] < record["hi"] < 0


def test_the_state_taken_up_is_the_state_left():
    done = halved()
    whole = watch(done)
    half = 4321
    first = type(done)(done.setup, done.config, done.state, done.outputs[:half], done.status[:half])
    parts = []
    library = shipped("bicycle_monitor")
    state = None
    for rows in (slice(0, half), slice(half, None)):
        log = done.setup.log
        part = replace(log, **{n: getattr(log, n)[rows] for n in ("t", "delta", "r", "U")})
        step = None if state is None else float(log.t[half] - log.t[half - 1])
        setup = replace(done.setup, log=part, first_step=step)
        one = type(done)(setup, done.config, done.state, done.outputs[rows], done.status[rows])
        seen = watch(one, state)
        state = seen.state
        parts.append(seen)
    assert first.outputs.shape[0] == half
    assert np.array_equal(np.concatenate([p.reference for p in parts]), whole.reference)
    assert np.array_equal(state, whole.state) and len(state) == len(library.names("state"))
    assert parts[0].alarms + parts[1].alarms == whole.alarms


def test_the_share_of_the_log_in_which_a_change_would_be_found_is_a_share():
    seen = watch(halved())

    assert 0.2 < seen.armed_share < 1
    assert not seen.armed[:1000].any()  # twenty seconds of listening first
    assert (seen.evidence >= 0).all()
