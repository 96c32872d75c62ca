"""How to confirm the one explanation: more strokes where something is still missing, and the test of each effect."""

from pathlib import Path

from ....ground.command import program_name
from ...document.content import Verdict
from ...document.made_keys import amount
from ...document.time_constants import time_constants_s
from ...mechanisms.library import mechanisms
from ..explanations import rivals
from ..foretold import expectation, loop_to_see
from ..held_out import holdout, in_vain, unseen
from ..language.explained_words import tells
from ..language.quantity import duration, listing, number, quantity
from ..language.vocabulary import Vocabulary
from ..measured import other_load
from ..measured.dimensions import far_moved
from ..named import certainty
from ..named.missing_signs import recorded
from . import commands, recipe, recorded_so_far, second_load, worth
from .run_asked import as_many_again, to_settle

OTHER_LOAD = "Under one load alone no slow effect's name is sure."
MORE_OF_IT = (
    "Better with more strokes under {load}: a second load that only {few} had makes no slow effect's name sure."
)
AGAIN = "With another load add --load-n to new_run; with a log of your own --recording FILE, in place of capture:"
HERE = " (this recording has it)"
OPTIONAL = "Optional, to be surer of a name{after}: before adopting, {record}"
NEEDED = "Make sure of the name before you adopt or report it, for {vain}: {record}"
RECORD = "record what tells the effect from others:"
ALL_HERE = "record again what tells the effect from others, which this recording has:"
BEFORE = f"If you have adopted it already, first take it out of each run ({program_name('adopt')} --remove)."
WHERE = "{}: {}."
DETAILS = "details.txt"
NUMBERS, SO_FAR = "the numbers to expect of it", "what was recorded so far"
BEYOND_DOUBT = 0.99  # of the probability of each effect: a name that is so sure needs no further run
RUN = "The run to make next"  # the heading of its steps and commands in the details
LEAVE = "Leave what is still missing, unless it is too much for your use."
NO_NAME = "No effect of the library is named for it."
TIED = "The best explanation leaves it too, and no further effect of the library is named for it."
TIED_LEAVES_NONE = "The best explanation leaves it; {}, likely as well, leaves only the noise."
MORE = "Other speeds and loads, diagnosed together, show more of it."
ABOVE = " (commands: the step before)"
AS_MANY = (
    "If what is still missing is too much for your use: record {again}, and "
    "diagnose the runs together{where}. If the error on the {strokes} falls to the noise, there were too few strokes; "
    "else this rig has physics that the library lacks."
)


def of_what_is_missing(
    content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, short: bool
) -> list[list[str]]:
    """What to do about the mismatch that named effects leave; nothing where they leave none."""
    if not unseen.partly(content, words) or content["verdict"] not in ("explained", "ambiguous"):
        return []
    tie = content["verdict"] == "ambiguous"
    if to_settle(content, words):
        return []  # that recording shows it too
    if unseen.nothing_new(content, words):
        return [[f"{LEAVE} {_of_tie(content, words) if tie else NO_NAME} {MORE}"]]
    strokes_again = as_many_again(content, words)
    run = content["next_run"]
    shown = tie and run is not None and not worth.first(run)  # the same commands stand in the details already
    if short:
        where = f" (commands: {DETAILS}, {RUN})" if shown else f" (commands: {DETAILS})"
        return [[f"{AS_MANY.partition('. ')[0]}.".format(where=where, again=strokes_again)]]
    again = commands.lines(folders, out, [""])
    printed = {line.strip() for step in of_names(content, words, folders, out, False) for line in step}
    above = set(again) <= printed  # the step before has them
    where = f" (commands: below, {RUN})" if shown else ABOVE if above else ""
    typed = [] if shown or above else [*(f"  {line}" for line in again), commands.remark(folders[-1], words)]
    return [[AS_MANY.format(where=where, again=strokes_again, strokes=holdout.strokes(content)), *typed]]


def _of_tie(content: Verdict, words: Vocabulary) -> str:
    """Whether what the best explanation leaves is explained by another one that is held."""
    floor = amount(content["evidence"], f"floor_{words.ending}")
    (best, *_), ties = rivals.entries(content, "named"), rivals.entries(content, "tied")
    if rivals.left_of(best, content, words.ending) > unseen.STILL_MISSING * floor:
        for tied in ties:
            if rivals.left_of(tied, content, words.ending) <= unseen.STILL_MISSING * floor:
                return TIED_LEAVES_NONE.format(rivals.called(tied["ids"]))
    return TIED


def of_the_name(content: Verdict, words: Vocabulary, short: bool) -> list[list[str]]:
    """The recording that can settle the name, where other effects are named without the last strokes."""
    settles = to_settle(content, words)
    return [[f"{settles} Commands: {f'{DETAILS}, ' * short}{RUN}."]] if settles else []


def of_what_is_left(content: Verdict, words: Vocabulary) -> list[list[str]]:
    """What to do about the mismatch that adopted effects leave; nothing where that is noise."""
    return [[f"{LEAVE} {NO_NAME} {MORE}"]] if unseen.left_over(content, words) else []


def of_names(
    content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, short: bool
) -> list[list[str]]:
    """The tests at the rig that confirm the names of the one explanation's effects.

    `short`: the run to record, or the tests where there is none, without numbers to expect and commands.
    """
    if content["verdict"] != "explained":
        return []
    ids = [entry["id"] for entry in content["mechanisms"]] if words.twisted else []
    numbers = expectation.lines(content, words, recipe.shows(content, words, ids))
    has = {id_ for id_ in ids if recorded(content, words, id_)}
    tests = [f"- {id_}: {tells(id_, words)}{_lasting(content, id_, words)}{HERE if id_ in has else ''}." for id_ in ids]
    if ids and has == set(ids) and not in_vain.doubt(content, words):
        return []  # the recording has all that it would ask for
    shares = certainty.known(content)
    if ids and not in_vain.doubt(content, words) and all(shares.get(id_, 0.0) >= BEYOND_DOUBT for id_ in ids):
        return []
    if not tests:
        return loop_to_see.step(content, words, numbers, short)
    if all(certainty.is_sure(content, words, id_) for id_ in ids) and expectation.tells_nothing(numbers):
        return []
    loads, other = _other_load(content, words) if recipe.load(content, words, ids) is None else ("", [])
    run = recipe.sentence(content, words, ids, loads)
    load = recipe.to_type(content, words, ids)
    if short and run:
        return [
            [
                _head(content, words, f"record {run.removeprefix(recipe.SO)}"),
                *other,
                _where(["its tests", NUMBERS * bool(numbers), "the commands"]),
            ]
        ]
    head = _head(content, words, ALL_HERE if has == set(ids) else RECORD)
    if short:
        so_far = recorded_so_far.lines(content, words, tests)
        more = [SO_FAR * bool(so_far), NUMBERS * bool(numbers), "the commands" * bool(numbers)]
        return [[head, *tests, *([_where(more)] if any(more) else [])]]
    typed = [again(folders[-1], load, words), *(f"  {line}" for line in commands.lines(folders, out, [load]))]
    run_lines = [*([run] if run else []), *other, *typed, BEFORE] if numbers or run else []
    return [[head, *tests, *recorded_so_far.lines(content, words, tests), *numbers, *run_lines]]


def _head(content: Verdict, words: Vocabulary, record: str) -> str:
    """Whether confirming a name is needed or optional, and when; it agrees with the advice on adopting."""
    doubt = in_vain.doubt(content, words)
    if doubt:
        return NEEDED.format(vain=doubt, record=record)
    return OPTIONAL.format(after=", after step 1" if far_moved(content) else "", record=record)


def _where(parts: list[str]) -> str:
    """A sentence that says where the other parts of a step stand."""
    kept = [part for part in parts if part]
    return WHERE.format(listing([kept[0][0].upper() + kept[0][1:], *kept[1:]]), DETAILS)


def _other_load(content: Verdict, words: Vocabulary) -> tuple[str, list[str]]:
    """The loads under which the run settles a slow effect's name, and the remark why; nothing where not needed."""
    if not certainty.slow_alike(content, words) or not content["evidence"].get("covered"):
        return "", []
    if few := other_load.only_in(content):
        return "", [MORE_OF_IT.format(load=other_load.size(content, words), few=few)]
    base = second_load.base(content)
    if base <= 0.0:
        return "", []
    half, twice = number(second_load.HALF * base), quantity(second_load.TWICE * base, words.load_unit)
    return f"{half} or {twice}", [OTHER_LOAD]


def again(old: Path, load: str, words: Vocabulary) -> str:
    """What to fill into the commands that record the tests, in the way the run `old` was recorded."""
    remark = commands.remark(old, words)
    return AGAIN if remark == commands.CAPTURE and not load else remark


def _lasting(content: Verdict, id_: str, words: Vocabulary) -> str:
    """How long to hold and to rest for an effect of time, and under which loads; nothing for other effects."""
    covered = content["evidence"].get("covered")
    entry = next(entry for entry in content["mechanisms"] if entry["id"] == id_)
    if covered is None or not mechanisms()[id_].acts_at_rest:
        return ""
    constants = time_constants_s(entry)
    longest_s = max(constants or [covered["longest_hold_s"], covered["longest_rest_s"]])
    twice = f"twice {'its longest time constant' if constants else 'the longest one here'}"
    (least, most), unit = covered["load"], words.load_unit
    several = content["evidence"]["loaded"] or bool(other_load.only_in(content))
    load = f"{number(least)} to " * several + quantity(most, unit)
    under = f", under {load} as recorded here" if words.load is not None and most > 0.0 else ""
    return f" ({duration(2.0 * longest_s)} or longer each, {twice}{under})" if longest_s > 0.0 else ""
