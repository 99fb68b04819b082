"""A state file: the same bits back, whole or refused with a reason."""

import json
import os

import numpy as np
import pytest

from similitude.saved_state import SavedState, StateError, fits, read_state, write_state

RANDOM = np.random.default_rng(0)


def state(**changes):
    values = {
        "made_for": {"L [m]": 2.7, "vehicle": "Estate", "population": "passenger_cars"},
        "settings": {"steer_lag": 0.013},
        "clock": 1234.567890123,
        "tail": {"t": [1.0, 1.01], "delta": [0.1, -0.0]},
        "filter": [float(x) for x in RANDOM.standard_normal(81) * 10.0 ** RANDOM.integers(-300, 300, 81)],
        "monitor": [0.1 + 0.2, 5e-324, -0.0, 1e308],
        "tyre": {"ln_K": 4.7},
    }
    return SavedState(**{**values, **changes})


def refusal(path):
    with pytest.raises(StateError) as caught:
        read_state(path)
    error = caught.value
    assert all((error.what, error.usually, error.paste, error.read)) and str(path) in error.what
    return error.what + error.usually


def test_what_was_written_reads_back_bit_for_bit(tmp_path):
    one = state()
    write_state(one, tmp_path / "s.json")
    back = read_state(tmp_path / "s.json")

    assert back == one
    for name in ("filter", "monitor"):
        assert np.array(getattr(back, name)).tobytes() == np.array(getattr(one, name)).tobytes()


def test_writing_leaves_nothing_else_behind_and_replaces(tmp_path):
    for clock in (1.0, 2.0):
        write_state(state(clock=clock), tmp_path / "s.json")

    assert os.listdir(tmp_path) == ["s.json"]
    assert read_state(tmp_path / "s.json").clock == 2.0


def test_a_write_that_fails_leaves_the_old_state(tmp_path, monkeypatch):
    write_state(state(clock=1.0), tmp_path / "s.json")
    monkeypatch.setattr(os, "replace", lambda *_: (_ for _ in ()).throw(OSError("no space left")))

    with pytest.raises(StateError, match="no space left"):
        write_state(state(clock=2.0), tmp_path / "s.json")
    assert os.listdir(tmp_path) == ["s.json"] and read_state(tmp_path / "s.json").clock == 1.0


def test_every_cut_and_every_flipped_byte_is_refused(tmp_path):
    path = tmp_path / "s.json"
    write_state(state(), path)
    whole = path.read_bytes()
    for size in (0, 1, len(whole) // 2, len(whole) - 3):
        path.write_bytes(whole[:size])
        assert "no whole state file" in refusal(path)
    rng = np.random.default_rng(1)
    for at in rng.integers(0, len(whole) - 2, 60):
        hurt = bytearray(whole)
        hurt[at] ^= 1 << int(rng.integers(0, 7))
        path.write_bytes(bytes(hurt))
        try:
            back = read_state(path)
        except StateError:
            continue
        assert back == read_state_of(whole, tmp_path)  # white space, or a digit beyond the double


def read_state_of(data, folder):
    other = folder / "other.json"
    other.write_bytes(data)
    return read_state(other)


def test_a_state_from_the_future_says_so(tmp_path):
    path = tmp_path / "s.json"
    write_state(state(), path)
    body = json.loads(path.read_text())
    path.write_text(json.dumps({**body, "version": 99}))

    assert "newer similitude" in refusal(path)


@pytest.mark.parametrize("text", ["[]", "{}", "null", '{"kind": "something else"}'])
def test_another_file_is_refused(tmp_path, text):
    path = tmp_path / "s.json"
    path.write_text(text)

    assert "not a state of ours" in refusal(path)


def test_an_edited_value_does_not_match_the_checksum(tmp_path):
    path = tmp_path / "s.json"
    write_state(state(), path)
    path.write_text(path.read_text().replace("0.013", "0.014"))

    assert "checksum" in refusal(path)


def test_a_file_that_is_not_there_or_a_folder_that_is_not(tmp_path):
    assert "cannot be read" in refusal(tmp_path / "none.json")
    with pytest.raises(StateError, match="cannot be written"):
        write_state(state(), tmp_path / "none" / "s.json")


@pytest.mark.parametrize("name", ["L [m]", "vehicle", "population"])
def test_what_differs_is_named_with_both_values(name):
    one = state()
    other = {**one.made_for, name: "another"}

    fits(one, dict(one.made_for))
    with pytest.raises(StateError) as caught:
        fits(one, other)
    assert name in caught.value.what and "another" in caught.value.what
    with pytest.raises(StateError):
        fits(one, {k: v for k, v in other.items() if k != name})
