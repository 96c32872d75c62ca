"""README and docs/: done in order, no command makes a run that another page has made, and none needs an unmade one."""

import re
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
NAME = r"(nylon-\d{8}-\d\d)"
STRING = re.compile(rf"new_run {NAME} --material nylon --radius-mm (\S+) --length-mm (\S+).*?--string-id (\S+)", re.S)


def test_each_run_of_the_pages_is_made_by_one_command() -> None:
    """Three pages made one run, of strings of two sizes under one name: the second command was refused."""
    text = "\n".join(page.read_text("utf-8") for page in PAGES)
    run_counts = Counter(re.findall(rf"(?:pipeline\.new_run|--run) {NAME}", text))
    assert len(run_counts) >= 7 and max(run_counts.values()) == 1, run_counts
    assert set(re.findall(NAME, text)) == set(run_counts), "what is recorded or asked about was made on a page"
    sizes = {string: {(radius, length) for _, radius, length, other in STRING.findall(text) if other == string}
             for *_, string in STRING.findall(text)}  # fmt: skip
    assert len(sizes) >= 2 and all(len(each) == 1 for each in sizes.values()), sizes
