"""What run.yaml has adopted, and whether it has seen the strokes that are held out: then no word calls them unseen."""

from typing import Any

SPLIT = "last 30 % of strokes"
UNSEEN, SEEN, PERHAPS = "unseen", "seen", "perhaps"


def included(content: dict[str, Any]) -> list[str]:
    """Ids that the simulator had from run.yaml before it was asked, those that it names once more among them."""
    new = {entry["id"] for entry in content["mechanisms"]}
    new -= {id_ for one in content.get("adopted", []) for id_ in one["effects"]}
    return [id_ for id_ in dict.fromkeys(entry["id"] for entry in content.get("simulation", [])) if id_ not in new]


def sight(content: dict[str, Any]) -> str:
    """Whether the adopted effects were fitted to a run of this diagnosis: `unseen`, `seen`, or `perhaps`."""
    ids = included(content)
    if not ids:
        return UNSEEN
    own = {content["run"]} if isinstance(content["run"], str) else set(content["run"])
    told = [one for one in content.get("adopted", []) if one.get("runs")]
    if any(own & set(one["runs"]) for one in told):
        return SEEN
    known = {id_ for one in told for id_ in one["effects"]}
    return UNSEEN if set(ids) <= known else PERHAPS


def strokes(content: dict[str, Any]) -> str:
    """What the held-out strokes are called: unseen only where no fit has seen them."""
    return "unseen strokes" if sight(content) == UNSEEN else "last strokes"


def heading(content: dict[str, Any]) -> str:
    """What the error on the held-out strokes is called."""
    held = content["fit"]["heldout"]
    split = held["split"] if held else SPLIT
    return {
        UNSEEN: "Error on unseen strokes",
        SEEN: f"Error on the {split}, which the adopted effects have seen",
        PERHAPS: f"Error on the {split}, which the adopted effects may have seen",
    }[sight(content)]
