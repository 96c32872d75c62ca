"""What makes sure of the one explanation: more strokes where something is still missing, and each effect's own sign."""

from pathlib import Path
from typing import Any

from ..library import mechanisms
from . import certainty, commands, unseen
from .quantity import duration, number, quantity
from .vocabulary import Vocabulary

ALIKE = 1.2  # times the slowest stroke's speed: a fastest one below that is no other speed


def of_what_is_missing(
    content: dict[str, Any], words: Vocabulary, folders: list[Path], out: Path | None
) -> list[list[str]]:
    """What to do about what is still missing beside the one explanation; nothing where nothing is, or some tie."""
    if not unseen.partly(content, words) or content["verdict"] != "explained":
        return []
    if unseen.nothing_new(content, words):
        return [
            [
                "Leave what is still missing, unless it is too much for your use. No effect of the library is named "
                "for it. Other speeds and loads, diagnosed together, show more of it.",
            ]
        ]
    again = commands.lines(folders, out, [""])
    return [
        [
            "If what changes from stroke to stroke is too much for your use: record as many strokes again in the same "
            "way, and diagnose both runs together. If the error on unseen strokes falls to the noise, there were too "
            "few strokes. If not, this rig has physics that the library lacks.",
            *(f"  {line}" for line in again),
            commands.CAPTURE,
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
    head = "To make sure of a name, a recording should hold what tells the effect from others:"
    return [[head, *tests[:-1], f"{tests[-1].removesuffix(';')}.", *held(content, words)]]


def held(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What this recording holds of loads, speeds, holds and rests; nothing where an older file does not say it."""
    known = content["evidence"].get("covered")
    if known is None:
        return []
    (least, most), (slow, fast) = known["load"], known["speed_per_s"]
    loads = (
        f"loads of {number(least, 3)} to {quantity(most, words.load_unit, 3)}"
        if content["evidence"]["loaded"]
        else "one load"
    )
    speeds = f"speeds of {number(slow)} to {quantity(fast, f'{words.motion_unit}/s')}"
    if fast < ALIKE * slow:
        speeds = f"one speed, {quantity(fast, f'{words.motion_unit}/s')}"
    stands = (
        f"holds of up to {duration(known['longest_hold_s'])} and rests of up to {duration(known['longest_rest_s'])}"
    )
    more = " or more" if content["evidence"]["loaded"] else ""
    under = f" under {quantity(least, words.load_unit, 3)}{more}" if words.load is not None and least > 0.0 else ""
    return [f"This one has {loads}, {speeds}, and {stands}{under}."]
