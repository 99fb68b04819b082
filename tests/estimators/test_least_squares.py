"""The scatter of an estimate as it feels it: coloured residuals count for what they do."""

import numpy as np
import pytest

from .ladder_case import config, drive, library, run


def ends(name, seeds, disturb):
    """ln K at the end and its claimed variance over drives that differ in the disturbance alone."""
    rows = drive(60.0, rms=0.006, band=(0.3, 8.0))
    found = []
    for seed in seeds:
        noisy = rows.copy()
        noisy[:, 3] += disturb(np.random.default_rng(seed), len(rows))
        outputs, _, _ = run(name, noisy)
        found.append((np.log(outputs["estimate"][-1]), outputs["variance"][-1]))
    return np.array(found).T


def coloured(rng, n):
    """First-order noise of half a second, as a gusty day makes it [rad/s]."""
    x, out = 0.0, []
    for w in rng.standard_normal(n):
        x = 0.98 * x + np.sqrt(1 - 0.98**2) * w
        out.append(x)
    return 0.01 * np.array(out)


@pytest.mark.parametrize("name", ["output_error", "robust"])
def test_the_claimed_sd_is_the_scatter_under_coloured_disturbances(name):
    """Forty draws tell an sd to 11 %; the blocks' own number, ten, tells one to 22 %."""
    ln_K, variance = ends(name, range(40), coloured)

    assert 0.7 < np.sqrt(np.mean(variance)) / np.std(ln_K) < 2.2


def test_nothing_learnt_is_a_factor_e_and_grows_no_further():
    rows = drive(20.0, rms=1e-5)
    for name in ("band", "output_error", "robust"):
        outputs, _, _ = run(name, rows)
        assert (outputs["variance"] == 1.0).all()


def test_unheard_the_interval_grows_and_heard_again_it_shrinks():
    straight = drive(200.0, rms=1e-5)
    curvy = drive(60.0)
    outputs, _, _ = run("robust", np.vstack([curvy, straight, curvy]), noise=1e-3)
    before, after, again = (outputs["variance"][i] for i in (5900, 25900, -1))

    # idle_drift, 2e-3 a second over the time that the excitation took to fade until the end
    assert before + 0.3 < after < before + 0.41
    assert again < before + 0.41 * np.exp(-55 / 20)


def test_information_only_grows_and_is_that_of_what_was_learnt():
    rows = drive(60.0)
    outputs, _, _ = run("output_error", rows)
    gained = outputs["information_gained"]

    assert (np.diff(gained) >= 0).all()
    assert (np.diff(gained)[np.diff(outputs["unknowns"]) == 0][:40] == 0).all()
    assert gained[-1] > 1 / outputs["variance"][-1] / 10


def test_the_first_block_is_not_counted():
    made = config("robust")
    state = library("robust").start(made)

    assert state[library("robust").index("state", "blocks")] == -1
