"""The tests at the rig that tell open effects apart, where no run is sure to do so."""

from ...document.content import Verdict
from ..foretold import expectation
from ..language.explained_words import tells
from ..language.vocabulary import Vocabulary
from ..named import certainty, effect_table
from . import worth

HEADING = "What tells the open effects apart at the rig"


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A line with the test of each open or probable effect, then the test for slow effects."""
    if content["verdict"] not in ("explained", "ambiguous"):
        return []
    numbers = expectation.lines(content, words) if content["verdict"] == "ambiguous" else []
    return [*_open(content, words), *certainty.asks(content, words, open_ones(content, words)), *numbers]


def open_ones(content: Verdict, words: Vocabulary) -> list[str]:
    """The effects that are open or probable, where explanations tie."""
    if content["verdict"] != "ambiguous":
        return []
    sets = [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]
    every = dict.fromkeys(id_ for ids in sets for id_ in sorted(ids))
    probable = effect_table.only_probable(content, words)
    return [id_ for id_ in every if id_ in probable or not all(id_ in ids for ids in sets)]


def _open(content: Verdict, words: Vocabulary) -> list[str]:
    run, tests = (
        content["next_run"],
        [f"{id_}: {tells(id_, words)}." for id_ in open_ones(content, words)],
    )
    tried = "These hold in general. Other loads and speeds were tried in simulation: on this rig they need not tell."
    decided = run is not None and ("parts" not in run or worth.decides(run))
    return [*([] if decided else [tried]), *tests] if tests else []
