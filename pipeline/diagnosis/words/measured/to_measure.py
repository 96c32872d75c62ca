"""The dimensions to measure again: their values in run.yaml, the best fits, how to measure, and the next steps."""

from ...document.bounds import of_later_run
from ...document.content import Verdict
from ...mechanisms.library import mechanisms
from ..language.quantity import listing
from ..language.text_table import IN_A_STEP, ROOM, aligned
from ..language.vocabulary import Vocabulary
from . import change, exactness, tolerances
from .dimensions import far_moved, from_to, name_of, whence
from .in_run_yaml import tolerance_keys
from .tolerances import stem

HEAD = ["dimension", "run.yaml says", "tolerance", "fits best", "measure to"]
FIRST = 4  # of them, on the page
HOW = "How each is measured: details.txt."
DETAILS = "details.txt"
UNEVEN = (  # the middle of such a loop is no zero
    "{} that is stronger in winding than in unwinding moves the zero of the motor as well. Where that zero is sure, "
    "write so (`tolerance: {{angle_turns: 0.01}}`), and diagnose again."
)
BESIDE = 2.0  # sigma: one that moved so far is measured too where another must be, for they take each other's place


def to_measure(content: Verdict) -> list[str]:
    """The dimensions to measure again, the farthest first; none where none moved far."""
    moved = content["evidence"]["moved_sigma"] if far_moved(content) else {}
    names = [name for name in moved if name in content["parameters"] and not of_later_run(name)]
    again = [name for name in names if abs(moved[name]) >= BESIDE]
    return sorted(again, key=lambda name: -abs(moved[name]))


def table(content: Verdict, words: Vocabulary, short: bool) -> list[str]:
    """Each dimension to measure again, with how to measure it below; `short`: only the first ones, without that."""
    names, rows = to_measure(content), []
    more = len(names) - FIRST if short else 0
    names = names[:FIRST] if more > 0 else names
    for name in names:
        nominal, value = from_to(content, name)
        in_run_yaml = f"{nominal} ({whence(content, name)})" if exactness.assumed(name) else nominal
        tolerance = tolerances.marked(content, name, words) or "–"
        rows.append([name_of(name), in_run_yaml, tolerance, value, exactness.cell(content, name)])
    head, *lines = _with_percents(content, names, rows)
    measured = [head]
    for name, line in zip(names, lines, strict=True):
        how = words.measured.get(stem(name))
        measured += [line, *([f"    {how}"] if how and not short else [])]
    if short:
        rest = [f"And {more} more dimensions: {DETAILS}."] if more > 0 else []
        how = f"{HOW}{exactness.look_for(content, {name: name_of(name) for name in names})}"
        return [*measured, *rest, how, *_together(content, names)]
    return [
        *measured,
        *exactness.mistakes(content, {name: name_of(name) for name in names}),
        *_together(content, names),
    ]


def _with_percents(content: Verdict, names: list[str], rows: list[list[str]]) -> list[str]:
    """The lines of the table, with the per cent between old and best value where there is room."""
    percents = [change.in_brackets(content, name) for name in names]
    wider = [[*row[:3], f"{row[3]}{percent}", *row[4:]] for row, percent in zip(rows, percents, strict=True)]
    room = ROOM - IN_A_STEP
    lines = aligned([HEAD, *wider], room)
    return lines if max(map(len, lines)) <= room else aligned([HEAD, *rows], room)


def _together(content: Verdict, names: list[str]) -> list[str]:
    """The dimensions to measure together, since they replace each other in the fit."""
    return [
        f"Measure the {name_of(first)} and the {name_of(second)} in one go: they take each other's place in the fit "
        f"(correlation {share:.2f}), so that one of them alone settles little."
        for first, second, share in exactness.trading(content, names)
    ]


def consequences(content: Verdict, then: str, short: bool) -> list[str]:
    """What to do after measuring; `then` is for the case that nothing changed; `short`: as one sentence."""
    moved = to_measure(content)
    where = ", ".join(f"{key}: …" for key in tolerance_keys(moved))
    exact = f"- if the same, known better than its tolerance: say how well (`tolerance: {{{where}}}`)"
    scaled = any(stem(name) == "scale" for name in moved)
    gain = " (a gain as `scale`, its inverse: details.txt, Dimensions)" if scaled else ""
    library = mechanisms()
    named = [entry["id"] for entry in content["mechanisms"] if entry["id"] in library]
    loops = [id_ for id_ in named if library[id_].driver.startswith("direction")]
    uneven = [UNEVEN.format(listing(loops))] if loops and "angle_turns" in moved else []
    if short:
        return [
            *uneven,
            f"Write what you measured, or how well, into run.yaml and diagnose again (how: {DETAILS}). If nothing "
            f"changes, {then}.",
        ]
    return [
        *uneven,
        f"- If you find another value: write it into run.yaml{gain}, and diagnose again;",
        *([f"{exact} and diagnose again;"] if where else []),
        f"- if the same, no better known: {then}. The percentages do not hold where other physics moved it.",
    ]
