"""From one drive to the next: going on is as if never stopped; a pause makes less sure."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.drive_memory import PARKED, made_for, take_up
from similitude.filter_run import population_setup
from similitude.identification import identify
from similitude.saved_state import StateError, read_state, write_state
from similitude.units import Uncertain

from .filter_rig import CAR, NOISE
from .simulated_drive import drive, metres, vehicle

LAG = 0.023  # s


def known(**more):
    return vehicle(
        yaw_rate_noise=Uncertain(NOISE, None, "rad/s"), steer_lag=Uncertain(LAG, None, "s"), **more
    )


@pytest.fixture(scope="module")
def log():
    return drive(seconds=50, rms=0.006, lag=LAG, seed=3)


def part(log, rows):
    return replace(log, **{name: getattr(log, name)[rows] for name in ("t", "delta", "r", "U")})


@pytest.fixture(scope="module")
def first(log):
    return identify(part(log, slice(0, 2777)), known())


def test_going_on_is_as_if_never_stopped_bit_for_bit(log, first, tmp_path):
    whole = identify(log, known())
    write_state(first.memory, tmp_path / "s.json")
    second = identify(part(log, slice(2777, None)), known(), state=read_state(tmp_path / "s.json"))

    for name in ("K", "ln_K_std", "r_predicted", "innovation", "innovation_std", "information"):
        together = np.concatenate([getattr(first.trace, name), getattr(second.trace, name)])
        assert together.tobytes() == getattr(whole.trace, name).tobytes(), name
    assert second.memory.filter == whole.memory.filter
    assert second.memory.monitor == whole.memory.monitor
    assert second.alarms == whole.alarms == ()
    assert "goes on" in second.assumed["start"].origin


def variance_of_K(memory, log):
    return variance(memory, log, "K")


def variance(memory, log, name):
    setup = population_setup(log, CAR, L=2.65, noise_std=NOISE, input_scale_sd=0.02)
    at = setup.library.index("state", "P")
    names = list(setup.library.layout.COORDINATES)
    i = names.index(name)
    return memory[at + i * len(names) - i * (i - 1) // 2]


def later(log, seconds):
    return replace(log, t=log.t + seconds)


def taken(first, log):
    run = identify(log, known(), state=first.memory)
    return run


def test_a_pause_makes_less_sure_and_a_longer_one_even_less(first, log):
    after = []
    for pause in (100.0, 2 * PARKED, 30 * 86400.0):
        setup = population_setup(later(log, pause), CAR, L=2.65, noise_std=NOISE, input_scale_sd=0.02)
        up = take_up(replace(first.memory, made_for=made_for(known(), setup)), known(), setup)
        assert not up.continues and up.elapsed == pytest.approx(pause + log.t[0] - first.log.t[-1])
        after.append(variance_of_K(up.filter, log))

    assert variance_of_K(first.memory.filter, log) < after[0] < after[1] < after[2]
    assert after[2] <= CAR.covariance[0, 0]


def test_no_drive_hands_on_a_slow_group_surer_than_half_the_population(first, log):
    learnt = list(first.memory.filter)
    setup = population_setup(later(log, 3600.0), CAR, L=2.65, noise_std=NOISE, input_scale_sd=0.02)
    for name in ("pi1", "eta", "rho"):
        at = next(i for i, x in enumerate(learnt) if x == variance(first.memory.filter, log, name))
        learnt[at] = 1e-8
    sure = replace(first.memory, filter=learnt, made_for=made_for(known(), setup))
    up = take_up(sure, known(), setup)
    for name, std in zip(CAR.names[1:], CAR.std[1:], strict=True):
        assert variance(up.filter, log, name) == pytest.approx((0.5 * std) ** 2)


def test_where_no_clock_tells_a_day_is_assumed_and_said(first, log):
    run = taken(first, replace(log, t=log.t - log.t[0]))

    assert run.assumed["start"].value is None and "a day" in run.assumed["start"].origin
    assert run.time_scales["tyre"]["drives"] == 2
    assert run.K.std < identify(log, known()).trace.ln_K_std[0] * run.K.value


def test_the_next_drive_starts_from_what_was_learnt(first, log):
    run = taken(first, later(log, 3600.0))

    assert abs(np.log(run.trace.K[0] / first.K.value)) < 0.1
    assert first.trace.ln_K_std[-1] < run.trace.ln_K_std[0] < 0.5 * first.trace.ln_K_std[0]


@pytest.mark.parametrize(
    "other",
    [
        {"L": metres(2.9)},
        {"name": "another car"},
        {"steering_ratio": Uncertain(15.0, None, "-")},
        {"a": metres(1.2)},
    ],
)
def test_another_vehicles_state_is_refused(first, log, other):
    car = replace(known(), **other)

    with pytest.raises(StateError) as caught:
        identify(later(log, 60.0), car, state=first.memory)
    assert "was saved for" in caught.value.what and caught.value.paste and caught.value.read


@pytest.mark.parametrize("name", ["program", "monitor program", "units", "estimator"])
def test_another_programs_state_is_refused(first, log, name):
    old = replace(first.memory, made_for={**first.memory.made_for, name: "older"})

    with pytest.raises(StateError, match=name):
        identify(later(log, 60.0), known(), state=old)


def test_a_state_saved_after_the_log_is_refused(first, log):
    epoch = 1.7e9
    ahead = replace(first.memory, clock=epoch + 1000.0)

    with pytest.raises(StateError, match="before that"):
        identify(later(log, epoch), known(), state=ahead)


def test_a_state_of_another_size_is_refused(first, log):
    with pytest.raises(StateError, match="reals"):
        identify(later(log, 60.0), known(), state=replace(first.memory, filter=first.memory.filter[:-1]))
