"""The run that decides between likely explanations, as a step of the page."""

import shlex
from pathlib import Path

from ....ground.command import command
from ...document.content import Verdict
from ...document.expected import NextRun
from ..language import outcomes
from ..language.quantity import listing, quantity
from ..language.vocabulary import Vocabulary
from ..named import effect_table
from . import experiment, parting, recorded_so_far, worth
from .make_sure import DETAILS, RUN
from .technician import every_load, lasting
from .tells import SETTLED

LONG = 80  # letters: a title that is told in the details alone
SETTLE = "To have it proposed, recorded and weighed for you (without a rig at a serial port leave out --port):"


def step(content: Verdict, words: Vocabulary, folders: list[Path], short: bool) -> list[list[str]]:
    """The run that decides between likely explanations, or the remark that no run does.

    `short`: what it is, without what it parts and foretells.
    """
    run = content["next_run"]
    if content["verdict"] != "ambiguous":
        return []
    if not run or "parts" not in run:
        return [[f"No run is proposed that decides between the {1 + len(content['alternatives'])} explanations."]]
    title = experiment.title(run, words)
    which = f"{'It takes ' if len(title) > LONG else f'{title}: '}{lasting(run)} in all{_asks(content, run, words)}."
    where = f"{which} Steps and commands: {f'{DETAILS}, ' * short}{RUN}."
    alone = _alone(words, folders)
    question, others = worth.question(content), "" if short else _not_asked(content, words)
    if worth.decides(run):
        within_a_sentence = question.replace(": ", ", ")
        need = f"If you need to know {within_a_sentence}{others}, make the run that can decide. {where}"
        return [[need, *alone]]
    if worth.raises(run):
        hard = ", the two explanations that are hardest to tell apart" if len(content["alternatives"]) > 1 else ""
        need = f"Only if you need to know {question}{hard}: try the run that tells them apart best{others}."
        parts = parting.some(content)  # then it leaves the two together: what it does part is said first
        need = f"Only if you need to know which is at work: try the run that tells most{others}." if parts else need
        tells = parting.sentence(content) if short and parts else ""
        return [[" ".join(part for part in (need, tells, f"{SETTLED}.", where) if part), *alone]]
    if parting.some(content):
        best = f"Only for that make the best run, which is in {DETAILS} under {RUN}."
        return [[f"No run that was tried decides {question}{others}. {parting.sentence(content)} {best}"]]
    return [[f"Make no other run: none that was tried decides {question}{others}."]]


def to_see_more(content: Verdict, words: Vocabulary, short: bool) -> list[list[str]]:
    """The run that shows more of the mismatch where nothing is named, as a step: what it is and what it shows."""
    run = content["next_run"]
    if not run:
        return []
    title = experiment.title(run, words)
    which = f"{lasting(run)} in all" if len(title) > LONG else f"{title}, {lasting(run)} in all"
    driver = words.follows(run["follows"]) if "follows" in run else ""
    follows = f": it follows {driver} here; see whether it does so in this run as well" if driver else ""
    where = f"Steps and commands: {f'{DETAILS}, ' * short}{RUN}"
    means = [f"   {row}" for row in outcomes.table(run["title"], words)] if short else []
    return [[f"Make the run that shows more of what is missing{follows}. {which}. {where}.", *means]]


def _alone(words: Vocabulary, folders: list[Path]) -> list[str]:
    """The command that makes the run for a person; nothing on a rig that `settle` cannot move."""
    if not words.twisted:
        return []
    return [SETTLE, f"  {command('settle')} {shlex.quote(str(folders[-1]))} --port PORT"]


def _not_asked(content: Verdict, words: Vocabulary) -> str:
    """The remark in brackets that only probable names do not need the run; nothing without such names."""
    probable = effect_table.only_probable(content, words)
    probable = [id_ for id_ in probable if id_ not in worth.differing(content)]
    return f" (it is not there to make the probable {listing(probable)} surer)" if probable else ""


def _asks(content: Verdict, run: NextRun, words: Vocabulary) -> str:
    """The demands of a run on the rig: other loads, other speeds."""
    title = experiment.title(run, words)
    usual = quantity(run["load"], words.load_unit) if run.get("load") else ""
    hung = [load for load in every_load(run, words) if load != usual]
    loads = f"{'other loads' if len(hung) > 1 else 'another load'} ({listing(hung)})" if hung else "another load"
    demands = ["another speed"] * recorded_so_far.asks_speed(content, words) + [loads] * ("load" in title)
    return f"; it asks for {listing(demands)}" if demands else ""
