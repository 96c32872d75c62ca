"""The explanations that a proposed run tells apart, for the details: predictions, their distance, its worth."""

from ...document.content import Verdict, proposal
from ...document.expected import NextRun
from ...document.made_keys import amount, extent
from ...proposal.design import PLAIN, deviations
from ..explanations import probability, rivals
from ..language import outcomes
from ..language.quantity import duration, first_upper, number, percent, place_near, quantity, size, to_tell
from ..language.text_table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from . import parting, worth
from .technician import legs_of

SETTLED = first_upper(worth.TESTED)
STANDS = 0.005  # of a place: who moves by less stands
NO_OTHER = "no other run that was tried in simulation does better"


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The two explanations that the run tells apart with what each predicts, then what that is worth."""
    run = proposal(content)
    if "parts" not in run:
        purpose = worth.purpose(content, words)
        return [purpose, *outcomes.table(run["title"], words)] if purpose else []
    more = f"Noise is not all that counts: {worth.TESTED}."
    without = f"Without the run {worth.otherwise(content, words)}."
    sentences = (_taken(run, words), parting.sentence(content), _closest(content), _decides(run), more, without)
    return [*aligned(_rows(content, run, words)), " ".join(part for part in sentences if part)]


def in_short(content: Verdict, words: Vocabulary) -> str:
    """The same in one line, of a run that decides nothing."""
    run = proposal(content)
    name, other = (worth.probable(ids, content) for ids in run["parts"])
    sentences = (f"It is to tell {name} from {other}.", parting.sentence(content), _decides(run), f"{SETTLED}.")
    return " ".join(part for part in sentences if part)


def _taken(run: NextRun, words: Vocabulary) -> str:
    """The step in which the predictions differ most, where the reading is taken; nothing where a file lacks it."""
    after_s, place = (run.get("apart") or {}).get("after_s", 0.0), run["legs"][0][words.driver]
    if after_s <= 0.0:
        return ""
    for leg in legs_of(run):
        to, after_s = leg[words.driver], after_s - float(leg["seconds"])
        if after_s <= 0.0:
            stands = abs(to - place) <= STANDS * max(abs(to), abs(place))
            where = quantity(to, words.motion_unit)
            return f"The reading is taken {f'while it stands at {where}' if stands else f'on the way to {where}'}."
        place = to
    return ""


def _closest(content: Verdict) -> str:
    """The two explanations that the run was chosen for, and whether the best one is among them."""
    count = min(worth.COMPARED, 1 + len(content["alternatives"]))
    which = [f"the two of the table are the closest of the {count} likeliest explanations"] if count > 2 else []
    best = ["the best one differs from both by at least as much"] if worth.aside(content) else []
    return f"{first_upper('; '.join([*which, *best]))}." if which or best else ""


def _rows(content: Verdict, run: NextRun, words: Vocabulary) -> list[list[str]]:
    """The table's cells: an explanation, its probability if it has one, and its reading where both differ the most."""
    readings_apart, rows = run.get("apart"), []
    ends = [f"{which}_{words.ending}" for which in ("first", "second")]
    both = (
        to_tell([amount(readings_apart, end) for end in ends], amount(readings_apart, f"by_{words.ending}"), words.unit)
        if readings_apart
        else ["", ""]
    )
    likelier = sorted(
        zip(run["parts"], both, strict=True), key=lambda pair: worth.share(pair[0], content) or 0.0, reverse=True
    )
    for ids, reading in likelier:
        cells = [rivals.called(ids)]
        if probability.known(content):
            share = worth.share(ids, content)
            cells.append(UNKNOWN if share is None else percent(share))
        if readings_apart:
            cells.append(reading)
        rows.append(cells)
    head = ["it is to tell apart", *(["probability"] if probability.known(content) else [])]
    if readings_apart:
        low, high = extent(content["evidence"], words.driver)
        near = place_near(amount(readings_apart, words.driver), words.motion_unit, high - low)
        after_s = readings_apart.get("after_s", 0.0)
        when = f"after {duration(after_s)}" if after_s > 0.0 else "in it"  # an older file does not say it
        head.append(f"reading {when}, {words.motion} near {near}")
        apart = size(amount(readings_apart, f"by_{words.ending}"), words.unit)
        rows.append(["their difference, if the run follows this one at once", *[UNKNOWN] * (len(head) - 2), apart])
    return [head, *rows]


def _decides(run: NextRun) -> str:
    """The distance of both predictions over all samples, now and with the run, and whether it decides."""
    now, then = deviations(run["gap_now"]), deviations(run["gap_then"])
    over = f"{number(then)} standard deviations of noise in the run, by {number(now)} in this recording"
    apart = f"over all samples they differ by {over}"
    wrong = "for a formula that is wrong by 10 % could make as much"
    if worth.decides(run):
        if now <= PLAIN:
            return f"The run can decide between these two: {apart}."
        more = f"In the run it would have to be wrong by {number(10.0 * then / now)} % for that."
        return f"The run can decide between these two. This recording does not, {wrong}. {more}"
    other = "" if worth.raises(run) else f"; {NO_OTHER}"
    if now > PLAIN:
        return f"This recording does not decide, and the run need not either, {wrong}: {apart}{other}."
    who = "a formula that is wrong by a few per cent" if then > PLAIN else "noise alone"
    return f"The run need not decide, for {who} can make as much: {apart}{other}."
