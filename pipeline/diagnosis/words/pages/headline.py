"""The verdict in one line: the acting effects first; it claims no more than the residual allows."""

from ...document.bounds import at_bound
from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..explanations import excursions
from ..held_out import holdout, unseen
from ..held_out.without_name import UNNAMED, kept_times, moved_in_vain
from ..language.quantity import first_upper, listing, size, times
from ..language.vocabulary import Vocabulary
from ..measured import moved_words
from ..named import slow_look_alikes
from . import at_work

WORSE = 2.0  # times the calibrated error: nobody should predict with a run.yaml that errs by more
SAID = {
    "consistent": "the simulation explains the recording to its noise ({floor}).",
    "parameters": "the simulation explains the recording once its measured dimensions move{moved}; "
    "no physics is missing.",
    "explained": "explained by {best}{sure}.",
    "ambiguous": "{at_work}{word}.",
    "unknown": "the mismatch is real, and no explanation of the library is good enough{lacks}.",
}
WITH_ADOPTED = {
    "consistent": "with {it} the simulation explains the recording to its noise ({floor}); {adopted}.",
    "parameters": "with {it} the simulation explains the recording once its dimensions move{far}; {adopted}.",
}
AS_ADOPTED = (
    "with {it} and the dimensions that came with {it} the simulator explains the recording ({error} rms, {ratio} times "
    "the noise); {adopted}."
)
HARDLY_MOVED = "{beside}the simulation explains the recording to its noise ({floor}); moving dimensions adds little."
HOLDS, NEW, LEFT = "and still hold{s}", "and something new is there", "and something without a name is left"
MAY_HOLD, UNFIT = "and may hold", "and fit{s} no more with the dimensions of run.yaml"
FAR = ", some by three times their tolerance: measure them again before you trust it"
PARTLY = "explained by {best}{sure}, but something is still missing."
NOT_SETTLED = "explained, but not settled"
UNSETTLED = "{best} explains the whole recording best{sure}. It is not settled: {otherwise}."
NO_TEST = "{names}{against} {were} fitted to {fitted_to}, {test} of {it}; {adopted}.{measure}"
MEASURE = " Some dimensions moved by three times their tolerance: measure them again before you trust this."
LEAD = ("ambiguous", "unknown")  # verdicts whose word is said of a run that has adopted effects
LEFT_OVER = "{adopted}, and {left} rms stays unexplained, {ratio} times the noise."
NOTHING_NAMED, NOTHING_FURTHER = "no effect can be named", "nothing further can be named"


def headline(content: Verdict, words: Vocabulary) -> str:
    """The verdict in one line."""
    run = ", ".join(holdout.runs(content))
    verdict, adopted = content["verdict"], holdout.included(content)
    fitted = unseen.fitted_times(content, words, named=False) if verdict in UNNAMED else None
    sentence = WITH_ADOPTED[verdict] if adopted and verdict in UNNAMED else SAID[verdict]
    if fitted is not None and fitted > unseen.STILL_MISSING:
        sentence = LEFT_OVER
    elif verdict == "explained" and unseen.partly(content, words):
        sentence = PARTLY
    elif verdict == "parameters" and moved_in_vain(content, words):
        sentence = HARDLY_MOVED
    elif gone_off := excursions.in_short(content, words):
        sentence = f"{gone_off}, which no explanation of the library does{{lacks}}."
    otherwise = _otherwise(content, words) if verdict == "explained" else ""
    if otherwise:
        sentence = UNSETTLED
    evidence, named = content["evidence"], NOTHING_FURTHER if adopted else NOTHING_NAMED
    likely = max((len(adoption["tied"]) for adoption in content.get("adopted", [])), default=0)
    if adopted and likely:
        named = f"{named}; what was adopted is one of {1 + likely} likely explanations"
    fields = {
        "floor": size(amount(content["fit"], f"noise_floor_{words.ending}"), words.unit)
        + (f" rms in {unseen.kinds(content, words)[1]}" if unseen.averaged(content, words) else " rms"),
        "best": holdout.named(content),
        "sure": at_work.how_sure(content),
        "at_work": at_work.sentence(content, words) if verdict == "ambiguous" else "",
        "word": "" if adopted else " (ambiguous)",
        "otherwise": otherwise,
        "lacks": at_work.lacks(content),
        "adopted": named,
        "beside": f"{named}; with {_them(adopted)} " if adopted else "",
        "it": _them(adopted),
        "moved": moved_words.bracketed(content),
        "far": FAR if at_bound(evidence["moved_sigma"]) else "",
        "left": size((amount_or_none(evidence, f"calibrated_{words.ending}") or 0.0), words.unit),
        "ratio": times(fitted or 0.0),
    }
    if kept := kept_times(content, words):
        sentence = AS_ADOPTED
        fields |= {
            "error": size(amount(content["evidence"], f"adopted_{words.ending}"), words.unit),
            "ratio": times(kept),
        }
    warning = unfit(content, words)
    state = NEW if verdict not in (*UNNAMED, "unknown") else MAY_HOLD if fields["far"] and not kept else HOLDS
    state = LEFT if verdict == "unknown" or sentence == LEFT_OVER else state
    seen = state in (HOLDS, MAY_HOLD) and holdout.status(content) in (holdout.SEEN, holdout.PARTLY)
    worse = "" if otherwise else unseen.worse(content, words)
    if seen and not warning:
        fields |= {"names": listing(adopted), "were": "was" if len(adopted) == 1 else "were"}
        fields |= {"fitted_to": holdout.fitted_to(content), "test": _test(content)}
        fields |= {"against": against_advice(content, ",", ","), "measure": MEASURE * (state == MAY_HOLD)}
        return f"{run}: {NO_TEST.format(**fields)}{as_it_stands(content, words)}{worse}"
    about = ": ".join([run, *_lead(content, adopted, UNFIT if warning else state)])
    sentence = f"{slow_look_alikes.unsettled(content, words)}{sentence.format(**fields)}"
    if warning:
        return f"{about}: {warning}. {first_upper(sentence)}{worse}"
    return f"{about}: {sentence}{as_it_stands(content, words)}{worse}"


def still_holds(content: Verdict, words: Vocabulary) -> bool:
    """Whether adopted effects still explain the recording, as the first line says it."""
    if not holdout.included(content) or content["verdict"] not in UNNAMED or unfit(content, words):
        return False
    fitted = unseen.fitted_times(content, words, named=False)
    return bool(kept_times(content, words)) or fitted is None or fitted <= unseen.STILL_MISSING


def _otherwise(content: Verdict, words: Vocabulary) -> str:
    """The remark that another explanation was found without the last strokes, and its error there; else nothing."""
    if not holdout.of_other(content):
        return ""
    other = f"without the {holdout.split(content)} another explanation was found"
    errors = unseen.errors(content, words)
    if errors is None or not unseen.fails_first(content, words):
        return other
    nominal, failed = (size(error, words.unit) for error in (errors[0], errors[2]))
    return f"{other}, which failed on them ({failed} rms; the nominal simulator: {nominal})"


def _test(content: Verdict) -> str:
    """Which of the recordings that adopted effects were fitted to, or were not, test them; before `of them`."""
    if unseen_runs := holdout.held_out_runs(content, seen=False):
        return f"and of the last strokes only those of {listing(unseen_runs)} are a test"
    single = len(holdout.runs(content)) == 1
    if holdout.fitted_runs(content) != holdout.runs(content):
        return "and so to the last strokes, which are no test"
    return "which is no test" if single else "which are no test"


def _them(adopted: list[str]) -> str:
    """The word for adopted effects in a sentence."""
    return "it" if len(adopted) == 1 else "them"


def against_advice(content: Verdict, before: str = "", after: str = "") -> str:
    """That a run adopted effects against the advice of their verdict, to go after their names; nothing if it did not.

    `before` and `after` are the signs that set it apart.
    """
    against, every = holdout.against_advice(content), holdout.included(content)
    if not against:
        return ""
    names = "" if against == every else f"{listing(against)} "
    return f"{before} {names}adopted against {'its' if len(against) == 1 else 'their'} verdict's advice{after}"


def _lead(content: Verdict, adopted: list[str], state: str) -> list[str]:
    """The adopted effects with their `state`; else the verdict's word where nothing is named."""
    verdict = content["verdict"]
    if not adopted:
        return [] if verdict in ("explained", "ambiguous") else [verdict]
    single = len(adopted) == 1
    word = f" ({verdict})" if verdict in LEAD else ""
    were, state = "was" if single else "were", state.format(s="s" if single else "")
    against = f"{were} adopted{' against the advice of their verdict' * bool(holdout.against_advice(content))}"
    return [f"{listing(adopted)} {against} {state}{word}"]


def unfit(content: Verdict, words: Vocabulary) -> str:
    """The warning not to predict with a run.yaml whose adopted effects do not fit its dimensions; else nothing."""
    errors = errors_of_adopted(content, words)
    if errors is None or errors[0] <= WORSE * errors[1]:
        return ""
    now, calibrated = (size(error, words.unit) for error in errors)
    return (
        f"do not predict with run.yaml as it stands: it errs by {now} rms, and by {calibrated} once its dimensions move"
    )


def as_it_stands(content: Verdict, words: Vocabulary) -> str:
    """The error of run.yaml with its adopted effects; nothing where none is adopted."""
    errors = errors_of_adopted(content, words)
    if errors is None:
        return ""
    now, calibrated = (size(error, words.unit) for error in errors)
    return f" run.yaml as it stands errs by {now} rms, calibrated by {calibrated}."


def errors_of_adopted(content: Verdict, words: Vocabulary) -> tuple[float, float] | None:
    """The errors of run.yaml with adopted effects and its own dimensions, nominal and calibrated; else None."""
    if any(adoption.get("dimensions") for adoption in content.get("adopted", [])):
        return None  # run.yaml simulates with these
    nominal, calibrated = (
        amount_or_none(content["evidence"], f"{name}_{words.ending}") for name in ("nominal", "calibrated")
    )
    return (nominal, calibrated) if holdout.included(content) and nominal and calibrated else None
