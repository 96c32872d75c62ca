"""The files that a page shows, by their paths: each code block that follows a line with nothing but a path."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def shown(page: str) -> dict[str, str]:
    """Text of each file that a page of the checkout shows, by its path."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return dict(re.findall(r"^`([\w/.-]+)`\n\n```\w+\n(.*?)^```", text, flags=re.M | re.S))
