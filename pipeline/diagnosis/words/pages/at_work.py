"""What is at work by several explanations, in one sentence: first what all or most of them have, then what is open."""

from ...document.content import Verdict
from ..explanations import probability
from ..language.quantity import listing, percent
from ..language.vocabulary import Vocabulary
from ..named import certainty, effect_table

NAMED = 3  # open effects by name; the others are counted
UNKNOWN = "it is not known which"


def sentence(content: Verdict, words: Vocabulary) -> str:
    """What is at work, how likely, and what is open; it has no full stop. For a verdict with several explanations."""
    best = [entry["id"] for entry in content["mechanisms"]]
    sets = [set(best), *map(set, content["alternatives"])]
    shares = certainty.known(content)
    ids = [*sorted(best, key=lambda id_: -shares.get(id_, 0.0)), *effect_table.only_elsewhere(content)]
    common = [id_ for id_ in ids if all(id_ in each for each in sets)]
    if shares:
        word = {id_: effect_table.how_sure(content, id_, words).partition(",")[0] for id_ in ids}
        sure = [id_ for id_ in best if word[id_] == "sure"]
        likely = [id_ for id_ in best if word[id_] == effect_table.PROBABLY]
        lead, first = [*sure, *likely], _likely(content, sure, likely)
    else:
        lead, every = common, "both" if len(sets) == 2 else f"all {len(sets)}"
        first = f"{listing(lead)} {_be(lead)} in {every} likely explanations" if lead else ""
    unsure = [id_ for id_ in ids if id_ not in lead]
    if not unsure:
        return first
    single = all(len(each - set(lead)) == 1 for each in sets) and set(lead) <= set(common)
    beside = f" beside {'it' if len(lead) == 1 else 'them'}"
    if single and not lead:
        return f"{_named(content, unsure, 'or')} is at work; {UNKNOWN}"
    if single:
        then = f"{UNKNOWN} of {_named(content, unsure, 'and')} acts{beside}"
    elif lead and set(lead) <= set(common):
        then = f"whether {_named(content, unsure, 'or')} acts{beside} is open"
    else:
        then = f"whether {_named(content, unsure, 'or')} is at work is open"
    return f"{first}; {then}" if first else then


def _likely(content: Verdict, sure: list[str], likely: list[str]) -> str:
    """The effects that are at work, then those that probably are, each with its percentage."""
    phrases = [f"{_each(content, sure)} {_be(sure)} at work"] if sure else []
    if likely:
        doubted = f"{_each(content, likely)}"
        phrases += [f"{doubted} probably"] if sure else [f"{doubted} {_be(likely)} probably at work"]
    return ", ".join(phrases)


def _each(content: Verdict, ids: list[str]) -> str:
    return listing([_one(content, id_) for id_ in ids])


def _named(content: Verdict, ids: list[str], last: str) -> str:
    """Effects with their percentages; of many the first ones, and how many more."""
    if len(ids) <= NAMED + 1:
        return listing([_one(content, id_) for id_ in ids], last)
    return f"{', '.join(_one(content, id_) for id_ in ids[:NAMED])} {last} one of {len(ids) - NAMED} more"


def _one(content: Verdict, id_: str) -> str:
    """An effect with how likely it is at work, where that is known."""
    shares = certainty.known(content)
    return f"{id_} ({percent(shares.get(id_, probability.at_work(content, id_)))})" if shares else id_


def _be(ids: list[str]) -> str:
    return "are" if len(ids) > 1 else "is"
