"""The effects that run.yaml has adopted, and whether they saw the held-out strokes; no word calls seen ones unseen."""

from ...document.content import Verdict
from ..language.quantity import listing

SPLIT = "last 30 % of strokes"
NO_EFFECT = "no effect"
UNSEEN, SEEN, PARTLY, PERHAPS = "unseen", "seen", "partly", "perhaps"


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
    """Whether the adopted effects were fitted to the held-out strokes: `unseen`, `seen`, `partly`, or `perhaps`.

    They are where they were fitted to the run that has these strokes; `partly`: to some of several such runs.
    """
    ids = included(content)
    if not ids:
        return UNSEEN
    if held_out_runs(content, seen=True):
        return PARTLY if held_out_runs(content, seen=False) else SEEN
    of_known_runs = [adoption for adoption in content.get("adopted", []) if adoption.get("runs")]
    fitted_ids = {id_ for adoption in of_known_runs for id_ in adoption["effects"]}
    return UNSEEN if set(ids) <= fitted_ids else PERHAPS


def runs(content: Verdict) -> list[str]:
    """The runs that a verdict is on."""
    return [content["run"]] if isinstance(content["run"], str) else list(content["run"])


def fitted_runs(content: Verdict) -> list[str]:
    """The runs of a verdict that the adopted effects were fitted to."""
    fitted = {run for adoption in content.get("adopted", []) for run in adoption.get("runs") or []}
    return [run for run in runs(content) if run in fitted] if included(content) else []


def held_out_runs(content: Verdict, seen: bool) -> list[str]:
    """The runs of the held-out strokes that the adopted effects were fitted to, or not; unless `seen`, the others.

    A file that does not tell which runs have these strokes counts as having them in the fitted runs.
    """
    fit, fitted = content.get("fit"), fitted_runs(content)
    heldout = fit["heldout"] if fit else None
    of_strokes = (heldout.get("runs") if heldout else None) or fitted or runs(content)
    return [run for run in of_strokes if (run in fitted) == seen]


def fitted_to(content: Verdict, very: str = "") -> str:
    """The recordings of this verdict that the adopted effects were fitted to, as a sentence names them."""
    fitted = fitted_runs(content)
    if fitted != runs(content):
        return listing(fitted)
    return f"these {very}recordings" if fitted[1:] else f"this {very}recording"


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
        PARTLY: f"Error on the {last} (partly seen)",
        PERHAPS: f"Error on the {last} (perhaps seen before)",
    }[status(content)]


def split_seen(content: Verdict) -> str:
    """Which strokes were held out, and which fits have seen them."""
    return (
        split(content)
        + {
            UNSEEN: " (seen by no fit)",
            SEEN: " (seen before)",
            PARTLY: " (partly seen)",
            PERHAPS: " (perhaps seen before)",
        }[status(content)]
    )
