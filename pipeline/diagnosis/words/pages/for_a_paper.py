"""The parts of a verdict that can go into a paper, with their numbers, and the parts that cannot."""

from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...document.made_keys import amount
from ..explanations import chances, not_named, probability, rivals
from ..held_out import holdout, in_vain, unseen
from ..held_out.without_name import UNNAMED
from ..language.places import lying
from ..language.quantity import listing, percent, reaches, size
from ..language.vocabulary import Vocabulary
from ..measured.dimensions import far_moved
from ..named import certainty, effect_sentence, own_size, slow_look_alikes
from . import of_adopted

HEADING = "To report it"
TO_REPORT = "TO REPORT"  # as bold as a plain page can be: the size to quote stands once
ONLY_WITH = f'{TO_REPORT} only with the words "{{}}"'  # where nothing that no fit has seen bears the numbers out
LEAST = 0.01  # a probability that a report names
NAMED = 3  # other explanations that a report names
RULE = (
    "Such a size has an interval narrower than a factor of 2; where moved dimensions can hide a part of an effect, it "
    "is the part that none can make (docs/diagnosis.md)."
)
NO_EFFECT = "Do not report an effect: none is named, however close one comes."
ONLY_PART = "Of {} only that part, not what {} in all nor {} constants (loop, times): dimensions could make the rest."
FITTED = "Do not report calibrated dimensions, nor other numbers under `simulation`: they are fitted, not measured."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A line of what can be reported and a line of what cannot; nothing where no effect is named."""
    if not content["mismatch"]:
        return []
    beyond = unseen.left_of_whole(content, words) if content["verdict"] in UNNAMED else 0.0
    missing_size = size(beyond or amount(content["mismatch"], f"rms_{words.ending}"), words.unit)
    missing = f"{missing_size} rms is missing after calibration, noise taken off"
    if not (beyond or amount(content["mismatch"], f"rms_{words.ending}")):
        missing = "after calibration nothing is missing beyond the noise"
    missing += _where(content, words) + _beside(content) + _unseen(content, words)
    statements = [
        missing,
        *of_adopted.reportable(content),
        *_sure(content, words),
        *_own(content, words),
        *_open(content, words),
        *_best(content, words),
    ]
    when = ", if measuring again changed nothing" if far_moved(content) else ""
    return [
        f"You can report{when}:",
        *(f"- {statement};" for statement in statements[:-1]),
        f"- {statements[-1]}.",
        *_not_yet(content, words),
        *of_adopted.not_reportable(content),
        *([NO_EFFECT] if content["verdict"] == "unknown" else []),
    ]


def _where(content: Verdict, words: Vocabulary) -> str:
    """The place of an unnamed mismatch, and the driver that it follows; ends a statement. Else nothing."""
    mismatch = content["mismatch"]
    if content["verdict"] != "unknown" or not mismatch or not amount(mismatch, f"rms_{words.ending}"):
        return ""
    return f", {lying(mismatch['location'], content['evidence'], words)}, following {mismatch['driver']}"


def _beside(content: Verdict) -> str:
    """The adopted effects in the simulator for which a statement holds; ends a statement."""
    ids = holdout.included(content)
    return f", with {listing(ids)} adopted (in run.yaml)" if ids else ""


def _unseen(content: Verdict, words: Vocabulary) -> str:
    """The remark that errors on unseen strokes can be reported, where they can; ends a statement."""
    errors = unseen.errors(content, words)
    if errors is None or holdout.status(content) != holdout.UNSEEN or in_vain.harmful(content, words):
        return ""
    return f"; the errors on the {holdout.strokes(content)} above"


def _sure(content: Verdict, words: Vocabulary) -> list[str]:
    """The effects that are surely at work; called not settled where the page says that none is proved."""
    sure = [id_ for id_, share in certainty.known(content).items() if reaches(share, certainty.SURE)]
    shares = certainty.known(content)
    word = {id_: "probable" if certainty.held_back(content, words, id_) else "sure" for id_ in sure}
    named = listing([f"{id_} ({word[id_]}, {percent(shares[id_])})" for id_ in sure])
    remark = slow_look_alikes.remark(content, words, sure)
    vain = in_vain.said(content, words)
    if in_vain.harmful(content, words):
        return [f"not settled: {named}, for {vain}{remark}"] if sure else []
    remark = f", though {vain}{remark}" if vain else remark
    return [f"at work: {named}{remark}"] if sure else []


def own_sizes(content: Verdict, words: Vocabulary) -> list[str]:
    """The effects whose own size can be reported; none where dimensions moved far."""
    ids = [entry["id"] for entry in content["mechanisms"] if own_size.reportable(entry, content, words)]
    return [] if far_moved(content) else ids


def _own(content: Verdict, words: Vocabulary) -> list[str]:
    """The sizes to quote, and the effects with constants to quote, if dimensions did not move far."""
    entries = _to_report(content, words, is_open=False)
    if not entries:
        return []
    sizes, constants = [], []
    all_in_part = len(entries) > 1 and all(own_size.own_part(entry, content, words) for entry in entries)
    for entry in entries:
        size = own_size.own_with_interval if all_in_part else _size
        sizes.append(f"{entry['id']} {size(entry, content, words)}")
        if not own_size.own_part(entry, content, words) and effect_sentence.has_constants(entry):
            constants.append(entry["id"])
    also = f", and the constants of {listing(constants)} above" if constants else ""
    of_each = f", of each {own_size.PART}" if all_in_part else ""
    best = rivals.called([entry["id"] for entry in content["mechanisms"]])
    provided = f", if {best} is right" if content["alternatives"] else ""
    return [f"{_head(content, words)}: {'; '.join(sizes)}{of_each} (rms, 90 % interval){also}{provided}"]


def _open(content: Verdict, words: Vocabulary) -> list[str]:
    """The largest size that an open effect of the best explanation may have, if dimensions did not move far."""
    most = [
        f"{entry['id']} {_size(entry, content, words)}, or 0 if it is not at work"
        for entry in _to_report(content, words, is_open=True)
    ]
    return [f"{_head(content, words)}, of what is open: {'; '.join(most)} (rms, 90 % interval)"] if most else []


def _head(content: Verdict, words: Vocabulary) -> str:
    """The beginning of a line of sizes; it limits them if the named effects improve nothing."""
    vain = in_vain.said(content, words)
    return ONLY_WITH.format(vain) if vain else TO_REPORT


def _size(entry: MechanismEntry, content: Verdict, words: Vocabulary) -> str:
    """The size of an effect to quote: the whole, or the part that no dimension could imitate, named so."""
    if own_size.own_part(entry, content, words):
        return f"{own_size.own_with_interval(entry, content, words)}, {own_size.PART}"
    return own_size.with_interval(entry, words)


def _to_report(content: Verdict, words: Vocabulary, is_open: bool) -> list[MechanismEntry]:
    """The effects whose size can be reported, those that are open or all others."""
    shares, ids = certainty.known(content), own_sizes(content, words)
    entries = [entry for entry in content["mechanisms"] if entry["id"] in ids]
    return [entry for entry in entries if reaches(shares.get(entry["id"], 1.0), certainty.PROBABLE) != is_open]


def _best(content: Verdict, words: Vocabulary) -> list[str]:
    """The probability of the best explanation, the rivals that are not excluded, and physics outside the library."""
    none = content["evidence"].get("probability_of_none")
    kept = chances.kept_shares(content)
    if not kept or none is None or not probability.known(content):
        return []
    name, share = kept[0]
    best = "of what it can tell from moved dimensions the" if not_named.likelier(content, share) else "the"
    even = [other for other, its_share in kept[1:] if percent(its_share) == percent(share)]
    than_these = f"{listing(even)} {'is' if len(even) == 1 else 'are'} as likely, every other one" if even else ""
    rest = f"{than_these or 'every other explanation'} is less likely, but none is impossible"
    rest += ", save those with an effect that is wrong while the motor stands" * bool(
        slow_look_alikes.excluded(content, words)
    )
    return [f"{best} recording agrees best with {name} ({percent(share)}); {rest}"]


def _not_yet(content: Verdict, words: Vocabulary) -> list[str]:
    """The numbers that are no results: poorly known sizes, and dimensions that calibration moved far."""
    if far_moved(content):
        return [
            "Do not report how much an effect does alone, its constants (loop, times, corners), or calibrated "
            "dimensions."
        ]
    doubtful = [entry for entry in content["mechanisms"] if own_size.doubt_of(entry, content, words)]
    reportable = own_sizes(content, words)
    no_size = [entry["id"] for entry in doubtful if entry["id"] not in reportable]
    in_part = [entry["id"] for entry in content["mechanisms"] if own_size.own_part(entry, content, words)]
    in_part = [id_ for id_ in in_part if id_ in reportable]
    in_all = [entry["id"] for entry in doubtful if entry["id"] in reportable and entry["id"] not in in_part]
    sentences = [f"Do not report how much {listing(no_size)} {_does(no_size)} alone."] if no_size else []
    sentences += [_only_part(in_part)] if in_part else []
    sentences += [f"Do not report what {listing(in_all)} {_does(in_all)} in all."] if in_all else []
    whole = [entry for entry in content["mechanisms"] if entry["id"] in reportable and entry["id"] not in in_part]
    sentences += effect_sentence.no_constants(whole)
    rule = [RULE] if reportable else []
    return [" ".join([*rule, *sentences, FITTED])] if content["mechanisms"] else []


def _only_part(ids: list[str]) -> str:
    several = len(ids) > 1
    return ONLY_PART.format(listing(ids), "they do" if several else "it does", "their" if several else "its")


def _does(ids: list[str]) -> str:
    return "do" if len(ids) > 1 else "does"
