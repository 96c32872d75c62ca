"""Nothing moves without approval: by a person who is asked, or by limits given in advance."""

import sys

from ..ground.command import command
from ..ground.errors import BadInput
from .answers import Answers
from .choose import apart
from .motion_table import begins, lines, size
from .step import Place, Step
from .tie import tie

WAYS = ("ask", "auto", "page")
YES, NO = ("y", "yes"), ("n", "no")
QUESTION = "Make this run? The motor moves at once. Type yes or no: "
AGAIN = "That is neither yes nor no. Make this run? Type yes, or anything else to leave it: "
UNATTENDED = ("auto", "page")  # nobody need stand at the terminal, so nothing moves without limits


def told(step: Step, place: Place) -> str:
    """A proposed run: what it is for, what moves in it, and where it is drawn."""
    if not step.legs:
        return f"step {step.number}: proposed: {step.proposal['title']}"
    drawn = f"drawn before it is made: {place.folder(step.number) / 'proposed.png'}"
    below = [*tie(step, place), *filter(None, [apart(step.proposal)]), begins(step), *lines(step), drawn]
    return "\n  ".join([f"step {step.number}: proposed: {step.proposal['title']} ({size(step)})", *below])


def approved(step: Step, way: str, answers: Answers) -> Step | None:
    """The step, approved, or None where the person says no; raises BadInput where nobody can be asked."""
    if way == "auto":
        return step.at("approved", approved_by="--approve auto, within --limits")
    if way == "page":
        print(f"  waiting for somebody to approve it on the page of {command('watch')}", flush=True)
        return step.at("approved", approved_by="a person, on the page") if answers.approved(step.number) else None
    if sys.stdin is None or not sys.stdin.isatty():
        mend = "start it in a terminal, or give --approve auto or page with --limits"
        raise BadInput("--approve", "ask", "there is no terminal in which to ask; nothing was moved", mend)
    return step.at("approved", approved_by="a person, asked") if _yes() else None


def _yes() -> bool:
    """Whether the person says yes; an answer other than yes or no is asked for once more, and then counts as no."""
    for question in (QUESTION, AGAIN):
        answer = input(question).strip().lower()
        if answer in YES or answer in NO:
            return answer in YES
    return False
