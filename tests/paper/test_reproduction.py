"""All at once."""

import json

from similitude.paper.claim import VERDICTS
from similitude.paper.reproduction import SUBJECTS

from .pinned import FILE
from .reproduced import small


def test_there_are_enough_claims_and_enough_that_do_not_simply_hold():
    pinned = json.loads(FILE.read_text(encoding="utf-8"))
    every = [record for records in pinned.values() for record in records]

    assert list(pinned) == list(SUBJECTS)
    assert len(every) >= 25 and sum(record["verdict"] != VERDICTS[0] for record in every) >= 8
    assert len({record["id"] for record in every}) == len(every)


def test_verdicts_are_counted():
    done = small()
    assert sum(done.count().values()) == len(done.claims) == len(done.records)
