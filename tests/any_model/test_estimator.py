"""From model to C: the twin's bits, the exported folder, and a model nobody shipped."""

from dataclasses import replace

import numpy as np
import pytest

from similitude import Model, Quantity, make_estimator, shipped_system
from similitude.embedded.verify import verify_folder
from similitude.errors import SimilitudeError

from .gallery import CASES, made

SLOW = ("overhead_crane", "aircraft_short_period", "quarter_car")
ALL = [pytest.param(n, marks=pytest.mark.slow) if n in SLOW else n for n in CASES]


@pytest.mark.parametrize("name", ALL)
def test_the_c_and_its_twin_give_the_same_bits(name):
    estimator = made(name)
    assert estimator.library.c is not None, estimator.library.why_slow
    log = estimator.simulate(seed=3)
    rows = np.column_stack([np.full(len(log["t"]), estimator.step), *list(log.values())[1:]])[:600]
    rng = np.random.default_rng(0)
    for column in range(rows.shape[1]):
        rows[rng.random(len(rows)) < 0.01, column] = rng.choice([np.nan, np.inf, 0.0, -1e30])
    config, states, outputs = estimator.config, [], []
    for library in (estimator.library, estimator.twin):
        states.append(library.start(config))
        outputs.append(library.run(config, states[-1], rows))

    assert outputs[0][0].tobytes() == outputs[1][0].tobytes()
    assert (outputs[0][1] == outputs[1][1]).all()
    assert states[0].tobytes() == states[1].tobytes() and np.isfinite(states[0]).all()


@pytest.mark.parametrize("name", ALL)
def test_the_exported_folder_passes_its_own_test(name, tmp_path):
    done = made(name).export(tmp_path / "firmware", target="host")

    assert verify_folder(done.folder).name == made(name).library.name
    assert done.numbers.sample_time == made(name).step


def test_single_precision_finds_the_same(tmp_path):
    """The exported float is another build of the same program; its twin's words were just compared."""
    estimator = made("rlc_circuit")
    from similitude.embedded.vectors import expected

    log = estimator.simulate(seed=2)
    rows = np.column_stack([np.full(1000, estimator.step), log["u"][:1000], log["vc"][:1000]])
    single = expected(estimator.source.twin, "float", estimator.config, rows)
    double = expected(estimator.source.twin, "double", estimator.config, rows)
    one, two = single.outputs.view(np.float32)[-1], double.outputs.view(np.float64)[-1]

    assert abs(np.log(one[0] / two[0])) < 0.5 * np.sqrt(two[1])


def test_a_model_of_ones_own_with_feedthrough_goes_the_same_way():
    """Force on a mass, measured by an accelerometer: the output shows the input at once."""
    model = Model(
        name="cart",
        states=(Quantity("v", "m/s", "speed"),),
        inputs=(Quantity("F", "N", "force"),),
        outputs=(Quantity("acc", "m/s^2", "acceleration"),),
        parameters=(Quantity("m", "kg", "mass"), Quantity("c", "N s/m", "friction")),
        rates={"v": "(F - c*v)/m"},
        output_map={"acc": "(F - c*v)/m"},
    )
    t = np.arange(0, 20, 0.02)
    estimator = make_estimator(
        model, drive=np.sign(np.sin(t)), step=0.02, noise="0.02 m/s^2",
        prior={"m": "2 kg +- 30 %", "c": "1 N s/m +- 30 %"}, kind="population",
    )  # fmt: skip
    found, truth = estimator.run(estimator.simulate(seed=1)), estimator.drawn(1)

    assert found.verdict == "identified"
    for name, one in found.parameters.items():
        assert abs(np.log(one.value / truth[name])) < 3 * one.sd, name


def test_changing_the_users_units_changes_nothing():
    case = {**CASES["dc_motor"], "prior": {"J": "100 kg cm^2 +- 50 %", "b": "100 mN m s/rad +- 30 %"}}
    mine = make_estimator(shipped_system("dc_motor"), **case)

    np.testing.assert_allclose(mine.config, made("dc_motor").config, rtol=1e-9)


def test_nothing_is_shared_between_runs():
    estimator = made("rlc_circuit")
    log = estimator.simulate(seed=2)

    assert estimator.run(log).value.tobytes() == estimator.run(log).value.tobytes()


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"noise": "0.1 A"}, "noise"),
        ({"drive": np.zeros(100)}, "drive"),
        ({"base": ("R", "K")}, "cannot be a base"),
        ({"input": None}, "2 inputs and none was chosen"),
        ({"roles": {"mu": "never"}}, "does not exist"),
    ],
)
def test_what_is_wrong_is_said_in_four_parts(changes, said):
    with pytest.raises(SimilitudeError, match=said) as raised:
        make_estimator(shipped_system("dc_motor"), **{**CASES["dc_motor"], **changes})
    assert raised.value.usually and raised.value.paste and raised.value.read


def test_a_bare_model_wants_all_its_values():
    bare = replace(shipped_system("dc_motor").model, name="bare")
    with pytest.raises(SimilitudeError, match="nothing is known of parameter"):
        make_estimator(bare, **CASES["dc_motor"])
