"""What to do next, in one piece of advice; it follows from the verdict and decides nothing."""

import shlex
from pathlib import Path
from typing import Any

from ...ground.command import command
from ..library import mechanisms
from . import certainty, report, sight, still, unseen, worth
from .adoption import predictions
from .dimensions import far_moved, name_of
from .headline import moved_in_vain
from .quantity import listing
from .vocabulary import Vocabulary

HEADING = "What to do next"


def lines(content: dict[str, Any], words: Vocabulary, folders: list[Path]) -> list[str]:
    """One piece of advice, on the runs in `folders`."""
    verdict, run = content["verdict"], content["next_run"]
    if verdict == "ambiguous":
        tests = [*_tests(content), *certainty.asks(content, words)]
        return [*_first(content), _ambiguous(content, words), *tests, *report.lines(content, words)]
    if verdict == "unknown":
        shows = "Make the run below: it shows more of what is missing. " if run else ""
        return [f"{shows}Adopt nothing: no effect of the library is named."]
    if verdict == "explained":
        if unseen.harmful(content, words):
            return [
                f"Adopt nothing: on the {sight.strokes(content)} the explanation makes the simulator worse. Record "
                "the rig once more, with more strokes, and diagnose both runs together."
            ]
        use = "Use the explanation: the commands are below."
        return [*_first(content), use, *certainty.asks(content, words), *report.lines(content, words)]
    tied = [one for one in content.get("adopted", []) if one["tied"]]
    if tied and not still.worth_making(tied):
        count = 1 + max(len(one["tied"]) for one in tied)
        said = f"Report what was adopted as one of {count} explanations: no run that was tried decides between them."
        return [said, *_anew(content, folders)]
    if tied:
        return ["Decide between what was adopted and what was likely as well, if you need to know: the run is below."]
    if unseen.left_over(content, words):
        return ["Record the rig in other ways, as said below, and diagnose the runs together."]
    if sight.included(content) and far_moved(content):
        return _anew(content, folders)
    return [_again(content, words) or "Nothing needs to be done: this recording shows nothing further."]


def _ambiguous(content: dict[str, Any], words: Vocabulary) -> str:
    """The run to make where it can decide, else what to do without it."""
    run, without = content["next_run"], worth.otherwise(content, words)
    if not run or "parts" not in run:
        return f"{without[0].upper()}{without[1:]}."
    if worth.decides(run):
        return f"Make the run below: it can decide {worth.question(content)}. If you do not make it, {without}."
    use = "" if unseen.harmful(content, words) else ", and predict with the first command under To use it"
    if _far(content):
        return f"{worth.undecided(run)}. If measuring changed nothing, {without}{use}."
    return f"{worth.undecided(run)}: {without}{use}."


def _tests(content: dict[str, Any]) -> list[str]:
    """What at the rig tells the effects that are open, where no run does: each one's own sign."""
    run = content["next_run"]
    if run and (worth.decides(run) if "parts" in run else True):
        return []
    sets = [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]
    open_ = [
        id_ for id_ in dict.fromkeys(id_ for ids in sets for id_ in sorted(ids)) if not all(id_ in one for one in sets)
    ]
    tests = ". ".join(f"{id_}: {mechanisms()[id_].told_apart_by}" for id_ in open_)
    tried = "other loads and speeds were tried in simulation, and need not here"
    return [f"In general these tell the open effects ({tried}): {tests}."] if tests else []


def _first(content: dict[str, Any]) -> list[str]:
    """What to measure before all else, and what it means where nothing changes."""
    names = _far(content)
    if not names:
        return []
    return [
        f"First measure {names} again; how exactly, and how run.yaml says it, stands under Dimensions. If a value "
        "changes, or its tolerance does, write that into run.yaml and diagnose again: it can turn this verdict over. "
        "If neither does, keep run.yaml as it is: then physics that the library lacks may have moved them, which no "
        "percentage here covers. The explanation still foretells this rig under such loads, speeds and ranges, but its "
        "dimensions are not the rig's.",
    ]


def _anew(content: dict[str, Any], folders: list[Path]) -> list[str]:
    """What to measure again after adopting, and what follows for the adopted effects."""
    names = _far(content)
    if not names:
        return []
    adopted = [one["diagnosis"] for one in content.get("adopted", []) if one.get("diagnosis")][-1:]
    return [
        f"Measure {names} again. If a value changes, write it into run.yaml, take the adopted effects out, "
        "diagnose again and adopt anew: they were fitted together with the dimensions. If none changes, take them out "
        f"too, and predict with {'the diagnosis that was adopted' if adopted else 'the adopted diagnosis.json'}:",
        *(f"  {command('adopt')} --remove {shlex.quote(str(folder))}" for folder in folders),
        *(f"  {line}" for source in adopted for line in predictions(Path(source), folders)),
    ]


def _again(content: dict[str, Any], words: Vocabulary) -> str:
    """Which dimensions to measure again, if any."""
    if content["verdict"] == "parameters" and moved_in_vain(content, words):
        return ""
    names = _far(content)
    return f"Measure {names} again, and write what you measured into run.yaml." if names else ""


def _far(content: dict[str, Any]) -> str:
    """The dimensions to measure again, by name; nothing where none moved far."""
    return listing([f"the {name_of(name)}" for name in far_moved(content)])
