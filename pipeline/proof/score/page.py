"""The proof as a page for readers: the goals and the results, then all scores, then every wrong case."""

from collections.abc import Sequence

import pandas as pd

from .against_truth import RIGHT

LARGE_RICH, POOR = "single, rich, kappa at least 0.5", "single, poor, kappa at least 0.5"
GOALS = (
    ("one effect of at least half a noise floor, named exactly", "≥ 95 %", "named exactly", LARGE_RICH),
    ("… named wrongly", "≤ 2 %", "named wrongly", LARGE_RICH),
    ("… ambiguous although the data part it", "≤ 5 %", "ambiguous though the data part it", LARGE_RICH),
    ("two effects, exactly both", "≥ 85 %", "named exactly", "pair"),
    ("two effects, both named", "", "all of the truth named", "pair"),
    ("false alarms over controls", "≤ 1 %", "false alarm", "controls"),
    ("outside of the library: `unknown`", "≥ 95 %", "called unknown", "open"),
    ("the library without the mechanism: `unknown`", "", "called unknown", "without"),
    ("poor protocol: truth named or in the set", "≥ 98 %", "named or tied with the truth", POOR),
    ("poor protocol: explanations in the set, mean", "≤ 3", "mean size of the set", "single, poor"),
    ("ties settled rightly by the proposed run", "", "tie settled rightly by proposed", "ties"),
    ("… by as much more of the same", "", "tie settled rightly by same", "ties"),
    ("mismatch box: overlap, median", "≥ 0.8", "location overlap", "rich"),
    ("held-out error over the oracle's, median, single", "≤ 1.1", "held-out error over the oracle's", "single"),
    ("… the worst", "≤ 2", "held-out error over the oracle's, worst", "single"),
    ("… after calibration alone, median", "", "calibrated held-out error over the oracle's", "single"),
    ("90 % intervals of r that hold the truth", "87–95 %", "90 % interval holds the radius", "all"),
    ("90 % intervals of b", "87–95 %", "90 % interval holds the separator", "all"),
    ("90 % intervals of d", "87–95 %", "90 % interval holds the zone", "all"),
    ("90 % intervals of an effect's size", "87–95 %", "90 % interval holds the effect's size", "all"),
    ("CPU seconds a case, median of the batches", "≤ 20", "CPU seconds a case", "all"),
)
TOO_ALIKE = 0.03  # of an effect
PLAIN = ("median", "worst", "overlap", "error over", "seconds", "size of the set")


def _is_share(metric: str) -> bool:
    return metric.endswith("at least 0.8") or not any(word in metric for word in PLAIN) or "effect's size" in metric


def _said(score: pd.Series) -> tuple[str, str, str]:
    """Value, interval and counts of a score, as text."""
    if _is_share(score["metric"]):
        value, low, high = (f"{100 * score[key]:.1f}" for key in ("value", "low", "high"))
        return f"{value} %", f"{low}–{high} %", f"{score['count']} of {score['of']}"
    value, low, high = (f"{score[key]:.3g}" for key in ("value", "low", "high"))
    return value, "" if score["metric"].endswith("worst") else f"{low}–{high}", f"{score['of']}"


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    lines = [head, tuple("---" for _ in head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _goals(scores: pd.DataFrame) -> str:
    by_metric = scores.set_index(["metric", "stratum"])
    rows = []
    for words, goal, metric, stratum in GOALS:
        if (metric, stratum) in by_metric.index:
            score = scores[(scores["metric"] == metric) & (scores["stratum"] == stratum)].iloc[0]
            rows.append((words, goal, *_said(score)))
    return _table(("quantity", "goal", "reached", "95 % interval", "cases"), rows)


def _mechanisms(cases: pd.DataFrame) -> str:
    """How often each effect is named exactly on the rich protocol, by its size."""
    single = cases[(cases["stratum"] == "single") & (cases["protocol"] == "rich")]
    sizes = sorted(single["kappa"].unique())
    rows = []
    for effect, of_effect in single.groupby("effects"):
        cells = []
        for kappa in sizes:
            at = of_effect[of_effect["kappa"] == kappa]["outcome"]
            cells.append(f"{(at == 'exact').sum()}/{len(at)}" if len(at) else "")
        rows.append((str(effect), *cells))
    return _table(("effect", *(f"kappa {kappa:g}" for kappa in sizes)), rows)


def _beside(scores: pd.DataFrame) -> str:
    """Every method on the same recordings: its scores side by side."""
    parts = scores["stratum"].str.split(": ", n=1, expand=True)
    by_part = scores.assign(method=parts[0], of_what=parts.get(1)).dropna(subset="of_what")
    methods = list(dict.fromkeys(by_part["method"]))
    rows = []
    for (metric, what), same in by_part.groupby(["metric", "of_what"], sort=False):
        by_method = {score["method"]: _said(score) for _, score in same.iterrows()}
        cells = [
            " ".join(part for part in by_method[method][::2] if part) if method in by_method else ""
            for method in methods
        ]
        rows.append((f"{metric}, {what}", *cells))
    return _table(("score", *methods), rows) if rows else "None was asked."


def _twins(twins: pd.DataFrame) -> str:
    """The share of each of the rig's effects that the library's mechanism of the same name leaves."""
    shares = twins.groupby("effect")["share"].agg(["median", "min", "count"]).sort_values("min")
    rows = []
    for name, row in shares.iterrows():
        close = "below 3 %: too alike" if row["min"] < TOO_ALIKE else ""
        rows.append((str(name), f"{100 * row['median']:.2g} %", f"{100 * row['min']:.2g} %", close))
    return _table(("effect", "left, median", "least", ""), rows)


def _wrong(cases: pd.DataFrame) -> str:
    rows = []
    wrong = cases[~cases["outcome"].isin(RIGHT)].fillna({"named": "", "alternatives": ""})
    for _, case in wrong.iterrows():
        kappa = "" if pd.isna(case["kappa"]) else f"{case['kappa']:g}"
        answer = f"{case['named']} ({case['alternatives']})" if case["alternatives"] else case["named"]
        cells = (case["run"], case["stratum"], case["protocol"], case["effects"], kappa, case["verdict"], answer)
        rows.append(tuple(str(cell) for cell in (*cells, case["outcome"])))
    return _table(("case", "stratum", "protocol", "hidden", "kappa", "verdict", "named (or)", "that is"), rows)


def page(cases: pd.DataFrame, scores: pd.DataFrame, twins: pd.DataFrame, hands: str = "") -> str:
    """The page as Markdown; `hands` is its first section, the scores by author."""
    shown, skipped = cases[cases["skipped"] == ""], cases[cases["skipped"] != ""]
    own = scores[~scores["stratum"].str.contains(": ")]
    everything = [(score["metric"], score["stratum"], *_said(score)) for _, score in own.iterrows()]
    codes = ", ".join(f"`{code}`" for code in sorted(set(shown["code"].dropna()))) if "code" in shown else ""
    reasons = [f"- {case['run']}: {case['skipped']}" for _, case in skipped.iterrows()]
    return "\n\n".join([
        "# The concealed proof",
        *([hands] if hands else []),
        "## The project's own rig",
        f"{len(shown)} concealed recordings of the synthetic rig, diagnosed before any answer was opened. Sizes are in"
        " noise floors after calibration (kappa). Intervals are exact (Clopper and Pearson; order statistics for"
        " medians). `docs/proof.md` says how it is sealed and what each score means.",
        f"Seeds {cases['seed'].min()} to {cases['seed'].max()}; the verdicts' code: {codes}.",
        "## Goals and what was reached", _goals(scores),
        "![what was named instead of what](confusion.png)",
        "![answers over the effect's size](dose_response.png)",
        "![named sizes over true ones](sizes.png)",
        "## Named exactly, by effect and size (rich protocol)", _mechanisms(shown),
        "## Beside other methods, on the same recordings", _beside(scores),
        "## What the library's twins leave of the rig's effects, free of noise", _twins(twins),
        "## All scores", _table(("score", "of", "value", "95 % interval", "cases"), everything),
        "## Every case that is not right", _wrong(shown),
        f"## Cases that could not be made: {len(skipped)} of {len(cases)}", "\n".join(reasons) or "None.",
    ]) + "\n"  # fmt: skip
