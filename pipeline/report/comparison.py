"""Metrics → comparison.md, .html: our numbers beside the paper's, their spread over the seeds, the split `later`."""

import argparse
from collections.abc import Sequence
from pathlib import Path

import pandas as pd

from ..ground.errors import program
from ..ground.model_names import PAPER
from ..ground.names import SYNTHETIC
from ..ground.stored import schemas
from ..ground.words.jump_notes import read_jumps
from .agreement import agreement
from .layout import paper
from .layout.made_by import MadeBy
from .layout.plain_markdown import line, plain
from .layout.titles import titles_of
from .parts import jumps
from .shown.shown_strokes import shown_of, tabled, there_of
from .shown.stroke_conditions import add_dataset, dataset_from, later_apart, otherwise
from .web.marks import add_mark, mark_from, write_page

UNKNOWN = MadeBy()
FAR = 1.5  # times the floor: an INN that errs so much is not what these data allow
NOTES = """\
Errors are on held-out points only. `within` cuts each stroke into short blocks, at most 80 a winding, and holds out one
block in four; `later` holds out the last quarter of the strokes, whole. Values are medians over the seeds, with the
lowest and the highest in brackets where they differ.
The displacement is tared once a string, on the rest before its first stroke, to the model's value at that twist.
Where the contraction is negative eq. 5 has no real root. The number under the root is then taken as 0, so the
traditional model answers one and the same twist there. The paper has numbers of two of these models: the INN and the
traditional one. The INN has the paper's five inputs. The direction is not among them, so it learns the mean of winding
and unwinding.
"""


def shown(values: pd.Series) -> str:
    """Median with the spread over the seeds, three decimals."""
    if values.empty:
        return ""
    low, middle, high = (f"{value:.3f}" for value in (values.min(), values.median(), values.max()))
    return middle if low == high else f"{middle} ({low}–{high})"


def why_apart(whole: pd.DataFrame, material: str) -> str:
    """Why the INN's errors are not the paper's, with the floor of these data; empty where there is no such row.

    `whole` holds the metrics over the whole range of twist.
    """
    chosen = whole[(whole["map"] == "forward") & (whole["split"] == "within") & (whole["phase"] == "winding")]
    values = chosen[chosen["metric"] == "rmse"].groupby(["model", "stroke"])["value"].median()
    printed = {stroke: by_metric[paper.METRICS.index("rmse")] for stroke, by_metric in paper.TABLES[1][PAPER].items()}
    both = [n for n in printed if (PAPER, str(n)) in values and ("floor_blind", str(n)) in values]
    if not both:
        return ""
    stroke = 5 if 5 in both else both[0]
    ours, floor = (values[model, str(stroke)] for model in (PAPER, "floor_blind"))
    reason = "This rig is not the paper's"
    if material == SYNTHETIC:
        reason = "The synthetic rig was fitted to the errors of the paper's traditional model, not to those of its INN"
    tells = "So a difference from the paper tells of the recording, not of a better or worse network."
    if ours > FAR * floor:
        tells = f"This network errs by {ours / floor:.1f} times that: its errors cannot be compared with the paper's."
    return (
        f"{reason}: forward, winding, n={stroke}, the INN's RMSE is {ours:.3f} mm here and {printed[stroke]:.3f} mm "
        f"in the paper. Here noise makes {floor:.3f} mm, together with the loop between winding and unwinding, which "
        "the INN is not told of (floor without direction, on the page of the models). It cannot go far below that. The "
        "paper does not state its own floor. "
        f"{tells}"
    )


def table(metrics: pd.DataFrame, number: int, strokes: list[str], titles: dict[str, str], beside: bool) -> list[str]:
    """Errors of every model by stroke, with the paper's beside ours where `beside` asks for them."""
    heads = [f"{metric} ({paper.UNITS[number]})" for metric in ("average", "maximum", "RMSE")]
    columns = [name for head in heads for name in ((head, "paper") if beside else (head,))]
    lines = [line(["model", "stroke", *columns]), line(["---"] * (2 + len(columns)))]
    for model, title in titles.items():
        for stroke in strokes:
            mine = metrics[(metrics["model"] == model) & (metrics["stroke"] == stroke)]
            printed = paper.TABLES[number].get(model, {}).get(int(stroke), ("", "", ""))
            cells = []
            for metric, theirs in zip(paper.METRICS, printed, strict=True):
                cells.append(shown(mine.loc[mine["metric"] == metric, "value"]))
                if beside:
                    cells.append(f"{theirs:.3f}" if isinstance(theirs, float) else "")
            lines.append(line([plain(title), f"n={stroke}", *cells]))
    return [*lines, ""]


def another_rig(mark: MadeBy) -> str:
    """Why no number on this page can agree with the paper, and how to make a page that can."""
    short = ", and its trainings are short" if mark.kind == "small" else ""
    return (
        f"No agreement with the paper is expected here: {plain(mark.name)} records another synthetic rig than the one "
        f"that was fitted to the paper{short}. This rig is {plain(mark.rig)}. The paper's numbers stand beside ours "
        "only for the layout. `snakemake --cores 2`, the default configuration, makes a page that can be compared."
    )


def comparison(
    metrics: pd.DataFrame,
    material: str,
    titles: dict[str, str],
    mark: MadeBy = UNKNOWN,
    dataset: pd.DataFrame | None = None,
    jumped: Sequence[str] = (),
) -> str:
    """Text of comparison.md of one material; the points of `dataset` say in what its strokes differ."""
    whole = metrics[metrics["angle_band"] == "all"]
    strokes_there = there_of(whole.loc[whole["split"] == "within", "stroke"])
    strokes = [str(stroke) for stroke in tabled(strokes_there, paper.STROKES)]
    which = [shown_of(strokes_there, paper.STROKES, material)]
    missing, apart = " ".join(filter(None, [*which, otherwise(dataset)])), later_apart(dataset)
    is_other_rig = material == SYNTHETIC and bool(mark.rig)
    why_off = another_rig(mark) if is_other_rig else why_apart(whole, material)
    why = [why_off, ""] if why_off else []
    text = [f"# {plain(material)}: our errors beside the paper's", "", *jumps.quoted(jumped), *why, NOTES]
    text += [missing, ""] if missing else []
    text += agreement(whole) if material == SYNTHETIC and not is_other_rig else []
    for number, direction in paper.MAPS.items():
        text += [f"## Table {'I' * number}, {direction}, within strokes, winding", ""]
        chosen = whole[(whole["map"] == direction) & (whole["split"] == "within") & (whole["phase"] == "winding")]
        text += table(chosen, number, strokes, titles, beside=True)
    for number, direction in paper.MAPS.items():
        chosen = whole[(whole["map"] == direction) & (whole["split"] == "within") & (whole["phase"] == "unwinding")]
        text += [f"## {direction.capitalize()}, within strokes, unwinding", ""]
        text += table(chosen, number, strokes, titles, beside=False)
    for number, direction in paper.MAPS.items():
        chosen = whole[(whole["map"] == direction) & (whole["split"] == "later") & (whole["phase"] == "winding")]
        text += [f"## {direction.capitalize()}, later strokes, winding", "", *([apart, ""] if apart else [])]
        later = [str(stroke) for stroke in there_of(chosen["stroke"])]
        few = ["Skipped: no string of this material has four strokes or more.", ""]
        text += table(chosen, number, later, titles, beside=False) if later else few
    return "\n".join(text)


@program
def main() -> None:
    """Write `comparison.md` and `.html` of one material."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.comparison", description=__doc__)
    parser.add_argument("metrics", type=Path)
    parser.add_argument("--titles", nargs="+", required=True, metavar="MODEL=TITLE")
    parser.add_argument(
        "--out", type=Path, required=True, help="the file of the page, .md, its .html beside it; required"
    )
    add_dataset(parser)
    jumps.arguments(parser)
    add_mark(parser)
    arguments = parser.parse_args()
    metrics = schemas.read(arguments.metrics, schemas.METRICS)
    dataset = dataset_from(arguments.dataset)
    material, mark = str(metrics["material"].iloc[0]), mark_from(arguments.made_by)
    jumped, titles = read_jumps(arguments.jumps), titles_of(arguments.titles)
    write_page(arguments.out, comparison(metrics, material, titles, mark, dataset, jumped), mark)


if __name__ == "__main__":
    main()
