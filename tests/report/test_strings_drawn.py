"""A figure of several strings drew one of them, and its words spoke of all."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from stages.nine_strokes import NINE

from pipeline.report.drawn.drawing import COLOURS, STYLE, lighter
from pipeline.report.drawn.figure_4 import figure_4
from pipeline.report.drawn.figure_5 import figure_5
from pipeline.report.drawn.winding import with_nominal
from pipeline.report.shown.strings_drawn import strings_drawn, which_strings
from pipeline.report.shown.stroke_conditions import labels

TWO = pd.concat(
    [
        NINE.assign(string="reel-a"),
        NINE[NINE["stroke"] <= 5].assign(string="reel-b", radius_mm=0.6, displacement_mm=9.0, load_n=40.0),
    ],
    ignore_index=True,
)


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def beneath(figure):
    words = figure.get_supxlabel() or figure.legends[0].get_title().get_text()
    return " ".join(words.split())


def test_figure_4_draws_both_strings_and_says_which_is_which():
    with plt.rc_context(STYLE):
        four = figure_4(with_nominal(TWO), "m")
        four.canvas.draw()
    forward, forward_error = four.axes[:2]
    of_second = [line for line in forward.get_lines() if (np.asarray(line.get_ydata()) == 9.0).any()]
    assert len(of_second) == 2, "strokes 1 and 5 of reel-b were not drawn"
    assert [line.get_color() for line in of_second] == [lighter(colour, 1) for colour in COLOURS[:2]]
    assert len(forward_error.get_lines()) == 2 * (3 + 2) + 1, "every sample and its mean, and 0"
    assert len([line for line in forward.get_lines() if line.get_linestyle() == "--"]) == 2, "a model for each size"
    legend = [text.get_text() for text in four.legends[0].get_texts()]
    assert legend[:2] == ["n=1 (20 and 40 N)", "n=5 (20 and 40 N)"] and legend[2:4] == [
        "n=9 (20 N)",
        "traditional model",
    ]
    assert legend[4:] == ["full colour: reel-a", "light colour: reel-b"]
    words = "Every string counts its own strokes: full colour is reel-a, light colour is reel-b; n=9 of reel-a alone."
    assert words in beneath(four)


def test_figure_5_says_that_it_draws_one_string():
    five = figure_5(with_nominal(TWO), {}, "m")
    words = "Every string counts its own strokes: drawn is reel-a alone; reel-b is not; the tables are of both."
    assert words in beneath(five) and five.get_suptitle() == "m: winding of reel-a"
    assert [axes.get_title(loc="left") for axes in five.axes[:3]] == [
        f"({letter}) forward, n={stroke} (20 N)" for letter, stroke in zip("abc", (1, 5, 9), strict=True)
    ]


def test_a_figure_of_one_string_says_nothing_of_strings():
    for figure in (figure_4(with_nominal(NINE), "m"), figure_5(with_nominal(NINE), {}, "m")):
        assert "string counts" not in beneath(figure) and figure.get_suptitle().startswith("m: winding")
        assert " of " not in figure.get_suptitle()
    assert len(figure_4(with_nominal(NINE), "m").legends[0].get_texts()) == 4


def test_of_many_strings_two_are_drawn_and_the_others_counted():
    many = pd.concat([NINE.assign(string=f"s{number}") for number in range(6)], ignore_index=True)
    of_stroke = strings_drawn(many, [1, 5], 2)
    assert of_stroke == {1: ["s0", "s1"], 5: ["s0", "s1"]}
    words = "full colour is s0, light colour is s1; 4 other strings are not; the tables are of all 6."
    assert which_strings(of_stroke, many).endswith(words)
    assert "drawn is s0 alone; 5 other strings are not;" in which_strings(strings_drawn(many, [1, 5], 1), many)


def test_no_stroke_is_left_out_for_the_string_that_has_it():
    """Strings whose strokes follow each other: three are drawn where two do not hold all strokes."""
    parts = [NINE[NINE["stroke"].between(low, low + 2)].assign(string=f"s{low}") for low in (1, 4, 7)]
    after_another = pd.concat(parts, ignore_index=True)
    assert strings_drawn(after_another, [1, 5, 9], 1) == {1: ["s1"], 5: ["s4"], 9: ["s7"]}
    words = "drawn is n=1 of s1, n=5 of s4 and n=9 of s7; the tables are of all 3."
    assert which_strings(strings_drawn(after_another, [1, 5, 9], 2), after_another).endswith(words)
    four = figure_4(with_nominal(after_another), "m")
    lines = [line.get_color() for line in four.axes[0].get_lines() if line.get_linestyle() == "-"]
    assert lines == list(COLOURS[:3]), "strokes are told apart by their colours, and none is light"


def test_a_label_says_the_loads_of_both_strings_once_where_they_are_alike():
    alike = TWO.assign(load_n=np.where(TWO["stroke"] == 9, 30.0, np.where(TWO["string"] == "reel-b", 20.1, 20.0)))
    strokes = {1: ["reel-a", "reel-b"], 9: ["reel-a"]}
    assert labels(alike, strokes) == {1: "n=1 (20 N)", 9: "n=9 (30 N)"}
