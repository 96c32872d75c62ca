"""The table of the weighed explanations, a numbered row each, the best one first; then remarks that no row can hold."""

from ...document.content import Verdict
from ...document.explanations import ExplanationEntry, share_of
from ...document.made_keys import amount, amount_or_none
from ...mechanisms.interface import physics
from ..language.quantity import of_column, percent, size, times
from ..language.text_table import UNKNOWN, within
from ..language.vocabulary import Vocabulary
from . import chances, closest, less_likely, not_named, probability, rivals

SHOWN = 8  # of those that are not kept
LEAST = 1e-6  # what a probability of nothing is said as: less than 1 %
NO_LESS, NOTHING = "as much as no effect", "nothing"
ROUNDED = 1e-9  # noise floors: a smaller difference is one of the last digits of a float


def heading(content: Verdict) -> str:
    """The question that the table answers: with probabilities where they are known."""
    return chances.HEADING if probability.known(content) else chances.BARE


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The table and what must be known to read it; nothing where nothing is named."""
    named = rivals.entries(content, "named")
    if not named or content["verdict"] not in ("explained", "ambiguous"):
        return []
    has_probabilities = probability.known(content)
    kept = [*named, *probability.likeliest(rivals.entries(content, "tied"))]
    rows = numbered(content)
    return [
        *within(_rows(content, rows, words), 0),
        *(
            [f"Kept: {less_likely.numbers(list(rows)[: len(kept)])}.{_though(rows)}"]
            if len(kept) > 1 and not has_probabilities
            else []
        ),
        *closest.stand_ins([each["ids"] for each in rows.values()]),
        *probability.rule(content),
        *less_likely.remarks(content, rows, len(kept), words),
        *not_named.lines(content),
    ]


def _though(rows: less_likely.Numbered) -> str:
    """Why effects of the best explanation are kept though they leave more; nothing where none do."""
    parts = [number for number, each in rows.items() if each["standing"] == "tied" and _within(each, rows[1])]
    if not parts:
        return ""
    are, them = ("are", "them") if len(parts) > 1 else ("is", "it")
    return (
        f" {less_likely.numbers(parts)} {are} kept though 1 leaves less: what 1 adds to {them} may only mend a formula."
    )


def _within(smaller: ExplanationEntry, larger: ExplanationEntry) -> bool:
    """Whether an explanation is a part of a larger one."""
    return set(smaller["ids"]) < set(larger["ids"])


def numbered(content: Verdict) -> less_likely.Numbered:
    """The rows of the table by their numbers, the kept ones first."""
    kept = [*rivals.entries(content, "named"), *probability.likeliest(rivals.entries(content, "tied"))]
    return dict(enumerate([*kept, *others_shown(content)], start=1))


def others_shown(content: Verdict) -> list[ExplanationEntry]:
    """The explanations that are shown without being kept, the likeliest first, in table and figure."""
    others = probability.likeliest([*rivals.entries(content, "beaten"), *rivals.entries(content, "not needed")])
    return others[:SHOWN]


def _rows(content: Verdict, rows: less_likely.Numbered, words: Vocabulary) -> list[list[str]]:
    """The table's cells, the heads first; with probabilities, the last rows are for all explanations without a row."""
    has_probabilities, floor = probability.known(content), amount(content["evidence"], f"floor_{words.ending}")
    cells = [[_name("no.", "explanation"), "probability", "leaves (× noise)", "rms apart from no. 1"]]
    out = [entry["ids"] for entry in not_named.entries(content)]
    none_acts = rivals.entries(content, "nothing")
    most = max(rivals.left_of(each, content, words.ending) for each in [*rows.values(), *none_acts])
    farthest = max(amount_or_none(each, f"gap_{words.ending}") or 0.0 for each in rows.values())
    for number, each in rows.items():
        left_rms, share = rivals.left_of(each, content, words.ending), each.get("probability")
        gap, no_less = amount_or_none(each, f"gap_{words.ending}"), rivals.no_less(each, content, words)
        leaves = NO_LESS if no_less else f"{of_column(left_rms, words.unit, most)} ({times(left_rms / floor)})"
        probable = UNKNOWN if share is None else percent(share or LEAST)
        differs = of_column(gap, words.unit, farthest) if gap is not None and number > 1 else UNKNOWN
        differs = NOTHING if number > 1 and gap is not None and gap < ROUNDED * floor else differs
        called = rivals.called(each["ids"]) + ", left out" * (each["ids"] in out)
        cells.append([_name(str(number), called), probable, leaves, differs])
    if has_probabilities:
        none = content["evidence"].get("probability_of_none") or 0.0
        of_library = [share_of(each) for each in rows.values() if physics(tuple(each["ids"]))]
        stand_ins = probability.stand_ins([each["ids"] for each in rows.values()])
        rest = max(1.0 - none - sum(of_library), 0.0)
        cells.append([_name(UNKNOWN, "all others of the library"), percent(rest), UNKNOWN, UNKNOWN])
        cells.append([_name(UNKNOWN, f"{chances.NONE}{stand_ins}"), percent(none), UNKNOWN, UNKNOWN])
    for alone in none_acts:
        left_rms = rivals.left_of(alone, content, words.ending)
        leaves = f"{size(left_rms, words.unit)} ({times(left_rms / floor)})"
        cells.append([_name(UNKNOWN, rivals.called([])), UNKNOWN, leaves, UNKNOWN])
    return cells if has_probabilities else [[row[0], *row[2:]] for row in cells]


def _name(number: str, name: str) -> str:
    return f"{number:<3}  {name}"
