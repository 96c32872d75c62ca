"""Whether adopting the named effects is advised: the same sentence on the page and in the details."""

from ....ground.command import program_name
from ....ground.words.verdict_text import MAY_ADOPT as MAY
from ...document.content import Verdict
from ...document.made_keys import amount, interval
from ..held_out import holdout, in_vain, unseen
from ..language.quantity import listing, size
from ..language.vocabulary import Vocabulary
from ..measured.dimensions import far_moved, name_of
from ..named import own_size
from ..next_run.run_asked import more_strokes
from . import for_a_paper

NOTHING_NAMED = "Adopt nothing: no effect of the library is named."
UNTRIED = "how much it errs on unseen strokes is not known"


def worse(content: Verdict) -> str:
    """The advice if the named effects make the simulator worse on strokes that no fit has seen."""
    if holdout.other_name(content):
        last = f"when the {holdout.split(content)} are left out"
        return f"Adopt nothing: the names change {last}, so none is proved."
    return f"Adopt nothing: on the {holdout.strokes(content)} the explanation makes the simulator worse."


def nothing_named(content: Verdict) -> str:
    """The advice if no effect is named, with the simulator that predicts the rig meanwhile, if there is one."""
    if "closest" not in content:
        return NOTHING_NAMED
    ids = content["closest"]["ids"]
    comes = "come" if len(ids) > 1 else "comes"
    curve = f"{program_name('simulate')} uses {' + '.join(ids)}, which {comes} closest, as a curve"
    return f"{NOTHING_NAMED} {curve}: it predicts motions like those recorded, and explains nothing."


def against(content: Verdict, words: Vocabulary) -> str:
    """The advice to adopt nothing, where it applies; else nothing."""
    if content["verdict"] == "unknown":
        return nothing_named(content)
    return worse(content) if in_vain.harmful(content, words) else ""


def of_adopting(content: Verdict, words: Vocabulary) -> str:
    """The advice on adopting, from the statements on the page; it decides nothing anew."""
    if in_vain.harmful(content, words):
        return worse(content)
    if "explained" in content["fit"].get("worse_than_nominal", []):
        which = holdout.simulator(content) if holdout.other_name(content) else "with it"
        strokes = holdout.strokes(content)
        return f"Do not adopt this: on the {strokes} the simulator {which} is worse than the nominal one."
    far = [f"the {name_of(name)}" for name in far_moved(content)]
    if far:
        return f"Do not adopt before {listing(far)} {'is' if len(far) == 1 else 'are'} measured again."
    if in_vain.improves_nothing(content, words):
        tried = holdout.other_name(content) != holdout.NO_EFFECT
        gains = "Adopting gains nothing" if tried else "Nothing shows that adopting gains anything"
        return f"{gains}: {in_vain.said(content, words)}."
    reportable = for_a_paper.own_sizes(content, words)
    sizes = (
        f"; report no size but that of {_called(reportable, content, words)} (details.txt, TO REPORT)"
        if reportable
        else f"; do not report {_sizes(content, words)}"
    )
    sizes = "" if len(reportable) == len(content["mechanisms"]) else sizes
    other = ", though another explanation may be the right one" if content["verdict"] == "ambiguous" else ""
    return f"{MAY} this to predict motions like the recorded ones{_errs(content, words)}{other}{sizes}."


def _errs(content: Verdict, words: Vocabulary) -> str:
    """The error to expect of a prediction, if it exceeds the noise or is unknown; ends a phrase."""
    unseen_errors, large = unseen.errors(content, words), unseen.partly(content, words)
    if other := holdout.of_other(content):
        erred = f"; {other} erred by {size(unseen_errors[2], words.unit)} rms" if unseen_errors and large else ""
        return f" ({UNTRIED}{erred})"
    if unseen_errors is None or not large or holdout.other_name(content) == holdout.NO_EFFECT:
        return ""
    return f" (expect errors of about {size(unseen_errors[2], words.unit)} rms)"


def _sizes(content: Verdict, words: Vocabulary) -> str:
    """The sizes that are not to be reported; for a single effect, with the reason."""
    if len(content["mechanisms"]) > 1 or not content["mismatch"]:
        return "its sizes"
    (entry,), missing = content["mechanisms"], amount(content["mismatch"], f"rms_{words.ending}")
    own = interval(entry, f"rms_{words.ending}")["value"]
    if own <= missing:
        return "its size: it is poorly known"
    sizes = f"{size(own, words.unit)} is more than the {size(missing, words.unit)} that is missing"
    return f"its size: {sizes}, so moved dimensions take a part of it back"


def _called(reportable: list[str], content: Verdict, words: Vocabulary) -> str:
    """The effects whose sizes can be reported, with the place of these sizes if they are only a part."""
    own_part_by_id = {entry["id"]: own_size.own_part(entry, content, words) for entry in content["mechanisms"]}
    return listing([f"{id_}{' in the last column' if own_part_by_id[id_] else ''}" for id_ in reportable])


def lets(content: Verdict, words: Vocabulary) -> bool:
    """Whether a verdict with named effects allows adopting them."""
    return of_adopting(content, words).startswith(MAY)


def contrary(content: Verdict, words: Vocabulary) -> str:
    """The advice that adopting would go against; nothing if it allows adopting, or a file tells too little."""
    try:
        whether = of_adopting(content, words) if content["verdict"] in ("explained", "ambiguous") else MAY
    except (LookupError, TypeError, ValueError, AttributeError):  # a file without evidence gives no advice
        return ""
    return "" if whether.startswith(MAY) else whether


def instead(content: Verdict, words: Vocabulary) -> list[str]:
    """As `contrary`, with the recording that the verdict asks for instead: a run keeps both."""
    whether = contrary(content, words)
    asks = [more_strokes(content, words)] if whether and in_vain.harmful(content, words) else []
    return [whether, *asks] if whether else []
