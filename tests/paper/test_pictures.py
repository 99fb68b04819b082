"""The paper's seven figures and ours all have a file, a title and words."""

from similitude.paper.pictures import PICTURES


def test_seven_figures_and_ours():
    assert [name for name in PICTURES if name.isdigit()] == list("1234567")
    assert all(one.theirs for name, one in PICTURES.items() if name.isdigit())
    assert len({one.file for one in PICTURES.values()}) == len(PICTURES)
    assert all(one.title and one.ours for one in PICTURES.values())
