"""The program as a whole: what it is called, where it comes from, what it costs."""

import re

from similitude.estimators.paper import paper_regression
from similitude.program.c import print_c
from similitude.program.library import shipped
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction


def test_the_committed_files_are_those_of_a_fresh_derivation():
    program = paper_regression(bicycle_reduction())
    twin = shipped("bicycle_paper").layout

    assert program.name == twin.NAME == "bicycle_paper"
    with open(twin.__file__, encoding="utf-8") as file:
        assert file.read() == print_python(program)
    with open(twin.__file__.removesuffix("py") + "c", encoding="utf-8") as file:
        assert file.read() == print_c(program)


def test_the_c_calls_nothing_and_says_where_it_comes_from():
    text = print_c(paper_regression(bicycle_reduction()))
    called = set(re.findall(r"(\w+)\(", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)))

    functions = {f"bicycle_paper_{f}" for f in ("init", "step", "batch", "advance", "report")}
    assert called - functions <= {
        "R",
        "MAGNITUDE",
        "WITHIN",
        "BEYOND",
        "sizeof",
        "__builtin_fabs",  # a bit cleared, no call on any target
        "__builtin_fabsf",
        "if",
        "for",
        "defined",
        "visibility",
        "__attribute__",
        "__declspec",
    }
    assert "Brennan & Alleyne 2004" in text
    assert "m1/T = pi1/pi5" in text


def test_a_step_costs_a_fraction_of_the_population_filter():
    paper, population = shipped("bicycle_paper").layout, shipped("bicycle_population").layout

    assert paper.OPERATIONS < 200
    assert paper.OPERATIONS < population.OPERATIONS / 4
