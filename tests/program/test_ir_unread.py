"""Temporaries that nothing reads are left out, and nothing else."""

import sympy as sp

from similitude.program.ir import Assign, Field, Program, When, without_unread

x, y, a, b, c = sp.symbols("x y a b c", real=True)


def program(*step):
    return Program(
        name="p", title="p", provenance=(), config=(), state=(Field("x", "-", ""),), sample=(Field("y", "-", ""),),
        output=(Field("z", "-", ""),), variables=(Field("status", "-", ""),),
        init=(Assign("x", sp.Integer(0)),), step=step, status={"ok": 0},
    )  # fmt: skip


def test_a_chain_of_unread_temporaries_goes_inside_guards_too():
    kept = (Assign("a", 2 * y), Assign("x", x + a), Assign("z", x), Assign("status", sp.Integer(0)))
    dead = Assign("b", 3 * y), When(y > 0, (Assign("c", b + 1),))
    shorter = without_unread(program(kept[0], *dead, *kept[1:]))

    assert [s for s in shorter.step if isinstance(s, Assign)] == list(kept)
    assert all(s.body == () for s in shorter.step if isinstance(s, When))


def test_what_is_read_stays():
    step = (Assign("a", 2 * y), Assign("x", x + a), Assign("z", a), Assign("status", sp.Integer(0)))

    assert without_unread(program(*step)).step == step
