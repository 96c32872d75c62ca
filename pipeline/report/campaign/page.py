"""A campaign's tables → its figures, its tables as csv, and the page that says which model knows a new string when."""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

from ...ground.errors import program
from ...ground.stored import schemas
from ...ground.stored.files import write_text
from ...stages.campaign.campaign_tables import COVERAGE, FEW_SHOT, FLOOR
from ...stages.campaign.points import SCHEMA
from ..drawn.drawing import STYLE, save
from ..layout.plain_markdown import plain
from ..layout.sidecar import Column, describe
from ..layout.titles import titles_of
from ..web.marks import add_mark, mark_from, write_page
from . import figures
from .coverage import intervals
from .error_sentences import by_material, leaders, nearest, shots_table, untold, without_others
from .results import MAPS

STRING: list[Column] = [("string", "string", "the string asked about"), ("material", "string", "its material")]
FEW_SHOT_COLUMNS: list[Column] = [
    ("model", "string", "file of the model, or floor"),
    ("how", "string", "transfer: learnt from other strings; alone: from this string only; oracle: sees the answers"),
    *STRING,
    ("shots", "integer", "strokes of the string that were shown"),
    ("forward_mm", "number", "RMSE of the displacement on later strokes"),
    ("inverse_turns", "number", "RMSE of the twist on later strokes"),
]
COVERAGE_COLUMNS: list[Column] = [
    *STRING,
    ("map", "string", "forward or inverse"),
    ("ahead", "integer", "strokes after the last that was learnt"),
    ("level", "number", "share that the intervals should hold"),
    ("held", "number", "share that they held"),
    ("width", "number", "their median width, in mm forward and in turns inverse"),
    ("points", "number", "points asked about"),
    ("outside", "number", "points outside of what was learnt, without an interval"),
]
NOTES = """\
Strings, rigs, loads and materials vary from string to string. Models learn on some strings; how a string may differ
from what they say is learnt on others (a string's own correction: an offset, a slope, a bend, a loop and a growth, as
likely as they are among those strings); the rest is new to both. Of each new string the first strokes are shown, 0 to
5, and the strokes after the fifth are asked about, whatever was shown. Errors are RMSE over those strokes; given are
the median over the new strings and, in brackets, the lower and upper quartiles. "Alone": learnt from the strokes shown
and nothing else. The traditional model without that word is the nominal equations with a string's correction on top.
Every model is fitted once, with one seed: how far another seed would move it is not measured here.
"""


def floor_note(floor: pd.DataFrame) -> str:
    """What the floor is, and how large."""
    sizes = " and ".join(f"{floor[column].median():.3g} {unit} {map_}" for map_, (column, unit) in MAPS.items())
    return (
        "The floor is what an oracle misses that sees the answers: smooth curves through each string's later strokes,"
        f" one for each stroke and direction; {sizes} (median). What a curve through so few points cannot follow counts"
        " to it, so it may lie a little above the sensors' noise.\n"
    )


def counted(points: pd.DataFrame) -> str:
    """How many strings there are, of how many materials, and what each part is for."""
    strings = points.drop_duplicates("string").groupby("strings").size()
    parts = (
        f"{strings['train']} to learn on, {strings['tune']} to learn on what a correction may be, {strings['test']} new"
    )
    return f"{strings.sum()} strings of {points['material'].nunique()} materials: {parts}.\n"


def page(
    points: pd.DataFrame, few_shot: pd.DataFrame, floor: pd.DataFrame, coverage: pd.DataFrame, titles: dict[str, str],
    of: str,
) -> str:  # fmt: skip
    """Text of `campaign.md`; `of` is the title of the model whose intervals `coverage` tells of."""
    text = ["# New strings: who knows them from how many strokes", "", counted(points), NOTES, floor_note(floor)]
    text += ["![Errors on new strings](few_shot.png)", ""]
    for map_, (column, unit) in MAPS.items():
        level = float(floor[column].median())
        text += [f"## {map_.capitalize()} ({unit})", "", leaders(few_shot, column, unit, titles)]
        text += [nearest(few_shot, column, unit, level, titles), without_others(few_shot, column, unit, titles), ""]
        text += shots_table(few_shot, floor, column, titles)
    text += ["## What a model cannot tell", "", *untold(few_shot, titles)]
    text += ["## By material", "", *by_material(few_shot, floor, titles)]
    text += ["## Intervals", "", "![Coverage](coverage.png)", "", *intervals(coverage, of)]
    text += ["All numbers, string by string: [few_shot.csv](few_shot.csv), [coverage.csv](coverage.csv).", ""]
    return "\n".join(text)


def few_shot_csv(few_shot: pd.DataFrame, floor: pd.DataFrame) -> str:
    """Every string's errors; the floor as rows without strokes shown."""
    beneath = floor.assign(model="floor", how="oracle", shots="")
    columns = ["model", "how", "string", "material", "shots", *(column for column, _ in MAPS.values())]
    rows = pd.concat([few_shot[columns].astype({"shots": str}), beneath[columns]], ignore_index=True)
    return rows.to_csv(index=False, float_format="%.6g", lineterminator="\n")


@program
def main() -> None:
    """Write `few_shot` and `coverage` as csv, png and pdf, `campaign.md` and `campaign.html`."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.campaign.page", description=__doc__)
    parser.add_argument("points", type=Path)
    parser.add_argument("--few-shot", type=Path, nargs="+", required=True, help="one file a model")
    parser.add_argument("--floor", type=Path, required=True)
    parser.add_argument("--coverage", type=Path, required=True)
    parser.add_argument("--titles", nargs="+", required=True, metavar="MODEL=TITLE")
    parser.add_argument("--intervals-of", required=True, metavar="TITLE", help="the model that `--coverage` is of")
    parser.add_argument("--out-dir", type=Path, required=True, help="the folder of the page; required")
    add_mark(parser)
    parser.add_argument("--svg-dir", type=Path, help="write the figures as svg there, too")
    arguments = parser.parse_args()
    titles, mark = titles_of(arguments.titles), mark_from(arguments.made_by)
    few_shot = pd.concat([schemas.read(path, FEW_SHOT) for path in arguments.few_shot], ignore_index=True)
    floor, coverage = schemas.read(arguments.floor, FLOOR), schemas.read(arguments.coverage, COVERAGE)
    points = schemas.read(arguments.points, SCHEMA)
    with plt.rc_context(STYLE):
        for name, figure in (
            ("few_shot", figures.few_shot(few_shot, floor, titles)),
            ("coverage", figures.coverage(coverage)),
        ):
            if arguments.svg_dir:
                figures.save_svg(figure, arguments.svg_dir / f"{name}.svg")
            save(figure, arguments.out_dir / name, mark)
    write_text(arguments.out_dir / "few_shot.csv", few_shot_csv(few_shot, floor))
    write_text(
        arguments.out_dir / "coverage.csv", coverage.to_csv(index=False, float_format="%.6g", lineterminator="\n")
    )
    describe(arguments.out_dir / "few_shot.csv", "Errors on new strings, string by string", FEW_SHOT_COLUMNS, mark)
    describe(
        arguments.out_dir / "coverage.csv", "What prediction intervals held, string by string", COVERAGE_COLUMNS, mark
    )
    names = {model: plain(title) for model, title in titles.items()}
    text = page(points, few_shot, floor, coverage, names, plain(arguments.intervals_of))
    write_page(arguments.out_dir / "campaign.md", text, mark)


if __name__ == "__main__":
    main()
