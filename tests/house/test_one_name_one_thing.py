"""No two modules of one name mean different things: who reads a name knows which thing it is."""

from collections import defaultdict
from pathlib import Path

PIPELINE = Path(__file__).parents[2] / "pipeline"
STRANGERS = PIPELINE / "rig" / "authors"  # by other hands, each in words of its own; never installed
ROLES = {"__init__", "__main__", "interface", "plan", "page", "figures", "results", "written"}  # of whichever room
# where one thing is made, and where another room conceals, exports, writes or tells that same thing
PAIRS = [
    ("diagnosis/mechanisms", "rig/effects"), ("models", "export/exporters"), ("systems", "rig/others"),
    ("proof/baselines", "real/black_boxes"), ("models", "real/black_boxes"), ("stages", "stages/campaign"),
    ("stages", "report"), ("run", "report"), ("proof", "real"), ("proof", "report"),
    ("notebook", "report"), ("ground", "report"), ("report", "report"), ("diagnosis", "diagnosis"),
    ("run", "diagnosis/words"), ("diagnosis", "stages/campaign"), ("", "rig"), ("", "diagnosis/fit"), ("run", "rig"),
    ("export/exporters", "real/black_boxes"),
]  # fmt: skip


def test_a_name_that_two_rooms_use_is_one_thing() -> None:
    by_name = defaultdict(list)
    for path in PIPELINE.rglob("*.py"):
        if not path.is_relative_to(STRANGERS) and path.stem not in ROLES:
            by_name[path.stem].append(path.relative_to(PIPELINE).parent.as_posix().removeprefix("."))
    several = {name: sorted(rooms) for name, rooms in by_name.items() if len(rooms) > 1}

    def alike(rooms: list[str]) -> bool:
        pairs = [(first, second) for number, first in enumerate(rooms) for second in rooms[number + 1 :]]
        return all(any((_in(a, x) and _in(b, y)) or (_in(a, y) and _in(b, x)) for x, y in PAIRS) for a, b in pairs)

    assert {name for name, rooms in several.items() if not alike(rooms)} == set()


def _in(folder: str, room: str) -> bool:
    return folder == room or (bool(room) and folder.startswith(f"{room}/"))
