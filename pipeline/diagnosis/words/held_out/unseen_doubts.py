"""Warnings about a simulator that errs on strokes that no fit has seen."""

from ...document.content import Verdict
from ...document.made_keys import amount
from ...study.heldout import WORSE
from ..language.quantity import ends, listing, percent, size
from ..language.vocabulary import Vocabulary
from . import holdout, in_vain, level, unseen
from .decided import decided


def cautions(content: Verdict, words: Vocabulary) -> list[str]:
    """The first warnings to a reader; none where the simulator foretells unseen strokes to the noise."""
    unseen_errors = unseen.errors(content, words)
    if unseen_errors is None:
        return left_of_whole(content, words)
    nominal, calibrated, explained = unseen_errors
    noise, sentences = amount(content["fit"], f"noise_floor_{words.ending}"), []
    named, strokes = content["verdict"] in ("explained", "ambiguous"), holdout.strokes(content)
    named_helps = named and explained < nominal  # then the first line says it
    if calibrated > WORSE * nominal and not named_helps:
        sizes = f"{size(calibrated, words.unit)} against {size(nominal, words.unit)}"
        sentences.append(
            f"On the {strokes} the calibrated simulator is worse than the nominal one: {sizes}."
            " What calibration alone learnt does not hold later: do not adopt its dimensions."
        )
    sentences += in_vain.unsettled(content, words)
    if unseen.partly(content, words) or decided(content):
        sentences += beyond(content, words)
    if in_vain.harmful(content, words):
        end = "adopt nothing" if holdout.other_name(content) else "do not adopt it"
        worse = f"On the {strokes} {in_vain.tried(content)} makes the calibrated simulator worse: {end}."
        sentences += [] if unseen.fails_first(content, words) else [worse]
        sentences += [] if unseen.other_fails(content, words) else in_vain.other_choice(content)
    elif in_vain.improves_nothing(content, words):
        means = (
            "so they say nothing of it" if in_vain.too_small(content, words) else "it may be no more than a good fit"
        )
        other = in_vain.other_choice(content)
        sentences += [f"O{in_vain.said(content, words)[1:]}{'' if other else f': {means}'}.", *other]
    if unseen.partly(content, words) and content["verdict"] != "unknown" and not unseen.other_fails(content, words):
        alone = named and unseen.of_calibration(content)
        lies = "" if alone else level.place_of_missing(content, words)
        sentences.append(f"{unseen.still_missing(content, words, explained / noise, named)} {lies}".rstrip())
    return [*sentences, *left_of_whole(content, words), *level.beaten(content, words)]


def beyond(content: Verdict, words: Vocabulary) -> list[str]:
    """The remark that unseen strokes reached a load or a motion beyond that of the strokes before; else nothing."""
    ranges_by_driver = content["evidence"].get("beyond_seen") or {}
    units = {"load": words.load_unit, "motion": words.motion_unit}
    wider = []
    for name, ranges in ranges_by_driver.items():
        both = ([ends(low, high, units[name], digits) for low, high in ranges] for digits in (2, 3))
        two, three = (next(both), next(both))
        seen, later = two if two[0] != two[1] else three
        wider.append(f"{later} of {words.motion if name == 'motion' else name} (before them: {seen})")
    if not wider:
        return []
    strokes = holdout.strokes(content)
    return [
        f"The {strokes} had {listing(wider)}: their error is also that of conditions which no fit has seen. "
        f"Record each load and each {words.motion} among the first strokes as well."
    ]


def left_of_whole(content: Verdict, words: Vocabulary) -> list[str]:
    """That the explanation leaves more than the noise of the whole recording, where unseen strokes do not show it.

    Averages have less noise than the single samples of unseen strokes, so that they show it alone.
    """
    fitted = unseen.fitted_times(content, words, named=True)
    if content["verdict"] not in ("explained", "ambiguous") or unseen.partly(content, words):
        return []
    if fitted is None or fitted <= unseen.STILL_MISSING:
        return []
    left_size = size(fitted * amount(content["evidence"], f"floor_{words.ending}"), words.unit)
    more = f"{unseen.exact(fitted)} times the noise{' of the averages' * unseen.averaged(content, words)}"
    none = content["evidence"].get("probability_of_none")
    share = "" if none is None else f"; the {percent(none)} for physics that the library lacks does not cover that"
    return [f"Something systematic is left: the explanation leaves {left_size} rms, {more}{share}."]
