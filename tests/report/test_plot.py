import time

import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.image import imread

from similitude.report.plot import draw, save_plot
from similitude.status import STATUS


def _labels(figure):
    return " ".join(text.get_text() for axes in figure.axes for text in axes.get_legend().get_texts())


def test_four_panels_share_time_and_say_their_units(example_run):
    figure = draw(example_run(3000))
    assert len(figure.axes) == 4
    assert len({axes.get_xlim() for axes in figure.axes}) == 1
    assert [axes.get_ylabel().rpartition("[")[2] for axes in figure.axes] == [
        "m²/s²]", "deg/s]", "deg/s]", "–]",
    ]  # fmt: skip
    assert figure.axes[3].get_xlabel() == "time [s]"


def test_no_line_has_more_than_4000_points(example_run):
    figure = draw(example_run(60_000))
    lines = [line for axes in figure.axes for line in axes.get_lines()]
    assert len(lines) >= 5
    assert max(line.get_xdata().size for line in lines if hasattr(line.get_xdata(), "size")) <= 4000


def test_the_picture_is_about_1200_by_1000_points(example_run, tmp_path):
    save_plot(example_run(3000), tmp_path / "plot.png")
    height, width = imread(tmp_path / "plot.png").shape[:2]
    assert abs(width - 1200) <= 12
    assert abs(height - 1000) <= 12


def test_a_drive_of_ten_minutes_is_drawn_quickly(example_run, tmp_path):
    run = example_run(60_000)
    spent = []
    for _ in range(2):
        start = time.process_time()  # the machine may be shared: count our own work only
        save_plot(run, tmp_path / "plot.png")
        spent.append(time.process_time() - start)
    assert min(spent) < 1.5  # 0.35 s where it was measured; the rest is room for slow machines


@pytest.mark.parametrize("name", ["too_slow", "no_measurement", "outside_linear", "bad_sample"])
def test_samples_that_could_not_teach_are_tinted_and_counted(example_run, name):
    run = example_run(400)
    run.trace.status = np.full(400, STATUS["ok"], np.int32)
    plain = _labels(draw(run))
    run.trace.status[100:200] = STATUS[name]
    figure = draw(run)
    assert "25 %" in _labels(figure)
    assert "25 %" not in plain
    tint = figure.axes[3].get_images()[0].get_array()[0, :, 3]
    shaded = np.flatnonzero(tint > 0) / tint.size
    # Bins of time are as long as two samples; the gap of the log shifts shares by its 3 %.
    assert 0.2 < shaded.min() < 0.3
    assert 0.4 < shaded.max() < 0.55


def test_the_interval_drawn_is_that_of_the_trace(example_run):
    run = example_run(900)
    band = next(c for c in draw(run).axes[0].collections if isinstance(c, PolyCollection))
    y = np.concatenate([path.vertices[:, 1] for path in band.get_paths()])
    assert np.nanmax(y) == pytest.approx(np.max(run.trace.K * np.exp(1.96 * run.trace.ln_K_std)))


def test_an_estimator_without_a_prior_draws_no_prior(example_run):
    run = example_run(500)
    assert "population alone" in _labels(draw(run))
    run.trace.ln_K_std[:] = 20.0
    assert "population alone" not in _labels(draw(run))


@pytest.mark.parametrize("case", ["nothing measured", "runaway", "constant", "two rows", "clock"])
def test_strange_runs_are_drawn_all_the_same(example_run, tmp_path, case):
    run = example_run(2 if case == "two rows" else 500, verdict="diverged", long_gap=False)
    if case == "nothing measured":
        run.trace.r_measured[:] = np.nan
        run.trace.innovation[:] = np.nan
        run.trace.status[:] = STATUS["no_measurement"]
    elif case == "runaway":
        run.trace.K[:] = np.logspace(2, 30, 500)
        run.trace.r_predicted[-50:] = 1e200
        run.trace.ln_K_std[:] = 1e4
    elif case == "constant":
        run.trace.K[:] = 100.0
        run.trace.ln_K_std[:] = 0.0
        run.trace.information[:] = 0.0
        run.trace.innovation_std[:] = 0.0
        run.trace.innovation[:] = 0.0
    elif case == "clock":
        run.trace.t[:] += 1.7e9
        assert "since the first sample" in draw(run).axes[3].get_xlabel()
    save_plot(run, tmp_path / "plot.png")
    assert imread(tmp_path / "plot.png").std() > 0.02
