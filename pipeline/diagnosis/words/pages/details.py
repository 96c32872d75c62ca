"""The content of `diagnosis.json` → `details.txt`: the reasons of a verdict, the next run step by step, the words."""

from collections.abc import Sequence
from pathlib import Path

from ....systems import System
from ...document.content import Part, Verdict, mismatch_of
from ..explanations import (
    chances,
    detection_limits,
    other_effects,
    probability,
    rejected_explanations,
    rivals,
    unexplained_pattern,
)
from ..held_out import holdout, in_vain, level, unseen
from ..language import explained_words
from ..language.places import EVERYWHERE, place
from ..language.quantity import duration, size, times
from ..language.sections import text
from ..language.vocabulary import Vocabulary
from ..measured import in_run_yaml, to_measure, tolerances
from ..measured.dimensions import cautions, far_moved, suspicious, table
from ..named import adopted_table, certainty, effect_table, effects, logged, needed, slow_look_alikes
from ..next_run import commands, deciding_run, experiment, make_sure, signs, worth
from ..next_run.run_asked import no_run
from . import adoption, error_table, report, spikes, to_do, verdict
from .headline import headline
from .spoken import whole

DOUBTS, WORDS = "What to know first", "What the words mean"
CLOSEST, BEATEN = "What comes closest, and does not do", "Why no other explanation"
EXPLAINS, BEST = "What explains it", "The best explanation"
SMALL = 0.5  # noise floors: a mismatch below shows in no single sample


def details_text(
    content: Verdict, system: System, folders: list[Path], out: Path | None = None, doubts: Sequence[str] = ()
) -> str:
    """All that a verdict stands on, for a person; `folders` are its runs and `out` its own folder, for the commands.

    `doubts` are sentences on the recording itself, which a reader must know before anything else.
    """
    words = Vocabulary.of(system)
    sections = [
        (headline(content, words), [*certainty.summary(content, words), *certainty.sizes(content, words)]),
        (
            DOUBTS,
            [
                *doubts,
                *verdict.what_first(content, words),
                *slow_look_alikes.lines(content, words),
                *suspicious(content),
                *spikes.lines(content, words),
            ],
        ),
        (effect_table.HEADING, effect_table.lines(content, words, short=False)),
        (adopted_table.HEADING, adopted_table.lines(content, words)),
        (chances.HEADING, chances.lines(content, words, short=False)),
        ("What is missing", [*missing(content, words), *logged.temperature(content, words)]),
        (
            f"{EXPLAINS if content['verdict'] == 'explained' else BEST}: {holdout.named(content)}",
            [
                *named(content, words),
                *needed.lines(content),
                *rivals.what_is_left(content, words),
                *unexplained_pattern.remains(content, words),
            ],
        ),
        ("What is likely beside it", tied(content, words)),
        (error_table.HEADING, error_table.lines(content, words)),
        (rivals.DIMENSIONS, moved(content, words)),
        (to_do.HEADING, to_do.lines(content, words, folders, out, short=False)),
        ("The run to make next", following(content, words, folders, out)),
        (signs.HEADING, signs.lines(content, words)),
        ("To use it", adoption.how(content, words, folders, out)),
        (report.HEADING, report.lines(content, words)),
        (CLOSEST if content["verdict"] == "unknown" else BEATEN, weighed(content, words)),
        (other_effects.HEADING, other_effects.lines(content, words)),
        ("What would have been seen", detection_limits.lines(content, words)),
    ]
    all_text = "\n".join(line for head, lines in sections for line in (head, *lines))
    return text(sections, last=(WORDS, explained_words.lines(content, all_text, words)))


def missing(content: Verdict, words: Vocabulary) -> list[str]:
    """How large the mismatch is, where, and what it follows."""
    mismatch = content["mismatch"]
    if not mismatch:
        return []
    if content["verdict"] == "parameters":
        return unexplained_pattern.pattern(content, words)
    rms, floor = mismatch[f"rms_{words.ending}"], content["evidence"][f"floor_{words.ending}"]
    where = place(mismatch["location"], content["evidence"], words)
    small = "The effect is smaller than the noise of one sample; it shows only over many samples."
    over = content["evidence"].get("step_s")
    step = f"averages of {duration(over)}" if over else "averages"
    noise = (
        f"Compared were {step}, not single samples: the noise of these averages is {size(floor, words.unit)} rms. "
        f"It is what `the noise` means here, except for the {holdout.strokes(content)}, compared sample by sample."
    )
    how_large = f"{size(rms, words.unit)} rms is missing after calibration (noise taken off)"
    return [
        f"Over the whole recording {how_large}, {times(rms / floor)} times the noise.",
        *([noise] if unseen.averaged(content, words) else []),
        *([small] if rms < SMALL * floor else []),
        "It is spread over the whole range."
        if where == EVERYWHERE
        else f"{100.0 * mismatch['location']['share']:.0f} % of its energy lies {where}.",
        follows(content),
    ]


def follows(content: Verdict) -> str:
    """What the mismatch follows; which effect follows what is said where each is told."""
    return f"What is missing follows {mismatch_of(content)['driver']}."


def named(content: Verdict, words: Vocabulary) -> list[str]:
    """How sure each mechanism's size is, and the sentences of those that only a user's own library knows."""
    own: list[Part] = content.get("of_your_own", {"mechanisms": []})["mechanisms"]
    hidden, lines = rivals.hidden(content, words), []
    for entry in content["mechanisms"]:
        limit = certainty.held_back(content, words, entry["id"])
        between = effects.between_runs(entry, words)
        interval = effects.interval(entry, words, holdout.named(content), limit)
        sentences = [interval, between, hidden.get(entry["id"], "")]
        lines.append(f"{entry['id']}: {' '.join(part for part in sentences if part)}")
    idle = content["evidence"].get("idle", [])
    lines += [f"{id_} was tried as well and is not named. {effects.NOTHING}" for id_ in idle]
    return lines + [f"of your own, {entry['id']}: {entry['sentence']}" for entry in own]


def tied(content: Verdict, words: Vocabulary) -> list[str]:
    """What ties, with what all share first."""
    if not content["alternatives"]:
        return []
    return [rivals.shared(content), *rivals.ties(content, words), *probability.rule(content)]


def weighed(content: Verdict, words: Vocabulary) -> list[str]:
    """Why the others were beaten, or what comes closest where nothing explains."""
    if content["verdict"] == "unknown":
        more = (
            "At most three effects at once are tried (of a moving mass four): where more are at work, the verdict is "
            "unknown too."
        )
        return [
            *rejected_explanations.insufficient(content, words),
            *level.to_reach(content, words),
            *probability.of_none(content),
            more,
        ]
    lines = rejected_explanations.rejected(content, words) if content["mechanisms"] else []
    alone = content["verdict"] == "explained"
    return [*(probability.rule(content) if alone else []), *lines]


def moved(content: Verdict, words: Vocabulary) -> list[str]:
    """The dimensions that calibration moved, how to measure them again, and how run.yaml says it."""
    named, far = content["verdict"] in to_do.NAMED, far_moved(content)
    in_step = to_do.asks_to_measure(content, words)
    return [
        *(table(content, words) if named or far or content["verdict"] == "parameters" else []),
        *cautions(content, words, holdout.included(content), unseen.inexact(content, words), in_step),
        *(in_run_yaml.lines(content, to_measure.to_measure(content)) if named else []),
        *tolerances.in_force(content, words),
    ]


def following(content: Verdict, words: Vocabulary, folders: list[Path], out: Path | None) -> list[str]:
    """The protocol, line by line, what it is worth, and the commands from its folder to its diagnosis."""
    run = content["next_run"]
    if not run:
        sure = bool(make_sure.of_names(content, words, folders, out, False))
        steps = bool(to_do.lines(content, words, folders, out, short=False))
        again = commands.lines(folders, out, [""]) if in_vain.harmful(content, words) else []
        to_record = no_run(content, words, sure, steps) + (commands.block(again, folders[-1], words) if again else [])
        return deciding_run.lines(content, words, folders, out) or to_record
    if worth.first(run):
        return experiment.brief(content, words)
    lines = [f"{experiment.title(run, words)}; {experiment.lasting(run)} in all."]
    lines += [f"  {line}" for line in experiment.steps(run, words, whole(content["evidence"], words))]
    lines += [worth.care(content, words), worth.purpose(content, words)]
    to_type = commands.lines(folders, out, experiment.loads(run, words))
    return [line for line in (*lines, *commands.block(to_type, folders[-1], words)) if line]
