"""Whether the traditional model's errors are those of the paper's Tables I and II, a line for each error."""

import pandas as pd

from ..ground.model_names import NOMINAL
from .layout import paper

WORST = 0.10  # relative difference from the paper's number up to which an error agrees
GOLDEN = (
    "Whether every row of these tables is the published one is said by `python tests/golden/check_metrics.py reports`; "
    "the published rows are in `tests/golden/published`."
)
NAMES = {"average": "average error", "maximum": "maximum error", "rmse": "RMSE"}


def differences(whole: pd.DataFrame) -> dict[tuple[int, str], list[float]]:
    """Relative differences of the model's errors from the paper's by table and metric, one for each common stroke.

    `whole` holds the metrics over the whole range of twist.
    """
    chosen = whole[(whole["model"] == NOMINAL) & (whole["split"] == "within") & (whole["phase"] == "winding")]
    medians = chosen.groupby(["map", "metric", "stroke"])["value"].median()
    off_by_cell: dict[tuple[int, str], list[float]] = {}
    for number, direction in paper.MAPS.items():
        for stroke, printed in paper.TABLES[number][NOMINAL].items():
            for metric, theirs in zip(paper.METRICS, printed, strict=True):
                place = (direction, metric, str(stroke))
                if place in medians:
                    off_by_cell.setdefault((number, metric), []).append(float(medians[place]) / theirs - 1.0)
    return off_by_cell


def agreement(whole: pd.DataFrame) -> list[str]:
    """Lines of Markdown that say of each error whether it agrees and within what; none where nothing compares."""
    worst_off = {quantity: max(map(abs, off)) for quantity, off in differences(whole).items()}
    if not worst_off:
        return []
    good = sum(worst <= WORST for worst in worst_off.values())
    strokes = ", ".join(str(stroke) for stroke in paper.STROKES)
    lines = [
        "## Does the traditional model agree with the paper?",
        "",
        f"{'Yes' if good == len(worst_off) else 'No'}: {good} of {len(worst_off)} errors agree. "
        f"An error agrees where it is at most {100 * WORST:.0f} % off the paper's "
        f"at each of the strokes n={strokes} that are there.",
        "",
    ]
    for (number, metric), worst in worst_off.items():
        name = f"Table {'I' * number}, {paper.MAPS[number]}, {NAMES[metric]} ({paper.UNITS[number]})"
        sentence = (
            f"agrees, within {100 * worst:.1f} %" if worst <= WORST else f"does not agree: {100 * worst:.1f} % off"
        )
        lines.append(f"- {name}: {sentence}")
    return [*lines, "", GOLDEN, ""]
