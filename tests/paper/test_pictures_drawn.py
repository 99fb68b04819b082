"""Figures 1 and 6 show what they must."""

from similitude.paper.pictures_drawn import figure_1, figure_6


def words(figure):
    return " ".join(text.get_text() for axes in figure.axes for text in axes.texts)


def test_figure_1_names_every_letter():
    for letter in ("a", "b", "L", "δ", "U", "ψ", "Caf", "Car"):
        assert letter in words(figure_1())


def test_figure_6_holds_the_printed_data():
    for value in ("5.451", "0.1615", "65, 110", "365.2", "0.2722", "0.4839"):
        assert value in words(figure_6())
