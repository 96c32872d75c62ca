"""No two modules of one name mean different things: who reads a name knows which thing it is."""

from collections import defaultdict
from pathlib import Path

PIPELINE = Path(__file__).parents[2] / "pipeline"
STRANGERS = PIPELINE / "rig" / "authors"  # by other hands, each in words of its own; never installed
# rooms that hold one module for each thing of a kind: a law, a model, a rig
KINDS = [
    {"diagnosis/mechanisms", "rig/effects"},
    {"models", "export/exporters", "proof/baselines", "real/black_boxes"},
    {"systems", "rig/others"},
]
# other names that stand more than once, by what is one in them; packages count, by their own names
ALIKE = {
    "what every module of this name is in its room: the form, the page, the figures, what they stand on": {
        "__main__", "interface", "page", "figures", "results", "index", "arguments", "written", "words",
        "parts",
    },
    "a thing, and the room, the program or the page of that same thing": {
        "adopt", "adoption", "campaign", "coverage", "dataset", "diagnosed", "diagnosis", "drawing", "floor",
        "glossary", "leak", "left_out", "models", "points", "proof", "real", "recorded_error", "recording", "score",
        "settle", "signature", "spikes", "verdict", "verdicts",
    },
    "a finding of the diagnosis: where it is made, the form in which it is kept, the words for it": {
        "another_rig", "closest", "dimensions", "evidence", "excursions", "expected", "explanations", "foretold",
        "held_out", "planned_motion", "planned_zero", "prediction", "residual", "rivals", "stand_ins",
    },
}  # fmt: skip


def places() -> dict[str, list[str]]:
    """The rooms that have a module or package of a name, by the names that stand more than once."""
    rooms = defaultdict(list)
    for path in PIPELINE.rglob("*.py"):
        thing = path.parent if path.stem == "__init__" else path
        if not path.is_relative_to(STRANGERS) and thing != PIPELINE:
            rooms[thing.stem].append(thing.relative_to(PIPELINE).parent.as_posix())
    return {name: sorted(where) for name, where in rooms.items() if len(where) > 1}


def test_a_name_that_stands_more_than_once_is_one_thing() -> None:
    listed = set().union(*ALIKE.values())
    several = {name for name, where in places().items() if not any(set(where) <= kind for kind in KINDS)}
    assert several - listed == set(), "rename the younger one, or say under which reason it is the same thing"
    assert listed - several == set(), "stands once: take it off the list"
