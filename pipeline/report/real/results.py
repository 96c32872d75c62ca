"""The results of a public rig's recordings, read from files: verdicts, held-out errors, black boxes, transfer."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pandas as pd

from ...ground.units import unit_of
from ...real.black_boxes import looks
from ...real.rigs import Expected, Rig, expected_of
from ...real.runs_to_make import ALL_OTHERS
from ..layout.verdict_content import Content
from ..layout.verdict_file import NAME, read_verdict
from .verdict_doubts import doubt

SIMULATORS = {"nominal": "nominal", "calibrated": "calibrated", "explained": "explained"}
BLACK_BOXES = {name: look["title"] for name, look in looks().items()}
TITLES = {**SIMULATORS, **BLACK_BOXES}
CARRIED = [name for name in TITLES if name != "calibrated"]
ELSEWHERE, OTHERS = "elsewhere_", "others_"  # before a method's name: learnt on another recording, on all others


@dataclass(frozen=True)
class Result:
    """One verdict, on one recording or on several together; `content` is None where there is none."""

    name: str
    folder: Path
    content: Content | None
    words: str
    group: str = ""
    black_boxes: dict[str, float] = field(default_factory=dict)
    elsewhere: dict[str, float] = field(default_factory=dict)
    others: dict[str, float] = field(default_factory=dict)
    unit: str = ""
    together: bool = False

    @property
    def named(self) -> str:
        """Ids of the best explanation."""
        return " + ".join(entry["id"] for entry in self.content["mechanisms"]) if self.content else ""

    @property
    def spoken(self) -> str:
        """The unit as it is written."""
        return unit_of(f"_{self.unit}") if self.unit else ""

    @property
    def heldout(self) -> dict[str, float]:
        """Error of every method on the strokes that no fit has seen."""
        heldout_errors: dict[str, float] = (self.content or Content(fit={}))["fit"].get("heldout") or {}
        own = {
            name: heldout_errors[f"{name}_{self.unit}"]
            for name in SIMULATORS
            if f"{name}_{self.unit}" in heldout_errors
        }
        return {**own, **self.black_boxes}

    @property
    def mismatch(self) -> float | None:
        """How much simulator and recording differ, rms in the reading's unit; None where they do not."""
        mismatch: Mapping[str, Any] = (self.content or {}).get("mismatch") or {}
        return mismatch.get(f"rms_{self.unit}")

    @property
    def noise_floor(self) -> float | None:
        """The noise of the reading, rms in its unit; None where there is no verdict."""
        fit: Mapping[str, Any] = (self.content or {}).get("fit") or {}
        return fit.get(f"noise_floor_{self.unit}")

    def row(self, rig: Rig) -> dict[str, str | float | None]:
        """This verdict in the table over all rigs."""
        undecided: Content = {"verdict": "not decided", "alternatives": [], "mismatch": None, "fit": {}}
        content = self.content or undecided
        expected = expected_of(rig, self.name)
        kind, why = doubt(self.content, self.words, expected, rig.answers) or ("", "")
        return {
            "recording": self.name,
            "together": "yes" if self.together else "no",
            "verdict": content["verdict"],
            "named": self.named,
            "ties": len(content["alternatives"]),
            "expected": expected_words(expected),
            "unit": self.spoken,
            "mismatch": self.mismatch,
            "noise_floor": self.noise_floor,
            **{name: self.heldout.get(name) for name in TITLES},
            **{f"{ELSEWHERE}{name}": self.elsewhere.get(name) for name in CARRIED},
            **{f"{OTHERS}{name}": self.others.get(name) for name in CARRIED},
            "doubt": kind,
            "why": why,
        }


def expected_words(expected: Expected | None) -> str:
    """The literature's answer in ids."""
    if expected is None or expected.names is None:
        return ""
    return " + ".join(" or ".join(either) for either in expected.names)


def _unit(content: Content | None) -> str:
    keys = (content or Content(fit={}))["fit"]
    return next((key.removeprefix("noise_floor_") for key in keys if key.startswith("noise_floor_")), "")


def read_result(folder: Path, together: bool = False) -> Result:
    """The verdict in a folder."""
    path = folder / NAME
    mend = f"remove {folder} and run snakemake real: it is made again"
    content = read_verdict(path, mend) if path.is_file() else None
    words = (folder / "verdict.txt").read_text(encoding="utf-8").strip()
    name = f"{folder.name} together" if together else folder.name
    return Result(name, folder, content, words, folder.name if together else "", unit=_unit(content), together=together)


def apart(transfer: pd.DataFrame) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Results learnt on one recording, and results learnt on all the others."""
    whole = transfer["learnt_from"] == ALL_OTHERS
    return transfer[~whole], transfer[whole]


def read_results(
    verdicts: list[Path], together: list[Path], black_boxes: list[Path], transfer: pd.DataFrame
) -> list[Result]:
    """The verdicts on single recordings, each with the other methods' errors, then those on several together."""
    others = {path.stem: json.loads(path.read_text(encoding="utf-8"))["heldout"] or {} for path in black_boxes}
    results = []
    pairs, left_out = apart(transfer)
    for folder in verdicts:
        result = read_result(folder)
        about = pairs[pairs["asked_about"] == result.name]
        elsewhere = about.groupby("method")["rms"].median().to_dict()
        from_all = left_out[left_out["asked_about"] == result.name].set_index("method")["rms"].to_dict()
        unit = result.unit or next(iter(about["unit"]), "")
        group = next(iter(about["group"]), "")
        extra = {"black_boxes": others.get(result.name, {}), "elsewhere": elsewhere, "others": from_all}
        extra |= {"unit": unit, "group": group}
        results.append(Result(**{**result.__dict__, **extra}))
    return results + [read_result(folder, together=True) for folder in together]
