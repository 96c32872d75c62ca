"""The parts of a page, shortened one after the other until it fits on one printed page; what had no room is kept."""

from collections.abc import Callable

from .brief import FULL, Brief, briefs, longest
from .sections import Sections, text

HEADING = "What had no room in verdict.txt"
LINES = 66  # of a printed page
CUT = "  The rest had no room on this page: details.txt."


def fitted(of: Callable[[Brief], Sections], last: str, last_short: str) -> tuple[str, Sections]:
    """The first text that fits on a page, and its sections; `of` makes the sections as short as it is told.

    `last` ends a page that says all, `last_short` one that does not. What is still too long loses its last lines.
    """

    def printed(brief: Brief) -> tuple[str, Sections]:
        sections = of(brief)
        return text(sections, (last if brief == FULL else last_short, []), brief.tight > 0), sections

    for brief in briefs():
        page, sections = printed(brief)
        if fits(page):
            return printed(longest(brief, lambda longer: fits(printed(longer)[0])))
    while not fits(page := text(_cut(sections), (last_short, []), tight=True)):
        most = max(range(1, len(sections)), key=lambda place: len(sections[place][1]))
        head, lines = sections[most]
        sections = [*sections[:most], (head, lines[:-1]), *sections[most + 1 :]]
    return page, sections


def fits(page: str) -> bool:
    """Whether a text is no longer than a page."""
    return len(page.splitlines()) <= LINES


def _cut(sections: Sections) -> Sections:
    """The sections, with a last line that says that more had no room."""
    head, lines = next(section for section in reversed(sections) if section[1])
    return [(name, [*lines, CUT]) if name == head else (name, own) for name, own in sections]


def without_room(full: Sections, shown: Sections) -> list[str]:
    """The lines of a page in full that a shorter one has not, under their headings."""
    printed = {line.strip() for _, lines in shown for line in lines}
    left = []
    for head, lines in full:
        missing = [line for line in lines if line.strip() not in printed]
        left += [f"{head}:", *(f"  {line}" for line in missing)] if missing else []
    return left


def unsaid(lines: list[str], sections: Sections) -> list[str]:
    """Those of some lines that no section says, and the headings of those."""
    printed = "\n".join(line for _, own in sections for line in own)
    left = [line for line in lines if not line.startswith(" ") or line.strip() not in printed]
    return [line for line, after in zip(left, [*left, ""][1:], strict=True) if " " in (line[:1], after[:1])]
