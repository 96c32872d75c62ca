"""The table of cases: the hidden effects, the verdict, and how far it is right; one row a case."""

import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pandas as pd

from ..sealed import Answer
from ..verdict_json import VerdictJson
from .against_truth import RIGHT, outcome, said, sets_of
from .overlap import overlap

TIE = 0.2  # noise floors: what copies the truth to less than this cannot be told from it
DIMENSIONS = {"radius_mm": "radius", "separator_mm": "separator", "torsion_zone_mm": "zone"}
OWN = "rig"  # the author of what the project's own rig makes
Row = dict[str, str | float | None]


def _json(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def _truth(answer: Answer) -> tuple[frozenset[str], bool]:
    """The right names, and whether the library has none of them."""
    nameless = answer["asked"]["stratum"] == "open" or bool(answer["asked"]["without"])
    return frozenset(effect["id"] for effect in answer["effects"]), nameless


def _told(answer: Answer) -> Row:
    """The hidden effects, in words."""
    question = answer["asked"]
    row: Row = {
        "run": answer["run"],
        "seed": question["seed"],
        "stratum": "without" if question["without"] else question["stratum"],
    }
    row |= {"author": question.get("author") or OWN}
    row |= {"protocol": question["protocol"], "kappa": question["kappas"][0] if question["kappas"] else None}
    row |= {"effects": "+".join(question["effects"]), "skipped": answer.get("skipped", "")}
    if "skipped" in answer:
        return row
    row["effects"] = "+".join(effect["id"] for effect in answer["effects"])
    row["laws"] = "+".join(effect.get("law", OWN) for effect in answer["effects"])
    row |= {"raw_mm": answer["together"]["raw_mm"], "hidden_share": answer["together"]["hidden_share"]}
    return row | {"noise_floor_mm": answer["noise_floor_mm"], "heldout_noise_mm": answer["heldout_noise_mm"]}


def _judged(answer: Answer, verdict: VerdictJson | None, left_over: Mapping[str, float]) -> Row:
    """The verdict, and one word for it."""
    truth, nameless = _truth(answer)
    word = outcome(verdict, truth, nameless)
    row: Row = {"outcome": word, "right": word in RIGHT, "verdict": "refused" if verdict is None else said(verdict)}
    if verdict is None:
        return row
    row["code"] = verdict.get("code", "")  # the fingerprint of the code that gave it
    sets = sets_of(verdict)
    row |= {"named": "+".join(sorted(sets[0])) if sets else "", "sets": len(sets)}
    row["alternatives"] = " | ".join("+".join(sorted(ids)) for ids in sets[1:])
    # of a tie: whether the data part the truth from everything else that stands in it
    beside = [left_over[name] for ids in sets if ids != truth for name in ids if name in left_over]
    row["least_left_over"] = min(beside) if beside else None
    row["separable"] = bool(min(beside) >= TIE) if beside else None
    return row


def _measured(answer: Answer, verdict: VerdictJson, run: Path) -> Row:
    """The numbers of a verdict beside the true ones."""
    row: Row = {}
    for key, short in DIMENSIONS.items():
        interval = verdict.get("parameters", {}).get(key)
        if interval and key in answer["dimensions"]:
            row[f"{short}_inside"] = interval["low"] <= answer["dimensions"][key]["true"] <= interval["high"]
    heldout: dict[str, float] = verdict["fit"].get("heldout") or {}
    for key in ("nominal_mm", "calibrated_mm", "explained_mm"):
        row[f"heldout_{key}"] = heldout.get(key)
    if heldout.get("explained_mm"):
        row["heldout_ratio"] = heldout["explained_mm"] / answer["heldout_noise_mm"]
        row["calibrated_ratio"] = heldout.get("calibrated_mm", float("nan")) / answer["heldout_noise_mm"]
    box = (verdict.get("mismatch") or {}).get("location")
    if box and answer["location"]:
        row["location_iou"] = overlap(run, box, answer["location"])
    return row


def _settled(answer: Answer, folder: Path) -> Row:
    """What became of a tie after the proposed run, and after as much more of the same motion."""
    row: Row = {}
    for way in ("proposed", "same"):
        if (folder / way).is_dir():
            again = _json(folder / way / "diagnosis.json")
            row[f"after_{way}"] = outcome(again, *_truth(answer))
            row[f"sets_after_{way}"] = len(sets_of(again)) if again else None
    return row


def _batch(place: Path, batch: str) -> Iterator[tuple[Row, list[Row]]]:
    left_over = _json(place / "lookalikes" / f"{batch}.json") or {}
    question = _json(place / "verdicts" / batch / "asked.json")
    for answer in _json(place / "sealed" / f"{batch}.json"):
        row, sizes = _told(answer), []
        run = answer["run"]
        if not row["skipped"]:
            verdict = _json(place / "verdicts" / batch / run / "diagnosis.json")
            row |= {"seconds": question["seconds"][run]}
            row |= _judged(answer, verdict, left_over.get(run, {}))
            if verdict is not None:
                row |= _measured(answer, verdict, place / "concealed" / batch / run)
                row |= _settled(answer, place / "settled" / batch / run)
            if verdict is not None and row["outcome"] == "exact":
                sizes = list(_sizes(answer, verdict))
        yield row, sizes


def _sizes(answer: Answer, verdict: VerdictJson) -> Iterator[Row]:
    """True and named size of every effect of a verdict that names exactly the truth."""
    named = {mechanism["id"]: mechanism["rms_mm"] for mechanism in verdict["mechanisms"]}
    for effect in answer["effects"]:
        interval = named[effect["id"]]
        row: Row = {"run": answer["run"], "effect": effect["id"], "stratum": answer["asked"]["stratum"]}
        row |= {"protocol": answer["protocol"], "kappa": effect["kappa"], "true_mm": effect["raw_mm"]}
        row |= {"value_mm": interval["value"], "low_mm": interval["low"], "high_mm": interval["high"]}
        yield row | {"inside": interval["low"] <= effect["raw_mm"] <= interval["high"]}


def gather(place: Path, batches: Iterable[str]) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Tables of all cases and of all sizes; the answers are opened here."""
    rows = [pair for batch in batches for pair in _batch(place, batch)]
    cases = pd.DataFrame([row for row, _ in rows]).sort_values("run", ignore_index=True)
    columns = ("run", "effect", "stratum", "protocol", "kappa", "true_mm", "value_mm", "low_mm", "high_mm", "inside")
    return cases, pd.DataFrame([size for _, sizes in rows for size in sizes], columns=list(columns))
