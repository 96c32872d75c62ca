import json
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from made_life import folder, samples
from made_recording import content

from pipeline.errors import BadInput
from pipeline.lifespan.__main__ import main
from pipeline.lifespan.ask import Answer, first, model_error, stroke_loss
from pipeline.lifespan.figure import page, question
from pipeline.lifespan.gather import strings
from pipeline.lifespan.left import LEAST_STROKES, Left
from pipeline.lifespan.record import sentence
from pipeline.lifespan.score import held, loses, score
from pipeline.lifespan.scoretable import words
from pipeline.rig import __main__ as rig

ROOT = Path(__file__).parents[2]


def program(*arguments):
    command = [sys.executable, "-m", "pipeline.lifespan", *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    place = tmp_path_factory.mktemp("life")
    ran = program(folder(place, "a-1", samples(24, 0.002)), "--out", place / "out")
    return ran, place / "out" / "a-1"


def test_the_program_ends_well(done):
    ran, out = done
    assert ran.returncode == 0, ran.stderr
    assert "until 10 % of the stroke is lost" in ran.stdout and "cannot be foreseen" in ran.stdout
    assert (out / "lifespan.png").stat().st_size > 10_000


def test_json_says_what_is_documented(done):
    told = json.loads((done[1] / "lifespan.json").read_text())
    assert told["string"] == "a-1" and told["strokes_seen"] == 24 and told["level"] == 0.9
    loss, error = told["questions"]["stroke_loss"], told["questions"]["model_error"]
    assert loss["state"] in ("interval", "one-sided") and loss["unit"] == "1" and loss["limit"] == 0.1
    # 0.2 % a stroke against the mean of the first three: the limit is passed at stroke 52
    assert loss["strokes_left"]["low"] < 28 < (loss["strokes_left"]["high"] or np.inf)
    assert loss["at_stroke"]["low"] == pytest.approx(24 + loss["strokes_left"]["low"], abs=1e-3)
    assert sum(law["weight"] for law in loss["laws"]) == pytest.approx(1.0, abs=0.05)
    assert {"name", "formula", "weight", "left_out_rms", "parameters"} == set(loss["laws"][0])
    assert error["state"] == "passed" or error["horizon_strokes"] > 0
    assert "stiffness_n_per_mm" in told["absent"]
    assert len(told["indicators"]["stroke_mm"]) == len(told["indicators"]["stroke_mm_error"]) == 24
    docs = (ROOT / "docs" / "lifespan.md").read_text()
    for key in (*told, *loss):
        assert f"`{key}`" in docs, key


@pytest.fixture(scope="module")
def drawn(done):
    """The first question to a string, with futures that pass the limit when a test says, as drawn."""
    health = strings([done[1].parents[1] / "a-1"])[0]
    answer = stroke_loss(health, 0.1)

    def draw(*when):
        left = replace(answer.left, when=np.sort(np.array(when, float)))
        axes = plt.figure().add_subplot()
        question(axes, replace(answer, left=left), 0.9)
        return axes

    yield draw
    plt.close("all")


def test_an_interval_with_an_end_is_drawn_to_its_end_and_one_without_to_an_arrow(drawn):
    for when, arrow in ((np.linspace(34, 141, 200), False), ([*np.linspace(34, 141, 100), *[np.inf] * 100], True)):
        axes = drawn(*when)
        ends = [line for line in axes.get_lines() if line.get_marker() == ">"]
        assert bool(ends) == arrow
        assert (axes.get_xlim()[1] > 24 + 136) != arrow
        assert any(f"{'more than' if arrow else 'to'} " in text.get_text() for text in axes.texts)


@pytest.mark.parametrize("strokes", [5, 24])
def test_strokes_are_whole_numbers_and_the_legend_lies_beside_the_axes_and_names_every_line(tmp_path, strokes):
    health = strings([folder(tmp_path, "a-1", samples(strokes, 0.002))])[0]
    axes = plt.figure().add_subplot()
    question(axes, stroke_loss(health, 0.1), 0.9)
    axes.figure.canvas.draw()
    assert all(tick == round(tick) for tick in axes.get_xticks())
    box = axes.get_legend().get_window_extent()
    assert box.y0 >= axes.get_window_extent().y1 - 1.0
    assert "last stroke seen" in [text.get_text() for text in axes.get_legend().get_texts()]
    plt.close("all")


def test_where_the_interval_begins_beyond_the_drawing_its_words_stand_above_the_limit(drawn):
    axes = drawn(*np.linspace(2000, 3000, 100), *[np.inf] * 100)
    (words,) = [text for text in axes.texts if "interval begins at stroke" in text.get_text()]
    axes.figure.canvas.draw()
    limit = axes.transData.transform((0.0, 10.0))[1]
    assert words.get_window_extent().y0 > limit + 2.0


def test_too_few_strokes_are_said_and_no_error(tmp_path):
    ran = program(folder(tmp_path, "a-1", samples(5, 0.002)), "--out", tmp_path / "out")
    assert ran.returncode == 0 and ran.stdout.splitlines()[0] == (
        "a-1: no forecast yet: 5 strokes seen; at least 12 are needed, 7 more than there are."
    )
    assert "new run with the same --string-id (a-1), then name all runs" in ran.stdout and "--strokes 24" in ran.stdout
    assert re.search(r"lost: no forecast yet. So far the stroke is [0-9.]+ % shorter than over the first 3", ran.stdout)
    assert re.search(r"1 mm: no forecast yet. So far it is off by [0-9.]+ mm \(the last 2 strokes, med", ran.stdout)
    told = json.loads((tmp_path / "out" / "a-1" / "lifespan.json").read_text())
    assert told["first"] is None and told["questions"]["stroke_loss"]["strokes_left"]["low"] is None


def test_a_single_stroke_is_no_error(tmp_path):
    """No stroke is left to compare with the first ones: the figure had nothing to draw a line at."""
    out = tmp_path / "out"
    ended = program(folder(tmp_path, "a-1", samples(1, 0.004)), "--out", out)
    assert ended.returncode == 0 and "no forecast yet: 1 stroke seen" in ended.stdout, ended.stderr
    assert ended.stdout.count("from stroke 4 on it shows") == 2
    assert (out / "a-1" / "lifespan.png").stat().st_size


@pytest.mark.parametrize("strokes", [1, 3, 11, 12])
def test_no_panel_is_empty_and_one_without_a_forecast_says_how_many_strokes_it_needs(tmp_path, monkeypatch, strokes):
    health = strings([folder(tmp_path, "a-1", samples(strokes, 0.004))])[0]
    with monkeypatch.context() as held:
        held.setattr(plt, "close", lambda figure: None)
        page(health, [stroke_loss(health, 0.1), model_error(health, 1.0)], 0.9, tmp_path / "page.png")
    panels = plt.gcf().axes
    for axes in panels:
        points = sum(np.isfinite(np.asarray(line.get_ydata(), float)).any() for line in axes.get_lines()
                     if len(line.get_xdata()) == len(line.get_ydata()) > 0 and line.get_marker() == ".")  # fmt: skip
        assert points or any("12" in text.get_text() for text in axes.texts)
    needed = [axes.get_title(loc="left") for axes in panels[:2]]
    told = f"no forecast yet: {strokes} strokes, 12 needed".replace(" 1 strokes", " 1 stroke")
    assert (told in needed) == (strokes < 12)
    plt.close("all")


def test_help_the_page_and_the_rig_say_how_many_strokes_a_forecast_needs():
    page_ = (ROOT / "docs" / "lifespan.md").read_text().split("## How")[0]
    assert f"{LEAST_STROKES} complete strokes" in page_ and "--strokes 24" in page_
    assert f"{LEAST_STROKES} complete strokes" in program("--help").stdout and rig.FORECAST == LEAST_STROKES
    assert "12 to foretell" in rig.strokes_of(9) and "foretell" not in rig.strokes_of(12)


def said_of(drawn_when, state):
    """One question's sentence for futures that pass their limit when a test says."""
    left = Left(when=np.sort(np.array(drawn_when, float)), horizon=120.0, choice=SimpleNamespace(
        best=SimpleNamespace(law=SimpleNamespace(name="linear")), weights=np.array([0.6, 0.4])))  # fmt: skip
    assert left.span(0.9).state == state
    return sentence(Answer("stroke_loss", "", "1", np.array([12.0]), np.zeros(1), np.zeros(1), 0.1, left), 0.9)


def test_the_sentence_says_what_is_sure_and_what_half_of_the_futures_do():
    limit, law = "until 10 % of the stroke is lost:", "The law of most weight: linear (60 %)."
    low, never = [10.0] * 9, [np.inf] * 60  # 9 of 100 pass at 10 strokes
    assert said_of([*low, *[66.0] * 31, *never], "one-sided") == (
        f"{limit} at least 66 strokes left (90 % sure); at least half of the futures last beyond 120, which is as far "
        f"as is asked. {law}"
    )
    assert said_of([*low, *[66.0] * 31, *[80.0] * 30, *never[:30]], "one-sided") == (
        f"{limit} at least 66 strokes left (90 % sure); half of the futures last longer than 80, some beyond 120, "
        f"which is as far as is asked. {law}"
    )
    assert said_of([*[20.0] * 10, *[40.0] * 80, *[90.0] * 10], "interval") == (
        f"{limit} 20 to 90 strokes left (90 % sure); half of the futures last longer than 40. {law}"
    )
    assert said_of([*low, *[np.inf] * 91], "censored") == (
        f"{limit} more than 120 strokes left (90 % sure), which is as far as is asked."
    )


def bedded(strokes, first):
    """Samples of strokes of which the first ones of a string have wider loops; `first` is the number of the first."""
    table = samples(strokes, 0.0, noise_mm=0.01)
    number = table.index // 114
    falls = (table["motor_turns"].diff() < 0) | (table["motor_turns"].shift(-1) < table["motor_turns"])
    wider_mm = np.where(falls, 0.5 * np.exp(-(number + first - 1) / 3.0), 0.0)
    return table.assign(displacement_mm=table["displacement_mm"] - wider_mm + 0.05 * number)


def test_a_run_that_begins_as_the_string_began_is_told_as_perhaps_another_string(tmp_path):
    one = {"string": {**content("x")["string"], "id": "s"}}
    runs = [folder(tmp_path, "a-1", bedded(8, 1), **one), folder(tmp_path, "a-2", bedded(8, 9), **one)]
    runs.append(folder(tmp_path, "a-3", bedded(8, 1), **one))
    assert strings(runs[:2])[0].anew == [] and strings(runs)[0].anew == ["a-3"]
    ran = program(*runs, "--out", tmp_path / "out")
    assert "a-3 begins as this string began" in ran.stdout and "a-2 begins" not in ran.stdout, ran.stderr
    assert "give it a string.id of its own" in ran.stdout
    assert json.loads((tmp_path / "out" / "s" / "lifespan.json").read_text())["starts_anew"] == ["a-3"]


def test_bad_input_is_named(tmp_path, monkeypatch, capsys):
    run = folder(tmp_path, "a-1", samples(5, 0.002))
    for arguments in (("--loss", "2"), ("--drift-mm", "0"), ("--level", "1")):
        monkeypatch.setattr(sys, "argv", ["lifespan", str(run), "--out", str(tmp_path / "out"), *arguments])
        with pytest.raises(SystemExit) as ended:
            main()
        said = capsys.readouterr().err
        assert ended.value.code == 2 and arguments[0] in said and "Mend" in said
    assert not (tmp_path / "out").exists()


def test_a_run_named_twice_is_refused(tmp_path):
    run = folder(tmp_path, "a-1", samples(5, 0.002))
    with pytest.raises(BadInput, match="twice"):
        strings([run, run.parent / "." / run.name])


def test_of_limits_that_were_passed_the_earlier_is_first(tmp_path):
    (one,) = strings([folder(tmp_path, "a-1", samples(24, 0.006))])
    late, early = stroke_loss(one, 0.10), stroke_loss(one, 0.05)
    assert early.left.passed_at < late.left.passed_at
    assert first([late, early]) is early and first([early, late]) is early


def test_a_life_is_scored_against_its_truth(tmp_path):
    folder(tmp_path, "a-1", samples(70, 0.002))
    stroke_mm = 10.0 * (1.0 - 0.002 * np.arange(70))
    pd.DataFrame({"run": "a-1", "stroke": np.arange(1, 71), "stroke_mm": stroke_mm}).to_parquet(
        tmp_path / "truth.parquet"
    )
    rows = score(tmp_path, 0.1, 5.0)
    lost = rows[rows["question"] == "stroke_loss"]
    assert lost["left"].iloc[0] + lost["seen"].iloc[0] == 52 and not lost["censored"].any()
    assert set(lost["cut"]) == {"25% of the life", "50% of the life", "75% of the life", "15 strokes", "30 strokes"}
    assert lost.groupby("method").size().nunique() == 1
    assert "| this forecast |" in words(rows)


def test_censored_lives_count_only_where_they_tell():
    left = Left(when=np.linspace(10.0, 20.0, 1001), horizon=100.0)
    assert held(left, 0.9, 15.0, False) == 1.0 and held(left, 0.9, 20.0, False) == 0.0
    assert held(left, 0.9, 20.0, True) == 0.0  # it went on beyond the upper end
    assert np.isnan(held(left, 0.9, 15.0, True)) and np.isnan(held(left, 0.9, 5.0, True))
    open_ended = Left(when=np.concatenate([np.linspace(10.0, 20.0, 500), np.full(500, np.inf)]), horizon=100.0)
    assert held(open_ended, 0.9, 15.0, True) == 1.0 and np.isnan(held(open_ended, 0.9, 5.0, True))
    assert np.isnan(held(Left("why"), 0.9, 5.0, False))


def test_a_life_s_limit_is_against_the_mean_of_the_first_three():
    truth = pd.DataFrame({"stroke": [1, 2, 3, 4, 5], "stroke_mm": [11.0, 10.0, 8.99, 9.1, 8.9]})
    assert loses(truth, 0.1) == 3.0 and np.isinf(loses(truth, 0.5))


@pytest.mark.parametrize("columns", [None, {"stroke": [1]}])
def test_a_truth_that_is_none_is_refused(tmp_path, columns):
    path = tmp_path / "truth.parquet"
    if columns is None:
        path.write_text("no table")
    else:
        pd.DataFrame(columns).to_parquet(path)
    with pytest.raises(BadInput, match="endurance rig"):
        score(tmp_path, 0.1, 5.0)


def test_an_out_that_is_a_file_is_refused_before_anything_is_asked(tmp_path):
    (tmp_path / "out").write_text("kept")
    ran = program(folder(tmp_path, "a-1", samples(24, 0.002)), "--out", tmp_path / "out")
    assert ran.returncode == 2 and "--out" in ran.stderr and (tmp_path / "out").read_text() == "kept"
