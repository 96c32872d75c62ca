"""What a proposed run tells apart, for the details: both predictions in a table, how far they are apart, its worth."""

from ...document.content import NextRun, Verdict, proposal
from ...proposal.design import PLAIN, deviations
from ..explanations import probability, rivals
from ..language.quantity import number, percent, place_near, size, times, to_tell
from ..language.table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from . import parting, worth

SETTLED = "In tests such runs settled 33 of 50 ties rightly, 2 wrongly."
NO_OTHER = "no other run that was tried in simulation does better"


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The two explanations that the run tells apart with what each predicts, then what that is worth."""
    run = proposal(content)
    if "parts" not in run:
        purpose = worth.purpose(content, words)
        return [purpose] if purpose else []
    count = min(worth.COMPARED, 1 + len(content["alternatives"]))
    which = f"These are the closest two of the {count} likeliest explanations." if count > 2 else ""
    said = (parting.sentence(content), f"{which}{worth.aside(content)}".strip(), *_worth(run, words))
    without = f"Without it {worth.otherwise(content, words)}."
    return [*aligned(_rows(content, run, words)), " ".join(part for part in (*said, without) if part)]


def in_short(content: Verdict, words: Vocabulary) -> str:
    """The same in one line, of a run that decides nothing."""
    run = proposal(content)
    one, other = (worth.probable(ids, content) for ids in run["parts"])
    said = (f"It is to tell {one} from {other}.", parting.sentence(content), *_worth(run, words))
    return " ".join(part for part in said if part)


def _worth(run: NextRun, words: Vocabulary) -> list[str]:
    """How far both predictions are apart, and what that is worth."""
    return [_apart(run, words), f"{_decides(run)} {SETTLED}"]


def _rows(content: Verdict, run: NextRun, words: Vocabulary) -> list[list[str]]:
    """The table's cells: an explanation, its probability if it has one, and its reading where both differ the most."""
    known, rows = run.get("apart"), []
    for ids, which in zip(run["parts"], ("first", "second"), strict=True):
        cells = [rivals.called(ids)]
        if probability.known(content):
            share = worth.share(ids, content)
            cells.append(UNKNOWN if share is None else percent(share))
        if known:
            cells.append(to_tell(known[f"{which}_{words.ending}"], known[f"by_{words.ending}"], words.unit))
        rows.append(cells)
    head = ["it is to tell apart", *(["probability"] if probability.known(content) else [])]
    if known:
        low, high = content["evidence"][words.driver]
        near = place_near(known[words.driver], words.motion_unit, high - low)
        head.append(f"reading in it, near {near}")
    return [head, *rows]


def _apart(run: NextRun, words: Vocabulary) -> str:
    """How far both predictions are apart: where they differ the most, and over all samples, so far and with the run."""
    now, then = (number(deviations(run[gap])) for gap in ("gap_now", "gap_then"))
    over = f"{then} standard deviations of noise over the run, {now} over this recording"
    if "apart" not in run:
        return f"The two readings differ by {over}."
    most = size(run["apart"][f"by_{words.ending}"], words.unit)
    return f"The two readings differ by up to {most} if the run follows this one at once, {over}."


def _decides(run: NextRun) -> str:
    """Whether the run can decide, and why this recording does not."""
    now, then = deviations(run["gap_now"]), deviations(run["gap_then"])
    wrong = "A formula that is wrong by 10 % could make as much, so this recording does not decide"
    if worth.decides(run):
        if now <= PLAIN:
            return "So the run can decide."
        return f"{wrong}; to make what the run shows it would have to be wrong by {times(then / now)} times as much."
    who = "a formula that is wrong by a few per cent" if then > PLAIN else "noise alone"
    other = "" if worth.raises(run) else f"; {NO_OTHER}"
    if now > PLAIN:
        return f"{wrong}, and the run need not either{other}."
    return f"The run need not decide, for {who} can make as much{other}."
