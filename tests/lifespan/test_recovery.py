"""A string that creeps under load and takes it back in each break does not age: its drift is told, and not foretold."""

import json
import re
from pathlib import Path
from typing import Any, cast

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import programs
import pytest
from made_life import folder, samples
from stages.nine_strokes import string

from pipeline.lifespan.__main__ import ask
from pipeline.lifespan.figure import page
from pipeline.lifespan.forecast.life_questions import model_error
from pipeline.lifespan.forecast.recovering import recovering
from pipeline.lifespan.from_folders import strings
from pipeline.lifespan.stroke_health.recovery import recovery
from pipeline.lifespan.words.recovery_said import recovery_line


def creeping(place: Path, runs: int, wear_mm: float = 0.0) -> list[Path]:
    """Runs of nine strokes of one string: it creeps by 0.4 mm and takes all back."""
    folders = []
    for number in range(runs):
        table = samples(9, 0.0, noise_mm=0.01)
        stroke = np.minimum(np.arange(len(table)) // 114, 8)
        creep_mm = -0.4 * np.expm1(-np.arange(len(table)) / 114.0 / 3.0)
        worn_mm = wear_mm * (9 * number + stroke)
        table["displacement_mm"] += 0.05 * stroke - creep_mm - worn_mm + 1e-4 * number
        table["time_s"] += 1e4 * number
        folders.append(folder(place, f"a-{number + 1}", table, string=string(id="a"), tare="checked"))
    return folders


def asked(place: Path, runs: int) -> tuple[str, dict[str, Any]]:
    """What the program prints in one line, and what it writes."""
    done = programs.run("pipeline.lifespan", *creeping(place, runs), "--drift-mm", "0.6", "--out", place / "out")
    assert done.returncode == 0, done.stderr
    return " ".join(done.stdout.split()), json.loads((place / "out" / "a" / "lifespan.json").read_text())


def test_what_comes_back_in_each_break_is_said_to_be_no_wear_and_is_not_foretold_to_grow(tmp_path: Path) -> None:
    """A string that never aged was to be calibrated again: its creep was foretold to go on for ever."""
    text, saved = asked(tmp_path, 4)
    assert re.search(
        r"Recovery: in 3 of 3 breaks that error fell back, by 0\.\d+ mm in the median\. That recovers", text
    )
    assert "is no wear. The forecast counts as wear only what stays after the breaks" in text
    assert saved["recovery"]["state"] == "recovers" and saved["recovery"]["breaks_in_all"] == 3
    assert [each["before_stroke"] for each in saved["recovery"]["breaks"]] == [10, 19, 28]
    assert all(each["error_after_mm"] < 0.5 * each["error_before_mm"] for each in saved["recovery"]["breaks"])
    error = saved["questions"]["model_error"]
    assert error["strokes_left"]["median"] is None and error["strokes_left"]["low"] > 200
    assert "need not be calibrated again" in text or error["state"] == "one-sided"


def test_one_break_is_said_to_be_too_few_and_which_run_would_tell(tmp_path: Path) -> None:
    text, saved = asked(tmp_path, 2)
    assert re.search(r"Recovery: in the break before stroke 10 that error fell from 0\.\d+ to 0\.\d+ mm\. It may", text)
    assert "one break is too few to tell. The forecast takes it for wear" in text
    assert "A run under the same load after a rest of 2 minutes or more would tell." in text, "a run takes 103 s"
    assert "That bound takes what came back in a break for wear." in text
    assert saved["recovery"]["state"] == "may be" and len(saved["recovery"]["breaks"]) == 1


def test_wear_that_stays_is_foretold_beside_what_recovers(tmp_path: Path) -> None:
    """The string wears by 0.02 mm a stroke: from 0.9 mm at stroke 36 it is off by 2 mm near stroke 90."""
    (health,) = strings(creeping(tmp_path, 4, wear_mm=0.02))
    assert recovery(health.strokes).is_known
    span = model_error(health, 2.0).left.span(0.9)
    true = (2.0 - float(health.strokes["model_error_mm"].iloc[-1])) / 0.02
    assert span.low < true < span.high and span.median == pytest.approx(true, rel=0.5)


def table_of(errors_mm: list[list[float]]) -> pd.DataFrame:
    """Strokes of runs with these errors of the model."""
    rows = [(f"a-{run}", value) for run, values in enumerate(errors_mm) for value in values]
    table = pd.DataFrame(rows, columns=["run", "model_error_mm"])
    return table.assign(stroke=np.arange(1, len(table) + 1), model_error_mm_error=0.002)


def test_a_break_without_a_good_part_back_is_none() -> None:
    grows = np.linspace(0.0, 0.4, 9)
    for back_mm, count in ((0.3, 1), (0.1, 0), (0.0, 0), (-0.3, 0)):
        assert len(recovery(table_of([[*grows], [*(grows[:6] + 0.4 - back_mm)]])).breaks) == count
    assert not recovery(table_of([[*(0.1 * grows)], [*(0.1 * grows)]])).breaks, "0.04 mm is too little to say"
    assert recovery(table_of([[*grows]])).count == 0


def test_runs_that_are_too_short_and_breaks_of_which_few_took_back_are_said_to_be() -> None:
    short = recovery(table_of([[0.0, 0.28, 0.3, 0.3, 0.3]] * 3))
    assert short.is_usual and not short.is_known
    assert "the runs are too short to tell" in recovery_line(short, True, 3.2)
    grows = np.linspace(0.0, 0.4, 9)
    seldom = recovery(table_of([[*grows], [*grows], *([*(grows + 0.4 * number)] for number in range(1, 4)), [*grows]]))
    assert len(seldom.breaks) == 2 and seldom.count == 5 and not seldom.is_known
    line = recovery_line(seldom, False, 0.2)
    assert "2 of 5 breaks are too few to tell." in line and "rest of 1 minute or more" in line
    assert "forecast" not in line


@pytest.mark.parametrize("is_log", [False, True])
def test_the_part_that_recovers_is_found_beside_wear(is_log: bool) -> None:
    since = np.tile(np.arange(1.0, 13.0), 4)
    n = np.arange(1.0, 49.0)
    part_mm = 0.1 * np.log1p(since) if is_log else -0.3 * np.expm1(-since / 4.0)
    own = recovering(n, part_mm + 0.01 * n, since)
    assert own.is_log is is_log and own.at(since) == pytest.approx(part_mm, abs=0.02)
    further = own.ahead(np.array([0.0, 100.0]), 4)
    assert further[:, 0] == pytest.approx(0.0) and further[1::2] == pytest.approx(0.0), "with breaks nothing is added"
    assert bool(further[0, 1] > 0.15) is is_log


def boxes(figure: Any, axes: Any) -> tuple[Any, list[Any]]:
    """The words at the bar of a panel and the curves of its futures, in pixels."""
    figure.canvas.draw()
    (words,) = [text for text in axes.texts if "of the futures" in text.get_text()]
    curves = [line for line in axes.get_lines() if line.get_label() == "median of the futures"]
    edges = [axes.collections[-1].get_paths()[0].vertices, *(line.get_xydata() for line in curves)]
    return words.get_window_extent(), [axes.transData.transform(edge) for edge in edges]


@pytest.mark.parametrize(("runs", "loss", "drift_mm"), [(2, 0.1, 0.6), (4, 0.1, 0.6), (1, 0.1, 5.0), (1, 0.02, 2.0)])
def test_no_words_lie_on_a_curve_and_the_arrow_has_room_in_the_frame(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, runs: int, loss: float, drift_mm: float
) -> None:
    """Words lay on the median of the futures, and an arrow was cut by the frame's edge."""
    own = creeping(tmp_path, runs) if runs > 1 else [folder(tmp_path, "a-1", samples(24, 0.0008))]
    (health,) = strings(own)
    with monkeypatch.context() as kept_open:
        kept_open.setattr(plt, "close", lambda figure: None)
        page(health, ask(health, loss, drift_mm), 0.9, tmp_path / "page.png")
    figure = plt.gcf()
    for axes in figure.axes[:2]:
        words, curves = boxes(figure, axes)
        frame = axes.get_window_extent()
        assert frame.x0 < words.x0 and words.x1 < frame.x1 and frame.y0 < words.y0 and words.y1 < frame.y1
        for curve in curves:
            dense = np.linspace(0.0, len(curve) - 1.0, 40 * len(curve))
            x, y = (np.interp(dense, np.arange(len(curve)), side) for side in curve.T)
            assert not ((x > words.x0) & (x < words.x1) & (y > words.y0) & (y < words.y1)).any()
        for arrow in (line for line in axes.get_lines() if line.get_marker() == ">"):
            assert frame.x0 < axes.transData.transform(arrow.get_xydata())[0, 0] < frame.x1 - 8.0
    heads = [cast(Any, axes).get_title(loc="left") for axes in figure.axes[:2]]
    assert ("creep that recovers, and no wear" in heads[1]) is (runs > 1) and "recovers" not in heads[0]
    plt.close("all")
