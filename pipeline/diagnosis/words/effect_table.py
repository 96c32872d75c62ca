"""The table of what acts: each effect by its name, how sure it is, how large it is, and what it does."""

from typing import Any

from . import certainty, probability, rivals
from .error_table import aligned
from .explained_words import meaning, on_rig
from .quantity import percent, size
from .vocabulary import Vocabulary

HEADING = "What acts, by the library's names"
HEAD = ["effect", "how sure", "its size, rms (90 % interval)"]
NO_SIZE = "–"  # of an effect that the best explanation has not
POORLY, HIDDEN, PARTLY = ", poorly known", ", poorly known: mostly hidden", ", partly hidden"
UNSURE_SIZE = (
    "Poorly known: dimensions or other effects can take over much of it. How sure an effect is says that it is there, "
    "not how large it is."
)
TAKEN_BACK = (
    "Mostly hidden: it is far larger than the {} that is missing. Moved dimensions or other effects take the rest back."
)
MORE = 0.02  # of a probability: what a reader wonders about
SOME_TAKEN_BACK = (
    "Partly hidden: it is more than the {} that is missing. Moved dimensions or other effects take the rest back, so "
    "its own size stands and falls with them."
)
ALSO_ELSEWHERE = (
    "How sure an effect is counts every explanation that has it, also those with other effects beside it. So it can be "
    "more than the {} of this one explanation."
)


def lines(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The effects of the best explanation, then those that only another likely one has; nothing where none is named."""
    if not content["mechanisms"]:
        return []
    shares = certainty.known(content)
    entries = sorted(content["mechanisms"], key=lambda entry: -shares.get(entry["id"], 0.0))
    rows = [[entry["id"], how_sure(content, entry["id"]), own_size(entry, content, words)] for entry in entries]
    rows += [[id_, how_sure(content, id_), NO_SIZE] for id_ in only_elsewhere(content)]
    head, *table = aligned([HEAD, *rows])
    does = {entry["id"]: entry["sentence"] for entry in entries}
    said = [head]
    for (id_, *_), row in zip(rows, table, strict=True):
        said += [row, f"    {does.get(id_) or on_rig(meaning(id_), words)}"]
    several = len(content["mechanisms"]) > 1 and content["alternatives"]
    best = " + ".join(entry["id"] for entry in content["mechanisms"])
    return [
        *said,
        *certainty.needed(content),
        *([f"Sizes are those of the best explanation, {best}."] if several else []),
        *_than_the_explanation(content),
        *([UNSURE_SIZE] if any(POORLY in row for *_, row in rows) else []),
        *([SOME_TAKEN_BACK.format(_missing(content, words))] if any(PARTLY in row for *_, row in rows) else []),
        *([TAKEN_BACK.format(_missing(content, words))] if any(HIDDEN in row for *_, row in rows) else []),
    ]


def _than_the_explanation(content: dict[str, Any]) -> list[str]:
    """Why an effect is surer than the one explanation that is named; nothing where it hardly is."""
    share = next(iter(rivals.entries(content, "named")), {}).get("probability")
    shares = certainty.known(content).values()
    if content["alternatives"] or share is None or max(shares, default=0.0) < share + MORE:
        return []
    return [ALSO_ELSEWHERE.format(percent(share))]


def only_elsewhere(content: dict[str, Any]) -> list[str]:
    """The effects that only another likely explanation has, the likeliest first."""
    best = {entry["id"] for entry in content["mechanisms"]}
    others = dict.fromkeys(id_ for ids in content["alternatives"] for id_ in ids if id_ not in best)
    return sorted(others, key=lambda id_: -probability.at_work(content, id_))


def how_sure(content: dict[str, Any], id_: str) -> str:
    """How probable an effect is, with the word for it; where that is unknown, in how many explanations it is."""
    if not certainty.known(content):
        sets = [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]
        return "named" if len(sets) == 1 else f"in {sum(id_ in ids for ids in sets)} of {len(sets)} explanations"
    share = certainty.known(content).get(id_, probability.at_work(content, id_))
    named = {entry["id"] for entry in content["mechanisms"]}
    word = "sure" if share >= certainty.SURE else "probable" if share >= certainty.PROBABLE and id_ in named else "open"
    return f"{word}, {percent(share)}"


def _missing(content: dict[str, Any], words: Vocabulary) -> str:
    return size(content["mismatch"][f"rms_{words.ending}"], words.unit)


def own_size(entry: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    """How much an effect moves the reading, with its interval if it has one, and what to think of it."""
    known = entry[f"rms_{words.ending}"]
    if not known["value"]:
        return "none"
    if known["high"] <= known["low"]:
        return size(known["value"], words.unit)
    within = certainty.span(known["low"], known["high"], words)
    much = content["mismatch"] and certainty.hidden(known["value"], content, words)
    some = entry["id"] in certainty.partly_hidden(content, words)
    doubt = HIDDEN if much else POORLY if certainty.wide(known) else PARTLY if some else ""
    return f"{size(known['value'], words.unit)} ({within}){doubt}"
