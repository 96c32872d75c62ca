"""The acting effects in one sentence: first those in all or most explanations, then the open ones, and how sure."""

from ...choice.judged import UNKNOWN
from ...document.content import Verdict
from ..explanations import not_named, probability, rivals
from ..language.quantity import listing, percent
from ..language.vocabulary import Vocabulary
from ..named import certainty, effect_table

NAMED = 3  # open effects by name; the others are counted
WHICH = "it is not known which"


def sentence(content: Verdict, words: Vocabulary) -> str:
    """The acting effects, how likely they are, and which are open, without a full stop; for several explanations."""
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
    if lead and not common and all(len(each) == 1 for each in sets) and word[lead[0]] != "sure":
        return f"probably {_one(content, ids[0])}, else {_named(content, ids[1:], 'or')}"
    unsure = [id_ for id_ in ids if id_ not in lead]
    if not unsure:
        return first
    single = all(len(each - set(lead)) == 1 for each in sets) and set(lead) <= set(common)
    beside = f" beside {'it' if len(lead) == 1 else 'them'}"
    if single and not lead:
        return f"{_named(content, unsure, 'or')} is at work; {WHICH}"
    if single:
        then = f"{WHICH} of {_named(content, unsure, 'and')} acts{beside}"
    elif lead and set(lead) <= set(common):
        then = _open(content, unsure, sets, f"acts{beside}", f"act{beside}")
    else:
        then = _open(content, unsure, sets, "is at work", "are at work")
    return f"{first}; {then}" if first else then


def lacks(content: Verdict) -> str:
    """How probable physics outside the library is, where that alone makes the verdict `unknown`; else nothing."""
    none = content["evidence"].get("probability_of_none") or 0.0
    return f"; physics that it lacks has a probability of {percent(none)}" if none >= UNKNOWN else ""


def how_sure(content: Verdict) -> str:
    """How probable the one explanation is; nothing where no probability is known.

    Of a single effect it is how probable the effect is in any explanation, as the table below has it, where that is
    about as much: two numbers for one thing make a reader stop.
    """
    share = next((best.get("probability") for best in rivals.entries(content, "named")), None)
    if share is None:
        return ""
    effects = [certainty.known(content).get(entry["id"], share) for entry in content["mechanisms"]]
    if len(effects) == 1 and abs(effects[0] - share) < certainty.SURER:
        share = effects[0]
    best = ", the likeliest that can be named" if not_named.likelier(content, share) else ""
    return f" ({percent(share)}{best})"


def _open(content: Verdict, unsure: list[str], sets: list[set[str]], acts: str, act: str) -> str:
    """Which effects may be at work, in words that do not present effects of one explanation as either-or.

    `acts` is the verb for one effect, `act` the verb for several.
    """
    within = [each & set(unsure) for each in sets]
    if all(len(each) < 2 for each in within):
        return f"whether {_named(content, unsure, 'or')} {acts} is open"
    if all(len(each) in (0, len(unsure)) for each in within):
        return f"whether {_named(content, unsure, 'and')} {act} is open"
    if len(unsure) == 2:
        return f"whether {', '.join(_one(content, id_) for id_ in unsure)} or both {act} is open"
    return f"which of {_named(content, unsure, 'and')} {act} is open"


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
    """Effects with their percentages; of many effects the first ones, and how many more there are."""
    if len(ids) <= NAMED + 1:
        return listing([_one(content, id_) for id_ in ids], last)
    one_of = "one of " * (last == "or")
    return f"{', '.join(_one(content, id_) for id_ in ids[:NAMED])} {last} {one_of}{len(ids) - NAMED} more"


def _one(content: Verdict, id_: str) -> str:
    """An effect with how likely it is at work, where that is known."""
    shares = certainty.known(content)
    return f"{id_} ({percent(shares.get(id_, probability.at_work(content, id_)))})" if shares else id_


def _be(ids: list[str]) -> str:
    return "are" if len(ids) > 1 else "is"
