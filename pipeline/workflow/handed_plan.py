"""The plan that a start hands to the nodes of its jobs, so that no node needs all of `raw/` for one job.

The plan travels in a variable of the environment, which every executor passes on, with or without a shared file system.
"""

import base64
import json
import lzma
from collections.abc import Mapping
from dataclasses import asdict

from ..ground.words.left_out import LeftOut
from .dag import Plan

PLAN = "TWISTBENCH_PLAN"
REFUSALS = "NOTE_REFUSALS"
LONGEST = 120_000  # bytes; Linux takes 131,072 in one variable


def packed(plan: Plan, files: Mapping[str, list[str]]) -> str:
    """The plan and each run's recorded files as text; empty if too long: then each node makes its own plan."""
    short = {run: tuple(path.removeprefix(f"raw/{run}/") for path in files[run]) for run in plan.runs}
    kinds = list(dict.fromkeys(short.values()))  # few: most runs have files of the same names
    which = [kinds.index(short[run]) for run in plan.runs]
    content = json.dumps([asdict(plan), kinds, which], separators=(",", ":"))
    text = base64.b64encode(lzma.compress(content.encode("utf-8"))).decode("ascii")
    return text if len(text) <= LONGEST else ""


def unpacked(text: str) -> tuple[Plan, dict[str, list[str]]]:
    """The plan, and each run's recorded files, as they were packed."""
    fields, kinds, which = json.loads(lzma.decompress(base64.b64decode(text)))
    plan = Plan(**fields)
    for kind in ("unfinished", "misnamed", "refused"):
        setattr(plan, kind, [LeftOut(**entry) for entry in getattr(plan, kind)])
    return plan, {
        run: [f"raw/{run}/{name}" for name in kinds[kind]] for run, kind in zip(plan.runs, which, strict=True)
    }
