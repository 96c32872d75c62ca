"""The content of `diagnosis.json` → `details.txt`: the reasons of a verdict, the next run step by step, the words."""

from collections.abc import Sequence
from pathlib import Path

from ....systems import System
from ...document.content import Verdict, mismatch_of
from ...document.made_keys import amount
from ..explanations import (
    chances,
    closest,
    detection_limits,
    explanation_table,
    other_effects,
    probability,
    stand_ins,
    though_it_fits,
    unexplained_pattern,
)
from ..held_out import holdout, in_vain, level, unseen
from ..language import explained_words
from ..language.places import EVERYWHERE, place
from ..language.quantity import size, times
from ..language.sections import Sections, text
from ..language.vocabulary import Vocabulary
from ..measured import in_run_yaml, run_zeros, to_measure, tolerances
from ..measured.dimensions import cautions, has_table, suspicious, table
from ..named import adopted_table, certainty, effect_table, logged, slow_look_alikes
from ..next_run import commands, deciding_run, experiment, make_sure, signs, tells, worth
from ..next_run.run_asked import no_run, to_settle
from . import adoption, error_table, for_a_paper, spikes, to_do, verdict
from .headline import headline
from .spoken import whole

DOUBTS, WORDS = "What to know first", "What the words mean"
CLOSEST, MISSING, RUN = "What comes closest, and does not do", "What is missing", "The run to make next"
LONG = 80  # letters: a title that says no more than the steps
SMALL = 0.5  # noise floors: a mismatch below shows in no single sample


def details_text(
    content: Verdict, system: System, folders: list[Path], out: Path | None = None, doubts: Sequence[str] = ()
) -> str:
    """All that a verdict rests on, for a person; `folders` are its runs and `out` its own folder, for commands.

    `doubts` are sentences on the recording itself, which a reader must know before anything else.
    """
    words = Vocabulary.of(system)
    sections: Sections = [
        (effect_table.HEADING, [*effect_table.lines(content, words, short=False), *stand_ins.lines(content)]),
        (adopted_table.HEADING, adopted_table.lines(content, words)),
        (explanation_table.heading(content), weighed(content, words)),
        (MISSING, [*missing(content, words), *logged.temperature(content, words)]),
        (CLOSEST, closest_ones(content, words)),
        (error_table.HEADING, [*error_table.lines(content, words), *spikes.lines(content, words)]),
        ("Dimensions", moved(content, words)),
        (to_do.HEADING, to_do.lines(content, words, folders, out, short=False)),
        (RUN, following(content, words, folders, out)),
        (signs.HEADING, signs.lines(content, words)),
        ("To use it", adoption.how(content, words, folders, out)),
        (for_a_paper.HEADING, for_a_paper.lines(content, words)),
        (other_effects.HEADING, other_effects.lines(content, words)),
        ("What would have been seen", detection_limits.lines(content, words)),
    ]
    heads = [head.partition(", ")[0] for head, lines in sections if lines]
    top = headline(content, words)
    first = [
        *doubts,
        *verdict.what_first(content, words, verdict.joined([(top, []), *sections])),
        *slow_look_alikes.lines(content, words),
        *suspicious(content),
    ]
    sections.insert(0, (DOUBTS, first))
    all_text = "\n".join([top, *(line for head, lines in sections for line in (head, *lines))])
    explained = (WORDS, explained_words.lines(content, all_text, words))
    return text([(top, [f"Sections: {'; '.join([*heads, WORDS])}."]), *sections], last=explained)


def missing(content: Verdict, words: Vocabulary) -> list[str]:
    """How large the mismatch is, where, and what it follows; then the pattern that the best explanation leaves."""
    mismatch = content["mismatch"]
    if not mismatch:
        return []
    if content["verdict"] == "parameters":
        return unexplained_pattern.pattern(content, words)
    rms, floor = amount(mismatch, f"rms_{words.ending}"), amount(content["evidence"], f"floor_{words.ending}")
    where = place(mismatch["location"], content["evidence"], words)
    small = "The effect is smaller than the noise of one sample; it shows only over many samples."
    how_large = f"{size(rms, words.unit)} rms is missing after calibration (noise taken off)"
    lies = f"{100.0 * mismatch['location']['share']:.0f} % of its energy lies {where}"
    return [
        f"Over the whole recording {how_large}, {times(rms / floor)} times the noise. "
        f"{'It is spread over the whole range' if where == EVERYWHERE else lies}. {follows(content)}",
        *([small] if rms < SMALL * floor else []),
        *unexplained_pattern.remains(content, words),
    ]


def follows(content: Verdict) -> str:
    """The driver that the mismatch follows; the sentence on each effect says what that effect follows."""
    return f"What is missing follows {mismatch_of(content)['driver']}."


def weighed(content: Verdict, words: Vocabulary) -> list[str]:
    """The weighed explanations, and what their percentages depend on."""
    table_lines = explanation_table.lines(content, words)
    if not table_lines or not probability.known(content):
        return table_lines
    limits = [certainty.limits(content)] if certainty.known(content) else []
    stands = " ".join([*limits, *chances.stands_on(content, words)])
    return [*table_lines, *([stands] if stands else [])]


def closest_ones(content: Verdict, words: Vocabulary) -> list[str]:
    """The closest explanations where nothing explains, and the error that physics still has to reach."""
    if content["verdict"] != "unknown":
        return []
    most = "At most three effects at once are tried (of a moving mass four)"
    more = f"{most}: where more are at work, the verdict is unknown too."
    return [
        *closest.insufficient(content, words),
        *though_it_fits.constants(content),
        more,
        *level.to_reach(content, words),
    ]


def moved(content: Verdict, words: Vocabulary) -> list[str]:
    """The dimensions that calibration moved, how to measure them again, the lines for run.yaml, each run's zero."""
    named = content["verdict"] in to_do.NAMED
    in_step = to_do.asks_to_measure(content, words)
    return [
        *(table(content, words) if has_table(content) else []),
        *cautions(content, words, holdout.included(content), unseen.inexact(content, words), in_step),
        *(in_run_yaml.lines(content, to_measure.to_measure(content)) if named else []),
        *run_zeros.lines(content, words),
        *tolerances.in_force(content, words),
    ]


def following(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The protocol, line by line, its worth, and the commands from its folder to its diagnosis."""
    run = content["next_run"]
    if not run:
        sure = bool(make_sure.of_names(content, words, folders, out, False))
        steps = bool(to_do.lines(content, words, folders, out, short=False))
        records = in_vain.harmful(content, words) or to_settle(content, words)
        again = commands.lines(folders, out, [""]) if records else []
        to_record = no_run(content, words, sure, steps) + (commands.block(again, folders[-1], words) if again else [])
        return deciding_run.lines(content, words, folders, out) or to_record
    if worth.first(run):
        return experiment.brief(content, words)
    called = experiment.title(run, words)
    lines = [
        f"{called}; {experiment.lasting(run)} in all." if len(called) <= LONG else f"{experiment.lasting(run)} in all:"
    ]
    lines += [f"  {line}" for line in experiment.steps(run, words, whole(content["evidence"], words))]
    lines += [worth.care(content, words), *tells.lines(content, words)]
    to_type = commands.lines(folders, out, experiment.loads(run, words))
    return [line for line in (*lines, *commands.block(to_type, folders[-1], words)) if line]
