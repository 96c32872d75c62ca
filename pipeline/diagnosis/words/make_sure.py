"""What makes sure of the one explanation: more strokes where something is still missing, and each effect's own sign."""

from pathlib import Path
from typing import Any

from ..library import mechanisms
from . import certainty, commands, unseen
from .vocabulary import Vocabulary


def of_what_is_missing(
    content: dict[str, Any], words: Vocabulary, folders: list[Path], out: Path | None
) -> list[list[str]]:
    """What to do about what is still missing beside the one explanation; nothing where nothing is, or some tie."""
    if not unseen.partly(content, words) or content["verdict"] != "explained":
        return []
    if unseen.nothing_new(content, words):
        return [
            [
                "Leave what is still missing, unless it is too much for your use: details.txt says where it lies. No "
                "effect of the library is named for it. Other speeds and loads, diagnosed together, show more of it."
            ]
        ]
    again = commands.lines(folders, out, [""])
    return [
        [
            "If what changes from stroke to stroke is too much for your use: record as many strokes again in the same "
            "way, and diagnose both runs together. If the error on unseen strokes falls to the noise, there were too "
            "few strokes. If not, this rig has physics that the library lacks.",
            *(f"  {line}" for line in again),
        ]
    ]


def of_names(content: dict[str, Any], words: Vocabulary) -> list[list[str]]:
    """What at the rig shows that the effects of the one explanation are what they are called."""
    if content["verdict"] != "explained":
        return []
    slow = certainty.slow_alike(content, words)
    ids = [entry["id"] for entry in content["mechanisms"] if entry["id"] not in slow]
    tests = [f"- {id_}: {mechanisms()[id_].told_apart_by};" for id_ in ids] if words.twisted else []
    if not tests:
        return []
    loads = "several loads" if content["evidence"]["loaded"] else "one load"
    has = f" (it has {loads})" if words.load is not None else ""
    head = f"To make sure of a name, see that the recording holds what tells the effect from others{has}:"
    return [[head, *tests[:-1], f"{tests[-1].removesuffix(';')}."]]
