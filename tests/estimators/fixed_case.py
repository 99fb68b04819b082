"""A drive and the numbers of a car, for the fixed-point profile's tests."""

import numpy as np

from similitude.embedded.fixed_profile import named_for_sums
from similitude.estimators.fixed_ranges import Names, paper_derived
from similitude.estimators.paper_design import PAPER_GROUPS, paper_config
from similitude.estimators.paper_sums import paper_sums
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction

STEP, L, NOISE = 0.01, 2.69, 0.0026  # s, m, rad/s
NAMES = Names("K", "U")


def paper_named():
    """The flat configuration of `bicycle_paper`, and that of its sums by name."""
    library = shipped("bicycle_paper")
    limits = {"U_least": 4.0, "output_limit": 3.7, "forgetting": 1 - 2.0**-14}
    config = paper_config(
        library, sample_time=STEP, L=L, speed=20.0, noise_std=NOISE, **limits, **PAPER_GROUPS
    )
    named = named_for_sums(dict(zip(library.names("config"), config.tolist(), strict=True)), L=L)
    named |= {"K_start": 145.0, "K_low": 17.0, "K_limit": 9700.0}
    return config, paper_derived(paper_sums(bicycle_reduction()), named, NAMES)


def rows_of_a_drive(n, *, noise=0.0, seed=0):
    """Rows (n, 4) of a weave with a changing speed."""
    t = STEP * np.arange(n)
    steer = 0.03 * np.sin(2 * np.pi * 0.5 * t) + 0.01 * np.sin(2 * np.pi * 1.7 * t)
    steer += 0.01 * np.sin(2 * np.pi * 5 * t)
    speed = 20 + 5 * np.sin(2 * np.pi * t / 25)
    r = _yaw_rate(steer, speed) + noise * np.random.default_rng(seed).standard_normal(n)
    return np.column_stack([np.full(n, STEP), steer, speed, r])


def _yaw_rate(steer, speed, K=146.0, pi1=0.4431, k=1.0977, pi5=0.251, parts=10):
    """The bicycle's yaw rate, the input held, by ten midpoint steps a sample."""
    v = r = 0.0
    found = np.empty(len(steer))
    for n, (d, U) in enumerate(zip(steer.tolist(), speed.tolist(), strict=True)):
        found[n] = r * U / L
        pi3, h = K / U**2, STEP * U / L / parts
        cross = (1 - pi1) * k - pi1
        turn = pi1**2 + (1 - pi1) ** 2 * k

        for _ in range(parts):
            at = v, r
            for part in (h / 2, h):
                dv = pi3 * (-(1 + k) * at[0] + cross * at[1] + d) - at[1]
                dr = pi3 / pi5 * (cross * at[0] - turn * at[1] + pi1 * d)
                at = v + part * dv, r + part * dr
            v, r = at
    return found
