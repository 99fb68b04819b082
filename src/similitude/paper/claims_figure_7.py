"""Claims about Figure 7, the treadmill, and about the gain that follows the running estimate.

Invariant: "scheduled" is closed loop: the filter that reads steer and gyro tick by tick feeds the gain.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from similitude.paper import printed
from similitude.paper.ahead import kept
from similitude.paper.bound import bound
from similitude.paper.claim import Claim, claim, number_claim
from similitude.paper.drives import (
    SOFT,
    SOFTEST,
    Drive,
    belt,
    belt_scheduled,
    belt_soft,
    belt_softest,
    belt_told,
    drive_of,
    population_reads,
    regression_reads,
)
from similitude.simulation.scenario import read_scenario

Array = NDArray[np.float64]
DRY, WET, PLANING, RETURN = (5.0, 60.0), (62.0, 70.0), (72.0, 83.0), (85.0, 90.0)  # s
SEEDS = (1, 2, 3)
PLANING_SHORT = (15.0, 28.0)  # s, in the scenario wet_lane
CLEAR = 0.1  # of π3 or of a distance: less of a difference is none
JUMP = 0.1  # m from one step to the next
CHANGES = (60.6, 70.0, 72.0, 83.0, 85.6)  # s


def figure_7_claims() -> list[Claim]:
    """The paper's story of the drive, then today's."""
    return [
        _dry(),
        _decline(),
        _planing(),
        _fish_tail(),
        _with_gyro(),
        _today(),
        _scheduled(),
        _soft_gain(),
        _scheduled_seeds(),
        _grip_alone(),
    ]


@lru_cache
def belt_paper(perfect: bool = True) -> Array:
    """The regression on Figure 7, (n,) [-]."""
    drive = belt()
    return regression_reads(drive, drive.r if perfect else drive.r_gyro)


@lru_cache
def belt_filter() -> tuple[Array, Array]:
    """The population filter on Figure 7 with the gyro: K and sd of ln K, (n,) each."""
    drive = belt()
    return population_reads(drive, drive.r_gyro)


@kept
def least_sd() -> Array:
    """A bound on Figure 7, (n,) [-]: of linear tyres on a smooth belt, which is less than any that is true.

    Tyres that saturate say less of the slope at small slip, and an uneven belt says less of everything.
    """
    return bound(belt(), CHANGES)


def excursions(drive: Drive, first: float, last: float) -> dict[str, float]:
    """Greatest distance from the path [m], its rms [m], greatest sideslip [rad] and yaw rate [rad/s]."""
    there = drive.during(first, last)
    off = (drive.y - drive.wanted)[there]
    return {
        "most": float(np.abs(off).max()),
        "rms": float(np.sqrt(np.mean(off**2))),
        "beta": float(np.abs(drive.beta[there]).max()),
        "r": float(np.abs(drive.r[there]).max()),
    }


def coverage(K: Array, sd: Array) -> float:
    """Share of the dry 20 to 60 s in which the 95 % interval holds the truth [-]."""
    calm = belt().during(20.0, 60.0)
    return float(np.mean((np.abs(np.log(K / belt().K)) < 1.96 * sd)[calm]))


def _mean(reads: Array, window: tuple[float, float]) -> float:
    return float(np.mean(reads[belt().during(*window)]))


def _dry() -> Claim:
    ours, true = _mean(belt_paper(), (40.0, 60.0)), _mean(belt().pi3, (40.0, 60.0))
    return number_claim(
        "fig7-dry",
        "section 7, Figure 7",
        "on the dry belt the estimate settles at about 0.4",
        printed=printed.DRY_ESTIMATE,
        ours=ours,
        tolerance=0.08,
        digits=2,
        why=f"Within a fifth of the print, with a perfect sensor and the grip assumed here. The π3 of the "
        f"printed parameters is {true:.3f}, so the estimate is too high, not 20 % too low as the paper "
        "has it. Which part of the drive raises it (15 cm steps, tyres near their grip) is not told apart.",
    )


def _decline() -> Claim:
    before, after = _mean(belt_paper(), (58.0, 60.0)), _mean(belt_paper(), (65.0, 68.0))
    K, _ = belt_filter()
    change = _mean(K, (65.0, 70.0)) / _mean(K, (40.0, 60.0)) - 1
    return claim(
        "fig7-decline",
        "section 7, Figure 7",
        "entering the wet half the estimate declines very suddenly",
        printed="very sudden decline",
        ours=after / before - 1,
        holds=after / before < 0.8,
        tolerance="a fifth or more within five seconds",
        digits=2,
        unit="relative change",
        why="With λ = 0.99995 a minute of dry driving outweighs five seconds; something else moved the "
        "paper's "
        f"estimate. The population filter changes by {100 * change:+.0f} % there, the stiffness by −50 %.",
    )


def _planing() -> Claim:
    before, after = _mean(belt_paper(), WET), _mean(belt_paper(), (78.0, 83.0))
    return claim(
        "fig7-planing",
        "section 7, Figure 7",
        "while the tyres hydroplane the estimate drops significantly lower",
        printed="significantly lower",
        ours=after / before - 1,
        holds=after / before < 0.8,
        tolerance="a fifth or more",
        digits=2,
        unit="relative change",
        why="Even with a perfect sensor the regression rises.",
    )


def _fish_tail() -> Claim:
    calm, tail = excursions(belt(), *WET)["r"], excursions(belt(), *RETURN)["r"]
    return claim(
        "fig7-fish-tail",
        "section 7, Figure 7",
        "coming back across the edge the vehicle fish-tails",
        printed="fish-tail",
        ours=[calm, tail],
        holds=tail > 3 * calm,
        tolerance="three times the yaw rate of before",
        digits=2,
        unit="rad/s",
        why="Greatest yaw rate on the wet half before hydroplaning, and on the way back with one side on "
        "each surface.",
    )


def _with_gyro() -> Claim:
    reads = _mean(belt_paper(perfect=False), (40.0, 60.0))
    true = _mean(belt().pi3, (40.0, 60.0))
    return claim(
        "fig7-gyro",
        "section 2",
        "the yaw-rate sensor that many cars already carry serves the method",
        printed="serves",
        ours=reads / true - 1,
        holds=abs(reads / true - 1) < 0.5,
        tolerance=0.5,
        digits=2,
        unit="relative error of π3",
        why="The paper's own experiment had an encoder at the centre of gravity, not the gyro of a car. With "
        f"0.1 deg/s of white noise the regression reads {reads:.1f} for {true:.2f}.",
    )


def _today() -> Claim:
    K, sd = belt_filter()
    pi3 = K / belt().U ** 2
    covered = coverage(K, sd)
    ours = [_mean(pi3, window) for window in ((40.0, 60.0), (66.0, 70.0), (74.0, 82.0), (95.0, 110.0))]
    true = [
        float(np.median(belt().pi3[belt().during(*w)])) for w in ((40, 60), (66, 70), (74, 82), (95, 110))
    ]
    falls = all(
        low < (1 - CLEAR) * high for high, low in ((ours[0], ours[1]), (ours[1], ours[2]), (ours[3], ours[2]))
    )
    return claim(
        "today-figure-7",
        "not in the paper",
        "the population filter tells Figure 7's story with a gyro: lower on the wet half, lower still, "
        "and back",
        printed=[float(f"{x:.3g}") for x in true],
        ours=ours,
        holds=falls,
        tolerance="falls, falls, rises, by a tenth or more",
        digits=2,
        unit="π3",
        why="Means of π3 at 40–60, 66–70, 74–82 and 95–110 s, beside the true medians (printed). Beyond "
        "the grip a slope "
        f"at small slip cannot be seen; what is read there is what the tyres still "
        f"give. On this belt the 95 % interval is too narrow: it holds the truth {100 * covered:.0f} % of "
        f"20–60 s.",
    )


def gains() -> dict[str, Drive]:
    """Figure 7 by the regulator's gain."""
    return {
        "fixed": belt(),
        "soft": belt_soft(),
        "softest": belt_softest(),
        "estimate": belt_scheduled(),
        "truth": belt_told(),
    }


def _scheduled() -> Claim:
    fixed, soft, follows = (excursions(gains()[n], *PLANING) for n in ("fixed", "soft", "estimate"))
    tails = {n: excursions(drive, *RETURN)["beta"] for n, drive in gains().items()}
    nearer = follows["rms"] < fixed["rms"] and follows["beta"] < fixed["beta"]
    return claim(
        "today-scheduled",
        "sections 7 and 8",
        "the estimate is very useful for scheduling control designs",
        printed="very useful",
        ours=[fixed["rms"], follows["rms"], soft["rms"]],
        holds=nearer and follows["rms"] < (1 - CLEAR) * soft["rms"],
        under=nearer and tails["estimate"] < tails["fixed"],
        tolerance="less distance and sideslip than the fixed gain, a tenth less distance than a soft one",
        digits=2,
        unit="m rms",
        condition="it is compared with the paper's fixed gain: distance, sideslip, sideslip on the way back "
        "are all less",
        why=f"Distance from the path while hydroplaning: the paper's gain, gain following the running "
        f"population filter, one gain designed for half the stiffness. Greatest sideslip there "
        f"{fixed['beta']:.2f}, {follows['beta']:.2f} and {soft['beta']:.2f} rad, on the way back "
        f"{tails['fixed']:.2f}, {tails['estimate']:.2f} and {tails['soft']:.2f} rad. One belt: see "
        "today-scheduled-belts for others, today-soft-gain for the dry half.",
    )


def after_jumps(drive: Drive, first: float, last: float) -> float:
    """Share of the squared distance from the path that falls into the second after one of its jumps [-]."""
    there = drive.during(first, last)
    off, jumps = ((drive.y - drive.wanted) ** 2)[there], np.abs(np.diff(drive.wanted[there])) > JUMP
    soon = np.convolve(np.append(jumps, False), np.ones(round(1 / drive.step)))[: off.size] > 0
    return float(off[soon].sum() / off.sum())


def _soft_gain() -> Claim:
    names = ("estimate", "soft", "softest", "fixed")
    follows, soft, softest, fixed = (excursions(gains()[n], *DRY)["rms"] for n in names)
    return claim(
        "today-soft-gain",
        "not in the paper",
        "on the dry half the gain that follows the estimate is clearly better than one soft gain",
        printed=round(fixed, 4),
        ours=[follows, soft, softest],
        holds=soft > (1 + CLEAR) * follows,
        under=softest > (1 + CLEAR) * follows,
        tolerance="a tenth less distance",
        digits=3,
        unit="m rms",
        condition=f"the one gain is designed for what is left while hydroplaning ({SOFTEST} of the "
        f"stiffness): it is {100 * (softest / follows - 1):.0f} % worse there",
        why="Distance from the path on the dry, 5 to 60 s: printed with the paper's gain, ours with the one "
        f"that follows, with one gain for {SOFT} and with one for {SOFTEST} of the stiffness. The gain for "
        f"{SOFT} is {100 * (soft / follows - 1):.1f} % worse only: {100 * after_jumps(belt(), *DRY):.0f} % "
        "of the squared distance falls into the second after a jump of the path.",
    )


@kept
def wet_lane_runs() -> list[tuple[dict[str, float], ...]]:
    """Excursions while hydroplaning in wet_lane, a seed each: fixed, following and soft gain."""
    changes = ({}, {"driver.schedule": "estimate"}, {"driver.design_stiffness": SOFT})
    return [
        tuple(
            excursions(drive_of(read_scenario("wet_lane", changes=change), seed), *PLANING_SHORT)
            for change in changes
        )
        for seed in SEEDS
    ]


def _scheduled_seeds() -> Claim:
    runs = wet_lane_runs()
    to_fixed, to_soft = ([run[1]["rms"] / run[i]["rms"] for run in runs] for i in (0, 2))
    worst = [max(run[i]["most"] for run in runs) for i in range(3)]
    return claim(
        "today-scheduled-belts",
        "not in the paper",
        "on other belts the gain that follows brings the vehicle nearer to its path each time than the fixed "
        "and than the soft gain",
        printed=1,
        ours=[*to_fixed, *to_soft],
        holds=max(*to_fixed, *to_soft) < 1,
        under=max(to_fixed) < 1,
        tolerance="each below 1",
        digits=2,
        unit="rms over rms of the fixed, then of the soft gain",
        condition="it is compared with the fixed gain",
        why=f"While hydroplaning, {len(SEEDS)} other seeds of the unevenness (wet_lane). The worst excursion "
        f"is {worst[0]:.2f} m with the fixed gain, {worst[1]:.2f} m with the scheduled, {worst[2]:.2f} m "
        "with the soft.",
    )


@kept
def grip_alone() -> tuple[float, float]:
    """Mean of ln K as the filter reads it, after minus before, in peak_only and in friction_step."""
    found = []
    for name in ("peak_only", "friction_step"):
        drive = drive_of_log(name)
        K, _ = population_reads(drive, drive.r_gyro)
        change = float(drive.scenario.road.surface[0].begin)
        before, after = drive.during(change - 15, change), drive.during(change + 5, change + 20)
        found.append(float(np.mean(np.log(K[after])) - np.mean(np.log(K[before]))))
    return found[0], found[1]


def drive_of_log(name: str) -> Drive:
    """A shipped scenario without a path, whose logger's yaw rate is all that is read."""
    from similitude.simulation.recording import run_scenario

    scenario = read_scenario(name)
    (recording,) = run_scenario(scenario, [0])
    log, truth = recording.log, recording.truth
    columns = (truth["t [s]"], log["delta [rad]"], truth["r [rad/s]"], log["r [rad/s]"], log["U [m/s]"])
    return Drive(
        scenario, *columns, truth["K [m^2/s^2]"], truth["y [m]"], 0 * truth["y [m]"], truth["beta [rad]"]
    )


def _grip_alone() -> Claim:
    peak, both = grip_alone()
    return claim(
        "sec1-detects-friction",
        "section 1",
        "the linear model can detect whether road friction has changed",
        printed="detects",
        ours=[peak, both],
        holds=peak < -0.2,
        under=both < -0.2,
        tolerance="ln K falls by 0.2 or more",
        digits=2,
        unit="change of ln K",
        condition="the stiffness falls together with the friction",
        why="Grip alone halved (scenario peak_only), and grip and stiffness halved (friction_step), as "
        "the population "
        "filter reads it. At small slip a lower limit moves nothing: stiffness is not friction.",
    )
