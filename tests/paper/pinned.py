"""What every claim came to when it was last looked at; `check` holds a run against it.

`pinned_claims.json` is written by ``python -m tests.paper.pinned`` and read by people before it is kept.
"""

import json
from pathlib import Path

import pytest

FILE = Path(__file__).with_name("pinned_claims.json")
EXACT = 1e-3  # relative: rounding to four digits, and what another BLAS may change in the last of them
DRIVEN = 0.03  # relative: two digits are kept of what a closed loop on a rough belt came to


def check(subject, claims, *, relative=EXACT):
    """Ids, verdicts and values of a subject's claims are the pinned ones."""
    pinned = json.loads(FILE.read_text(encoding="utf-8"))[subject]
    assert [claim.id for claim in claims] == [record["id"] for record in pinned]
    for claim, record in zip(claims, pinned, strict=True):
        assert claim.verdict == record["verdict"], claim
        _same(claim.tolerance, record["tolerance"], claim, relative)
        _same(claim.ours, record["ours"], claim, relative)
        assert claim.statement and claim.where


def _same(found, pinned, claim, relative):
    if isinstance(pinned, list):
        for one, other in zip(found, pinned, strict=True):
            _same(one, other, claim, relative)
    elif isinstance(pinned, str):
        assert found == pinned, claim
    else:
        assert found == pytest.approx(pinned, rel=relative, abs=1e-12), claim


if __name__ == "__main__":
    from similitude.paper.reproduction import SUBJECTS

    kept = ("id", "ours", "verdict", "tolerance")
    found = {s: [{k: c.record[k] for k in kept} for c in claims()] for s, claims in SUBJECTS.items()}
    FILE.write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
