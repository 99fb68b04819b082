"""The posterior Cramér-Rao bound for a K that is taken to drift: the filter's own recursion along the truth.

A filter whose prior mean is the true car, fed the car's exact response, stays where it is; its covariance is
then the bound's recursion (Tichavsky, Muravchik, Nehorai 1998), with the filter's unknowns and drift, a gyro
whose noise is known, and nothing else wrong. Before the step for the car as it was,
after it for what it became.
"""

from dataclasses import replace

import numpy as np

from similitude.filter_run import LINEAR, population_setup
from similitude.program.library import shipped
from similitude.simulate import bicycle_response

from .experiment import NOISE, drawn_prior, log_of_car

DRIFT = 1e-3  # 1/s, of ln K
FIXED = {"drift": DRIFT, "jump_drift": 0.0}
NOTHING_WRONG = {
    "structure_share": 0.0,
    "timing_error": 0.0,
    "noise_adapt": 1e-9,
    "noise_scale_low": 1.0,
    "noise_scale_high": 1.0,
    "excitation_ratio": 0.0,
    "disturbance_floor": 1e-9,
    "disturbance_share": 0.0,
    "disturbance_scale_low": 1e-6,
    "seldom": 0.0,
}


def rms_and_bound(cars, *, step=60.0):
    """rms of ln K of the filter with that drift and of the bound, (cars,) each, in the judged windows."""
    t = cars.t
    before, end = (t >= step - 20) & (t < step), t > t[-1] - 20
    found = [(_rms(cars, i, before | end), _bound(cars, i, before, end)) for i in range(len(cars.L))]
    return np.array(found).T


def setup_of(cars, i, **changed):
    """A filter with linear tyres for one car of the fleet."""
    made = population_setup(
        log_of_car(cars, i), drawn_prior(), L=cars.L[i], noise_std=NOISE, input_scale_sd=0.02
    )
    return replace(made, library=shipped(LINEAR), **changed)


def _rms(cars, i, window):
    done = setup_of(cars, i).run(**FIXED)
    return np.sqrt(np.mean(np.log(done.output("estimate") / cars.K[i])[window] ** 2))


def _bound(cars, i, before, end):
    as_it_was, as_it_became = (_variance(cars, i, factor) for factor in (1.0, cars.K[i, -1] / cars.K[i, 0]))
    return np.sqrt((as_it_was[before].mean() + as_it_became[end].mean()) / 2)


def _variance(cars, i, factor):
    true = cars.unknowns(i)
    true["K"] *= factor
    r, _ = bicycle_response(cars.t, cars.steer[i], cars.U[i], L=cars.L[i], **true)
    mean = np.array([true[name] for name in ("K", "pi1", "eta", "rho")])
    setup = setup_of(cars, i, prior=replace(drawn_prior(), mean=mean), log=replace(log_of_car(cars, i), r=r))
    done = setup.run(**FIXED, **NOTHING_WRONG)
    # it rests: what little it moves is the difference between its step and the exact response
    assert np.abs(np.log(done.output("estimate") / true["K"])).max() < 0.01
    return done.output("own_variance")
