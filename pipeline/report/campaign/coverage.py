"""What a campaign's prediction intervals held: sentences and tables by level, map, strokes ahead and material."""

import pandas as pd

from ..layout.plain_markdown import line
from .results import MAPS, TOLERANCE, by_string, pooled

SHOWN_LEVEL = 0.9  # of the tables by material and by string


def intervals(coverage: pd.DataFrame, of: str) -> list[str]:
    """The section on intervals; `of` is the title of the model that has them."""
    strokes_ahead = sorted({int(ahead) for ahead in coverage["ahead"]})
    strings = coverage["string"].nunique()
    text = [
        f"{of}, fitted on each string alone but for its last {len(strokes_ahead)} strokes, is asked about those."
        f" Its intervals, pooled over {strings} strings, held as follows; ± is one standard error over them.",
        "", _kept(coverage), _singly(coverage), _flagged(coverage), "",
        *_levels(coverage, strokes_ahead), *_materials(coverage),
    ]  # fmt: skip
    return text


def _percent(share: float, error: float) -> str:
    return f"{100.0 * share:.1f}" + ("" if pd.isna(error) else f" ± {100.0 * error:.1f}")


def _kept(coverage: pd.DataFrame) -> str:
    """Whether the shares held are within the tolerance of their levels, and which is farthest."""
    table = pooled(coverage, ["map", "level"])
    off = table["held"] - table["level"]
    within = int((off.abs() <= TOLERANCE).sum())
    far = table.loc[off.abs().idxmax()]
    return (
        f"{within} of {len(table)} shares (two maps, {table['level'].nunique()} levels) are within"
        f" {100.0 * TOLERANCE:.0f} points of their level; the farthest is {far['map']} at {100.0 * far['level']:.0f} %,"
        f" which held {_percent(far['held'], far['error'])} %."
    )


def _singly(coverage: pd.DataFrame) -> str:
    """How the share varies from string to string."""
    held_shares = by_string(coverage, SHOWN_LEVEL)
    low, middle, high = 100.0 * held_shares.quantile([0.05, 0.5, 0.95])
    return (
        f"That is over all strings together: of a single string the {100.0 * SHOWN_LEVEL:.0f} % intervals held"
        f" {middle:.0f} % (median); one string in twenty held less than {low:.0f} %, one more than {high:.0f} %."
    )


def _flagged(coverage: pd.DataFrame) -> str:
    """The share of points that were flagged as outside the training range."""
    level = coverage["level"].iloc[0]
    table = pooled(coverage[coverage["level"] == level], ["map"])
    shares = ", ".join(f"{100.0 * row['outside']:.2f} % {row['map']}" for _, row in table.iterrows())
    return f"Outside the range that was learnt, so flagged and without an interval, not counted above: {shares}."


def _levels(coverage: pd.DataFrame, strokes_ahead: list[int]) -> list[str]:
    """Shares held and widths by map, level and strokes ahead."""
    heads = [f"{ahead} ahead: held (%)" for ahead in strokes_ahead] + [
        f"{ahead} ahead: width" for ahead in strokes_ahead
    ]
    lines = [line(["map", "level (%)", "held (%)", *heads]), line(["---"] * (3 + len(heads)))]
    whole = pooled(coverage, ["map", "level"])
    apart = pooled(coverage, ["map", "level", "ahead"]).set_index(["map", "level", "ahead"])
    for _, row in whole.iterrows():
        each = [apart.loc[(row["map"], row["level"], ahead)] for ahead in strokes_ahead]
        held_cells = [_percent(pooled_row["held"], pooled_row["error"]) for pooled_row in each]
        widths = [f"{pooled_row['width']:.3g} {MAPS[row['map']][1]}" for pooled_row in each]
        shown = _percent(row["held"], row["error"])
        lines.append(line([row["map"], f"{100.0 * row['level']:.0f}", shown, *held_cells, *widths]))
    return [*lines, ""]


def _materials(coverage: pd.DataFrame) -> list[str]:
    """Shares held at one level by material."""
    at_level = coverage[(coverage["level"] - SHOWN_LEVEL).abs() < 1e-9]
    table = pooled(at_level, ["material", "map"]).set_index(["material", "map"])
    head = [f"material, level {100.0 * SHOWN_LEVEL:.0f} %", "strings", *(f"{map_}: held (%)" for map_ in MAPS)]
    lines = [line(head), line(["---"] * len(head))]
    for material in sorted(set(at_level["material"])):
        each = [table.loc[(material, map_)] for map_ in MAPS]
        shares = [_percent(pooled_row["held"], pooled_row["error"]) for pooled_row in each]
        lines.append(line([material, f"{each[0]['strings']:.0f}", *shares]))
    return [*lines, ""]
