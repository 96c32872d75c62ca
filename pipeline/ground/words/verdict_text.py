"""The parts of a `verdict.txt` that programs read: its first words with their warnings, and the next steps."""

import re

MOST = 2000  # letters that are shown of its first words
TO_DO = "What to do"  # begins the heading under which it says it
STEP = re.compile(r"^  \d+\. ", re.M)
MAY_ADOPT = "You may adopt"  # begins the sentence of a verdict that lets a person adopt what it names
RECORD = re.compile(r"\brecord\b(?! FILE)", re.I)


def headline(text: str) -> str:
    """The words up to the first empty line, on one line; empty where it has none."""
    return " ".join(text.partition("\n\n")[0].split())[:MOST]


def to_do(text: str) -> str:
    """The lines under `TO_DO`, without their heading; empty where it has no such part."""
    return text.partition(f"\n{TO_DO}")[2].partition("\n\n")[0].partition("\n")[2]


def record_asked(text: str) -> str:
    """The step that asks for another recording, on one line, up to its first sentence; empty where there is none."""
    steps = [" ".join(step.split()) for step in STEP.split(to_do(text))]
    asking = next((step for step in steps if RECORD.search(step)), "")
    return re.split(r"(?<=[.]) (?=[A-Z])", asking)[0].rstrip(".")
