"""The table of acting effects: each effect's name, how sure it is, how large it is, and what it does."""

from ...document.content import Verdict, mismatch_of
from ...document.effects_named import MechanismEntry
from ...document.made_keys import Interval, amount, by_name, interval
from ...mechanisms.library import mechanisms
from ..explanations import probability
from ..held_out import holdout
from ..language.quantity import listing, percent, reaches, size
from ..language.text_table import aligned
from ..language.vocabulary import Vocabulary
from ..measured.dimensions import far_moved, name_of
from . import cancelling, certainty, effect_sentence, in_a_line, needed
from .own_size import HIDDEN, PART, PARTLY, POORLY, in_columns, own_part, own_with_interval, to_report

HEADING = "What acts, by the library's names"
HEAD = ["effect", "how sure", "its size, rms (90 % interval)"]
PROBABLY = "probable"
OWN_PART = "its own part"  # the head of a column
OF_OWN_PART = f"Its own part is {PART}."
AT_A_STAND = ", and is gone as soon as the motor stands"  # of a loss, by its law
WHOSE = "Sizes are those of the best explanation."
NO_PERCENTAGE = "No percentage is known on this rig."
OF_CHANCE = "No percentage is known of an effect whose every move is chance."
NO_SIZE = "–"  # of an effect that the best explanation has not
UNSURE_SIZE = (
    "Poorly known: the interval is wider than a factor of 2, since dimensions or other effects can take over much of "
    "the size, however sure the effect is{}."
)
SURE_FROM = "Sure: {} or more; probable: {} or more, or sure but for a reason that is told; open: less."
NO_INTERVAL = "{} without an interval: the fit gives it one value alone."
IDLE = "{} was tried as well and is not named. {}"
READ = "Sizes of one effect: rms is its usual size over the whole recording{}{}. All hold if {} is right."
UP_TO = "; after `up to` stands its largest one"
READ_PART = "; the last column is the rms, over the whole recording, of the part that no wrong dimension can make"
TAKEN_BACK = (
    "Mostly hidden: it is far larger than the {} that is missing. Moved dimensions or other effects take the rest back."
)
ELSEWHERE, CHIEF = 0.5, 3  # tolerances that a dimension moved in an effect's place, to be named; how many are
NEAR_0 = 0.02  # of an interval's upper end: a lower end that is less reads as 0
BOTH_HOLD = ": {} {} though the interval reaches 0, for the percentage counts all signs, the interval the size alone"
IN_ALL = (
    "What no wrong dimension can make of {}: {}. The rest {} could make as well. The two overlap, so their rms sizes "
    "do not add up."
)
SOME_TAKEN_BACK = (
    "Partly hidden: it is more than the {} that is missing. Moved dimensions or other effects take the rest back, so "
    "its own size stands and falls with them."
)


def lines(content: Verdict, words: Vocabulary, short: bool) -> list[str]:
    """The effects of the best explanation, then those that only other likely ones have; nothing without a name.

    `short`: a line on each effect, and no more remarks than which effect is open and whose the sizes are.
    """
    if not content["mechanisms"]:
        return []
    shares = certainty.known(content)
    entries = sorted(content["mechanisms"], key=lambda entry: -shares.get(entry["id"], 0.0))
    parts = any(own_part(entry, content, words) for entry in entries)
    sizes = {entry["id"]: in_columns(entry, content, words, parts, short) for entry in entries}
    columns = [*HEAD, *([OWN_PART] if parts else [])]
    rows = [[id_, how_sure(content, id_, words), *cells] for id_, cells in sizes.items()]
    elsewhere = only_elsewhere(content)
    rows += [[id_, how_sure(content, id_, words), *[NO_SIZE] * (len(columns) - 2)] for id_ in elsewhere]
    head, *table = aligned([columns, *rows])
    does = {
        each["id"]: in_a_line.of_named(each, content, words) if short else _sentence(each, content) for each in entries
    }
    between = {} if short else {entry["id"]: effect_sentence.between_runs(entry, words) for entry in entries}
    table_lines = [head]
    for (id_, *_), row in zip(rows, table, strict=True):
        what = does.get(id_) or in_a_line.of_open(id_, content, words)
        table_lines += [row, f"    {what}{'' if short else _of_strokes(content, id_, words)}{between.get(id_, '')}"]
    several = len(content["mechanisms"]) > 1 and content["alternatives"]
    larger = to_report(content, entries, words, _in_its_place(content))
    if short:
        against = cancelling.lines(content, entries, words)
        note = [OF_OWN_PART] if parts else []
        return [
            *table_lines,
            *([] if certainty.known(content) else [_no_percentage(entries)]),
            *_in_one([*needed.lines(content), *note, *larger, *([WHOSE] if several else []), *against]),
            *_in_one([*certainty.than_the_explanation(content), *certainty.no_promise(content, words)]),
            *([] if far_moved(content) else certainty.to_write(content, words, short)),  # else it is said first
        ]
    thoughts = " ".join(cell for cells in sizes.values() for cell in cells)
    of_own: list[MechanismEntry] = content.get("of_your_own", {"mechanisms": []})["mechanisms"]
    exact = [entry["id"] for entry in entries if _exact(interval(entry, f"rms_{words.ending}"))]
    largest = UP_TO * any("up to" in entry["sentence"] for entry in entries)
    sure = SURE_FROM.format(percent(certainty.SURE), percent(certainty.PROBABLE))
    return [
        *table_lines,
        *(f"of your own, {entry['id']}: {entry['sentence']}" for entry in of_own),
        *(IDLE.format(id_, effect_sentence.NOTHING) for id_ in content["evidence"].get("idle", [])),
        *_in_one([*needed.lines(content), *certainty.to_write(content, words)]),
        *_in_one([*([sure] if shares else []), *certainty.than_the_explanation(content)]),
        READ.format(largest, READ_PART * parts, holdout.named(content)),
        *_in_all(content, entries, words),
        *cancelling.lines(content, entries, words),
        *([NO_INTERVAL.format(listing(exact))] if exact else []),
        *([UNSURE_SIZE.format(_sure_and_near_0(content, entries, words))] if POORLY in thoughts else []),
        *([SOME_TAKEN_BACK.format(_missing(content, words))] if PARTLY in thoughts else []),
        *([TAKEN_BACK.format(_missing(content, words))] if HIDDEN in thoughts else []),
    ]


def _sentence(entry: MechanismEntry, content: Verdict) -> str:
    """What an effect does; without its action at a stand, where the motor never stood long enough to show it."""
    tried = content["evidence"].get("not_kept")
    never = tried is not None and bool(tried) and not tried[0]["stands"]
    return str(entry["sentence"]).replace(AT_A_STAND, "") if never else str(entry["sentence"])


def _in_all(content: Verdict, entries: list[MechanismEntry], words: Vocabulary) -> list[str]:
    """The part of each effect that no dimension could imitate, and what could do the rest; nothing if that is all."""
    parts = {
        entry["id"]: own_with_interval(entry, content, words) for entry in entries if own_part(entry, content, words)
    }
    sizes = [f"{id_} {part}" if len(parts) > 1 else part for id_, part in parts.items()]
    return [IN_ALL.format(listing(list(parts)), listing(sizes), _in_its_place(content))] if parts else []


def _no_percentage(entries: list[MechanismEntry]) -> str:
    """Why no effect has a percentage."""
    return OF_CHANCE if any(mechanisms()[entry["id"]].largest_move for entry in entries) else NO_PERCENTAGE


def _in_its_place(content: Verdict) -> str:
    """The dimensions that calibration alone moves differently than the explanation does, the farthest first."""
    alone, beside = content["evidence"].get("moved_alone_sigma", {}), content["evidence"]["moved_sigma"]
    apart = {name: abs(alone[name] - beside[name]) for name in alone if name in beside}
    names = [name for name in sorted(apart, key=lambda name: -apart[name]) if apart[name] >= ELSEWHERE][:CHIEF]
    return f"a slightly different {listing([name_of(name) for name in names])}" if names else "moved dimensions"


def _sure_and_near_0(content: Verdict, entries: list[MechanismEntry], words: Vocabulary) -> str:
    """Why an effect can be sure although its interval reaches 0; nothing where that is not the case."""
    shares, sizes = certainty.known(content), {entry["id"]: interval(entry, f"rms_{words.ending}") for entry in entries}
    both = [
        id_
        for id_, rms in sizes.items()
        if reaches(shares.get(id_, 0.0), certainty.SURE) and rms["low"] <= NEAR_0 * rms["high"] and rms["value"]
    ]
    are = "are" if len(both) > 1 else "is"
    sure = "probable" if any(certainty.held_back(content, words, id_) for id_ in both) else "sure"
    return BOTH_HOLD.format(listing(both), f"{are} {sure}") if both else ""


def _exact(rms: Interval) -> bool:
    """Whether a size has no interval."""
    return bool(rms["value"]) and bool(rms["high"] <= rms["low"])


def _in_one(sentences: list[str]) -> list[str]:
    """Short sentences as one line, which takes less of a page."""
    return [" ".join(sentences)] if sentences else []


def _of_strokes(content: Verdict, id_: str, words: Vocabulary) -> str:
    """What a named effect does from stroke to stroke."""
    return effect_sentence.at_the_top(content, by_name(content["evidence"], f"tops_{words.ending}").get(id_), words)


def only_elsewhere(content: Verdict) -> list[str]:
    """The effects that only another likely explanation has, the likeliest first."""
    best = {entry["id"] for entry in content["mechanisms"]}
    others = dict.fromkeys(id_ for ids in content["alternatives"] for id_ in ids if id_ not in best)
    return sorted(others, key=lambda id_: -probability.at_work(content, id_))


def how_sure(content: Verdict, id_: str, words: Vocabulary) -> str:
    """How probable an effect is, with its word; if that is unknown, the number of explanations that have it."""
    if not certainty.known(content):
        sets = [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]
        return "named" if len(sets) == 1 else f"in {sum(id_ in ids for ids in sets)} of {len(sets)} explanations"
    share = certainty.known(content).get(id_, probability.at_work(content, id_))
    named = {entry["id"] for entry in content["mechanisms"]}
    surely = reaches(share, certainty.SURE) and not certainty.held_back(content, words, id_)
    probably = reaches(share, certainty.SURE) or (reaches(share, certainty.PROBABLE) and id_ in named)
    word = "sure" if surely else PROBABLY if probably else "open"
    return f"{word}, {percent(share)}"


def only_probable(content: Verdict, words: Vocabulary) -> list[str]:
    """The named effects that are called probable."""
    ids = [entry["id"] for entry in content["mechanisms"]]
    return [id_ for id_ in ids if how_sure(content, id_, words).startswith(PROBABLY)]


def _missing(content: Verdict, words: Vocabulary) -> str:
    return size(amount(mismatch_of(content), f"rms_{words.ending}"), words.unit)
