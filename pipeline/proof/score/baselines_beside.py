"""The baselines beside the diagnosis: the same recordings, the same words for right and wrong."""

import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TypedDict

import pandas as pd

from ..verdict_json import VerdictJson
from .against_truth import outcome
from .case_table import Row
from .scores import CHANCE, COLUMNS, LARGE, Score, middle, share

OWN = "diagnosis"
TABLE = ("run", "stratum", "effects", "kappa", "method", "names", "named", "outcome", "heldout_ratio", "seconds")


class Answered(TypedDict):
    """A method's result on a case, as its baselines.json holds it; the error on unseen strokes is in mm."""

    named: list[str] | None
    heldout_mm: float | None
    seconds: float


def _spoken(named: list[str]) -> VerdictJson:
    """What a baseline names, as a verdict."""
    return {"verdict": "explained" if named else "consistent", "mechanisms": [{"id": name} for name in named]}


def _of_case(case: pd.Series, answers: dict[str, Answered]) -> Iterator[Row]:
    case_row = {key: case[key] for key in ("run", "stratum", "effects", "kappa")}
    own = {"method": OWN, "names": True, "named": case["named"], "outcome": case["outcome"]}
    yield case_row | own | {"heldout_ratio": case.get("heldout_ratio"), "seconds": case["seconds"]}
    truth = frozenset(name for name in str(case["effects"]).split("+") if name)
    for method, answer in answers.items():
        row = case_row | {"method": method, "names": answer["named"] is not None, "seconds": answer["seconds"]}
        if answer["named"] is not None:
            row |= {
                "named": "+".join(answer["named"]),
                "outcome": outcome(_spoken(answer["named"]), truth, nameless=False),
            }
        error_mm = answer["heldout_mm"]
        yield row | {"heldout_ratio": None if error_mm is None else error_mm / case["heldout_noise_mm"]}


def gather(cases: pd.DataFrame, place: Path, batches: Iterable[str]) -> pd.DataFrame:
    """One row a case and method, of those cases that the baselines were asked about; columns TABLE."""
    rows: list[Row] = []
    by_run = cases.set_index("run", drop=False)
    for path in sorted(path for batch in batches for path in (place / "baselines" / batch).glob("*/baselines.json")):
        answers = json.loads(path.read_text(encoding="utf-8"))
        rows += _of_case(by_run.loc[answers.pop("run")], answers)
    return pd.DataFrame(rows, columns=list(TABLE))


def scores(beside: pd.DataFrame) -> pd.DataFrame:
    """One row a score and method; columns as all scores, the stratum being `method: what of`."""
    rows: list[Score] = []
    for method, of_method in beside.groupby("method", sort=False):
        single = of_method[(of_method["stratum"] == "single") & (of_method["kappa"] >= LARGE)]
        controls = of_method[of_method["stratum"].isin(["none", "parameters", "noise"])]
        pairs = of_method[of_method["stratum"] == "pair"]
        if of_method["names"].all():
            rows += share("named exactly", f"{method}: single", single["outcome"] == "exact")
            rows += share("named wrongly", f"{method}: single", single["outcome"].isin(["wrong", "extra", "part"]))
            rows += share("named exactly", f"{method}: pair", pairs["outcome"] == "exact")
            rows += share("false alarm", f"{method}: controls", controls["outcome"] == "false alarm")
        steady = of_method[
            ~of_method["effects"].astype(str).str.split("+").map(lambda names: bool({*names} & {*CHANCE}))
        ]
        hidden = steady[steady["stratum"].isin(["single", "pair"])]
        rows += middle("held-out error over the oracle's", f"{method}: effects", hidden["heldout_ratio"])
        rows += middle("seconds a case", f"{method}: all", of_method["seconds"])
    return pd.DataFrame(rows, columns=list(COLUMNS))
