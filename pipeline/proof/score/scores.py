"""From the table of cases to the scores, each with its exact 95 % interval."""

from collections.abc import Iterator

import pandas as pd

from ...rig import effects
from . import share_intervals
from .against_truth import RIGHT

LARGE = 0.5  # noise floors from which on an effect must be named
CHANCE = tuple(name for name in effects.names() if effects.concealed(name).by_chance)
FIRM_WRONG = ("wrong", "extra", "part", "false alarm")
COLUMNS = ("metric", "stratum", "count", "of", "value", "low", "high")
Score = tuple[str, str, float, int, float, float, float]


def share(metric: str, stratum: str, hits: pd.Series) -> Iterator[Score]:
    """Share of true values; nothing when there are none at all."""
    hits = hits.dropna().astype(bool)
    if len(hits):
        count = int(hits.sum())
        yield metric, stratum, count, len(hits), count / len(hits), *share_intervals.share(count, len(hits))


def middle(metric: str, stratum: str, values: pd.Series, best: str = "least") -> Iterator[Score]:
    """Median of values, and the worst value as a separate score."""
    values = values.dropna().astype(float)
    if len(values):
        yield (
            metric,
            stratum,
            len(values),
            len(values),
            float(values.median()),
            *share_intervals.median(values.tolist()),
        )
        worst = float(values.max() if best == "least" else values.min())
        yield f"{metric}, worst", stratum, len(values), len(values), worst, worst, worst


def mean(metric: str, stratum: str, values: pd.Series) -> Iterator[Score]:
    """Mean of values with its bootstrap interval."""
    values = values.dropna().astype(float)
    if len(values):
        bounds = share_intervals.mean(values.tolist())
        yield metric, stratum, len(values), len(values), float(values.mean()), *bounds


def _named(cases: pd.DataFrame, stratum: str) -> Iterator[Score]:
    """The outcomes of cases whose truth has a name."""
    firm_wrong = cases["outcome"].isin(FIRM_WRONG)
    both = cases["outcome"].isin(["exact", "extra"])
    tied = cases["verdict"] == "ambiguous"
    yield from share("named exactly", stratum, cases["outcome"] == "exact")
    yield from share("named or tied with the truth", stratum, cases["right"])
    yield from share("named wrongly", stratum, firm_wrong)
    yield from share("all of the truth named", stratum, both)
    yield from share("ambiguous", stratum, tied)
    yield from share("ambiguous though the data part it", stratum, tied & (cases["separable"] == True))  # noqa: E712
    yield from share("found nothing", stratum, cases["outcome"] == "missed")
    yield from share("called unknown", stratum, cases["outcome"] == "unknown")
    yield from share("refused", stratum, cases["outcome"] == "refused")


def _controls(cases: pd.DataFrame) -> Iterator[Score]:
    controls = cases[cases["stratum"].isin(["none", "parameters", "noise"])]
    for stratum, group in [*controls.groupby("stratum"), ("controls", controls)]:
        yield from share("false alarm", str(stratum), group["outcome"] == "false alarm")
        yield from share("refused", str(stratum), group["outcome"] == "refused")


def _figures(cases: pd.DataFrame, sizes: pd.DataFrame) -> Iterator[Score]:
    """Intervals, places and held-out errors."""
    for short in ("radius", "separator", "zone"):
        if f"{short}_inside" in cases:
            for stratum, group in [*cases.groupby("stratum"), ("all", cases)]:
                yield from share(f"90 % interval holds the {short}", str(stratum), group[f"{short}_inside"])
    for stratum, group in [*sizes.groupby("stratum"), ("all", sizes)]:
        yield from share("90 % interval holds the effect's size", str(stratum), group["inside"])
    effects = cases[cases["stratum"].isin(["single", "pair", "open"])]
    if "location_iou" in cases:
        for protocol, group in effects.groupby("protocol"):
            yield from middle("location overlap", f"{protocol}", group["location_iou"], best="most")
            yield from share("location overlap at least 0.8", f"{protocol}", group["location_iou"].dropna() >= 0.8)
    if "heldout_ratio" in cases:
        chance = cases["effects"].str.split("+").map(lambda names: bool({*names} & {*CHANCE}))
        for stratum, group in cases[~chance].groupby("stratum"):
            yield from middle("held-out error over the oracle's", str(stratum), group["heldout_ratio"])
            yield from middle("calibrated held-out error over the oracle's", str(stratum), group["calibrated_ratio"])
    yield from middle("CPU seconds a case", "all", cases["seconds"])


def _ties(cases: pd.DataFrame) -> Iterator[Score]:
    """Ties whose proposed run was made: how many it settled, and how many more of the same motion would settle."""
    for way in ("proposed", "same"):
        if f"after_{way}" in cases:
            done = cases[cases[f"after_{way}"].notna()]
            after = done[f"after_{way}"]
            yield from share(f"tie settled rightly by {way}", "ties", after.isin(set(RIGHT) - {"tie with the truth"}))
            yield from share(f"tie settled wrongly by {way}", "ties", after.isin(FIRM_WRONG))
            yield from share(f"truth named or in the set after {way}", "ties", after.isin(RIGHT))
            yield from mean(f"mean size of the set after {way}", "ties", done[f"sets_after_{way}"])


def scores(cases: pd.DataFrame, sizes: pd.DataFrame) -> pd.DataFrame:
    """One row a score; columns COLUMNS. `count` of `of` cases where it is a share."""
    made_cases = cases[cases["skipped"] == ""]
    rows: list[Score] = list(share("case could not be made", "all", cases["skipped"] != ""))
    rows += _controls(made_cases)
    for protocol, single in made_cases[made_cases["stratum"] == "single"].groupby("protocol"):
        large = single[single["kappa"] >= LARGE]
        for kappa, group in single.groupby("kappa"):
            rows += _named(group, f"single, {protocol}, kappa {kappa:g}")
        rows += _named(large, f"single, {protocol}, kappa at least {LARGE:g}")
        ties = single[single["right"] & (single["sets"] > 0)]
        rows += mean("mean size of the set", f"single, {protocol}", ties["sets"])
    pairs = made_cases[made_cases["stratum"] == "pair"]
    rows += _named(pairs, "pair") if len(pairs) else []
    for stratum in ("open", "without"):
        group = made_cases[made_cases["stratum"] == stratum]
        rows += share("called unknown", stratum, group["outcome"] == "unknown as it should")
        named = group["outcome"].isin(["wrong", "tie without the truth"])
        rows += share("named all the same", stratum, named)
        if stratum == "without":
            parted = named & (group["separable"] == True)  # noqa: E712
            rows += share("named all the same though the data part it", stratum, parted)
        rows += share("found nothing", stratum, group["outcome"] == "missed")
    rows += _ties(made_cases)
    rows += _figures(made_cases, sizes)
    return pd.DataFrame(rows, columns=list(COLUMNS))
