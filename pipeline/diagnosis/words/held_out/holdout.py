"""The effects that run.yaml has adopted, and whether they saw the held-out strokes; no word calls seen ones unseen."""

from ...document.content import Verdict

SPLIT = "last 30 % of strokes"
NO_EFFECT = "no effect"
UNSEEN, SEEN, PERHAPS = "unseen", "seen", "perhaps"


def included(content: Verdict) -> list[str]:
    """Ids that the simulator had from run.yaml beforehand, including those that the verdict names again."""
    new = {entry["id"] for entry in [*content["mechanisms"], *content.get("beside", [])]}
    new -= {id_ for adoption in content.get("adopted", []) for id_ in adoption["effects"]}
    return [id_ for id_ in dict.fromkeys(entry["id"] for entry in content.get("simulation", [])) if id_ not in new]


def against_advice(content: Verdict) -> list[str]:
    """Those of `included` that were adopted against the advice of their verdict."""
    ids = {id_ for each in content.get("adopted", []) if each.get("against_advice") for id_ in each["effects"]}
    return [id_ for id_ in included(content) if id_ in ids]


def status(content: Verdict) -> str:
    """Whether the adopted effects were fitted to a run of this diagnosis: `unseen`, `seen`, or `perhaps`."""
    ids = included(content)
    if not ids:
        return UNSEEN
    own = {content["run"]} if isinstance(content["run"], str) else set(content["run"])
    of_known_runs = [adoption for adoption in content.get("adopted", []) if adoption.get("runs")]
    if any(own & set(adoption["runs"]) for adoption in of_known_runs):
        return SEEN
    fitted_ids = {id_ for adoption in of_known_runs for id_ in adoption["effects"]}
    return UNSEEN if set(ids) <= fitted_ids else PERHAPS


def other_name(content: Verdict) -> str:
    """The effects named without the last strokes, if they differ from those named with them; else nothing."""
    chosen = content["evidence"].get("chosen_without_them")
    if chosen is None or set(chosen) == {entry["id"] for entry in content["mechanisms"]}:
        return ""
    return " + ".join(sorted(set(chosen))) or NO_EFFECT


def of_other(content: Verdict) -> str:
    """As `other_name`: the error on the last strokes is theirs. Empty where no effect was named without them."""
    other = other_name(content)
    return other if other not in ("", NO_EFFECT) else ""


def closest(content: Verdict) -> str:
    """The closest effects without the last strokes, to which the error there belongs; else nothing."""
    return " + ".join(sorted(set(content["evidence"].get("closest_without_them", []))))


def closest_is_named(content: Verdict) -> bool:
    """Whether what comes closest without the last strokes is the named effects: the error there is theirs."""
    of_named = {entry["id"] for entry in content["mechanisms"]}
    return bool(of_named) and other_name(content) == NO_EFFECT and closest(content) == " + ".join(sorted(of_named))


def others(content: Verdict) -> tuple[str, str]:
    """The effects that the error on the last strokes is of, where they are not the named ones.

    Returns those named without these strokes, and those that come closest where none are; each can be empty.
    """
    return ("", "") if closest_is_named(content) else (other_name(content), closest(content))


def named(content: Verdict) -> str:
    """The best explanation, as its effects are listed everywhere."""
    best = [shown["ids"] for shown in content["evidence"]["explanations"] if shown["standing"] == "named"]
    return " + ".join([*best, [entry["id"] for entry in content["mechanisms"]]][0])


def split(content: Verdict) -> str:
    """The held-out strokes, as the head of a table names them."""
    heldout = content["fit"]["heldout"]
    return str(heldout["split"]) if heldout else SPLIT


def settled_otherwise(content: Verdict) -> str:
    """That other effects were named without the last strokes, as the end of a phrase; nothing where none were.

    It does not name them: a reader would take the first names that he reads for those of the verdict.
    """
    return f"without the {split(content)} other effects are named" if of_other(content) else ""


def not_lasting(content: Verdict, id_: str) -> str:
    """As `settled_otherwise`, but only if an effect is not among those named without the last strokes."""
    return "" if id_ in of_other(content).split(" + ") else settled_otherwise(content)


def whose(content: Verdict) -> str:
    """The effects to which the error on the last strokes belongs, if not the named ones; goes after its size."""
    other = other_name(content)
    if other == NO_EFFECT and closest(content):
        return f" (of {closest(content)}, which comes closest without these strokes: no effect is named there)"
    return f" (of {other}, which the procedure names without these strokes)" if other else ""


def whose_if_known(content: Verdict) -> str:
    """As `whose`; empty where a file does not tell the effects named without those strokes."""
    evidence = content.get("evidence")
    chosen = evidence.get("chosen_without_them") if isinstance(evidence, dict) else None
    return whose(content) if isinstance(chosen, list) and all(isinstance(id_, str) for id_ in chosen) else ""


def simulator(content: Verdict) -> str:
    """The simulator to which the error on the last strokes belongs; goes after `the simulator`."""
    if other_name(content) == NO_EFFECT:
        which = f"with {closest(content)}, which comes closest" if closest(content) else "without an effect"
        return f"{which} (the procedure names none without these strokes)"
    other = of_other(content)
    return f"with {other} (which the procedure names without these strokes)" if other else "as diagnosed"


def strokes(content: Verdict) -> str:
    """The name of the held-out strokes: they are called unseen only if no fit has seen them."""
    return "unseen strokes" if status(content) == UNSEEN else "last strokes"


def heading(content: Verdict) -> str:
    """The name of the error on the held-out strokes."""
    last = split(content)
    return {
        UNSEEN: "Error on unseen strokes",
        SEEN: f"Error on the {last} (seen before)",
        PERHAPS: f"Error on the {last} (perhaps seen before)",
    }[status(content)]
