"""What the monitor found, in words that terminal and page share."""

from similitude.report.alarm_words import alarm_lines, known_lines

from .example_run import example_run

DROP = {"t": 31.2, "onset": 30.4, "kind": "stiffness_drop", "change": -0.42, "std": 0.05, "lo": -0.51,
        "hi": -0.31}  # fmt: skip


def test_an_alarm_says_when_what_how_much_and_since_when():
    (line,) = alarm_lines(example_run(300, alarms=(DROP,)))

    for part in ("31.20 s", "30.40 s", "softer", "42 ± 5 %", "−51", "−31"):
        assert part in line


def test_without_alarms_there_is_nothing_to_say():
    assert alarm_lines(example_run(300)) == []


def test_what_is_known_names_interval_tyre_road_and_the_monitor():
    text = " ".join(known_lines(example_run(300)))

    for part in ("halve", "3 drives", "118", "62 %", "10 h"):
        assert part in text


def test_a_monitor_that_was_never_armed_says_why():
    run = example_run(300)
    run.monitor = {"armed_share": 0.0, "hours_between_false_alarms": 10.0}

    assert "would not have been found" in " ".join(known_lines(run))


def test_terminal_page_and_picture_show_the_alarm():
    from rich.console import Console

    from similitude.report.html_charts import charts_of
    from similitude.report.html_report import html_report
    from similitude.report.plot import draw
    from similitude.report.summary import summary
    from similitude.report.terminal import page

    run = example_run(600, alarms=(DROP | {"t": 3.2, "onset": 2.4},))
    console = Console(width=100, record=True, file=open("/dev/null", "w"))
    console.print(page(run))
    assert "softer" in console.export_text()
    record = summary(run, {})
    assert record["alarms"][0]["kind"] == "stiffness_drop"
    assert "softer" in html_report(run, record)
    assert any(span.colour == "alarm" for span in charts_of(run)["estimate"].spans)
    plain = example_run(600)
    lines = [len(axes.lines) for axes in draw(run).axes]
    assert [a - b for a, b in zip(lines, (len(x.lines) for x in draw(plain).axes), strict=True)] == [1] * 4
