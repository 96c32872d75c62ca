"""The first section of the proof's page: how well recordings by each author are named, and by each law."""

import pandas as pd

GOALS = {
    "one effect: exactly": "≥ 90 %",
    "one effect: exactly, or in the set": "≥ 98 %",
    "one effect: firm wrong name": "≤ 2 %",
    "one effect, poor protocol: exactly, or in the set": "≥ 98 %",
    "two effects: exactly both": "≥ 75 %",
    "two effects: exactly both, or in the set": "≥ 90 %",
    "controls with a name, or unknown": "≤ 1 %",
    "outside the library: unknown": "≥ 80 %",
    "outside the library: firm name": "≤ 5 %",
    "held out over noise, median": "≤ 1.05",
}
WORDS = """\
An author is a generator of recordings that was written apart from the diagnosis and from the other authors: other laws
for the same effects, another rig, another motion, other noise. `rig` is the project's own. Effects are of at least half
a noise floor; protocols are rich or usual unless a row says poor."""


def _said(score: pd.Series) -> str:
    if "median" in score["quantity"]:
        return f"{score['value']:.3g} ({score['low']:.3g} to {score['high']:.3g}; {score['of']})"
    low, high = 100 * score["low"], 100 * score["high"]
    return f"{score['count']} of {score['of']} = {100 * score['value']:.0f} % ({low:.0f} to {high:.0f})"


def _table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def section(authors: pd.DataFrame, laws: pd.DataFrame) -> str:
    """Markdown of the tables that `pipeline.proof.score.authors` makes."""
    names = list(dict.fromkeys(authors["author"]))
    cells = {(score["quantity"], score["author"]): _said(score) for _, score in authors.iterrows()}
    rows = [
        [quantity, goal, *(cells.get((quantity, name), "") for name in names)]
        for quantity, goal in GOALS.items()
        if any((quantity, name) in cells for name in names)
    ]
    by_law = [
        [str(row["effect"]), str(row["author"]), str(row["law"]), f"{row['exact']} of {row['of']}", str(row["said"])]
        for _, row in laws.iterrows()
    ]
    return "\n\n".join(
        [
            "## By author: cases, share, exact 95 % interval",
            WORDS,
            _table(["quantity", "goal", *names], rows),
            "### By law: one effect, named exactly",
            _table(["effect", "author", "law", "exactly", "what else was said"], by_law),
        ]
    )
