"""False alarms and delays of the change alarm over simulated roads."""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from similitude.change_alarm import watch
from similitude.filter_run import population_setup
from similitude.log import Log

from .experiment import NOISE, drawn_prior
from .road import GOOD, KINDS, NUISANCE, Installation, road

CHANGE_AT = 60.0  # s
WAIT = 30.0  # s after a change; what is not found by then is missed
INSTALLATIONS = {"good": GOOD, "nuisance": NUISANCE}
CLEAN = Installation()


def passes(cars):
    """The filter over every car's log."""
    prior = drawn_prior()
    for i in range(len(cars.L)):
        U = cars.U[i] if np.ndim(cars.U) == 2 else np.full(len(cars.t), cars.U[i])
        log = Log(
            name=f"car {i}", path=None, t=cars.t, delta=cars.steer[i], r=cars.yaw_rate[i],
            U=U, ay=None, sources={},
        )  # fmt: skip
        yield population_setup(log, prior, L=cars.L[i], noise_std=NOISE, input_scale_sd=0.02).run()


def false_alarms(seed, *, cars, thresholds, duration=600.0, kinds=KINDS):
    """Alarms in sound drives: (kind, installation) -> hours driven and alarms for each (fall, rise)."""
    found = {}
    for number, kind in enumerate(kinds):
        for place, (name, installation) in enumerate(INSTALLATIONS.items()):
            drives = road(
                seed + 10 * number + place, cars=cars, kind=kind, duration=duration, installation=installation
            )
            counts = np.zeros(len(thresholds), dtype=int)
            for done in passes(drives):
                counts += [len(watch(done, changes=_both(*pair)).alarms) for pair in thresholds]
            found[kind, name] = (cars * duration / 3600, counts)
    return found


def _both(fall, rise):
    return {"threshold_fall": fall, "threshold_rise": rise}


def upper_bound(count):
    """95 % upper bound of a Poisson mean of which ``count`` were seen."""
    return chi2.ppf(0.95, 2 * (count + 1)) / 2


@dataclass(frozen=True)
class Delays:
    """Of one change in many cars: delays [s], inf where it was missed; size and onset as told."""

    delays: np.ndarray
    armed: float  # share of the cars whose monitor was armed when the change came
    before: int  # alarms before the change
    change: np.ndarray
    std: np.ndarray
    onset: np.ndarray  # s after the true one

    def quantile(self, q):
        """Delay within which a share ``q`` was found [s]."""
        return float(np.sort(self.delays)[min(int(q * len(self.delays)), len(self.delays) - 1)])

    @property
    def missed(self):
        """Share of the cars in which the change was not found in time."""
        return float(np.mean(np.isinf(self.delays)))


def delays(seed, *, cars, factor, lateral, installation=CLEAN):
    """K times ``factor`` at 60 s; ``lateral`` rms before it [m/s^2]."""
    kind = "stiffness_drop" if factor < 1 else "stiffness_rise"
    drives = road(
        seed, cars=cars, kind="highway", duration=CHANGE_AT + WAIT, installation=installation,
        events=False, changes=((CHANGE_AT, factor),), lateral=lateral,
    )  # fmt: skip
    late, told, before, ready = [], [], 0, 0
    for done in passes(drives):
        seen = watch(done)
        ready += seen.armed[int(CHANGE_AT * 100) - 1]
        before += sum(a.t < CHANGE_AT for a in seen.alarms)
        hits = [a for a in seen.alarms if a.t >= CHANGE_AT and a.kind == kind]
        late.append(hits[0].t - CHANGE_AT if hits else np.inf)
        if hits:
            told.append((hits[0].change, hits[0].std, hits[0].onset - CHANGE_AT))
    change, std, onset = np.array(told).reshape(-1, 3).T
    return Delays(np.array(late), ready / cars, before, change, std, onset)
