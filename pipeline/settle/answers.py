"""A person's answers given outside the terminal, as files in the loop's folder: approve a run, or stop everything.

An approval names the question that the loop asks at that moment: one of an earlier question, or of an earlier start of
the program, moves nothing.
"""

import json
import secrets
import time
from contextlib import suppress
from pathlib import Path
from typing import TypedDict, cast

from ..ground.stored.files import write_text

QUESTION, APPROVED, STOP = "question.json", "approved.json", "stop"
LOOKS_S = 0.1


class Question(TypedDict):
    """A question of the loop, as its file has it: the step's number, and a text that no other question has."""

    step: int
    question: str


class Answers:
    """The files in the folder of one loop."""

    def __init__(self, out: Path) -> None:
        self.out = out

    def begin(self) -> None:
        """Forget the answers to an earlier start of the loop."""
        for name in (STOP, QUESTION, APPROVED):
            (self.out / name).unlink(missing_ok=True)

    def stopped(self) -> bool:
        """Whether somebody has said stop."""
        return (self.out / STOP).exists()

    def approved(self, number: int) -> bool:
        """Ask whether a step's run is to be made, and wait; False where somebody says stop."""
        question: Question = {"step": number, "question": secrets.token_hex(16)}
        write_text(self.out / QUESTION, json.dumps(question) + "\n")
        try:
            while not self.stopped():
                if _read(self.out / APPROVED) == question:
                    return True
                time.sleep(LOOKS_S)
            return False
        finally:
            for name in (QUESTION, APPROVED):
                (self.out / name).unlink(missing_ok=True)

    def question(self) -> Question | None:
        """What the loop asks now, or None."""
        return _read(self.out / QUESTION)

    def approve(self, question: str) -> bool:
        """Say yes; returns False if this is not the loop's present question."""
        pending = self.question()
        if pending is None or pending["question"] != question:
            return False
        write_text(self.out / APPROVED, json.dumps(pending) + "\n")
        return True

    def stop(self) -> None:
        """Say stop: the motor first, then the loop."""
        write_text(self.out / STOP, "somebody said stop\n")


def _read(path: Path) -> Question | None:
    with suppress(OSError, ValueError, RecursionError):
        content = json.loads(path.read_text(encoding="utf-8"))
        if isinstance(content, dict) and isinstance(content.get("question"), str):
            return cast(Question, content) if isinstance(content.get("step"), int) else None
    return None
