"""How short each part of the page is said: in full while all fits, then shorter, part after part, in one order."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Brief:
    """Of each part of the page 0: in full; 1 and more: shorter. What goes stands in details.txt."""

    doubts: int = 0
    effects: int = 0
    chances: int = 0
    measure: int = 0
    run: int = 0
    sure: int = 0
    use: int = 0
    report: int = 0
    tight: int = 0


FULL = Brief()
ORDER = (
    {"chances": 1, "run": 1},  # what details.txt tells anyway, or the page elsewhere
    {"effects": 1},
    {"sure": 1},
    {"report": 1, "measure": 1},
    {"tight": 1},
    {"use": 1},
    {"sure": 2},
    {"effects": 2},
    {"doubts": 1},
    {"run": 2},
    {"sure": 3},
    {"report": 2},
    {"effects": 3},
    {"chances": 2},
    {"effects": 4},
    {"measure": 2},
    {"doubts": 2},
    {"measure": 3, "use": 2},
    {"sure": 4},
)


def briefs() -> Iterator[Brief]:
    """The page in full, then each time one part of it shorter."""
    brief = FULL
    yield brief
    for shorter in ORDER:
        brief = replace(brief, **shorter)
        yield brief


def longest(brief: Brief, fits: Callable[[Brief], bool]) -> Brief:
    """A page that fits, with what still has room in it said in full again, what went last first."""
    for shorter in reversed(ORDER):
        longer = replace(brief, **{part: level - 1 for part, level in shorter.items() if getattr(brief, part) == level})
        if longer != brief and fits(longer):
            brief = longer
    return brief


def first_sentence(line: str) -> str:
    """A line without what follows its first sentence."""
    head, stop, _ = line.partition(". ")
    return f"{head}{stop.rstrip()}"
