"""What of a verdict can go into a paper, with its numbers, and what cannot."""

from ..content import Verdict
from . import certainty, chances, effects, holdout, left_out, own_size, probability, rivals, slow_look_alikes, unseen
from .dimensions import far_moved
from .quantity import listing, percent, size
from .vocabulary import Vocabulary

TO_REPORT = "TO REPORT"  # as bold as a plain page can be: the size to quote stands once
LEAST = 0.01  # a probability that a report names
NAMED = 3  # other explanations that a report names
FITTED = "Do not report calibrated dimensions, nor other numbers under `simulation`: they are fitted, not measured."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A line of what can be reported, and one of what cannot; nothing where nothing is named."""
    if not content["mismatch"]:
        return []
    left = size(content["mismatch"][f"rms_{words.ending}"], words.unit)
    missing = f"{left} rms is missing after calibration, noise taken off"
    missing += _unseen(content, words)
    statements = [missing, *_sure(content, words), *_own(content, words), *_best(content, words)]
    when = ", if measuring again changed nothing" if far_moved(content) else ""
    return [
        f"You can report{when}:",
        *(f"- {statement};" for statement in statements[:-1]),
        f"- {statements[-1]}.",
        *_not_yet(content, words),
    ]


def _unseen(content: Verdict, words: Vocabulary) -> str:
    """That the errors on strokes that no fit has seen can be reported, where they can; ends a statement."""
    errors = unseen.errors(content, words)
    if errors is None or holdout.status(content) != holdout.UNSEEN or unseen.harmful(content, words):
        return ""
    return f"; the errors on the {holdout.strokes(content)} above"


def _sure(content: Verdict, words: Vocabulary) -> list[str]:
    """Which effects are at work, where that is sure."""
    sure = [id_ for id_, share in certainty.known(content).items() if share >= certainty.SURE]
    shares = certainty.known(content)
    word = {id_: "probable" if certainty.held_back(content, words, id_) else "sure" for id_ in sure}
    named = listing([f"{id_} ({word[id_]}, {percent(shares[id_])})" for id_ in sure])
    return [f"at work: {named}{slow_look_alikes.remark(content, words, sure)}"] if sure else []


def own_sizes(content: Verdict, words: Vocabulary) -> list[str]:
    """The effects whose own size can be reported; none where dimensions moved far."""
    known = [entry["id"] for entry in content["mechanisms"] if own_size.reportable(entry, content, words)]
    return [] if far_moved(content) else known


def _own(content: Verdict, words: Vocabulary) -> list[str]:
    """The sizes to quote and whose constants, where dimensions did not move far."""
    entries = [entry for entry in content["mechanisms"] if entry["id"] in own_sizes(content, words)]
    if not entries:
        return []
    sizes, constants = [], []
    for entry in entries:
        if own_size.own_part(entry, content, words):
            sizes.append(f"{entry['id']} {own_size.own_with_interval(entry, content, words)}, {own_size.PART}")
            continue
        sizes.append(f"{entry['id']} {own_size.with_interval(entry, words)}")
        constants += [entry["id"]] if effects.has_constants(entry) else []
    also = f", and the constants of {listing(constants)} above" if constants else ""
    best = rivals.called([entry["id"] for entry in content["mechanisms"]])
    provided = f", if {best} is right" if content["alternatives"] else ""
    return [f"{TO_REPORT}: {'; '.join(sizes)} (rms, 90 % interval){also}{provided}"]


def _best(content: Verdict, words: Vocabulary) -> list[str]:
    """How likely the best explanation is, what is not excluded, and physics that the library lacks."""
    none = content["evidence"].get("probability_of_none")
    kept = chances.kept_shares(content)
    if not kept or none is None or not probability.known(content):
        return []
    name, share = kept[0]
    best = "of what it can tell from moved dimensions the" if left_out.likelier(content, share) else "the"
    rest = "beyond these no other is excluded" if slow_look_alikes.excluded(content, words) else "no other is excluded"
    return [f"{best} recording agrees best with {name} ({percent(share)}); {rest}"]


def _not_yet(content: Verdict, words: Vocabulary) -> list[str]:
    """What is no result: sizes that are poorly known, and dimensions that calibration moved far."""
    if far_moved(content):
        return [
            "Do not report how much an effect does alone, its constants (times, corners), or calibrated dimensions."
        ]
    doubtful = [entry for entry in content["mechanisms"] if own_size.doubt_of(entry, content, words)]
    no_size = [entry["id"] for entry in doubtful if not own_size.reportable(entry, content, words)]
    in_all = [entry["id"] for entry in doubtful if own_size.reportable(entry, content, words)]
    sentences = [f"Do not report how much {listing(no_size)} {_does(no_size)} alone."] if no_size else []
    sentences += [f"Do not report what {listing(in_all)} {_does(in_all)} in all."] if in_all else []
    return [" ".join([*sentences, FITTED])] if content["mechanisms"] else []


def _does(ids: list[str]) -> str:
    return "do" if len(ids) > 1 else "does"
