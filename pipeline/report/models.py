"""Metrics → models.md, .html, .csv: every model's RMSE by stroke, direction and angle, beside the data's floor."""

import argparse
from collections.abc import Iterable, Sequence
from pathlib import Path

import pandas as pd

from ..ground.errors import program
from ..ground.model_errors import APART, NEEDS_MOTION, chosen_of, floor_of
from ..ground.model_names import FLOORS
from ..ground.stored import schemas
from ..ground.stored.files import write_text
from ..ground.words.jump_notes import read_jumps
from .layout import paper
from .layout.plain_markdown import line, plain
from .layout.sidecar import Column, describe
from .layout.titles import titles_of
from .model_to_take import inverse_beside
from .model_to_take.fitted import FLOOR_TITLES, SPLITS, lines_on_files, times_floor
from .model_to_take.least_errors import on_simulator, sentences
from .model_to_take.usual_model import RULE, RULES, ranked, weighed
from .parts import jumps
from .shown.strings_together import together
from .shown.stroke_conditions import add_dataset, dataset_from, later_apart, otherwise
from .web.marks import add_mark, mark_from, write_page

WHERE = ["stroke", "phase", "angle_band"]
COLUMNS: list[Column] = [
    ("model", "string", "file of the model, or a floor"), ("title", "string", "its title"),
    ("direction", "boolean", "whether it knows winding from unwinding"),
    ("split", "string", "what was held out: blocks within strokes, or whole later strokes"),
    ("map", "string", "forward: displacement from twist; inverse: twist from displacement"),
    ("unit", "string", "unit of the errors"), ("column", "string", "all, a stroke, a phase or a band of twist"),
    ("median", "number", "RMSE, median over the seeds"), ("low", "number", "lowest of the seeds"),
    ("high", "number", "highest of the seeds"), ("floor", "number", "RMSE of the floor for what the model knows"),
    ("ratio", "number", "median over floor"),
    (APART, "boolean", "whether these strokes were recorded under a load or to a twist that few learnt ones have"),
    (NEEDS_MOTION, "boolean", "whether it answers along a whole motion alone: it is neither exported nor asked"),
]  # fmt: skip
NOTES = """\
RMSE on held-out points, winding and unwinding together unless a column says otherwise: the median over the seeds, with
the lowest and the highest in brackets where they differ. `within` cuts each stroke into short blocks, at most 80 a
winding, and holds out one block in four; `later` holds out the last quarter of the strokes, whole. (A diagnosis of one
run leaves out the last 30 % of its strokes, and may name other effects without them than the model `diagnosed` does
without the last quarter: the errors in its verdict and in the table of runs can be several times smaller or larger.) n
is the number of the stroke. The last four columns are quarters of the material's range of twist, the lowest first.
**Bold**: the least of a column.

A floor is the least error that these data allow. It is no model: it is what the best smooth curve through the held-out
points of each stroke misses. The floor with direction has one curve for winding and one for unwinding: what it misses
is noise. The floor without direction has one curve for both: it also misses the loop between the two. `× floor` is a
model's error divided by the floor for what the model knows. A model that knows more than the twist (or contraction),
the string, the stroke and the direction, such as the load or the past, may get below its floor. A model without the
direction may do so in the column of winding, if it is worse in that of unwinding, or the other way round.
"""


def columns(metrics: pd.DataFrame) -> dict[str, tuple[str, str, str]]:
    """Heads of the columns, with the stroke, phase and angle band of each.

    Strokes are the paper's; if at most one of them is there, also the first and the last held-out stroke.
    """
    strokes = sorted({int(stroke) for stroke in metrics["stroke"] if stroke != "all"})
    shown = [stroke for stroke in strokes if stroke in paper.STROKES]
    shown = shown if len(shown) > 1 else sorted({*strokes[:1], *shown, *strokes[-1:]})
    bands = sorted(set(metrics["angle_band"]) - {"all"}, key=lambda band: int(band.split("-")[0]))
    return {
        "all": ("all", "all", "all"),
        **{f"n={stroke}": (str(stroke), "all", "all") for stroke in shown},
        **{phase: ("all", phase, "all") for phase in ("winding", "unwinding")},
        **{band: ("all", "all", band) for band in bands},
    }


def numbers(metrics: pd.DataFrame, titles: dict[str, str], directed: Iterable[str]) -> pd.DataFrame:
    """Median, lowest and highest RMSE of every model and floor in every column of both splits and maps, a row each.

    `directed` names the models that are told the direction. `ratio` is the median over the floor that the model's
    inputs entitle it to.
    """
    directed_names, rows = {*directed, "floor"}, []
    rmse = metrics[metrics["metric"] == "rmse"]
    for (split, way), chosen in rmse.groupby(["split", "map"], sort=False):
        values = {key: group["value"] for key, group in chosen.groupby(["model", *WHERE])}
        for model, title in {**titles, **FLOOR_TITLES}.items():
            for head, where in columns(chosen).items():
                seeds, floor = values.get((model, *where)), "floor" if model in directed_names else "floor_blind"
                if seeds is None:
                    continue
                spread = [seeds.median(), seeds.min(), seeds.max()]
                least = values[floor, *where].median() if (floor, *where) in values else float("nan")
                is_directed, unit = model in directed_names, chosen["unit"].iloc[0]
                rows.append([model, title, is_directed, split, way, unit, head, *spread, least, spread[0] / least])
    return pd.DataFrame(rows, columns=[head for head, _, _ in COLUMNS if head not in (APART, NEEDS_MOTION)])


def _cell(row: pd.Series, best: float) -> str:
    """Median with the spread over the seeds, three decimals, bold when it shows the same number as the best."""
    middle, low, high = (f"{row[name]:.3f}" for name in ("median", "low", "high"))
    middle = f"**{middle}**" if middle == f"{best:.3f}" and row["model"] not in FLOORS else middle
    return middle if low == high else f"{middle} ({low}–{high})"


def table(chosen: pd.DataFrame) -> list[str]:
    """Lines of the Markdown table of one split and map: the models, then the floors."""
    heads = list(dict.fromkeys(chosen["column"]))
    best = chosen[~chosen["model"].isin(FLOORS)].groupby("column")["median"].min()
    lines = [line(["model", "knows the direction", "× floor", *heads]), line(["---"] * (3 + len(heads)))]
    for model, mine in chosen.groupby("model", sort=False):
        by_column = mine.set_index("column", drop=False)
        cells = [_cell(by_column.loc[head], best[head]) if head in by_column.index else "" for head in heads]
        title, direction, ratio = mine["title"].iloc[0], "", ""
        if model not in FLOORS:
            title, direction = plain(title), "yes" if mine["direction"].iloc[0] else "no"
            ratio = times_floor(by_column.loc["all", "ratio"])
        lines.append(line([title, direction, ratio, *cells]))
    return lines


def on_model_to_take(table_of: pd.DataFrame) -> list[str]:
    """Lines that name the model to take, by which rule, and one that errs less on strokes like the recorded ones."""
    whole = table_of[(table_of["column"] == "all") & ~table_of["model"].isin(FLOORS)]
    for mark in (APART, NEEDS_MOTION):
        whole = whole[~whole[mark]] if mark in whole else whole
    titles = {row["model"]: plain(row["title"]) for _, row in whole.iterrows()}
    errors_mm, errors_turns = (
        {(row["model"], row["split"]): float(row["median"]) for _, row in whole[whole["map"] == way].iterrows()}
        for way in paper.MAPS.values()
    )
    chosen = chosen_of(titles, errors_mm)
    if not chosen:
        return []
    rules = [f"{number}. {rule}" for number, rule in enumerate(RULES, start=1)]
    at_inverse = inverse_beside.sentences(chosen, titles, errors_turns, errors_mm)
    beside = weighed(titles, errors_mm, floor_of(row for _, row in table_of.iterrows()))
    sentences = [f"Take the **{titles[chosen]}**.", ranked(chosen, titles, errors_mm), beside, at_inverse]
    return [" ".join(filter(None, sentences)), "", RULE, "", *rules, ""]


def page(table_of: pd.DataFrame, material: str, dataset: pd.DataFrame | None = None, jumped: Sequence[str] = ()) -> str:
    """Text of models.md of one material, from the table of `numbers`; the points say in what its strokes differ."""
    text = [f"# {plain(material)}: every model beside the floor of the data", "", *jumps.quoted(jumped)]
    text += [*on_model_to_take(table_of), NOTES]
    differ, apart = otherwise(dataset), later_apart(dataset)
    heads = table_of["column"].astype(str)
    mixed = together(dataset, sorted({int(head[2:]) for head in heads if head.startswith("n=")}))
    text += [row for words in (mixed, differ) if words for row in (words, "")]
    for split, name in SPLITS.items():
        for way in paper.MAPS.values():
            chosen = table_of[(table_of["split"] == split) & (table_of["map"] == way)]
            if chosen.empty:
                text += [f"## {way.capitalize()}, {name}", "", "Skipped: the strings have too few strokes.", ""]
                continue
            text += [f"## {way.capitalize()}, {name}: RMSE in {chosen['unit'].iloc[0]}", ""]
            text += [apart, ""] if apart and split == "later" else []
            text += [*table(chosen), ""]
            text += [*sentences(chosen), *on_simulator(table_of, split, way), ""]
    return "\n".join(text)


@program
def main() -> None:
    """Write `models.md`, `models.html` and `models.csv` of one material."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.models", description=__doc__)
    parser.add_argument("metrics", type=Path)
    parser.add_argument("--titles", nargs="+", required=True, metavar="MODEL=TITLE")
    parser.add_argument("--directed", nargs="*", default=[], metavar="MODEL", help="models that know the direction")
    parser.add_argument(
        "--whole-motion", nargs="*", default=[], metavar="MODEL", help="models that need a whole motion"
    )
    parser.add_argument(
        "--out", type=Path, required=True, help="the file of the page, .md, its .html beside it; required"
    )
    parser.add_argument("--table", type=Path, required=True)
    add_dataset(parser)
    jumps.arguments(parser)
    add_mark(parser)
    arguments = parser.parse_args()
    metrics = schemas.read(arguments.metrics, schemas.METRICS)
    table_numbers = numbers(metrics, titles_of(arguments.titles), arguments.directed)
    material, mark = str(metrics["material"].iloc[0]), mark_from(arguments.made_by)
    dataset = dataset_from(arguments.dataset)
    is_apart = bool(later_apart(dataset))
    table_numbers[APART] = (table_numbers["split"] == "later") & is_apart
    table_numbers[NEEDS_MOTION] = table_numbers["model"].isin(arguments.whole_motion)
    first = page(table_numbers, material, dataset, read_jumps(arguments.jumps))
    text = "\n".join([first, *lines_on_files(metrics, material, is_apart, arguments.whole_motion)])
    write_page(arguments.out, text, mark)
    write_text(arguments.table, table_numbers.to_csv(index=False, float_format="%.9g"))
    describe(arguments.table, f"Every model beside the floor of the data, {material}", COLUMNS, mark)


if __name__ == "__main__":
    main()
