"""Every erratum leads to a claim that is made, and what is misprinted does not simply hold."""

import json

from similitude.paper.claim import HOLDS
from similitude.paper.errata import ERRATA

from .pinned import FILE

# The number is right: what is wrong is its unit (seconds), or that it stands without an interval.
RIGHT_NUMBERS = {"sec5-sample-time", "eq18-slope"}


def test_every_erratum_has_a_claim_and_what_is_misprinted_does_not_simply_hold():
    pinned = json.loads(FILE.read_text(encoding="utf-8"))
    verdicts = {record["id"]: record["verdict"] for records in pinned.values() for record in records}

    assert [e.claim for e in ERRATA if e.claim not in verdicts] == []
    assert {e.claim for e in ERRATA if verdicts[e.claim] == HOLDS} == RIGHT_NUMBERS
    assert len(ERRATA) == 12 and len({e.claim for e in ERRATA}) == 12
