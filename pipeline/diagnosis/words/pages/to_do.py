"""The next steps in numbered lines; they follow from the verdict and decide nothing."""

from pathlib import Path

from ....ground.command import command
from ...document.content import Verdict
from ..explanations import excursions
from ..held_out import holdout, in_vain, unseen
from ..held_out.without_name import moved_in_vain
from ..language.quantity import listing
from ..language.vocabulary import Vocabulary
from ..measured import to_measure
from ..measured.dimensions import far_moved, name_of
from ..next_run import after_adopting, deciding_run, make_sure, to_decide, worth
from ..next_run.make_sure import DETAILS, RUN
from ..next_run.run_asked import more_strokes
from . import advice, to_use
from .adoption import dimensions_came, predictions

HEADING = "What to do, in this order"
NAMED = ("explained", "ambiguous")
SUSPECT = (
    "If you suspect a cause, write its law as a mechanism of your own and diagnose again: docs/new_rig.md. Until then "
    "report the size, the place and what it follows, under What is missing."
)
COMMANDS = (f" Commands: {RUN}.", f" Commands: {DETAILS}, {RUN}.")  # where they stand, for the details and the page


def lines(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, short: bool) -> list[str]:
    """The steps, numbered where there are several; further lines of a step are indented below it.

    `short`: as the page has them; else as the details do, where to predict and to adopt has a section of its own.
    """
    steps = _steps(content, words, folders, out, short)
    if len(steps) == 1 and (short or len(_steps(content, words, folders, out, True)) == 1):
        return steps[0]
    numbered = []
    for place, (first, *rest) in enumerate(steps, start=1):
        numbered += [f"{place}. {first}", *(f"   {line}" for line in rest)]
    return numbered


def _steps(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, short: bool) -> list[list[str]]:
    """The steps, each its lines; the details number one step too where the page has several."""
    if content["verdict"] in NAMED:
        return _named(content, words, folders, out, short)
    return _unnamed(content, words, folders, short)


def _named(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None, short: bool) -> list[list[str]]:
    """The steps where something is named."""
    if in_vain.harmful(content, words):
        run = content["next_run"]
        idle = run is not None and worth.first(run)  # such a run has no commands
        return [
            [f"{advice.worse(content)} {more_strokes(content, words)}{'' if idle else COMMANDS[short]}"],
            *_measure(content, words, short, "leave it, and take this verdict as provisional"),
            *to_decide.step(content, words, folders, short),
        ]
    return [
        *_measure(content, words, short),
        *make_sure.of_the_name(content, words, short),
        *to_decide.step(content, words, folders, short),
        *make_sure.of_names(content, words, folders, out, short),
        *make_sure.of_what_is_missing(content, words, folders, out, short),
        *(to_use.predict(content, words, folders, out) if short else []),
        *(to_use.adopt(content, words, folders, out) if short else []),
    ]


def asks_to_measure(content: Verdict, words: Vocabulary) -> bool:
    """Whether one of the steps is to measure dimensions again."""
    if not far_moved(content):
        return False
    if content["verdict"] in (*NAMED, "unknown") or any(adoption["tied"] for adoption in content.get("adopted", [])):
        return True
    moved_for_nothing = content["verdict"] == "parameters" and moved_in_vain(content, words)
    return bool(holdout.included(content)) or not moved_for_nothing


def _where(short: bool) -> str:
    """The place of the details, as the page and the details themselves name it."""
    return f"in {DETAILS}" if short else "below"


def _measure(content: Verdict, words: Vocabulary, short: bool, then: str = "go on with step 2") -> list[list[str]]:
    """The dimensions to measure again, and the following steps; nothing where none moved far."""
    if not far_moved(content):
        return []
    return [
        [
            "Measure again what calibration moved far:",
            *to_measure.table(content, words, short),
            *to_measure.consequences(content, then, short),
        ]
    ]


def _unnamed(content: Verdict, words: Vocabulary, folders: list[Path], short: bool) -> list[list[str]]:
    """The steps where nothing is named."""
    if content["verdict"] == "unknown":
        look, again = excursions.step(content, words), _measure(content, words, short, "go on")
        more = to_decide.to_see_more(content, words, short) if not look else []
        return [*look, *again, *more, [advice.nothing_named(content)], [SUSPECT]]
    if advised := _advised(content, words, folders, short):
        return [*_anew(content, words, folders, short), advised, *make_sure.of_what_is_left(content, words)]
    tied = [adoption for adoption in content.get("adopted", []) if adoption["tied"]]
    if tied and not deciding_run.worth_making(tied):
        count = 1 + max(len(adoption["tied"]) for adoption in tied)
        text = f"Report what was adopted as one of {count} explanations: no run that was tried decides between them."
        return [[text], *_anew(content, words, folders, short), *make_sure.of_what_is_left(content, words)]
    if tied:
        return [
            *_anew(content, words, folders, short),
            [
                "Decide between what was adopted and what was likely as well, if you need to know: the run is "
                f"{_where(short)} under {RUN}. Take out what was adopted first, for it is not weighed again:",
                *to_use.remove(folders, short),
            ],
            *make_sure.of_what_is_left(content, words),
        ]
    if unseen.left_over(content, words):
        record = (
            f"Record the rig in other ways, as it stands {_where(short)} under {RUN}, and diagnose the runs together."
        )
        return [*_first_measure(content, words, folders, short), [record]]
    if holdout.included(content) and far_moved(content):
        return _anew(content, words, folders, short)
    if asks_to_measure(content, words):
        return _first_measure(content, words, folders, short)
    open_still = after_adopting.of_adopted(content, words, holdout.included(content), folders, short)
    return [["Nothing needs to be done: this recording shows nothing further."], *open_still]


def _first_measure(content: Verdict, words: Vocabulary, folders: list[Path], short: bool) -> list[list[str]]:
    """The dimensions to measure where nothing is named; nothing where no step asks for it."""
    if holdout.included(content):
        return _anew(content, words, folders, short)
    if not asks_to_measure(content, words):
        return []
    names = listing([f"the {name_of(name)}" for name in far_moved(content)])
    then = "write what you measured into run.yaml, and diagnose again"
    return [[f"Measure {names} again, {then}.", *to_measure.table(content, words, short)]]


def _advised(content: Verdict, words: Vocabulary, folders: list[Path], short: bool) -> list[str]:
    """The steps where effects were adopted against their verdict's advice; else nothing."""
    against = [adoption["against_advice"] for adoption in content.get("adopted", []) if adoption.get("against_advice")]
    recordings = list(dict.fromkeys(recording for _, *more in against for recording in more))
    if not recordings:
        out = "Take out what was adopted, unless you know better: its verdict advised against it."
        return [out, *to_use.remove(folders, short)] if against else []
    asks = f"{' '.join(recordings)} The verdict that was adopted asked for that."
    return [asks, *after_adopting.anew(folders, "", words, short)]


def _anew(content: Verdict, words: Vocabulary, folders: list[Path], short: bool) -> list[list[str]]:
    """The dimensions to measure again after adopting, and what follows for the adopted effects."""
    if not far_moved(content):
        return []
    remove = to_use.remove(folders, short)
    again = ["Measure again what calibration moved far:", *to_measure.table(content, words, short)]
    change = (
        "Where you find another value, take the adopted effects out, write the value into run.yaml, diagnose again, "
        "and adopt what the new verdict names: effects and dimensions were fitted together."
    )
    if dimensions_came(content):
        keep = f"If nothing changed, keep what was adopted, and predict with {command('simulate')} as it is."
        return [again, [change, *remove], [keep]]
    adopted = [adoption for adoption in content.get("adopted", []) if adoption.get("diagnosis")][-1:]
    adopted_files = [(Path(str(adoption["diagnosis"])), adoption["effects"]) for adoption in adopted]
    predict = [
        f"  {line}"
        for source, ids in adopted_files
        for line in predictions(source, folders[:1] if short else folders, ids)
    ]
    keep = (
        f"If nothing changed, predict with {'the diagnosis that was adopted:' if adopted else 'that diagnosis.json.'}"
    )
    return [again, [change, *remove], [keep, *predict]]
