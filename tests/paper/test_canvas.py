"""Pictures are PNGs that depend on their numbers alone."""

from similitude.paper.canvas import label, legend, panels, png


def drawn(value):
    figure, (one, _) = panels(2, 2.0)
    one.plot([0, 1], [0, value], label="line")
    label(one, "x", "y", "title")
    legend(one)
    return png(figure)


def test_equal_numbers_give_equal_bytes():
    assert drawn(1) == drawn(1) != drawn(2)
    assert drawn(1).startswith(b"\x89PNG") and b"Software" not in drawn(1)
