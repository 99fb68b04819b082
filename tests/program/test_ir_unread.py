"""Temporaries that nothing reads are left out, and nothing else."""

import sympy as sp

from similitude.program.ir import Assign, Field, Program, When, without_unread

x, y, a, b, c = sp.symbols("x y a b c", real=True)


def program(*step):
    def real(name):
        return (Field(name, "-", ""),)

    return Program(
        name="p", title="p", provenance=(), config=(), state=real("x"), sample=real("y"), output=real("z"),
        variables=real("status"), init=(Assign("x", sp.Integer(0)),), step=step, status={"ok": 0},
    )  # fmt: skip


def test_a_chain_of_unread_temporaries_goes_inside_guards_too():
    kept = (Assign("a", 2 * y), Assign("x", x + a), Assign("z", x), Assign("status", sp.Integer(0)))
    dead = Assign("b", 3 * y), When(y > 0, (Assign("c", b + 1),))
    shorter = without_unread(program(kept[0], *dead, *kept[1:]))

    assert shorter.step == kept


def test_what_is_read_stays():
    step = (Assign("a", 2 * y), Assign("x", x + a), Assign("z", a), Assign("status", sp.Integer(0)))

    assert without_unread(program(*step)).step == step
