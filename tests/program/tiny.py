"""A step program of a few lines: an average that forgets, held over bad samples."""

from dataclasses import replace

import sympy as sp

from similitude.program.ir import Assign, Field, Program, When

x, mean, rate, dt, weight = sp.symbols("x mean rate dt weight", real=True)


def tiny_program(**changes) -> Program:
    """The program, with some of its parts replaced."""
    good = sp.And(x > -10, x < 10)
    program = Program(
        name="average",
        title="Forgetting average",
        provenance=("a test",),
        config=(Field("rate", "1/s", "forgetting rate"),),
        state=(Field("mean", "V", "average so far"), Field("last", "V", "last values", 2)),
        sample=(Field("dt", "s", "time step"), Field("x", "V", "measured")),
        output=(Field("shown", "V", "average shown"),),
        variables=(Field("status", "-", "status code"),),
        init=(
            Assign("mean", sp.Integer(0)),
            Assign("last_0", sp.Integer(0)),
            Assign("last_1", sp.Integer(0)),
        ),
        step=(
            Assign("status", sp.Integer(0)),
            When(
                good,
                (
                    Assign("weight", sp.Min(1, dt * rate), "share of the newest"),
                    Assign("mean", mean + weight * (x - mean)),
                    Assign("last_1", sp.Symbol("last_0", real=True)),
                    Assign("last_0", x),
                ),
                (Assign("status", sp.Integer(7)),),
                "a bad sample is left out",
            ),
            Assign("shown", mean),
        ),
        status={"ok": 0, "bad_sample": 7},
    )
    return replace(program, **changes)


def reporting_program() -> Program:
    """The same average, handed out when it is asked for."""
    stepped = tuple(s for s in tiny_program().step if getattr(s, "target", "") != "shown")
    newest = sp.Symbol("last_0", real=True)
    return tiny_program(
        step=stepped,
        report=(Assign("twice", 2 * mean), Assign("shown", sp.Symbol("twice", real=True) - newest)),
    )
