"""One list of status names and codes, shared by Python, generated C and JSON.

Invariant: a name is never renamed and a code never reused; C enumerators are ``<SYSTEM>_<NAME>``.
"""

from __future__ import annotations

STATUS: dict[str, int] = {
    "ok": 0,
    "not_excited": 1,
    "outside_linear": 2,
    "at_limit": 3,
    "no_measurement": 4,
    "restarted": 5,
    "too_slow": 6,
    "bad_sample": 7,
}

MEANING: dict[str, str] = {
    "ok": "the sample was used for every unknown",
    "not_excited": "the manoeuvre says too little; the unknowns are held, only biases follow",
    "outside_linear": "beyond the linear range of the model; used, but it proves little",
    "at_limit": "an unknown sits at the edge of what the population allows",
    "no_measurement": "an input or the measured output is missing; predicted only",
    "restarted": "the dynamic state was started anew after a gap",
    "too_slow": "too slow for the dynamics to show; the unknowns are held",
    "bad_sample": "time did not advance or the value is impossible; the sample was ignored",
}

NAMES: tuple[str, ...] = tuple(sorted(STATUS, key=STATUS.__getitem__))
