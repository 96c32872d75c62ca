"""What of a verdict can go into a paper, with its numbers, and what cannot."""

from ..content import Verdict
from . import certainty, chances, effects, holdout, left_out, probability, rivals, slow_look_alikes, unseen
from .dimensions import far_moved
from .quantity import listing, percent, size, times
from .vocabulary import Vocabulary

LEAST = 0.01  # a probability that a report names
NAMED = 3  # other explanations that a report names
FITTED = "Do not report calibrated dimensions, nor other numbers under `simulation`: they are fitted, not measured."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A line of what can be reported, and one of what cannot; nothing where nothing is named."""
    if not content["mismatch"]:
        return []
    left = size(content["mismatch"][f"rms_{words.ending}"], words.unit)
    missing = f"{left} rms is missing after calibration, noise taken off"
    nominal = content["evidence"].get(f"nominal_{words.ending}")
    if far_moved(content) and nominal is not None:
        missing = f"with the dimensions of run.yaml the simulator errs by {size(nominal, words.unit)} rms; {missing}"
    statements = [missing, *_unseen(content, words), *_sure(content, words), *_own(content, words), *_best(content)]
    when = ", if measuring again changed nothing" if far_moved(content) else ""
    return [
        f"You can report{when}:",
        *(f"- {statement};" for statement in statements[:-1]),
        f"- {statements[-1]}.",
        *_not_yet(content, words),
    ]


def _unseen(content: Verdict, words: Vocabulary) -> list[str]:
    """The error on strokes that no fit has seen, without the explanation and with it."""
    errors = unseen.errors(content, words)
    if errors is None or holdout.status(content) != holdout.UNSEEN or unseen.harmful(content, words):
        return []
    _, calibrated, explained = (size(error, words.unit) for error in errors)
    ratio = times(errors[2] / content["fit"][f"noise_floor_{words.ending}"])
    return [
        f"on the {holdout.strokes(content)} the best explanation errs by {explained} ({ratio} times the noise of "
        f"single samples), calibration alone by {calibrated}"
    ]


def _sure(content: Verdict, words: Vocabulary) -> list[str]:
    """Which effects are at work, where that is sure."""
    sure = [id_ for id_, share in certainty.known(content).items() if share >= certainty.SURE]
    shares = certainty.known(content)
    named = listing([f"{id_} (probability {percent(shares[id_])})" for id_ in sure])
    return [f"at work, by the library's names: {named}{slow_look_alikes.remark(content, words, sure)}"] if sure else []


def own_sizes(content: Verdict, words: Vocabulary) -> list[str]:
    """The effects whose own size can be reported; none where dimensions moved far."""
    not_alone = {*certainty.poorly_known(content, words), *certainty.partly_hidden(content, words)}
    named = [entry["id"] for entry in content["mechanisms"]]
    return [] if far_moved(content) else [id_ for id_ in named if id_ not in not_alone]


def _own(content: Verdict, words: Vocabulary) -> list[str]:
    """That sizes and constants can be reported, where one explanation stands on dimensions that did not move far."""
    known = own_sizes(content, words)
    if not known:
        return []
    constants = any(effects.has_constants(entry) for entry in content["mechanisms"] if entry["id"] in known)
    also = " and its constants" if constants and len(known) == 1 else " and their constants" if constants else ""
    best = rivals.called([entry["id"] for entry in content["mechanisms"]])
    provided = f", if {best} is right" if content["alternatives"] else ""
    return [f"the size of {listing(known)}{also} as the table above says, with 90 % intervals{provided}"]


def _best(content: Verdict) -> list[str]:
    """How likely the best explanation is, what is not excluded, and physics that the library lacks."""
    none = content["evidence"].get("probability_of_none")
    kept = chances.kept_shares(content)
    if not kept or none is None or not probability.known(content):
        return []
    (name, share), *others = kept
    following = chances.next_best(content)
    out = [(rivals.called(entry["ids"]), entry["probability"]) for entry in left_out.entries(content)[:NAMED]]
    rest = [*others[:NAMED], *out, *([following] if following and not others else [])]
    left = max(1.0 - none - share - sum(its for _, its in rest), 0.0)
    also = [f"{other} ({percent(its)})" for other, its in rest]
    also += [f"others of the library ({percent(left)} together)"] if left >= LEAST else []
    also += [f"physics that the library lacks ({percent(none)})"]
    best = "of what it can tell from moved dimensions the" if left_out.likelier(content, share) else "the"
    return [f"{best} recording agrees best with {name} ({percent(share)}); not excluded are {listing(also)}"]


def _not_yet(content: Verdict, words: Vocabulary) -> list[str]:
    """What is no result: sizes that are poorly known, and dimensions that calibration moved far."""
    if far_moved(content):
        return [
            "Do not report how much an effect does alone, its constants (times, corners), or calibrated dimensions: "
            "dimensions that moved so far can have taken a part of it."
        ]
    poorly = list(dict.fromkeys([*certainty.poorly_known(content, words), *certainty.partly_hidden(content, words)]))
    if not poorly:
        return [FITTED] if content["mechanisms"] else []
    return [f"Do not report how much {listing(poorly)} {'do' if len(poorly) > 1 else 'does'} alone. {FITTED}"]
