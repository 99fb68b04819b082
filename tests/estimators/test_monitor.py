"""The monitor's step program: any system, twin and C alike, finite whatever comes in."""

import types

import numpy as np
import pytest

from similitude.errors import ProgramError
from similitude.estimators.monitor import monitor
from similitude.filter_run import Pass, population_setup
from similitude.monitor_config import monitor_config
from similitude.program.c import print_c
from similitude.program.library import assemble, shipped
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction

from ..filter_rig import CAR, NOISE, car, car_config, twin_of
from ..rough_drive import rough_drive
from ..small_systems import CASES


def bits(array):
    return np.ascontiguousarray(array, dtype=np.float64).view(np.uint64)


def rough_samples(samples, seed):
    """A drive with every fault, as the filter hands it on."""
    filter_, library = car(), shipped("bicycle_monitor")
    config, rows = car_config(filter_), rough_drive(samples, seed)
    outputs, status = filter_.run(config, filter_.start(config), rows)
    at = [filter_.index("output", name) for name in library.names("sample")[5:]]
    return np.column_stack([rows, status.astype(float), outputs[:, at]])


@pytest.mark.parametrize("seed", range(2))
def test_the_twin_gives_the_same_bits(seed):
    library = shipped("bicycle_monitor")
    assert library.c is not None, library.why_slow
    # armed at once and easily rung, so that every branch is taken
    eager = {"heard_least": 0.0, "known_least": 0.0, "hearing_least": 0.0, "validity_limit": 1e3}
    config = monitor_config(library, L=2.7, **eager, threshold_fall=1.0, threshold_rise=1.0)
    rows = rough_samples(12_000, seed)
    states = library.start(config), twin_of(library).start(config)

    ours, theirs = (
        one.run(config, state, rows) for one, state in zip((library, twin_of(library)), states, strict=True)
    )

    assert np.array_equal(bits(ours[0]), bits(theirs[0]))
    assert np.array_equal(ours[1], theirs[1])
    assert np.array_equal(bits(states[0]), bits(states[1]))
    assert (ours[0][:, 0] == 1).any() and (ours[0][:, 0] == 2).any()


def test_whatever_comes_in_every_number_stays_finite():
    library = shipped("bicycle_monitor")
    config, rows = monitor_config(library, L=2.7), rough_samples(20_000, 5)
    rng = np.random.default_rng(3)
    for column in range(4):  # what a logger writes; the rest is the filter's, which is finite
        rows[rng.random(len(rows)) < 0.02, column] = rng.choice([np.nan, np.inf, -np.inf, 0.0, -1e9, 1e300])
    state = library.start(config)

    outputs, _ = library.run(config, state, rows)

    assert np.isfinite(outputs).all() and np.isfinite(state).all()


def test_a_row_whose_time_does_not_advance_changes_nothing():
    library = shipped("bicycle_monitor")
    config, rows = monitor_config(library, L=2.7), rough_samples(500, 6)
    state = library.start(config)
    library.run(config, state, rows)
    before, bad = state.copy(), rows[-1:].copy()
    bad[0, 0] = 0.0

    outputs, status = library.run(config, state, bad)

    assert status[0] == library.layout.STATUS["bad_sample"] and outputs[0, 0] == 0
    assert np.array_equal(bits(state), bits(before))


@pytest.mark.parametrize("name", ["heater", "aircraft"])
def test_another_system_gets_its_monitor_with_no_change_to_the_library(name):
    program = monitor(CASES[name]().reduction)
    layout = types.ModuleType(program.name)
    exec(compile(print_python(program), f"{program.name}.py", "exec"), layout.__dict__)
    library = assemble(layout, print_c(program))
    assert library.c is not None, library.why_slow

    text = " ".join(f"{n} {m}" for t in ("CONFIG", "SAMPLE") for n, _, m, _ in getattr(layout, t))
    assert "steer" not in text and "yaw" not in text


def test_a_change_of_what_may_be_negative_is_no_factor_and_refused():
    with pytest.raises(ProgramError) as caught:
        monitor(CASES["spring"]().reduction)
    assert caught.value.paste and caught.value.read


def test_the_sample_begins_as_the_filters_and_goes_on_with_what_it_hands_out():
    filter_, library = car(), shipped("bicycle_monitor")
    names = library.names("sample")

    assert names[:4] == filter_.names("sample")
    assert set(names[5:]) <= set(filter_.names("output"))
    assert monitor(bicycle_reduction()).name == library.name


def test_a_passes_outputs_and_the_monitors_samples_agree():
    from ..simulated_drive import drive

    log = drive(seconds=5)
    done = population_setup(log, CAR, L=2.65, noise_std=NOISE, input_scale_sd=0.02).run()
    assert isinstance(done, Pass) and np.isfinite(done.output("disturbance_now")).all()
    assert (done.output("noise_now") > 0).all()
