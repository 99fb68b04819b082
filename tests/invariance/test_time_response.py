"""Time responses: the paper's numbers, drives with what they are made of, initial states, closed forms."""

import numpy as np
import pytest

from similitude.errors import ModelError
from similitude.invariance.invariances import invariances
from similitude.model import Model, Quantity
from similitude.systems.bicycle import BICYCLE

SCALE_CAR = {
    "m": "5.451 kg", "Iz": "0.1615 kg m^2", "U": "4 m/s", "a": "0.1461 m", "b": "0.2191 m",
    "Caf": "65 N/rad", "Car": "110 N/rad", "delta": "1 rad", "t": "0.15 s",
}  # fmt: skip


def test_the_row_of_time_holds_with_the_time_argument_and_not_without():
    """Erratum of eq 13: -1.3063 without the time argument, -1.0000 with it."""
    rows = invariances(BICYCLE)
    S = rows.sensitivities(SCALE_CAR)
    time = rows.rows[2]

    assert str(time) == "time: -S_U - 2 S_Caf - 2 S_Car + S_t = -1"
    assert time.left_side(S) == pytest.approx(-1, abs=1e-9)
    assert time.left_side(S, leave_out=["t"]) == pytest.approx(-1.3063, abs=5e-5)
    assert max(rows.verify(SCALE_CAR | {"t": np.linspace(0, 1, 5)}).values()) < 1e-9


def test_three_of_seven_are_recovered():
    rows = invariances(BICYCLE)
    S = rows.sensitivities(SCALE_CAR)
    others = {n: s for n, s in S.items() if n not in ("m", "Iz", "Caf")}

    assert rows.solve_for(["m", "Iz", "Caf"], others) == {
        n: pytest.approx(S[n], abs=1e-9) for n in ("m", "Iz", "Caf")
    }


def lag() -> Model:
    return Model(
        "lag", [Quantity("x", "m")], [Quantity("u", "m")], [Quantity("x", "m")], [Quantity("T", "s")],
        {"x": "(u - x)/T"},
    )  # fmt: skip


def test_a_step_of_a_lag_in_closed_form():
    rows = invariances(lag())
    S, e = rows.sensitivities({"T": 2.0, "u": 3.0, "t": 1.0}), np.exp(-0.5)

    assert S == {n: pytest.approx(v, abs=1e-10) for n, v in
                 {"u": 1.0, "T": -0.5 * e / (1 - e), "t": 0.5 * e / (1 - e)}.items()}  # fmt: skip


def test_what_a_drive_is_made_of_are_arguments():
    rows = invariances(
        lag(),
        drive={"u": "A*sin(w*t)"},
        quantities=[Quantity("A", "m"), Quantity("w", "rad/s")],
        initial=["x"],
    )

    assert rows.arguments == ("T", "A", "w", "x0", "t")
    assert str(rows.rows[-1]) == "time: S_T - S_w + S_t = 0"
    values = {"T": 2.0, "A": 1.0, "w": 3.0, "x0": 0.5, "t": [0.5, 1.5]}
    assert max(rows.verify(values).values()) < 1e-9


def test_what_nothing_drives_starts_from_its_states():
    decay = Model(
        "decay", [Quantity("n", "mol")], [], [Quantity("n", "mol")], [Quantity("k", "1/s")], {"n": "-k*n"}
    )
    rows = invariances(decay)

    assert rows.arguments == ("k", "n0", "t")
    assert rows.sensitivities({"k": 2.0, "n0": 5.0, "t": 0.5}) == {
        "k": pytest.approx(-1, abs=1e-10), "n0": pytest.approx(1), "t": pytest.approx(-1, abs=1e-10)
    }  # fmt: skip


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"drive": {"v": "1"}}, r"'v' is no driven input \(there are u\)"),
        ({"drive": {"u": "A*t"}}, "'A', which is not declared"),
        ({"drive": {"u": "T"}}, "the drive of 'u' is not homogeneous: T is in s"),
        ({"initial": ["y"]}, r"'y' is no initial state \(there are x\)"),
    ],
)
def test_a_drive_that_does_not_fit_is_refused(options, said):
    with pytest.raises(ModelError, match=said):
        invariances(lag(), **options)
