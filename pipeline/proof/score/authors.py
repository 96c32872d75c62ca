"""Scores by the author of the recordings, and by the hidden law: a diagnosis must not depend on one author."""

from collections.abc import Iterator

import pandas as pd

from . import share_intervals
from .scores import CHANCE, FIRM_WRONG, LARGE

ALL = "all"
AUTHOR_COLUMNS = ("author", "quantity", "count", "of", "value", "low", "high")
LAW_COLUMNS = ("effect", "author", "law", "exact", "of", "said")
Score = tuple[str, str, int, int, float, float, float]


def _share(author: str, quantity: str, hits: pd.Series) -> Iterator[Score]:
    if len(hits):
        count = int(hits.sum())
        yield author, quantity, count, len(hits), count / len(hits), *share_intervals.share(count, len(hits))


def _of_author(author: str, cases: pd.DataFrame) -> Iterator[Score]:
    """Scores of one author's cases, or of all: columns AUTHOR_COLUMNS."""
    stratum, firm = cases["stratum"], cases["outcome"].isin(FIRM_WRONG)
    single = cases[(stratum == "single") & (cases["kappa"] >= LARGE) & (cases["protocol"] != "poor")]
    poor = cases[(stratum == "single") & (cases["kappa"] >= LARGE) & (cases["protocol"] == "poor")]
    pair, outside = cases[stratum == "pair"], cases[stratum == "open"]
    control = cases[stratum.isin(["none", "parameters", "noise"])]
    yield from _share(author, "one effect: exactly", single["outcome"] == "exact")
    yield from _share(author, "one effect: exactly, or in the set", single["right"])
    yield from _share(author, "one effect: firm wrong name", firm[single.index])
    yield from _share(author, "one effect, poor protocol: exactly, or in the set", poor["right"])
    yield from _share(author, "two effects: exactly both", pair["outcome"] == "exact")
    yield from _share(author, "two effects: exactly both, or in the set", pair["right"])
    yield from _share(author, "controls with a name, or unknown", control["outcome"] == "false alarm")
    yield from _share(author, "outside the library: unknown", outside["outcome"] == "unknown as it should")
    yield from _share(author, "outside the library: firm name", firm[outside.index])
    steady = cases[~cases["effects"].str.split("+").map(lambda names: bool({*names} & {*CHANCE}))]
    ratios = steady["heldout_ratio"].dropna().astype(float).tolist() if "heldout_ratio" in steady else []
    if ratios:
        middle = float(pd.Series(ratios).median())
        yield author, "held out over noise, median", len(ratios), len(ratios), middle, *share_intervals.median(ratios)


def by_author(cases: pd.DataFrame) -> pd.DataFrame:
    """One row a score and author, `all` first; columns AUTHOR_COLUMNS, with exact 95 % intervals."""
    made_cases = cases[(cases["skipped"] == "") & (cases["stratum"] != "without")]
    rows = list(_of_author(ALL, made_cases))
    for author, of_author in made_cases.groupby("author"):
        rows += _of_author(str(author), of_author)
    return pd.DataFrame(rows, columns=list(AUTHOR_COLUMNS))


def by_law(cases: pd.DataFrame) -> pd.DataFrame:
    """One row an effect, author and law, of single effects that must be named; columns LAW_COLUMNS."""
    made_cases = cases[(cases["skipped"] == "") & (cases["stratum"] == "single") & (cases["protocol"] != "poor")]
    made_cases = made_cases[made_cases["kappa"] >= LARGE]
    rows = []
    for (effect, author, law), of_law in made_cases.groupby(["effects", "author", "laws"]):
        exact = of_law["outcome"] == "exact"
        other = of_law[~exact].fillna({"named": "", "alternatives": ""})
        verdicts = [f"{case['verdict']} {case['named']}".strip() for _, case in other.iterrows()]
        rows.append((effect, author, law, int(exact.sum()), len(of_law), "; ".join(sorted(verdicts))))
    return pd.DataFrame(rows, columns=list(LAW_COLUMNS))
