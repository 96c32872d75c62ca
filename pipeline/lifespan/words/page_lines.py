"""Lines → a text no wider than a page."""

from ...ground.words.wrapped_lines import wrapped

FURTHER = 4  # spaces by which the rest of a wrapped line is indented: a fact of its own is indented by 2 more


def page(lines: str) -> str:
    """A text of which each line is within the width of a page, its rest indented further; commands stay whole."""
    return "\n".join(row for line in lines.splitlines() for row in wrapped(line, further=FURTHER))
