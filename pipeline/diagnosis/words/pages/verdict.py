"""The content of `diagnosis.json` → `verdict.txt`: one page with the acting effects, the fit, and the next steps."""

from collections.abc import Sequence
from pathlib import Path

from ....ground.words.counts import counted
from ....systems import System
from ...document.content import Verdict
from ...document.made_keys import amount, by_name
from ...mechanisms.interface import physics
from ..explanations import chances, closest, excursions, rivals, stand_ins, unexplained_pattern
from ..held_out import holdout, in_vain, level, unseen, unseen_doubts
from ..held_out.without_name import UNNAMED, kept_times
from ..language.places import lying
from ..language.quantity import listing, size, times
from ..language.sections import Sections, shortened, text
from ..language.vocabulary import Vocabulary
from ..measured import breaks, tolerances
from ..measured.dimensions import LEAVES, adopted_fit, corrected, far_moved, name_of
from ..named import adopted_table, effect_table, logged, slow_look_alikes
from ..next_run.run_asked import to_settle
from . import adoption, error_table, spikes, to_do
from .headline import headline

DOUBTS = "What to know first"
ENOUGH_STROKES = 6  # for names of effects of a string; a test holds it to what the end of a capture says
LONG = 200  # letters of a doubt on the page
MORE = "More: details.txt (reasons, steps in full, what can be reported, words), diagnosis.pdf (figures)."


def verdict_text(
    content: Verdict, system: System, folders: list[Path], out: Path | None = None, doubts: Sequence[str] = ()
) -> str:
    """The verdict on one page; `folders` are its runs and `out` its own folder, for the commands.

    `doubts` are sentences on the recording itself, which a reader must know before anything else.
    """
    words = Vocabulary.of(system)
    missing, would, temperature = _unknown(content, words), _would(content, words), logged.temperature(content, words)
    acts = effect_table.lines(content, words, short=True) if content["mechanisms"] else []
    sections: Sections = [
        (headline(content, words), []),
        (effect_table.HEADING, [*acts, *stand_ins.lines(content)]),
        (adopted_table.HEADING, adopted_table.lines(content, words)),
        (chances.HEADING, chances.lines(content)),
        (chances.BARE, chances.bare(content, words)),
        ("What is missing", [*missing, *temperature] if missing else []),
        (error_table.HEADING, [*error_table.short(content, words), *spikes.lines(content, words)]),
        ("Dimensions", [] if kept_times(content, words) else corrected(content, words)),
        (to_do.HEADING, to_do.lines(content, words, folders, out, short=True)),
        ("What would have been seen", [*would, *temperature] if would else []),
    ]
    # the headline and the table of errors have these
    above = in_vain.unsettled(content, words) if to_settle(content, words) else []
    first = [line for line in what_first(content, words, joined(sections)) if line not in above]
    first = [shortened(line, LONG) for line in (*first, *slow_look_alikes.doubts(content, words))]
    sections.insert(1, (DOUBTS, [*doubts, *first]))
    return text(sections, (MORE, closest.not_told(joined(sections))))


def joined(sections: Sections) -> str:
    """The words of some sections, for a check which of them a page uses."""
    return "\n".join(line for head, lines in sections if lines or head for line in (head, *lines))


def what_first(content: Verdict, words: Vocabulary, rest: str = "") -> list[str]:
    """What a reader must know before trusting a verdict, a line each; the most important stands first.

    `rest` is the text of the page beside it.
    Slow effects that look alike are not in it: the page has a line on them, and the details have one on each.
    """
    after = [
        *_few_strokes(content, words),
        *breaks.changed(content),
        *_provisional(content, words),
        *unseen_doubts.cautions(content, words),
        *_left(content, words),
    ]
    return [*adoption.cautions(content, "\n".join([rest, *after])), *after]


def _few_strokes(content: Verdict, words: Vocabulary) -> list[str]:
    """That names of a string are provisional which so few strokes gave."""
    first, last = content["evidence"]["strokes"]
    if not words.twisted or not content["mechanisms"] or last - first + 1 >= ENOUGH_STROKES:
        return []
    strokes = counted(last - first + 1, "stroke")
    return [f"There are only {strokes}, and names need {ENOUGH_STROKES} to 8, with holds: take these as provisional."]


def _left(content: Verdict, words: Vocabulary) -> list[str]:
    """The place of the residual pattern, if unseen strokes are poorly predicted and nothing says why."""
    if not unseen.partly(content, words) or level.place_of_missing(content, words):
        return []
    least = rivals.NOISY if level.beaten(content, words) else 0.0
    return unexplained_pattern.remains(content, words, least)


def _provisional(content: Verdict, words: Vocabulary) -> list[str]:
    """Why names may not last: dimensions that calibration moved far, and odd tolerances."""
    moved = far_moved(content)
    lines = tolerances.doubts(content, words)
    if moved:
        names = listing([f"the {name_of(name)}" for name in moved])
        single = len(moved) == 1
        their, are = ("its", "it is") if single else ("their", "they are")
        below = " (below)" * to_do.asks_to_measure(content, words)
        lines.append(
            f"Calibration moved {names} by {_span(moved)} times {their} tolerance. Until {are} measured again{below}, "
            f"{_what(content)} provisional. Three times is the most that it may."
        )
    if moved and adoption.dimensions_came(content) and adoption.adopted_again(content):
        lines.append("These are the values that were adopted with the effects: nothing new was found about them.")
    elif moved and adoption.dimensions_came(content):
        lines.append(
            "What was adopted fitted with other dimensions (`adopted` in run.yaml): dimensions take each other's "
            "place, so these need not be the wrong ones."
        )
    if (
        adopted_fit(content)
        and not kept_times(content, words)
        and any(abs(sigma) > LEAVES for sigma in content["evidence"]["moved_sigma"].values())
    ):
        lines.append(
            "Fitted anew, dimensions moved far. That is no reason to measure them again: the dimensions that were "
            "adopted lie within their tolerances, and fit this rig as well."
        )
    return lines


def _what(content: Verdict) -> str:
    return "names, percentages and sizes are" if content["mechanisms"] else "this verdict is"


def _span(moved: dict[str, float]) -> str:
    ends = list(dict.fromkeys(times(abs(sigma)) for sigma in sorted(moved.values(), key=abs)))
    return ends[0] if len(ends) == 1 else f"{ends[0]} to {ends[-1]}"


def _unknown(content: Verdict, words: Vocabulary) -> list[str]:
    """An unnamed mismatch: its size, place and driver, the closest explanations, and the error to reach."""
    mismatch = content["mismatch"]
    if not mismatch or content["verdict"] != "unknown":
        return []
    rms, floor = amount(mismatch, f"rms_{words.ending}"), amount(content["evidence"], f"floor_{words.ending}")
    lies = lying(mismatch["location"], content["evidence"], words)
    beyond = f"{size(rms, words.unit)} rms is missing after calibration"
    missing = f"{beyond}, noise taken off ({times(rms / floor)} times the noise)"
    return [
        f"{missing}, {lies}. It follows {mismatch['driver']}.",
        *excursions.lines(content, words),
        "What comes closest, and does not do:",
        *closest.insufficient(content, words),
        *level.to_reach(content, words),
    ]


def _would(content: Verdict, words: Vocabulary) -> list[str]:
    """The worth of a verdict without a name, in short: from which size on effects would have been seen."""
    detectable = by_name(content["fit"], f"detectable_{words.ending}")
    sizes = {
        id_: least for id_, least in detectable.items() if physics((id_,)) and id_ not in holdout.included(content)
    }
    if content["verdict"] not in UNNAMED or not sizes:
        return []
    left_rms = unseen.left_over(content, words)
    if left_rms:
        more = f"Of the errors above, {size(left_rms, words.unit)} rms is more than noise"
        return [f"{more}: effects of that size and less may hide in it."]
    ends = [min(sizes, key=lambda id_: sizes[id_]), max(sizes, key=lambda id_: sizes[id_])]
    from_to = " to ".join(f"{size(sizes[id_], words.unit)} ({id_})" for id_ in dict.fromkeys(ends))
    return [f"An effect would have been seen from this size on: {from_to} rms. details.txt has the size of each."]
