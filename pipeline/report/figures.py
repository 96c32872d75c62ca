"""Dataset, metrics and predictions → Figures 4 and 5 of the paper, as png and pdf."""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

from ..ground.errors import program
from ..ground.model_errors import chosen_of
from ..ground.model_names import NOMINAL, PAPER
from ..ground.stored import schemas
from .drawn.drawing import STYLE, save
from .drawn.figure_4 import figure_4
from .drawn.figure_5 import figure_5
from .drawn.winding import with_median, with_nominal
from .layout.titles import titles_of
from .model_to_take.usual_model import errors_of
from .shown.stroke_conditions import later_apart
from .web.marks import add_mark, mark_from


def best_other(metrics: pd.DataFrame, titles: dict[str, str]) -> str | None:
    """The model, neither the INN nor the traditional one, of the least forward RMSE on all points held out within."""
    whole = (metrics[["stroke", "phase", "angle_band"]] == "all").all(axis=1)
    is_forward_rmse = (metrics["metric"] == "rmse") & (metrics["map"] == "forward") & (metrics["split"] == "within")
    middle = metrics[whole & is_forward_rmse].groupby("model")["value"].median()
    others = [model for model in titles if model not in (PAPER, NOMINAL) and model in middle.index]
    return min(others, key=lambda model: middle[model], default=None)


@program
def main() -> None:
    """Draw both figures of one material."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.figures", description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("metrics", type=Path)
    meaning = "<model>/within-<seed>.predictions.parquet, of every model"
    parser.add_argument("--predictions", type=Path, nargs="+", required=True, help=meaning)
    parser.add_argument("--titles", nargs="+", required=True, metavar="MODEL=TITLE")
    parser.add_argument(
        "--whole-motion", nargs="*", default=[], metavar="MODEL", help="models that need a whole motion"
    )
    parser.add_argument("--out-dir", type=Path, required=True, help="the folder of the figures; required")
    add_mark(parser)
    arguments = parser.parse_args()
    titles, mark = titles_of(arguments.titles), mark_from(arguments.made_by)
    dataset = schemas.read(arguments.dataset, schemas.DATASET)
    metrics = schemas.read(arguments.metrics, schemas.METRICS)
    material, recorded = arguments.dataset.parent.name, with_nominal(dataset)
    by_model: dict[str, list[Path]] = {}
    for path in arguments.predictions:
        by_model.setdefault(path.parent.name, []).append(path)
    errors_mm = errors_of(metrics, bool(later_apart(dataset)), arguments.whole_motion)
    to_compare = set(by_model) - set(arguments.whole_motion)
    best, taken = best_other(metrics, titles), chosen_of(to_compare, errors_mm)
    shown = [model for model in dict.fromkeys((PAPER, best, taken)) if model in by_model and model != NOMINAL]
    learned = {titles[model]: with_median(dataset, by_model[model]) for model in shown}
    with plt.rc_context(STYLE):
        save(figure_4(recorded, material), arguments.out_dir / "figure_4", mark)
        save(
            figure_5(
                recorded,
                learned,
                material,
                titles[best] if best in shown else "",
                titles[taken] if taken in shown and taken not in (PAPER, best) else "",
            ),
            arguments.out_dir / "figure_5",
            mark,
        )


if __name__ == "__main__":
    main()
