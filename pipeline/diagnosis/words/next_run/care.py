"""What to mind before the rig is driven otherwise than it was: speeds and loads that were not recorded, in words."""

import itertools

from ....ground.command import command
from ...document.content import NextRun, Verdict, proposal
from ..language.vocabulary import Vocabulary
from . import worth

NEW = 0.1  # of a speed: one that leaves what was recorded by less is none
CARE = {
    "twice the speed": "Only if the motor can go so fast.",
    "twice the load": "Only if the rig bears so much.",
    "another load": "Only if the rig bears so much.",
}  # by what a title says


def asks_speed(content: Verdict, words: Vocabulary) -> bool:
    """Whether the run moves at a speed that was not recorded; by its title where an older file does not say."""
    run, known = proposal(content), content["evidence"].get("covered")
    if known is None or "speed" not in run["title"]:
        return "speed" in run["title"]
    slow, fast = known["speed_per_s"]
    places = [leg[words.driver] for leg in run["legs"]]
    ways = zip(itertools.pairwise(places), run["legs"][1:], strict=True)
    speeds = [abs(to - at) / leg["seconds"] for (at, to), leg in ways if to != at]
    return not all((1.0 - NEW) * slow <= speed <= (1.0 + NEW) * fast for speed in speeds)


def asks_load(content: Verdict, words: Vocabulary) -> bool:
    """Whether the run hangs more than was recorded; True where an older file does not say."""
    run, known = proposal(content), content["evidence"].get("covered")
    loads = [leg.get(words.load) for leg in run["legs"]] if words.load else []
    hung = [float(load) for load in loads if load is not None]
    return known is None or not hung or max(hung) > (1.0 + NEW) * known["load"][1]


def under_this_load(run: NextRun, words: Vocabulary) -> str:
    """The command that looks for a run without another load; nothing where no run of such a rig is looked for."""
    load = run.get("load")
    if words.driver != "motor_turns" or not run.get("fixed_load") or not load:
        return ""
    hangs = f"{load:.4g}"
    look = f"{command('settle')} RUN --limits '{{load_n: [{hangs}, {hangs}]}}'"
    return f" `{look}` looks for one under this load; it says where none does."


def care(content: Verdict, words: Vocabulary) -> str:
    """What to mind before the rig is driven otherwise than it was, and what to do if it cannot be."""
    run = proposal(content)
    new = {"speed": asks_speed(content, words), "load": asks_load(content, words)}
    changes = {change: text for change, text in CARE.items() if all(new[what] or what not in change for what in new)}
    caution = next((text for change, text in changes.items() if change in run["title"]), "")
    if "load" in run["title"] and words.load:
        cannot = "If your rig cannot change its load, "
    elif caution:
        cannot = "If your rig cannot go so fast, "
    else:
        return ""
    if "parts" in run:
        lost = "the likelier explanations stay tied" if worth.decides(run) else "less is learnt"
        cannot += f"leave this run out: {lost}."
        if "load" in run["title"] and words.load:
            cannot += under_this_load(run, words)
    else:
        cannot += (
            "make the run at the other speed alone: it shows less." if "speed" in run["title"] else "leave it out."
        )
    return " ".join(part for part in (caution, cannot) if part)
