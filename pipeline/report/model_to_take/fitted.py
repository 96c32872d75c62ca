"""The files of a material's fitted models and how to use them, for a person who asks or exports one."""

from collections.abc import Collection, Iterable
from pathlib import Path

import pandas as pd

from ...ground.model_errors import chosen_of
from ...ground.model_names import FLOORS
from ..layout.plain_markdown import line
from .model_advice import advice_on
from .usual_model import errors_of, uses

FLOOR_TITLES = {"floor_blind": "*floor without direction*", "floor": "*floor with direction*"}
SPLITS = {"within": "within strokes", "later": "later strokes"}
QUESTIONS = "questions.csv has a row for each question: docs/use_a_model.md shows one"


def lines_on_files(
    metrics: pd.DataFrame, material: str, is_apart: bool = False, whole_motion: Collection[str] = ()
) -> list[str]:
    """Lines of Markdown: the commands, and the file of every fit that metrics are of.

    `is_apart` and `whole_motion` as in `errors_of`.
    """
    fits = metrics.loc[~metrics["model"].isin(FLOORS), ["model", "split", "seed"]].drop_duplicates()
    to_compare = set(fits["model"]) - set(whole_motion)
    chosen = chosen_of(to_compare, errors_of(metrics, is_apart, whole_motion))
    if not chosen:
        return []
    heads = ["folder", *(f"files of the split `{split}`" for split in SPLITS)]
    lines = [line(heads), line(["---"] * len(heads))]
    for model, mine in fits.groupby("model", sort=True):
        seeds = {split: sorted(set(mine.loc[mine["split"] == split, "seed"])) for split in SPLITS}
        cells = [", ".join(f"`{split}-{seed}.model`" for seed in seeds[split]) for split in SPLITS]
        lines.append(line([f"`processed/{material}/{model}/`", *cells]))
    export, ask = uses(material, chosen)
    with_motion = sorted(set(fits["model"]) & set(whole_motion))
    text = [
        "## Where the fitted models lie",
        "",
        "`within-0` was fitted to three of four blocks of every stroke, `later-0` without the last quarter of the",
        "strokes; a larger number is another seed. To use a model take `within-0`.",
        *(f"`{model}` needs the whole motion: it is neither exported nor asked." for model in with_motion),
        "",
        f"- On a controller (or `--format onnx`): `{export}`",
        f"- Questions in a table: `{ask}` fits the model anew, and its answers have intervals.",
        "- The answers of an export: `--saved` with the file in place of `--model`; they have no intervals.",
        "",
    ]
    return [*text, *lines, ""]


def lines_at_end(
    material: str,
    made_paths: Iterable[Path],
    models_csv: Path,
    short: bool = False,
    whole_motion: Collection[str] = (),
) -> list[str]:
    """Lines for the end of the main job on the fitted models among its files, ordered by error.

    `short`: which to take and how to export it, where a page has the rest. Those of `whole_motion` are not named: they
    answer along a whole motion alone.
    """
    files = [path for path in made_paths if path.suffix == ".model" and path.parent.parent.name == material]
    files = [path for path in files if path.parent.name not in whole_motion]
    saved = [path.parent.name for path in files if path.name == "within-0.model"]
    advice = advice_on(saved, models_csv)
    if not advice.model:
        return []
    others = ", ".join(sorted({path.parent.name for path in files} - {advice.model}))
    more = [f"fitted too: {others}"] if others else []
    to = [f"to {where}: {uses(material, model)[0]}" for where, model in advice.controllers.items()]
    if short:
        return [*([advice.reason] if advice.reason else []), *to]
    ask = f"to ask it: {uses(material, advice.model)[1]}"
    return [*filter(None, (advice.reason, advice.at_inverse)), *to, ask, QUESTIONS, *more]


def times_floor(ratio: float) -> str:
    """How many times its floor an error is, with three significant digits at most."""
    if ratio >= 10.0:
        return f"{float(f'{ratio:.3g}'):g}"
    return f"{ratio:.2f}"
