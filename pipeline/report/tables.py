"""Metrics → Tables I and II in the paper's layout, as csv, Markdown and LaTeX, marked with their configuration."""

import argparse
from collections.abc import Sequence
from pathlib import Path

import pandas as pd

from ..ground.errors import program
from ..ground.stored import schemas
from ..ground.stored.files import write_text
from ..ground.words.jump_notes import read_jumps
from ..ground.words.left_out import LeftOut
from . import left_out
from .layout import paper
from .layout.made_by import MadeBy, sentence, warning
from .layout.plain_markdown import note, plain
from .layout.sidecar import Column, describe
from .layout.table_forms import OF_WHAT, Row, to_csv, to_latex, to_markdown
from .layout.titles import titles_of
from .left_out import quoted
from .parts import jumps
from .shown.shown_strokes import rows_of, shown_of, tabled, there_of
from .shown.strings_together import together
from .shown.stroke_conditions import add_dataset, dataset_from, otherwise
from .web.marks import add_mark, mark_from

MOST = 3  # runs that a table names


def shown(metrics: pd.DataFrame, number: int) -> pd.DataFrame:
    """The metrics of Table I or II: winding, split `within`, the whole range of twist, one direction."""
    return metrics[
        (metrics["split"] == "within")
        & (metrics["phase"] == "winding")
        & (metrics["angle_band"] == "all")
        & (metrics["map"] == paper.MAPS[number])
    ]


def cell(metrics: pd.DataFrame, model: str, stroke: int, metric: str) -> str:
    """Median over the seeds to three decimals, or nothing where the material has no such stroke."""
    values = metrics.loc[
        (metrics["model"] == model) & (metrics["stroke"] == str(stroke)) & (metrics["metric"] == metric), "value"
    ]
    return "" if values.empty else f"{values.median():.3f}"


def rows(
    metrics: pd.DataFrame, number: int, titles: dict[str, str], strokes: Sequence[int] = paper.STROKES
) -> list[Row]:
    """Rows of Table I or II; `titles` maps a model's name to its title, in order."""
    chosen = shown(metrics, number)
    return [
        (title, f"n={stroke}", [cell(chosen, model, stroke, metric) for metric in paper.METRICS])
        for model, title in titles.items()
        for stroke in strokes
    ]


def of_what(metrics: pd.DataFrame, number: int, titles: dict[str, str], runs: Sequence[str]) -> str:
    """The sources of the numbers in Table I or II: material, points, seeds and runs."""
    chosen = shown(metrics, number)
    seeds = chosen[chosen["model"].isin(titles)].groupby("model")["seed"].nunique()
    many = {count: [titles[model] for model in titles if seeds.get(model) == count] for count in sorted({*seeds} - {1})}
    counts = ", ".join(f"{count} of {', '.join(models)}" for count, models in many.items())
    rest = f" ({counts}{'; the others one fit' * bool((seeds == 1).any())})" if counts else " (one fit of each model)"
    named = ", ".join(quoted(run) for run in runs[:MOST]) + f" and {len(runs) - MOST} more" * (len(runs) > MOST)
    made_of = f"; made of run{'s' * (len(runs) > 1)} {named}" if runs else ""
    return (
        f"{OF_WHAT} {metrics['material'].iloc[0]}: {paper.MAPS[number]} errors on held-out points of the split within "
        "(each stroke is cut into short blocks, and one block in four is held out), winding, median over the seeds"
        f"{rest}{made_of}."
    )


def columns(number: int, material: str) -> list[Column]:
    """The meaning of the columns of a material's csv."""
    unit = {1: "mm", 2: "turns of the motor"}[number]
    words = [
        "the model's title",
        f"n: the stroke's number since the string was new; shown are the paper's three, {rows_of(material)} has all",
        *(f"{metric} of the {paper.MAPS[number]} error on held-out winding points in {unit}, median over the seeds;"
          " empty where the material has no such stroke" for metric in ("mean of the size", "largest size", "RMSE")),
    ]  # fmt: skip
    kinds = ["string", "string", "number", "number", "number"]
    return list(zip(paper.header(number), kinds, words, strict=True))


def write(
    metrics: pd.DataFrame,
    number: int,
    titles: dict[str, str],
    mark: MadeBy,
    folder: Path,
    gone: Sequence[LeftOut] = (),
    jumped: Sequence[str] = (),
    dataset: pd.DataFrame | None = None,
) -> None:
    """Write one table in all three forms; csv keeps the paper's strokes, the others show those that are there."""
    material, stem = str(metrics["material"].iloc[0]), folder / f"table_{number}"
    strokes = there_of(shown(metrics, number)["stroke"])
    printed = rows(metrics, number, titles, tabled(strokes, paper.STROKES))
    what = of_what(metrics, number, titles, [] if dataset is None else sorted(dataset["run"].unique()))
    apart = otherwise(dataset, tabled(strokes, paper.STROKES))
    mixed = together(dataset, tabled(strokes, paper.STROKES))
    strokes_told = shown_of(strokes, paper.STROKES, material), mixed, apart
    which = [words for words in strokes_told if words]
    write_text(stem.with_suffix(".csv"), to_csv(number, rows(metrics, number, titles)))
    notes = (plain(what), *which, *left_out.beneath("md", gone), *jumps.beneath("md", jumped), note(mark))
    write_text(stem.with_suffix(".md"), to_markdown(number, printed, warning(mark), notes))
    label = f"tab:{material}-{paper.MAPS[number]}"
    excepted = (*left_out.beneath("tex", gone), *jumps.beneath("tex", jumped))
    notes = (" ".join([what, *which]), *excepted, sentence(mark))
    write_text(stem.with_suffix(".tex"), to_latex(number, printed, label, warning(mark), notes))
    title = f"Table {'I' * number}: {paper.TITLES[number].lower()}, {material}"
    describe(stem.with_suffix(".csv"), title, columns(number, material), mark)


@program
def main() -> None:
    """Write `table_1` and `table_2` of one material in all three forms."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.tables", description=__doc__)
    parser.add_argument("metrics", type=Path)
    parser.add_argument("--titles", nargs="+", required=True, metavar="MODEL=TITLE")
    parser.add_argument("--out-dir", type=Path, required=True, help="the folder of the tables; required")
    add_mark(parser)
    left_out.arguments(parser)
    jumps.arguments(parser)
    add_dataset(parser)
    arguments = parser.parse_args()
    metrics, gone = schemas.read(arguments.metrics, schemas.METRICS), left_out.told(arguments)
    titles, mark = titles_of(arguments.titles), mark_from(arguments.made_by)
    dataset, jumped = dataset_from(arguments.dataset), read_jumps(arguments.jumps)
    for number in paper.TABLES:
        write(metrics, number, titles, mark, arguments.out_dir, gone, jumped, dataset)


if __name__ == "__main__":
    main()
