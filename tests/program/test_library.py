"""A Library is its layout and its C, or its twin: the same arrays in, the same bits out."""

import types

import numpy as np
import pytest

from similitude.errors import ProgramError
from similitude.program import library as libraries
from similitude.program.library import Library, assemble, shipped

from ..filter_rig import car_config, twin_of
from ..rough_drive import rough_drive


@pytest.fixture
def bicycle():
    return shipped("bicycle_population")


def test_a_shipped_estimator_is_loaded_once(bicycle):
    assert shipped("bicycle_population") is bicycle
    assert bicycle.c is not None and bicycle.why_slow == ""


def test_an_index_leads_to_its_name_and_past_arrays(bicycle):
    for struct in ("config", "state", "sample", "output"):
        names = bicycle.names(struct)
        assert len(set(names)) == len(names)
        for field, _, _, size in getattr(bicycle.layout, struct.upper()):
            first = field if size == 1 else f"{field}_0"
            assert names[bicycle.index(struct, field)] == first
    with pytest.raises(ProgramError, match="no state field 'stiffness'"):
        bicycle.index("state", "stiffness")


def test_config_takes_every_name_exactly_once(bicycle):
    flat = car_config(bicycle)
    values, start = {}, 0
    for name, _, _, size in bicycle.layout.CONFIG:
        values[name] = flat[start : start + size]
        start += size
    assert np.array_equal(bicycle.config(values), flat)
    for broken in (
        {name: x for name, x in values.items() if name != "drift"},
        {**values, "drift": np.nan},
        {**values, "drift": [1.0, 2.0]},
        {**values, "P_prior": np.ones(9)},
        {**values, "drfit": 1.0},
    ):
        with pytest.raises(ProgramError) as refused:
            bicycle.config(broken)
        assert len(str(refused.value).splitlines()) == 4
        assert any(name in refused.value.what for name in ("drift", "P_prior", "drfit"))


def test_a_state_can_be_copied_saved_and_taken_up_again(bicycle):
    config, rows = car_config(bicycle), rough_drive(2000, seed=1)
    whole = bicycle.start(config)
    outputs, status = bicycle.run(config, whole, rows)
    part = bicycle.start(config)
    first, early = bicycle.run(config, part, rows[:777])
    kept = np.frombuffer(part.tobytes()).copy()  # as a file would hold it
    second, late = bicycle.run(config, kept, rows[777:])

    assert np.array_equal(np.concatenate([first, second]), outputs)
    assert np.array_equal(np.concatenate([early, late]), status)
    assert np.array_equal(kept, whole)


def test_no_rows_change_nothing(bicycle):
    config = car_config(bicycle)
    for library in (bicycle, twin_of(bicycle)):
        state = library.start(config)
        before = state.copy()
        outputs, status = library.run(config, state, np.empty((0, 4)))
        assert outputs.shape == (0, len(library.names("output"))) and status.shape == (0,)
        assert np.array_equal(state, before)


def test_rows_in_any_layout_of_memory_are_the_same_rows(bicycle):
    config, rows = car_config(bicycle), rough_drive(300, seed=2)
    found = []
    for same in (rows, np.asfortranarray(rows), rows[::-1][::-1], rows.astype(">f8")):
        outputs, _ = bicycle.run(config, bicycle.start(config), same)
        found.append(outputs)
    assert all(np.array_equal(found[0], other) for other in found[1:])


@pytest.mark.parametrize("which", ["config", "state", "samples"])
def test_arrays_the_c_would_overrun_are_refused(bicycle, which):
    config = car_config(bicycle)
    good = {"config": config, "state": bicycle.start(config), "samples": np.zeros((3, 4))}
    wrong = [good[which][..., :-1].copy()]
    if which != "samples":  # samples are converted; a state is changed in place and cannot be
        wrong += [good[which].astype(np.float32), np.repeat(good[which], 2)[::2]]
    for array in wrong:
        with pytest.raises(ProgramError, match="reals is needed"):
            bicycle.run(**{**good, which: array})


def test_without_a_compiler_the_twin_is_taken_and_one_line_says_why(cache, monkeypatch, bicycle):
    monkeypatch.setenv("SIMILITUDE_CC", "/nowhere/cc")
    source = "int not_even_read;"
    slow = assemble(bicycle.layout, source)
    assert slow.c is None
    assert "/nowhere/cc" in slow.why_slow and "hundred times slower" in slow.why_slow
    assert len(slow.why_slow.splitlines()) == 1


def test_a_compiler_that_refuses_is_also_said_in_one_line(cache, bicycle):
    slow = assemble(bicycle.layout, "this is no C\nnor this\n")
    assert slow.c is None
    assert len(slow.why_slow.splitlines()) == 1


def test_a_library_of_another_estimator_is_not_taken_for_this_one(cache):
    layout = types.SimpleNamespace(NAME="other")
    with pytest.raises(AttributeError, match="other_init"):
        assemble(layout, "int unrelated(void) { return 1; }")


def test_a_libray_says_which_struct_is_meant():
    assert Library("x", types.SimpleNamespace(STATE=(("a", "-", "", 2), ("b", "m", "", 1))), None).names(
        "state"
    ) == ["a_0", "a_1", "b"]
    assert libraries.GENERATED == "similitude.generated"
