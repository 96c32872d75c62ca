"""The page of figures: what its panels show can be read, and legends lie on no curve."""

import copy
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.legend import Legend

from pipeline.diagnosis.choice.judged import HELD
from pipeline.diagnosis.document.bounds import BOUND
from pipeline.diagnosis.drawing import driver_panels, figures, mismatch_map, panels
from pipeline.diagnosis.fit.adopt import adoptions
from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.diagnosis.verdict import diagnosis
from pipeline.diagnosis.words.explanations import explanation_table, probability, rivals
from pipeline.diagnosis.words.held_out.holdout import heading
from pipeline.diagnosis.words.held_out.unseen import noises
from pipeline.diagnosis.words.language.quantity import percent
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.pages import to_do
from pipeline.run.description import Adopted
from pipeline.run.samples import read_samples
from pipeline.systems import systems

MARK = (
    "recorded by ci.yaml on another synthetic rig: set-up small (5 strokes, 4 to 20 turns under 20 N, then 1 to 16 "
    "turns under 30 N)"
)


@pytest.fixture(scope="module")
def drawn(studied, tmp_path_factory, request):
    """The page of a run with creep, or with what the parameter says, and its diagnosis. Tests leave both alone."""
    outcome, run, _ = studied(*getattr(request, "param", ("creep",)))
    content = diagnosis(outcome, outcome.problem, None, [run], None, frozenset())
    kept, draw, page = [], figures.drawn, tmp_path_factory.mktemp("drawn") / "page"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(figures, "drawn", lambda *arguments: kept.append(draw(*arguments)) or kept[-1])
        figures.page(outcome, content, page, MARK)
    assert page.with_suffix(".png").is_file() and page.with_suffix(".pdf").is_file()
    return kept[0], content


def test_the_figure_wears_the_mark_of_what_recorded_it_and_its_numbers_do_not_crowd(drawn) -> None:
    figure, _ = drawn
    warned = figure.subfigs[0].get_suptitle()
    assert " ".join(warned.split()).startswith(MARK)
    width = figure.subfigs[0]._suptitle.get_window_extent(FigureCanvasAgg(figure).get_renderer()).width
    assert width < 0.95 * figure.bbox.width, "a line of the mark runs to the edge of the page or over it"
    for axes in figure.subfigs[-1].axes:
        low, high = axes.get_xlim()
        assert sum(low <= place <= high for place in axes.get_xticks()) <= 6


def test_a_simulator_has_one_colour_in_every_panel_and_the_signs_of_the_maps_are_explained(drawn) -> None:
    figure, _ = drawn
    top, maps, _, bottom = figure.subfigs
    lines = [line for part in (top, bottom) for axes in part.axes for line in axes.get_lines()]
    for name in ("calibrated", "as diagnosed"):
        named = {(line.get_color(), line.get_linestyle()) for line in lines if line.get_label() == name}
        assert {colour for colour, _ in named} == {panels.SHADES[name]} and {style for _, style in named} <= {
            "-",
            "None",
        }
    (legend,) = maps.legends
    signs = [text.get_text() for text in legend.get_texts()]
    assert signs[0] == "the turn; right of it: unwinding" and "between two runs" not in signs
    assert legend.get_window_extent().y1 <= min(axes.get_window_extent().y0 for axes in maps.axes)


def test_a_cell_of_a_map_without_samples_is_not_white_and_runs_are_parted(studied) -> None:
    problem = studied("creep")[0].problem
    seen = problem.drivers
    half = len(seen.first) // 2
    begin = int(np.flatnonzero(np.diff(seen.stroke[half:]))[0]) + half + 1
    runs = replace(
        seen, first=np.where(np.arange(len(seen.first)) < begin, seen.first, np.arange(len(seen.first)) - begin)
    )
    low = replace(runs, motion=np.where(seen.stroke == seen.stroke.max(), 0.5 * seen.motion, seen.motion))
    first = int(seen.stroke[begin])
    assert mismatch_map.begins_of_runs(seen) == [] and mismatch_map.begins_of_runs(low) == [first]
    labels = [sign.get_label() for sign in mismatch_map.map_signs(low, problem.measured)]
    assert labels == ["the turn; right of it: unwinding", "between two runs", "nothing recorded"]
    _, axes = plt.subplots()
    mismatch_map.mismatch_map(axes, low, problem.measured, "map", 1.0)
    assert axes.get_facecolor()[:3] == (0.8, 0.8, 0.8) and axes.get_lines()[1].get_ydata() == [first - 0.5] * 2


@pytest.mark.long
def test_the_small_panels_share_a_legend_beside_them_and_calibration_leaves_what_the_words_say(drawn) -> None:
    figure, content = drawn
    bottom = figure.subfigs[-1]
    small = [axes for axes in bottom.axes if axes.get_lines()]
    assert small and all(axes.get_legend() is None for axes in small)
    assert "time (s), means of whole strokes" in [axes.get_xlabel() for axes in small], "in bins of time it would beat"
    (legend,) = bottom.legends
    labels = [text.get_text() for text in legend.get_texts()]
    assert labels[:2] == ["calibrated", "as diagnosed"] and labels[2].startswith("± noise")
    box = legend.get_window_extent()
    assert all(box.y1 <= axes.get_window_extent().y0 for axes in small)
    ranking = figure.subfigs[-2].axes[0]
    evidence = content["evidence"]
    alone = next(place for place, entry in enumerate(evidence["explanations"]) if not entry["ids"])
    ends = ranking.collections[1].get_offsets()[:, 0]
    assert ends[alone] == pytest.approx(evidence["calibrated_mm"] / evidence["floor_mm"])
    diamonds = next(line for line in ranking.get_lines() if line.get_marker() == "D").get_xdata()
    assert all(x <= end + 1e-9 for x, end in zip(diamonds, ends, strict=True))


@pytest.mark.parametrize(("drawn", "names"), [((), ["nominal", "calibrated"])], indirect=["drawn"])
def test_where_nothing_is_named_nothing_is_drawn_twice_and_no_legend_names_what_is_not_drawn(drawn, names) -> None:
    figure, content = drawn
    assert not content["mechanisms"] and content["verdict"] in ("consistent", "parameters")
    top, maps, _, bottom = figure.subfigs
    for axes, shown in zip(top.axes[:2], (["recording", "calibrated"], names), strict=True):
        lines = [line for line in axes.get_lines() if not line.get_label().startswith("_")]
        assert (
            [line.get_label() for line in lines] == [text.get_text() for text in axes.get_legend().get_texts()] == shown
        )
        assert panels.AFTER not in [line.get_color() for line in lines]
    assert [axes.get_title() for axes in maps.axes if axes.images] == [
        f"Recording − simulation, {name} (own scale)" for name in names
    ]
    assert [text.get_text() for text in bottom.legends[0].get_texts()][:2] == names
    _, axes = plt.subplots()
    panels.held_out(axes, {"nominal_mm": 0.4, "calibrated_mm": 0.2, "explained_mm": 0.2}, 0.02, "mm", "mm")
    assert [label.get_text() for label in axes.get_xticklabels()] == names
    assert len(axes.collections[1].get_offsets()) == len(names)


def test_on_a_logarithmic_axis_no_bar_stands_but_a_line_from_the_noise_to_a_point(drawn) -> None:
    figure, _ = drawn
    ranking = figure.subfigs[-2].axes[0]
    stems, points = ranking.collections[:2]
    assert not ranking.patches and {line[0][0] for line in stems.get_segments()} == {1.0}
    assert [line[1][0] for line in stems.get_segments()] == pytest.approx(list(points.get_offsets()[:, 0]))
    _, axes = plt.subplots()
    heldout = {"nominal_mm": 0.4, "calibrated_mm": 0.2, "explained_mm": 0.03}
    panels.held_out(axes, heldout, 0.02, "mm", "mm")
    assert not axes.patches and [line[0][1] for line in axes.collections[0].get_segments()] == [0.02] * 3


@pytest.mark.parametrize(
    "errors",
    [(5.0, 2.0, 37.0), (37.0, 2.0, 0.03), (0.4, 37.0, 0.03), (37.0, 36.0, 35.0), (0.4, 0.2, 0.2), (900.0,) * 3],
)
@pytest.mark.parametrize("without", ["", "creep + friction_hysteresis + axial_elasticity + wear"])
def test_no_label_of_an_error_on_unseen_strokes_runs_into_the_legend(errors, without) -> None:
    """A large error's label was printed over the words of the noise."""
    figure = plt.figure(figsize=(figures.SIZE_INCHES[0], 3.6), layout="constrained")
    _, axes = figure.subplots(1, 2, width_ratios=[3, 2])
    heldout = dict(zip(("nominal_mm", "calibrated_mm", "explained_mm"), errors, strict=True))
    single, long_title = "noise of single samples: 0.030 mm", "Error on the last 2 strokes, which the effects have seen"
    panels.held_out(axes, heldout, 0.03, "mm", "mm", single, long_title, without=without)
    figure.draw_without_rendering()
    legend = axes.get_legend().get_window_extent()
    labels = [text.get_window_extent() for text in axes.texts]
    assert labels and not any(label.overlaps(legend) for label in labels)
    assert all(label.y1 < axes.get_window_extent().y1 for label in labels)
    assert legend.width < axes.get_window_extent().width
    top = max(axes.collections[1].get_offsets()[:, 1])
    assert axes.transData.transform((0, top))[1] < legend.y0, "no point stands beneath the legend"
    plt.close(figure)


def test_the_last_error_on_unseen_strokes_is_called_by_what_was_named_without_them() -> None:
    _, axes = plt.subplots()
    heldout = {"nominal_mm": 0.4, "calibrated_mm": 0.2, "explained_mm": 0.3}
    panels.held_out(axes, heldout, 0.02, "mm", "mm", without="creep + wear")
    assert axes.get_xticklabels()[2].get_text() == "other\neffects", "its legend says which"
    called = [" ".join(text.get_text().split()) for text in axes.get_legend().get_texts()]
    assert called == ["named without these strokes: creep + wear", "noise"]
    faces = axes.collections[-1].get_facecolors()
    assert [face.tolist() == [1.0] * 4 for face in faces] == [False, False, True], "no colour of an explanation"


def test_the_figure_shows_the_probability_by_which_explanations_are_held_or_ruled_out(drawn) -> None:
    figure, content = drawn
    evidence = content["evidence"]
    held_probabilities = [
        entry["probability"] for entry in evidence["explanations"] if entry["standing"] in ("named", "tied")
    ]
    assert len(held_probabilities) == 1 + len(content["alternatives"])
    assert (
        sum(held_probabilities)
        >= HELD * (1.0 - evidence["probability_of_none"]) - 1e-4
        > sum(held_probabilities) - min(held_probabilities)
    )
    others = [entry for entry in evidence["explanations"] if entry["standing"] in ("beaten", "not needed")]
    assert others and all((entry["probability"] or 0.0) <= min(held_probabilities) for entry in others)
    shown = [text.get_text() for text in figure.subfigs[-2].axes[0].texts]
    listed = explanation_table.others_shown(content)
    in_table = [entry for entry in evidence["explanations"] if entry not in others or entry in listed]
    kept_last = sorted(in_table, key=lambda entry: (entry["standing"] in panels.KEPT, entry["probability"] or 0.0))
    assert shown == [
        probability.not_weighed(entry["ids"]) if entry["probability"] is None else percent(entry["probability"])
        for entry in kept_last
    ]
    assert kept_last[-1]["standing"] == "named", "the uppermost is the best"
    names = [label.get_text() for label in figure.subfigs[-2].axes[0].get_yticklabels()]
    assert names == [" + ".join(entry["ids"]) or "calibration alone" for entry in kept_last]


def test_the_two_sizes_of_the_noise_have_each_a_name_of_its_own_in_figure_and_words(drawn) -> None:
    figure, content = drawn
    words = Vocabulary.of(systems()["separator"])
    content = copy.deepcopy(content) | {"fit": content["fit"] | {"noise_floor_mm": 0.032}}
    content["evidence"] |= {"floor_mm": 0.018, "step_s": 0.04}
    compared, single = noises(content, words)
    assert (compared, single) == ("noise of averages of 0.04 s: 0.018 mm", "noise of single samples: 0.032 mm")
    _, (left_axes, right) = plt.subplots(1, 2)
    panels.ranking(left_axes, content, "mm", compared)
    heldout = {"nominal_mm": 0.4, "calibrated_mm": 0.2, "explained_mm": 0.03}
    panels.held_out(right, heldout, 0.032, "mm", "mm", single)
    for axes, noise_label in ((left_axes, compared), (right, single)):
        assert noise_label in [text.get_text() for text in axes.get_legend().get_texts()]
    drawn_ = figure.subfigs[-2].axes[0].get_legend().get_texts() + figure.subfigs[-1].legends[0].get_texts()
    assert not [text for text in drawn_ if "floor" in text.get_text()]


def test_the_title_of_the_error_on_held_out_strokes_says_whether_a_fit_has_seen_them(drawn) -> None:
    figure, content = drawn
    assert " ".join(figure.subfigs[-2].axes[1].get_title().split()) == "Error on unseen strokes"
    adoption = {"effects": ["creep"], "verdict": "explained", "tied": [], "runs": [content["run"]]}
    _, axes = plt.subplots()
    heldout = {"split": "last 2 strokes", "nominal_mm": 0.4, "calibrated_mm": 0.2, "explained_mm": 0.03}
    adopted_content = content | {"adopted": [adoption], "fit": content["fit"] | {"heldout": heldout}}
    panels.held_out(axes, heldout, 0.02, "mm", "mm", title=heading(adopted_content))
    title = " ".join(axes.get_title().split())
    assert title == "Error on the last 2 strokes (seen before)"
    assert max(map(len, axes.get_title().splitlines())) <= panels.TITLE_WIDE


def test_the_page_says_each_colour_of_the_figure_in_the_words_of_its_legend() -> None:
    page = " ".join((Path(__file__).parents[3] / "docs" / "diagnosis.md").read_text(encoding="utf-8").split())
    for colour, label in panels.STANDINGS.values():
        start = "In an `unknown` verdict orange is" if "not enough" in label else panels.COLOUR[colour]
        assert f"{start}: {label}" in page, label


@pytest.mark.long
def test_a_dimension_that_runs_to_the_bound_of_its_tolerance_is_marked_in_the_json(conceal) -> None:
    run, samples = read_samples(conceal()[0])
    sure = {"radius": 0.001, "separator_mm": 0.01, "torsion_zone_mm": 0.01, "length_mm": 0.01}
    wide = run.model_copy(update={"tolerance": sure})
    more = samples.assign(displacement_mm=1.05 * samples["displacement_mm"])  # 3 sigma of the gain are 1.5 %
    for each_run, table, bound in ((wide, more, "upper"), (run, samples, None)):
        outcome = study(make_problem([RecordedRun.cut(each_run, table)]))
        content = diagnosis(outcome, outcome.problem, None, [each_run], None, frozenset())
        assert content["parameters"]["scale"].get("at_bound") == bound
        far = [name for name, sigma in content["evidence"]["moved_sigma"].items() if abs(sigma) >= BOUND]
        assert far == [name for name, entry in content["parameters"].items() if "at_bound" in entry]


@pytest.mark.parametrize("count", range(1, 7))
def test_the_small_panels_leave_no_hole(count) -> None:
    figure = plt.figure(layout="constrained").subfigures(1, 1)
    panel_axes = driver_panels.filled(figure, count)
    figure.canvas.draw()
    rows = {round(axes.get_position().y0, 2) for axes in panel_axes}
    assert len(panel_axes) == count and len(rows) == min(count, 2)
    for row in rows:
        across = [axes.get_position() for axes in panel_axes if round(axes.get_position().y0, 2) == row]
        assert min(box.x0 for box in across) < 0.2 and max(box.x1 for box in across) > 0.8
        assert sum(box.width for box in across) > 0.5
    plt.close("all")


def test_a_load_that_is_constant_but_for_noise_drives_nothing(problem) -> None:
    for loaded in (True, False):
        shown = driver_panels.listeners(replace(problem.drivers, loaded=loaded))
        assert any(label.startswith("load (") for label in shown) == loaded


def test_each_map_has_the_scale_of_its_own_residual(drawn) -> None:
    figure, _ = drawn
    limits = [axes.images[0].get_clim()[1] for axes in figure.subfigs[1].axes if axes.images]
    assert len(limits) == 2 and limits[1] < limits[0]
    maps = [axes for axes in figure.subfigs[1].axes if axes.images]
    assert [axes.get_title() for axes in maps] == [
        f"Recording − simulation, {name} (own scale)" for name in ("calibrated", "as diagnosed")
    ]
    assert [label.get_text() for label in maps[0].get_xticklabels()][1::2] == ["winding →", "→ unwinding"]


@pytest.mark.parametrize("named", [True, False])
def test_a_larger_explanation_is_only_larger_than_the_best_where_there_is_a_best(named) -> None:
    base_entry = {"left_mm": 0.1, "with_discrepancy_mm": 0.1, "probability": None}
    shown = [
        {**base_entry, "ids": [], "standing": "nothing"},
        {**base_entry, "ids": ["wear"], "standing": "not needed"},
    ]
    shown += [{**base_entry, "ids": ["creep"], "standing": "named"}] if named else []
    _, axes = plt.subplots()
    panels.ranking(axes, {"evidence": {"explanations": shown, "floor_mm": 0.05}, "mechanisms": []}, "mm")
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert ("less likely, with more effects" in labels) is named
    assert ("with a further effect that adds too little" in labels) is not named


def test_a_larger_set_is_drawn_with_no_more_than_its_parts_leave_and_each_row_stands_in_the_details_too() -> None:
    """A fit that did not find its best stood there with eight times what one of its effects leaves alone."""
    sizes = {(): 1.0, ("creep",): 0.1, ("creep", "wear"): 0.8, ("slack",): 1.6}
    others = [("creep", f"x_{letter}") for letter in "abcdefgh"]
    base_entry = {"with_discrepancy_mm": 2.0, "probability": None, "standing": "beaten"}
    shown = [
        {**base_entry, "ids": [*ids], "left_mm": left_mm}
        for ids, left_mm in [*sizes.items(), *((ids, 0.1) for ids in others)]
    ]
    shown[0]["standing"], shown[1]["standing"] = "nothing", "named"
    evidence = {"explanations": shown, "floor_mm": 0.1, "calibrated_mm": 1.0}
    content = {"evidence": evidence, "mechanisms": [{"id": "creep"}], "verdict": "explained"}
    _, axes = plt.subplots()
    panels.ranking(axes, content, "mm")
    names = [label.get_text() for label in axes.get_yticklabels()]
    left_by_name = dict(zip(names, axes.collections[1].get_offsets()[:, 0], strict=True))
    assert left_by_name["creep"] == pytest.approx(1.0) and max(left_by_name.values()) == left_by_name[
        "calibration alone"
    ] == pytest.approx(10.0)
    assert len(names) == 1 + explanation_table.SHOWN + 1, "the best one, those that the table has, calibration"
    for ids in (["creep", "wear"], ["slack"]):
        entry = next(each for each in shown if each["ids"] == ids)
        assert rivals.left_of(entry, content, "mm") == (0.1 if "creep" in ids else 1.0)


@pytest.mark.parametrize(("bent", "below"), [(0.04, True), (0.06, False)])
def test_diamonds_are_left_out_where_they_decide_nothing_and_the_title_says_where_no_more_effect_is_named(
    bent, below
) -> None:
    base_entry = {"left_mm": 0.1, "with_discrepancy_mm": bent, "probability": None}
    shown = [
        {**base_entry, "ids": [], "standing": "nothing"},
        {**base_entry, "ids": ["wear"], "standing": "not needed"},
    ]
    shown += [{**base_entry, "ids": ["creep"], "standing": "not needed"}]
    shown += [{**base_entry, "ids": ["slack"], "standing": "not needed"}]
    content = {"evidence": {"explanations": shown, "floor_mm": 0.05}, "mechanisms": [], "simulation": [{"id": "slack"}]}
    _, axes = plt.subplots()
    panels.ranking(axes, content, "mm")
    legend_text = " ".join(text.get_text() for text in axes.get_legend().get_texts())
    assert ("left if each effect may differ from its formula by 10 %" in legend_text) is not below
    assert axes.get_title() == "One more effect: none takes enough away"
    drawn_ = [label.get_text() for label in axes.get_yticklabels()]
    assert drawn_ == ["slack (adopted)", "wear", "creep"], "what is adopted already is no further effect"
    assert "what is adopted, and calibration" in legend_text and "no mechanism" not in legend_text
    panels.ranking(axes, content | {"simulation": []}, "mm")
    assert axes.get_title() == "Explanations: what each leaves"


def test_a_run_whose_adopted_effects_do_not_fit_its_dimensions_is_warned_of_above_the_figure(drawn) -> None:
    content = copy.deepcopy(drawn[1])
    words = Vocabulary.of(systems()["separator"])
    content["simulation"] = [{"id": "slack", "parameters": {}}]
    content["evidence"] |= {"nominal_mm": 1.0, "calibrated_mm": 0.02, "moved_sigma": {"radius": BOUND}}
    content["parameters"] = {"radius": {}}
    content["adopted"] = []
    first, second = figures.warning(content, words).split("\n")
    assert first.startswith("do not predict with run.yaml as it stands: it errs by 1.0 mm rms")
    assert second == "calibration moved radius far: measure it again first (verdict.txt)"
    content["evidence"]["nominal_mm"] = 0.03
    assert figures.warning(content, words) == second


def test_the_figures_headline_says_that_nothing_is_to_be_adopted_where_the_verdict_says_it(drawn) -> None:
    content = copy.deepcopy(drawn[1])
    words = Vocabulary.of(systems()["separator"])
    content["evidence"]["moved_sigma"] = {}
    assert figures.warning(content, words) == ""
    errors = {"nominal_mm": 0.57, "calibrated_mm": 0.24, "explained_mm": 2.1}
    content["fit"]["heldout"] = {"split": "last 2 strokes", **errors}
    headline = figures.warning(content, words)
    assert headline == "adopt nothing: on the unseen strokes the explanation makes the simulator worse"
    assert headline.capitalize() in " ".join(" ".join(to_do.lines(content, words, [], None, short=True)).split())
    unknown = content | {"verdict": "unknown"}
    assert figures.warning(unknown, words) == "adopt nothing: no effect of the library is named"


@pytest.mark.long
def test_after_adopting_the_figure_shows_what_was_adopted_and_not_a_simulator_that_nobody_uses(conceal) -> None:
    folder = conceal("creep")[0]
    run, samples = read_samples(folder)
    first, _ = diagnosed([RecordedRun.cut(run, samples, folder=folder)])
    adopted = [Adopted.model_validate(adoption) for adoption in adoptions(first, "a.json", run.run)]
    again = run.model_copy(update={"simulation": first["simulation"], "adopted": adopted})
    verdict, studied = diagnosed([RecordedRun.cut(again, samples, folder=folder)])
    assert verdict["verdict"] in ("consistent", "parameters")
    kept = figures.as_adopted(studied, verdict)
    assert kept is not None
    residual = studied.problem.measured - kept
    assert np.sqrt(np.mean(residual**2)) == pytest.approx(verdict["evidence"]["adopted_mm"], rel=1e-3)
    above, below = (
        [text.get_text() for text in axes.get_legend().get_texts()] for axes in figures.drawn(studied, verdict).axes[:2]
    )
    assert above == ["recording", "as adopted"] and below == ["calibrated", "as adopted"]
    assert figures.as_adopted(studied, {**verdict, "adopted": []}) is None


def test_a_long_name_of_what_was_named_without_the_last_strokes_hangs_below_no_axis() -> None:
    _, axes = plt.subplots()
    heldout = {"nominal_mm": 0.57, "calibrated_mm": 0.24, "explained_mm": 2.3}
    panels.held_out(axes, heldout, 0.031, "mm", "mm", without="plastic_elongation + shaft_windup")
    assert all(len(label.get_text().splitlines()) <= 2 for label in axes.get_xticklabels())
    plt.close("all")


def test_the_words_of_a_narrow_panel_of_unseen_strokes_stay_in_it_and_apart() -> None:
    """Beside long names of explanations the legend ran over the frame, its sign lay on the axis, two labels touched."""
    figure = plt.figure(figsize=(figures.SIZE_INCHES[0], 3.6), layout="constrained")
    ranked, axes = figure.subplots(1, 2, width_ratios=[3, 2])
    ranked.set_yticks([0.5], ["friction_hysteresis + plastic_elongation + radius_compaction"], fontsize=7)
    heldout = {"nominal_mm": 1.4, "calibrated_mm": 0.32, "explained_mm": 0.037}
    named = "creep + friction_hysteresis + radius_compaction"
    panels.held_out(axes, heldout, 0.031, "mm", "mm", "noise of single samples: 0.031 mm", without=named)
    figure.draw_without_rendering()
    frame, legend = axes.get_window_extent(), axes.get_legend().get_window_extent()
    assert frame.x0 + 2 < legend.x0 and legend.x1 < frame.x1
    labels = [label.get_window_extent() for label in axes.get_xticklabels()]
    assert all(left_box.x1 + 5 < right.x0 for left_box, right in pairwise(labels))
    plt.close(figure)


def test_what_comes_closest_is_drawn_hollow_and_called_no_name() -> None:
    _, axes = plt.subplots()
    heldout = {"nominal_mm": 0.35, "calibrated_mm": 0.32, "explained_mm": 0.073}
    panels.held_out(axes, heldout, 0.019, "mm", "mm", without="no effect", closest="viscous_loss")
    assert axes.get_xticklabels()[-1].get_text() == "closest,\nno name"
    assert "closest, no name: viscous_loss" in [text.get_text() for text in axes.get_legend().get_texts()]
    assert axes.collections[-1].get_facecolor()[-1].tolist() == [1.0, 1.0, 1.0, 1.0]
    plt.close("all")


def test_kept_explanations_stand_first_and_no_word_lies_over_its_bar() -> None:
    """A kept one stood below one that was left out; `less than 1 %` lay over the bar of one that leaves little."""
    shown = [
        {"ids": ["wear"], "left_mm": 0.1, "with_discrepancy_mm": 0.1, "probability": 0.4, "standing": "beaten"},
        {"ids": ["creep"], "left_mm": 0.03, "with_discrepancy_mm": 0.03, "probability": 0.3, "standing": "named"},
        {"ids": ["stick_slip"], "left_mm": 0.2, "with_discrepancy_mm": 0.2, "probability": None, "standing": "beaten"},
    ]
    _, axes = plt.subplots()
    panels.ranking(axes, {"evidence": {"explanations": shown, "floor_mm": 0.05}, "mechanisms": []}, "mm")
    assert [label.get_text() for label in axes.get_yticklabels()] == ["stick_slip", "wear", "creep"]
    assert [text.get_text() for text in axes.texts] == [probability.NO_MARK, "40 %", "30 %"]
    assert axes.texts[2].get_position()[0] > 1.0, "its bar goes from 1, the noise, to 0.6"
    plt.close("all")


ONE = {"left_mm": 0.1, "bent_mm": 0.1, "probability": None}


def ranked(verdict, *rows):
    """The axes of the ranking, each row of ids, standing, what it leaves, and that with a discrepancy."""
    shown = [
        {**ONE, "ids": ids, "standing": standing, "left_mm": left_mm, "bent_mm": bent}
        for ids, standing, left_mm, bent in [([], "nothing", 1.0, 1.0), *rows]
    ]
    _, axes = plt.subplots()
    evidence = {"explanations": shown, "floor_mm": 0.1, "calibrated_mm": 1.0}
    panels.ranking(axes, {"evidence": evidence, "mechanisms": [], "verdict": verdict}, "mm")
    return axes


def test_only_the_closest_of_an_unknown_mismatch_is_the_best_there_is() -> None:
    """Two points, at 1.1 and 11 times the noise, were `the best there is, and not enough`."""
    axes = ranked("unknown", (["slack"], "not enough", 0.9, 0.9), (["creep"], "not enough", 0.11, 0.11))
    edges = [tuple(colour[:3]) for colour in axes.collections[1].get_edgecolors()]
    orange, grey = (plt.matplotlib.colors.to_rgb(colour) for colour in (panels.TIED, panels.OTHER))
    assert edges[1:] == [pytest.approx(grey), pytest.approx(orange)]
    plt.close("all")


def test_calibration_alone_is_the_last_row_and_rivals_that_fit_with_a_small_error_say_so() -> None:
    rows = [(["end_stop"], "beaten", 1.2, 1.2), (["wear"], "beaten", 0.2, 0.1), (["creep"], "named", 0.1, 0.1)]
    axes = ranked("explained", *rows)
    names = [label.get_text() for label in axes.get_yticklabels()]
    assert names[0] == "calibration alone" and names[-1] == "creep", "from below"
    beside = dict(zip(names, [text.get_text() for text in axes.texts], strict=True))
    legend = [text.get_text() for text in axes.get_legend().get_texts()]
    assert panels.LEFT_OUT in legend and panels.WORSE not in legend, "the rule, for it is no order of what is left"
    assert beside["wear"] == panels.AS_GOOD == "at the noise only if formulas err by 10 %"
    assert not beside["end_stop"] and not beside["creep"]
    assert not any("x_" in text.get_text() for text in axes.get_legend().get_texts())
    axes = ranked("explained", *rows, (["x_wave"], "beaten", 0.9, 0.9))
    assert panels.STAND_IN in [text.get_text() for text in axes.get_legend().get_texts()]
    plt.close("all")


def test_a_part_of_the_best_is_kept_for_a_reason_that_the_legend_says() -> None:
    """What leaves 6.1 times the noise was `likely as well`, and what leaves 2.3 times `fits worse`."""
    rows = [(["wear"], "beaten", 0.2, 0.1), (["creep"], "tied", 0.6, 0.3), (["creep", "jam"], "named", 0.2, 0.1)]
    for each, meaning in ((rows, panels.MENDS), ([rows[0], (["slack"], *rows[1][1:]), rows[2]], "likely as well")):
        axes = ranked("ambiguous", *each)
        legend = [text.get_text() for text in axes.get_legend().get_texts()]
        assert meaning in legend and panels.LEFT_OUT in legend
    plt.close("all")


def test_a_further_effect_is_a_ring_and_no_second_grey() -> None:
    axes = ranked("explained", (["creep", "wear"], "not needed", 0.1, 0.1), (["creep"], "named", 0.1, 0.1))
    faces = axes.collections[1].get_facecolors()
    assert tuple(faces[1][:3]) == (1.0, 1.0, 1.0) and tuple(faces[2][:3]) != (1.0, 1.0, 1.0)
    plt.close("all")


def test_a_load_panel_joins_no_means_of_both_ways(problem) -> None:
    _, axes = plt.subplots()
    load = np.linspace(0.0, 1.0, 5000)
    for label, marker in (("load (N)", "None"), ("rate (turns/s)", "-")):
        axes.clear()
        driver_panels.by_driver(axes, load, {"calibrated": load}, 0.1, label)
        assert axes.get_lines()[0].get_linestyle() == marker
    plt.close("all")


def test_maps_begin_where_the_page_says_and_are_called_as_there(problem) -> None:
    """An axis began at 0.938 turns, and another at -0.029."""
    _, axes = plt.subplots()
    span = float(np.ptp(problem.drivers.motion))
    drivers = replace(problem.drivers, motion=problem.drivers.motion - problem.drivers.motion.min() - 0.0017 * span)
    mismatch_map.mismatch_map(axes, drivers, problem.measured, "map", 1.0, "motor angle")
    assert axes.get_xticklabels()[0].get_text() == "0" and axes.get_xlabel().startswith("motor angle (")
    names = driver_panels.listeners(problem.drivers, motion="motor angle")
    assert any(name.startswith("motor angle, winding") for name in names)
    plt.close("all")


def test_what_comes_closest_is_drawn_beside_calibration_and_called_no_name(studied) -> None:
    """Of an unknown mismatch the left map was nominal, and what predicts the rig was nowhere."""
    outcome, run, _ = studied("creep")
    unknown = replace(outcome, verdict="unknown", closest=outcome.best, state=outcome.base)
    content = diagnosis(unknown, outcome.problem, None, [run], None, frozenset())
    figure = figures.drawn(unknown, content)
    titles = [axes.get_title() for axes in figure.subfigs[1].axes if axes.images]
    assert titles == [f"Recording − simulation, {name} (own scale)" for name in ("calibrated", "closest, no name")]
    lines = {line.get_label(): line.get_color() for axes in figure.subfigs[0].axes for line in axes.get_lines()}
    assert lines["closest, no name"] == panels.TIED and "as diagnosed" not in lines


def test_the_named_effects_are_no_closest_ones_where_these_come_closest_without_the_last_strokes(studied) -> None:
    """The figure called the named effects `closest, no name`."""
    outcome, run, _ = studied("creep")
    content = diagnosis(outcome, outcome.problem, None, [run], None, frozenset())
    errors = {"split": "last 30 % of strokes", "nominal_mm": 0.4, "calibrated_mm": 0.3, "explained_mm": 0.04}
    content["fit"]["heldout"] = errors
    for ids, called in ((["creep"], "as\ndiagnosed"), (["wear"], "closest,\nno name")):
        content["evidence"] |= {"chosen_without_them": [], "closest_without_them": ids}
        axes = figures.drawn(outcome, content).subfigs[2].axes[1]
        assert [label.get_text() for label in axes.get_xticklabels()][-1] == called
        entries = [text.get_text() for text in axes.get_legend().get_texts()]
        assert any("no name" in entry for entry in entries) == (ids == ["wear"])


def test_the_band_of_the_noise_is_as_wide_as_its_legend_says(studied) -> None:
    """It had the noise of the search, where the page tells a smaller one."""
    outcome, run, _ = studied("creep")
    content = diagnosis(outcome, outcome.problem, None, [run], None, frozenset())
    content["evidence"]["floor_mm"] = 0.321
    figure = figures.drawn(outcome, content)
    (axes,) = [axes for axes in figure.axes if axes.get_xlabel() == "rate (turns/s)"]
    (band,) = axes.patches
    assert band.get_bbox().extents[[1, 3]].tolist() == [-0.321, 0.321]
    labels = [text.get_text() for legend in figure.findobj(Legend) for text in legend.get_texts()]
    assert [label[-7:] for label in labels if label.startswith("± noise")] == ["0.32 mm"]
