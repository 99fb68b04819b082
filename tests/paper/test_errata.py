"""Every erratum leads to a claim that is made, and those that misprint do not simply hold."""

from similitude.paper.errata import ERRATA

from .pinned import FILE


def test_every_erratum_has_a_claim():
    text = FILE.read_text(encoding="utf-8")
    assert [e.claim for e in ERRATA if f'"{e.claim}"' not in text] == []
    assert len(ERRATA) == 12 and len({e.claim for e in ERRATA}) == 12
