import json
import re
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import programs
import pytest
from made_life import folder, samples
from made_recording import content

from pipeline.ground.errors import BadInput
from pipeline.ground.words import wrapped_lines
from pipeline.lifespan.__main__ import main
from pipeline.lifespan.figure import page, question
from pipeline.lifespan.forecast.laws import LAWS
from pipeline.lifespan.forecast.life_questions import Answer, first, model_error, stroke_loss
from pipeline.lifespan.forecast.strokes_left import ACCELERATES, HORIZON, LEAST_STROKES, Left, sudden, surprises
from pipeline.lifespan.from_folders import strings
from pipeline.lifespan.score.__main__ import held, loses, score
from pipeline.lifespan.score.scoretable import words
from pipeline.lifespan.stroke_health.at_rest import longer_at_rest
from pipeline.lifespan.words import page_lines
from pipeline.lifespan.words.calibration_advice import advice, recalibrate_after, rests_on
from pipeline.lifespan.words.claims_held import HELD, measured
from pipeline.lifespan.words.figure_words import WIDE, footnote, which_run
from pipeline.lifespan.words.sentences import UNFORESEEN, answered, sentence
from pipeline.lifespan.words.so_far import beside_limit, so_far
from pipeline.rig import __main__ as rig

ROOT = Path(__file__).parents[2]


def program(*arguments):
    return programs.run("pipeline.lifespan", *arguments)


def joined(text):
    """Printed lines without the breaks of the page's width."""
    return re.sub(r"\n {6,}", " ", text)


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    place = tmp_path_factory.mktemp("life")
    ran = program(folder(place, "a-1", samples(24, 0.002)), "--out", place / "out")
    return ran, place / "out" / "a-1"


def test_the_program_ends_well(done):
    ran, out = done
    assert ran.returncode == 0, ran.stderr
    assert "In our tests (120 synthetic strings) such an" in " ".join(ran.stdout.split())
    assert (
        ran.stdout.index("Until that model") < ran.stdout.index("  Advice: ") < ran.stdout.index("  Written")
        and "Such a zero" not in ran.stdout
    )
    assert "Until 10 % of the stroke is lost" in ran.stdout and "A sudden end" in ran.stdout
    before, _, after = ran.stdout.partition("  A future is one of 2,000 ways in which this string may go on")
    assert "futures" in after and "futures" not in before, "a word is said before its meaning"
    assert (out / "lifespan.png").stat().st_size > 10_000


def test_json_says_what_is_documented(done):
    saved = json.loads((done[1] / "lifespan.json").read_text())
    assert saved["string"] == "a-1" and saved["strokes_seen"] == 24 and saved["level"] == 0.9
    loss, error = saved["questions"]["stroke_loss"], saved["questions"]["model_error"]
    assert loss["state"] in ("interval", "one-sided") and loss["unit"] == "1" and loss["limit"] == 0.1
    # 0.2 % a stroke against the mean of the first three: the limit is passed at stroke 52
    assert loss["strokes_left"]["low"] < 28 < (loss["strokes_left"]["high"] or np.inf)
    assert loss["at_stroke"]["low"] == pytest.approx(24 + loss["strokes_left"]["low"], abs=1e-3)
    assert sum(law["weight"] for law in loss["laws"]) == pytest.approx(1.0, abs=0.05)
    assert {"name", "formula", "weight", "left_out_rms", "parameters"} == set(loss["laws"][0])
    assert error["state"] == "passed" or error["horizon_strokes"] > 0
    assert "stiffness_n_per_mm" in saved["absent"]
    assert len(saved["indicators"]["stroke_mm"]) == len(saved["indicators"]["stroke_mm_error"]) == 24
    docs = (ROOT / "docs" / "lifespan.md").read_text()
    for key in (*saved, *loss):
        assert f"`{key}`" in docs, key


@pytest.fixture(scope="module")
def drawn(done):
    """The first question to a string, with futures that pass the limit when a test says, as drawn."""
    health = strings([done[1].parents[1] / "a-1"])[0]
    answer = stroke_loss(health, 0.1)

    def answered(*when):
        return replace(answer, left=replace(answer.left, when=np.sort(np.array(when, float))))

    def draw(*when):
        axes = plt.figure().add_subplot()
        question(axes, answered(*when), 0.9)
        return axes

    draw.answer = answered
    yield draw
    plt.close("all")


def test_an_interval_with_an_end_is_drawn_to_its_end_and_one_without_to_an_arrow(drawn):
    for when, arrow in ((np.linspace(34, 141, 200), False), ([*np.linspace(34, 141, 100), *[np.inf] * 100], True)):
        axes = drawn(*when)
        ends = [line for line in axes.get_lines() if line.get_marker() == ">"]
        assert bool(ends) == arrow
        assert axes.get_xlim()[1] == pytest.approx(24 + 240 if arrow else 24 + 1.15 * 136, rel=0.06)
        assert any(f"{'at least' if arrow else 'to'} " in text.get_text() for text in axes.texts)


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


def test_the_axis_reaches_as_far_as_the_words_and_both_bounds_are_the_same_whole_strokes(drawn):
    """The words said 197 strokes and beyond 240 where the axis ended after 96, and 9.52 strokes were `at least 10`."""
    for when in ([*[9.52] * 20, *[197.3] * 20, *[np.inf] * 160], [*[197.9] * 30, *[np.inf] * 170]):
        answer, axes = drawn.answer(*when), drawn(*when)
        claim_text = " ".join(sentence(answer, 0.9))
        (least,) = re.findall(r"at least ([0-9]+) strokes left in 90 % of the futures", claim_text)
        assert int(least) == int(answer.left.span(0.9).low)
        beside = [text.get_text().replace("\n", " ") for text in axes.texts]
        assert [f"at least {least} strokes left in 90 % of the futures"] == beside
        axes.figure.canvas.draw()
        assert axes.get_xlim()[1] == pytest.approx(24 + answer.left.horizon, rel=0.06)
        (begins,) = [line.get_xdata()[0] for line in axes.get_lines() if line.get_marker() == "|"]
        assert int(begins) == 24 + int(least) < axes.get_xlim()[1]


def test_the_median_future_begins_where_the_points_end_and_no_error_is_negative(tmp_path):
    health = strings([folder(tmp_path, "a-1", samples(24, 0.002))])[0]
    for answer in (stroke_loss(health, 0.1), model_error(health, 4.0)):
        band = answer.left.band
        band = replace(band, values=band.values - 0.2 * band.ahead)
        answer = replace(answer, left=replace(answer.left, band=band))
        axes = plt.figure().add_subplot()
        question(axes, answer, 0.9)
        lines = {line.get_label(): line for line in axes.get_lines()}
        assert min(lines["median of the futures"].get_xdata()) == 24
        (fitted,) = [line for label, line in lines.items() if label.startswith("law fitted")]
        assert max(fitted.get_xdata()) == 24
        shade = axes.collections[-1].get_paths()[0].vertices
        assert answer.unit == "1" or shade[:, 1].min() >= 0.0
    plt.close("all")


@pytest.mark.parametrize(("loss", "state"), [(0.002, "interval"), (0.0002, "one-sided")])
def test_the_shade_meets_the_limit_where_the_bar_begins_and_ends(tmp_path, loss, state):
    """The bar counted sudden ends and was put later, and an arrow left out 10 % where the shade left out 5 %."""
    answer = stroke_loss(strings([folder(tmp_path, "a-1", samples(24, loss))])[0], 0.1)
    span, axes = answer.left.span(0.9), plt.figure().add_subplot()
    assert span.state == state
    question(axes, answer, 0.9)
    edge = axes.collections[-1].get_paths()[0].vertices
    above = edge[(edge[:, 1] >= 10.0) & (edge[:, 0] > 24.0)][:, 0]
    assert above.min() - 24.0 == pytest.approx(span.low, rel=0.05)
    if state == "interval":
        end = edge[:, 0].max()
        assert end - 24.0 == pytest.approx(span.high)
        assert edge[edge[:, 0] == end][:, 1].min() == pytest.approx(10.0, rel=0.05)
    inside = "90 %" if state == "interval" else "80 %"
    legend = [text.get_text() for text in axes.get_legend().get_texts()]
    assert f"the middle {inside} of the futures" in legend and "limit, 10 %" in legend
    plt.close("all")


def test_the_picture_says_what_its_lines_are_and_a_loop_below_0(tmp_path, monkeypatch):
    health = strings([folder(tmp_path, "a-1", samples(24, 0.002))])[0]
    monkeypatch.setattr(plt, "close", lambda figure: None)
    for sign in (1.0, -1.0):
        table = health.strokes.assign(loop_mm=sign * health.strokes["loop_mm"].abs())
        changed_health = replace(health, strokes=table)
        page(
            changed_health,
            [stroke_loss(changed_health, 0.1), model_error(changed_health, 4.0)],
            0.9,
            tmp_path / "page.png",
        )
        heads = [axes.get_title(loc="left") for axes in plt.gcf().axes]
        assert any("shorter while it unwinds" in head for head in heads) == (sign < 0.0)
        assert not any("unwinds" in text.get_text() for axes in plt.gcf().axes for text in axes.texts), (
            "lines crossed it"
        )
        foot = plt.gcf().get_supxlabel()
        assert max(map(len, foot.split("\n"))) <= WIDE and len(foot.split("\n")) <= len(foot) / WIDE + 3
        for word in ("Blue: ", "Green: ", "Orange: ", "Black bar: ", "ends suddenly", "Loop: "):
            assert word in foot
    monkeypatch.undo()
    plt.close("all")


@pytest.mark.parametrize("count", [5, 24])
def test_the_picture_says_what_each_panel_asks_and_no_head_lies_on_a_legend(tmp_path, monkeypatch, count):
    """A picture without a forecast had no word on its points, and none had a word on a stroke loss below 0."""
    health = strings([folder(tmp_path, "a-1", samples(count, 0.002))])[0]
    of_one_load = replace(health.loads, others=[(30.0, [*range(40, 49)])])
    health = replace(health, string="spool-of-dyneema", left_out=[7, 8], loads=of_one_load)
    with monkeypatch.context() as held_open:
        held_open.setattr(plt, "close", lambda figure: None)
        page(health, [stroke_loss(health, 0.1), model_error(health, 4.0)], 0.9, tmp_path / "page.png")
    figure = plt.gcf()
    figure.canvas.draw()
    title, left_out = " ".join(figure.get_suptitle().split()), "2 left out (another range of twist)"
    assert title.endswith(f": {count} strokes seen{health.loads.under}, {left_out}, 9 left out (another load)")
    ends = figure._suptitle.get_window_extent()
    assert figure.bbox.x0 < ends.x0 and ends.x1 < figure.bbox.x1, "both ends of a long title were cut off"
    words = figure.get_supxlabel()
    assert words.startswith("Blue: each stroke as measured") and ("futures" in words) == (count > 12)
    heads = [axes.get_title(loc="left") for axes in figure.axes[:2]]
    assert "below 0: the stroke grew" in heads[0] and "calibrated on the first 3 strokes" in heads[1]
    for axes in figure.axes[:2]:
        head, legend = (each.get_window_extent() for each in (axes._left_title, axes.get_legend()))
        first = head.y0 + 0.5 * head.height * (count < 12)  # without a forecast its last line stands beside the legend
        assert first >= legend.y1 - 2.0 or head.x1 < legend.x0
        assert head.x1 < figure.bbox.x1
    upper, lower = ([text.get_text() for text in axes.get_legend().get_texts()] for axes in figure.axes[:2])
    assert {"measured", "last stroke seen"} <= {*upper} and "limit, 4 mm" in lower
    assert all(name.startswith(("limit, ", "law fitted, ")) for name in {*upper} & {*lower}), "six names stood twice"
    assert not {"measured", "last stroke seen", "median of the futures"} & {*lower}
    plt.close("all")


def named(answer, name):
    """The answer with all laws called by one name."""
    choice = answer.left.choice
    fits = [replace(fit, law=replace(fit.law, name=name)) for fit in choice.fits]
    return replace(answer, left=replace(answer.left, choice=replace(choice, fits=fits)))


@pytest.mark.parametrize("loss", [0.002, 0.0002])
def test_no_words_lie_off_the_sheet_and_the_panels_use_it(tmp_path, monkeypatch, loss):
    """The legend of a law with a long name ran off the left edge, and pushed all panels to the right."""
    health = strings([folder(tmp_path, "a-1", samples(24, loss))])[0]
    longest = max((law.name for law in LAWS), key=len)
    answers = [named(answer, longest) for answer in (stroke_loss(health, 0.1), model_error(health, 4.0))]
    with monkeypatch.context() as held_open:
        held_open.setattr(plt, "close", lambda figure: None)
        page(health, answers, 0.9, tmp_path / "page.png")
    figure = plt.gcf()
    figure.canvas.draw()
    sheet, panels = figure.bbox, figure.axes
    for legend in (axes.get_legend() for axes in panels[:2]):
        assert any(longest in text.get_text() for text in legend.get_texts())
        for box in (text.get_window_extent() for text in legend.get_texts()):
            assert sheet.x0 <= box.x0 and box.x1 <= sheet.x1 and sheet.y0 <= box.y0 and box.y1 <= sheet.y1
    assert all(axes.get_window_extent().width > 0.8 * sheet.width for axes in panels[:2])
    (law,) = [line for line in panels[0].get_lines() if str(line.get_label()).startswith("law fitted")]
    points = [line for line in panels[0].get_lines() if line.get_marker() == "."]
    assert all(law.get_zorder() > line.get_zorder() for line in points), "the points hid the law"
    plt.close("all")


def test_the_picture_marks_where_each_further_recording_begins(tmp_path, monkeypatch):
    """The strokes of two recordings stood in one row, and a step between them looked like wear."""
    health = strings([folder(tmp_path, "a-1", samples(14, 0.002))])[0]
    table = health.strokes.assign(run=["a-1"] * 8 + ["a-2"] * 6)
    monkeypatch.setattr(plt, "close", lambda figure: None)
    changed_health = replace(health, strokes=table, runs=["a-1", "a-2"])
    page(
        changed_health, [stroke_loss(changed_health, 0.1), model_error(changed_health, 4.0)], 0.9, tmp_path / "page.png"
    )
    drawn = plt.gcf().axes
    dotted = [[line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == ":"] for axes in drawn]
    assert len(drawn) > 3 and dotted == [[8.5]] * len(drawn)
    loss, drift = drawn[:2]
    assert loss.get_xlim() == drift.get_xlim(), "one stroke stood at two places, one below the other"
    assert [text.get_text() for axes in drawn for text in axes.texts if "begins" in text.get_text()] == ["a-2 begins"]
    words = "Dotted: a further recording begins. Strokes 1 to 8: a-1; 9 to 14: a-2."
    assert words in plt.gcf().get_supxlabel(), "a panel showed two runs, and no word said which is which"
    monkeypatch.undo()
    plt.close("all")


def test_too_few_strokes_are_said_and_no_error(tmp_path):
    ran = program(folder(tmp_path, "a-1", samples(5, 0.002)), "--out", tmp_path / "out")
    assert ran.returncode == 0 and ran.stdout.splitlines()[0] == (
        "a-1: no forecast yet: 5 strokes recorded (1 to 5), all compared; at least 12 are needed, 7 more than "
        "there are."
    )
    text = joined(ran.stdout)
    again = "as a new run (pipeline.new_run --like its first run), wound to "
    assert again in text and " turns. Then name all runs" in text
    assert re.search(r"So far: [0-9.]+ % of the stroke is lost \(.*\)\.\n  Until .* lost: no forecast yet\.", text)
    model = "a model calibrated on the first 3 strokes is off by"
    assert re.search(
        rf"So far: {model} [0-9.]+ mm \(.* 2 strokes\)\.\n  Until that model is off by 1 mm: no forecast", text
    )
    assert "synthetic" not in text and "Advice" not in text
    run_folder = folder(tmp_path, "a-2", samples(5, 0.002))
    path = run_folder / "run.yaml"
    path.write_text(re.sub(r'("?material"?:\s*)"?\w+"?', r'\1"example"', path.read_text()))
    assert "\n  Only if you record the synthetic rig (" in joined(
        program(run_folder, "--out", tmp_path / "other").stdout
    )
    saved = json.loads((tmp_path / "out" / "a-1" / "lifespan.json").read_text())
    assert saved["first"] is None and saved["questions"]["stroke_loss"]["strokes_left"]["low"] is None


def test_a_single_stroke_is_no_error(tmp_path):
    """No stroke is left to compare with the first ones: the figure had nothing to draw a line at."""
    out = tmp_path / "out"
    ended = program(folder(tmp_path, "a-1", samples(1, 0.004)), "--out", out)
    assert ended.returncode == 0 and "no forecast yet: 1 stroke recorded" in ended.stdout, ended.stderr
    few = "So far: no change can be seen: 1 stroke is compared, and the first 3 are what later ones are compared with."
    assert joined(ended.stdout).count(f"{few} A change shows after 3 more like it.") == 1, "it was said twice"
    assert ended.stdout.count("So far") == 1
    assert "\n  Until a model calibrated on the first 3 strokes is off by 1 mm: no forecast yet." in ended.stdout
    assert (out / "a-1" / "lifespan.png").stat().st_size


@pytest.mark.parametrize("strokes", [1, 3, 11, 12])
def test_no_panel_is_empty_and_one_without_a_forecast_says_how_many_strokes_it_needs(tmp_path, monkeypatch, strokes):
    health = strings([folder(tmp_path, "a-1", samples(strokes, 0.004))])[0]
    with monkeypatch.context() as patch:
        patch.setattr(plt, "close", lambda figure: None)
        page(health, [stroke_loss(health, 0.1), model_error(health, 1.0)], 0.9, tmp_path / "page.png")
    panels = plt.gcf().axes
    for axes in panels:
        points = sum(np.isfinite(np.asarray(line.get_ydata(), float)).any() for line in axes.get_lines()
                     if len(line.get_xdata()) == len(line.get_ydata()) > 0 and line.get_marker() == ".")  # fmt: skip
        assert points or any("12" in text.get_text() for text in axes.texts)
    needed = [axes.get_title(loc="left") for axes in panels[:2]]
    notice = f"no forecast yet: {strokes} strokes, 12 needed".replace(" 1 strokes", " 1 stroke")
    assert (notice in "\n".join(needed).split("\n")) == (strokes < 12)
    plt.close("all")


def test_help_the_page_and_the_rig_say_how_many_strokes_a_forecast_needs():
    page_ = (ROOT / "docs" / "lifespan.md").read_text().split("## How")[0]
    rule = f"{LEAST_STROKES} complete strokes to about the same twist under one load"
    assert rule in page_ and "--strokes 24" in page_
    help_ = " ".join(program("--help").stdout.split())
    assert f"{LEAST_STROKES} complete strokes of a string to about the same twist under one load" in help_
    assert f"{LEAST_STROKES} equal strokes under one load" in help_ and rig.FORECAST == LEAST_STROKES
    use, readme = (ROOT / name for name in ("docs/use_a_model.md", "README.md"))
    assert rule in use.read_text() and f"needs {LEAST_STROKES} equal ones, one load" in readme.read_text()
    assert "12 to foretell" in rig.strokes_of(9) and "foretell" not in rig.strokes_of(12)


def said_of(drawn_when, state):
    """One question's sentence for futures that pass their limit when a test says."""
    forecast = Left(when=np.sort(np.array(drawn_when, float)), horizon=120.0, choice=SimpleNamespace(
        best=SimpleNamespace(law=SimpleNamespace(name="linear")), weights=np.array([0.6, 0.4])))  # fmt: skip
    assert forecast.span(0.9).state == state
    return sentence(Answer("stroke_loss", "", "1", np.array([12.0]), np.zeros(1), np.zeros(1), 0.1, forecast), 0.9)


def test_the_sentence_says_what_is_sure_and_what_half_of_the_futures_do():
    limit = "Until 10 % of the stroke is lost:"
    low, never = [10.0] * 9, [np.inf] * 60  # 9 of 100 pass at 10 strokes
    least = f"{limit} at least 66 strokes left in 90 % of the futures (10 % pass it sooner)."
    assert said_of([*low, *[66.9] * 31, *never], "one-sided") == [
        least,
        "At least half of the futures stay below the limit for all 120 strokes.",
    ]
    assert said_of([*low, *[66.9] * 31, *[80.6] * 30, *never[:30]], "one-sided") == [
        least,
        "Half of the futures stay below the limit for longer than 80 strokes.",
    ]
    assert said_of([*[20.9] * 10, *[40.9] * 80, *[89.1] * 10], "interval") == [
        f"{limit} 20 to 90 strokes left in 90 % of the futures (5 % pass it sooner, 5 % later).",
        "Half of the futures stay below the limit for longer than 40 strokes.",
    ]
    assert said_of([*[0.4] * 12, *[66.9] * 28, *never], "one-sided")[0] == (
        f"{limit} not one stroke is sure (10 % of the futures pass it within the next one)."
    ), "it promised at least 0 strokes"
    assert said_of([*low, *[np.inf] * 91], "censored") == [
        f"{limit} more than 120 strokes left in 90 % of the futures.",
    ]


def test_the_advice_says_why_it_comes_long_before_half_of_the_futures_pass_the_limit():
    """ "Calibrate again after about 7 strokes" stood beside "half stay below the limit for all 480"."""
    for when, worst_share in (
        ([7.2] * 11 + [np.inf] * 89, "10 %"),
        ([7.2] * 6 + [60.0] * 94, "5 %"),
        ([50.0] * 99 + [90.0], ""),
    ):
        forecast = Left(when=np.sort(np.array(when)), horizon=120.0)
        lines = rests_on([Answer("model_error", "", "mm", np.arange(12.0), np.zeros(12), np.zeros(12), 1.0, forecast)])
        both = f"The advice is for the worst {worst_share} of the futures, which pass 1 mm by then; half of them stay"
        assert (both in lines[0]) == bool(worst_share), lines


def test_a_bound_in_words_leaves_out_the_share_of_futures_that_it_says():
    """Of two ends each leaves 5 % of the futures outside; an end that stands alone leaves 10 %."""
    when = np.arange(1.0, 201.0)
    lines = said_of(when[:190].tolist() + [119.0] * 10, "interval")
    assert "(5 % pass it sooner, 5 % later)" in lines[0] and np.mean(np.sort(when) < 10.0) < 0.05
    alone = Left(when=np.concatenate([when[:100], np.full(100, np.inf)]), horizon=120.0).span(0.9)
    assert np.mean(when[:100] <= alone.low) * 100 / 200 == 0.10


@pytest.mark.parametrize(
    ("value", "limit", "digits"),
    [(1.031, 1.0, "1.03"), (0.9961, 1.0, "0.996"), (0.84, 1.0, "0.84"), (10.04, 10.0, "10.04"), (1.0, 1.0, "1")],
)
def test_a_number_beside_its_limit_has_the_digits_that_tell_them_apart(value, limit, digits):
    """ "The model is off by 1 mm" stood beside a limit of 1 mm that was "passed already"."""
    assert beside_limit(value, limit) == digits


@pytest.mark.parametrize(
    ("off_mm", "noise_mm", "size_words"),
    [
        (0.0, 0.0071, "less than the noise of a stroke, 0.0071 mm"),
        (0.0, 0.0, "nothing measurable"),
        (7e-18, 1e-17, "nothing measurable"),
        (0.02, 0.0071, "0.02 mm"),
    ],
)
def test_a_model_that_is_off_by_less_than_its_noise_is_not_off_by_0_mm(off_mm, noise_mm, size_words):
    values, noise = np.full(12, off_mm), np.full(12, noise_mm)
    so_far_text = so_far(Answer("model_error", "", "mm", np.arange(1.0, 13.0), values, noise, 1.0, Left("why")))
    assert so_far_text.startswith(
        f"So far: a model calibrated on the first 3 strokes is off by {size_words} (median of"
    )


def ageless(strokes):
    """Samples of strokes of a string of which nothing changes."""
    table = samples(strokes, 0.0)
    stroke = np.minimum(np.arange(len(table)) // 114, strokes - 1)
    return table.assign(displacement_mm=table["displacement_mm"] + 0.05 * stroke)


def test_a_string_that_does_not_age_is_first_said_not_to_and_its_bound_to_be_caution(tmp_path, done):
    """It began with "at least 88 strokes left": only the eighth line said that all changes were noise."""
    ran = program(folder(tmp_path, "a-1", ageless(14)), "--out", tmp_path / "out")
    first_words = "a-1: 14 strokes recorded (1 to 14), all compared. The model below is calibrated on the first 3 of "
    first_words += "them.\n  No ageing is seen: every change is within the noise"
    text = joined(ran.stdout)
    assert text.startswith(first_words), ran.stderr
    (least,) = re.findall(r"The 14 strokes compared can promise at least ([0-9]+) strokes more: this bound is", text)
    assert f"at least {least} strokes left in 90 % of the futures" in text and "off by 0 mm" not in text
    assert "No ageing" not in done[0].stdout, "a string that wears"


def test_no_printed_line_is_wider_than_those_of_a_diagnosis_and_a_command_stays_whole(done):
    for line in done[0].stdout.splitlines():
        fits = len(line) <= wrapped_lines.WIDE
        assert fits or line.lstrip().startswith(wrapped_lines.COMMANDS), line
    command = f"      snakemake --cores 2 -- {'long/' * 40}"
    assert page_lines.page(f"a\n{command}") == f"a\n{command}"


def test_the_foot_of_the_picture_names_few_recordings_and_none_where_there_is_one():
    runs = pd.DataFrame({"stroke": np.arange(1.0, 6.0), "run": list("abcde")})
    assert which_run(runs) == "Dotted: a further recording begins. The upper panel names it."
    assert which_run(runs[:4]).endswith("Strokes 1: a; 2: b; 3: c; 4: d.")
    assert which_run(runs[:1]) == ""


def test_the_picture_says_why_its_shade_holds_fewer_futures_than_its_arrow_promises():
    """ "The middle 80 % of the futures" stood beside "in 90 % of the futures", and no word said why."""
    answer = claim("stroke_loss", *[30.0] * 50, *[np.inf] * 50)
    answer = replace(answer, left=replace(answer.left, band=object()))
    words_ = footnote([answer], 0.9).replace("\n", " ")
    assert "at most 10 % of the futures pass the limit before it begins, so 90 % stay below it until then" in words_
    assert "The shade leaves out 10 % above and 10 % below: the middle 80 %." in words_


@pytest.mark.parametrize(
    ("question", "unit", "said_so"),
    [
        (
            "model_error",
            "mm",
            "off by 0.14 mm (median of the last 3 strokes). That has not grown since the first third",
        ),
        ("stroke_loss", "1", "This change is within the noise of the strokes."),
    ],
)
def test_an_error_that_stays_is_no_change_within_the_noise(question, unit, said_so):
    """A model that was off by 0.14 mm, nine times the noise, was "within the noise of the strokes"."""
    n = np.arange(4.0, 19.0)
    value = 0.14 + 0.001 * np.cos(n)
    answer = Answer(question, "", unit, n, value, 0.015 + 0.0 * n, 1.0, Left("why", drifts=False))
    text = " ".join(answered(answer, 0.9, True))
    assert said_so in text and ("This change" in text) == (unit == "1"), text


def test_what_is_so_so_far_is_said_and_a_stroke_that_grew_has_lost_nothing():
    """A stroke that grew by 1.5 % was said to have lost a negative share."""
    n, forecast = np.arange(1.0, 13.0), Left("why")
    for last, loss_words in (
        (-0.015, "the stroke grew by 1.5 %; nothing is lost"),
        (0.02, "2 % of the stroke is lost"),
    ):
        values = np.linspace(0.0, last, 12)
        values[-3:] = last
        against = "(the last 3 strokes against the first 3)."
        assert (
            so_far(Answer("stroke_loss", "", "1", n, values, values, 0.1, forecast))
            == f"So far: {loss_words} {against}"
        )
    grown = Answer("stroke_loss", "", "1", n, np.repeat([0.0, -0.014], 6), np.full(12, 0.001), 0.1, forecast)
    rests = pd.DataFrame({"rest_mm": np.repeat([9.0, 8.4, 7.8], 4), "rest_mm_error": 0.01})
    so_far_text = so_far(grown, longer_at_rest(rests))
    beyond = "the stroke grew by 1.4 %, beyond the noise; nothing is lost, but the string is 1.2 mm longer at rest, "
    assert f"{beyond}beyond the noise (the last" in so_far_text
    lost = replace(grown, values=0.001 * (-1.0) ** n)
    so_far_text = so_far(lost, longer_at_rest(rests))
    assert "0.1 % of the stroke is lost, within the noise, but the string is 1.2 mm longer at rest, bey" in so_far_text
    scattered = rests.assign(rest_mm=np.repeat([9.0, 8.8], 6) + 0.5 * (-1.0) ** n)
    assert longer_at_rest(scattered) == "", "strokes scatter by more than each one's readings"
    assert longer_at_rest(rests.assign(rest_mm_error=1.0)) == longer_at_rest(rests[:5]) == "", "within the noise"
    for least in (np.full(12, 1.1e-16), np.full(12, -1.1e-16)):
        so_far_text = so_far(Answer("stroke_loss", "", "1", n, least, least, 0.1, forecast))
        assert (
            so_far_text == "So far: nothing measurable of the stroke is lost (the last 3 strokes against the first 3)."
        )
    off = np.full(12, 0.841)
    so_far_text = so_far(Answer("model_error", "", "mm", n, off, off, 1.0, forecast))
    assert (
        so_far_text
        == "So far: a model calibrated on the first 3 strokes is off by 0.84 mm (median of the last 3 strokes)."
    )


def test_the_chance_of_a_sudden_end_in_words_is_the_one_in_the_futures():
    ends = surprises(100.0, np.random.default_rng(0))
    for _ in range(20):
        ends = np.concatenate([ends, surprises(100.0, np.random.default_rng(len(ends)))])
    for times in (1.0, HORIZON):
        assert np.mean(ends <= times * 100.0) == pytest.approx(sudden(times), abs=0.006)
        assert f"{100 * sudden(times):.0f} in 100" in UNFORESEEN
    assert f"{100 * ACCELERATES:.0f} in 100" in UNFORESEEN and "same three chances" in UNFORESEEN


def test_both_questions_look_ahead_by_the_same_number_of_strokes(tmp_path):
    """It was 240 for the stroke and 210 for the model, which has no error over the first three strokes."""
    health = strings([folder(tmp_path, "a-1", samples(24, 0.002))])[0]
    assert [answer.left.horizon for answer in (stroke_loss(health, 0.1), model_error(health, 4.0))] == [240.0, 240.0]


def test_beside_a_claim_stands_how_often_its_kind_held_as_the_page_has_it():
    """`90 % sure` stood alone, while the page said that the intervals of the model's error hold in 83 %."""
    text = (ROOT / "docs" / "lifespan.md").read_text()
    kinds = text.split("**By kind of claim.**")[1].split("\n\n")[1]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in kinds.splitlines()[2:]]
    page_ = {(what, state): (all_, late) for what, state, all_, late, *_ in cells}
    names = {"stroke_loss": "10 % of the stroke lost", "model_error": "model off by 1 mm"}
    words_ = {"one-sided": "at least", "interval": "from … to"}
    assert len(page_) == len(HELD)
    for (what, state), held_share in HELD.items():
        all_, late = page_[names[what], words_[state]]
        assert all_.startswith(f"{held_share.percent} % (")
        assert late.startswith("too few" if held_share.late_percent is None else f"{held_share.late_percent} % (")
        assert f"held in {held_share.percent:.0f} of 100 cases" in measured(what, state)
    assert "asked at 75 % of the life in 93" in measured("stroke_loss", "interval")
    assert measured("stroke_loss", "one-sided").endswith("that could be judged: so the bound is cautious.")
    assert "cautious" not in measured("model_error", "interval")
    assert "too few" in measured("stroke_loss", "censored")
    for (_, state), held_share in HELD.items():
        assert held_share.percent > 89.5, f"{state}: what is called 90 % holds less often"


def claim(question, *when, passed=np.nan):
    forecast = Left("" if len(when) else "why", passed, np.sort(np.array(when, float)), horizon=240.0)
    unit = "1" if question == "stroke_loss" else "mm"
    return Answer(question, "", unit, np.arange(1.0, 25.0), np.zeros(24), np.zeros(24), 0.1, forecast)


FIRST = "that model"


@pytest.mark.parametrize(
    ("drift", "advised", "why", "again"),
    [
        ([9.5] * 50 + [np.inf] * 50, "calibrate your model again after about 9 strokes, at stroke 33. Ask again after "
         "4 strokes, at stroke 28.", f"{FIRST} may be off by 0.1 mm by then", "at least 9 strokes are left"),
        ([0.4] * 50 + [np.inf] * 50, "calibrate your model again now. Ask again after 1 stroke, at stroke 25.",
         f"{FIRST} may be off", "a limit may be passed within 2 strokes."),
        ([1.4] * 50 + [np.inf] * 50, "calibrate your model again after about 1 stroke, at stroke 25. Ask again after "
         "1 stroke, at stroke 25.", f"{FIRST} may be off", "a limit may be passed within 2 strokes."),
        ([np.inf] * 9, "your model need not be calibrated again within 240 strokes. Ask again after 24 strokes, at "
         "stroke 48.", f"{FIRST} is off by less than 0.1 mm so long", "the strokes compared have doubled then."),
        ([], "no reason to calibrate your model again is seen so far. Ask again after 24 strokes, at stroke 48.",
         f"nothing is foretold of {FIRST}", "the strokes compared have doubled then."),
    ],
)  # fmt: skip
def test_the_advice_says_what_to_do_next_and_what_that_rests_on(drift, advised, why, again):
    answers = [claim("stroke_loss", *[150.0] * 50, *[np.inf] * 50), claim("model_error", *drift)]
    assert advice(answers) == f"Advice: {advised}"
    reasons = rests_on(answers)
    heading = "Why no calibration" if advised.startswith(("no reason", "your model need not")) else "Why calibrate"
    assert reasons[0].startswith(f"{heading}: {why}") and reasons[1].startswith(f"Why ask again: {again}")
    assert len(reasons) == 2, "a sentence said that both follow from all strokes, which helped nobody"


def test_the_page_s_example_has_the_program_s_own_reasons():
    """Two of its sentences were of another recording, and one was said no more."""
    reasons = rests_on([claim("stroke_loss", *[197.0] * 50), claim("model_error", *[9.5] * 50, *[18.2] * 150)])
    example = joined((ROOT / "docs" / "lifespan.md").read_text().split("```")[5])
    assert [line.strip() for line in example.splitlines() if line.strip().startswith("Why ")] == [
        reason.replace("by 0.1 mm", "by 1 mm") for reason in reasons
    ]


def test_a_model_that_is_off_already_is_to_be_calibrated_again_now():
    answers = [claim("stroke_loss", *[30.0] * 50, *[np.inf] * 50), claim("model_error", passed=20.0)]
    assert advice(answers) == "Advice: calibrate your model again now. Ask again after 15 strokes, at stroke 39."
    assert rests_on(answers)[0] == f"Why calibrate: {FIRST} was off by 0.1 mm at stroke 20 already."
    assert recalibrate_after(answers) == 0


def test_a_stroke_that_the_string_has_passed_is_not_advised_as_one_to_come():
    """ "Ask again after 15 strokes, at stroke 39" of a string that had done 44, under another load."""
    answers = [claim("stroke_loss", *[30.0] * 50, *[np.inf] * 50), claim("model_error", *[22.4] * 100)]
    text = advice(answers, done=39)
    still_to_come = "again at about stroke 46, 7 strokes from now: the string has done 39. Ask"
    assert still_to_come in text
    assert "Ask again once strokes are recorded after stroke 39: stroke 35, at which that was due, is done." in text
    text = advice(answers, done=34)
    assert "Ask again at stroke 35, the next one: the string has done 34." in text, "`after 11 strokes` was one"
    (claimed, _) = sentence(answers[0], 0.9, after=" after stroke 24")
    assert "at least 30 strokes left after stroke 24 in 90 % of the futures" in claimed
    text = advice(answers, done=24, beside=True)
    assert "Ask again after 11 strokes, counted from stroke 24. Strokes of runs that were not given count too." in text
    assert "at stroke 35" not in text and "is done" not in text


def test_the_advice_gives_the_command_and_says_why_it_stays_after_a_calibration(tmp_path):
    """ "Calibrate the model again" stood there without a command, and stayed there once it was done."""
    printed = []
    for place in (tmp_path / "a b", tmp_path / "raw"):
        place.mkdir()
        run = folder(place, "a-1", samples(24, 0.004))
        ran = programs.run("pipeline.lifespan", run, "--out", tmp_path / "out", cwd=tmp_path)
        assert ran.returncode == 0, ran.stderr
        printed.append(ran.stdout)
    elsewhere, paste = f"--out {tmp_path / 'out' / 'calibrated'}", "    Calibrate it by this command (it"
    own = f"\n      python -m pipeline.diagnose '{tmp_path}/a b/a-1' {elsewhere}\n"
    assert f"{paste} calibrates the simulator's dimensions on these runs):{own}" in printed[0]
    own = "\n      snakemake --cores 2 -- processed/UHMWPE/spline/within-0.model\n"
    assert f"{paste} fits the spline of UHMWPE to all of its runs in raw/):{own}" in printed[1]
    for text in printed:
        assert "After a calibration name only the runs recorded since: a forecast" in joined(text)


def bedded(strokes, first):
    """Samples of strokes of which the first ones of a string have wider loops; `first` is the number of the first."""
    table = samples(strokes, 0.0, noise_mm=0.01)
    number = table.index // 114
    falls = (table["motor_turns"].diff() < 0) | (table["motor_turns"].shift(-1) < table["motor_turns"])
    wider_mm = np.where(falls, 0.5 * np.exp(-(number + first - 1) / 3.0), 0.0)
    return table.assign(displacement_mm=table["displacement_mm"] - wider_mm + 0.05 * number)


def test_one_recording_under_two_names_is_refused(tmp_path):
    string_entry = {"string": {**content("x")["string"], "id": "s"}}
    runs = [folder(tmp_path, name, bedded(8, 1), **string_entry) for name in ("a-1", "a-2")]
    ran = program(*runs, "--out", tmp_path / "out")
    assert ran.returncode == 2 and not (tmp_path / "out" / "s").exists()
    assert "a-2: recording: has the same samples as a-1. Mend: name one of the two" in ran.stderr


def test_a_run_that_begins_as_the_string_began_is_told_as_perhaps_another_string(tmp_path):
    string_entry = {"string": {**content("x")["string"], "id": "s"}}
    runs = [
        folder(tmp_path, "a-1", bedded(8, 1), **string_entry),
        folder(tmp_path, "a-2", bedded(8, 9), **string_entry),
    ]
    other = bedded(8, 1)  # of another string, and no copy
    runs.append(folder(tmp_path, "a-3", other.assign(displacement_mm=other["displacement_mm"] + 1e-4), **string_entry))
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
        complaint = capsys.readouterr().err
        assert ended.value.code == 2 and arguments[0] in complaint and "Mend" in complaint
    assert not (tmp_path / "out").exists()


def test_a_run_named_twice_is_refused(tmp_path):
    run = folder(tmp_path, "a-1", samples(5, 0.002))
    with pytest.raises(BadInput, match="twice"):
        strings([run, run.parent / "." / run.name])


def test_of_limits_that_were_passed_the_earlier_is_first(tmp_path):
    (health,) = strings([folder(tmp_path, "a-1", samples(24, 0.006))])
    late, early = stroke_loss(health, 0.10), stroke_loss(health, 0.05)
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
    score_text = words(rows)
    assert "| this forecast |" in score_text and "| one-sided, 75% of the life |" in score_text.replace(
        "interval,", "one-sided,"
    )


def test_censored_lives_count_only_where_they_tell():
    forecast = Left(when=np.linspace(10.0, 20.0, 1001), horizon=100.0)
    assert held(forecast, 0.9, 15.0, False) == 1.0 and held(forecast, 0.9, 20.0, False) == 0.0
    assert held(forecast, 0.9, 20.0, True) == 0.0  # it went on beyond the upper end
    assert np.isnan(held(forecast, 0.9, 15.0, True)) and np.isnan(held(forecast, 0.9, 5.0, True))
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
