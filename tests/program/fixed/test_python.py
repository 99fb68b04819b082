"""The twin is a module with layout, fractions, init and step."""

from tests.program.fixed.lowered import tiny_fixed, twin_of


def test_the_twin_says_what_its_words_are():
    twin = twin_of(tiny_fixed())

    assert [row[0] for row in twin.STATE] == ["mean_high", "mean_low", "last_0", "last_1"]
    assert len(twin.SAMPLE) == len(twin.SAMPLE_FRACTIONS)
    assert "Q" in twin.SAMPLE[1][2] and twin.SAMPLE[1][1] == "V"
    assert twin.OPERATIONS > 5


def test_a_step_returns_status_and_words():
    twin = twin_of(tiny_fixed())
    state = twin.init([0])
    status, out = twin.step([0], state, [1 << 29, 5 << twin.SAMPLE_FRACTIONS[1]])

    assert status == 0 and len(out) == 1 and out[0] > 0
    assert twin.step([0], state, [1 << 29, -(2**31)])[0] == 7
