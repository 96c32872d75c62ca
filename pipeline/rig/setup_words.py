"""The words on the synthetic rig's recordings, where a configuration names another set-up than the default one."""

from collections.abc import Mapping
from itertools import groupby
from pathlib import Path

import yaml

SHIPPED = Path(__file__).parent / "setups"
MOST = 3  # kinds of strokes that are said apart


def strokes_of(setup: str) -> str:
    """How many strokes a set-up winds, to which twist and under which load; empty for an unreadable file."""
    path = SHIPPED / f"{setup}.yaml"
    try:
        content = yaml.safe_load((path if path.is_file() else Path(setup)).read_text(encoding="utf-8"))
        parts = [(part["top_turns"], part["load_n"], part.get("repeat", 1)) for part in content["motion"]["strokes"]]
        kinds = [(*kind, sum(part[2] for part in same)) for kind, same in groupby(parts, key=lambda part: part[:2])]
        count = sum(repeat for *_, repeat in kinds)
        spans = [f"{repeat} from 0 up to {top:g} turns under {load:g} N" for top, load, repeat in kinds]
    except (OSError, ValueError, KeyError, TypeError, AttributeError, yaml.YAMLError):
        return ""
    whole = f"{count} stroke{'s' * (count != 1)}"
    return f"{whole}: {', then '.join(spans)}" if len(kinds) <= MOST else whole


def other_rig(synthetic: Mapping[str, Mapping[str, object]], default: Mapping[str, Mapping[str, object]]) -> str:
    """The set-ups of some runs that differ from the default's, each with its strokes; empty where none does."""
    usual = {str(run["setup"]) for run in default.values()}
    others = dict.fromkeys(str(run["setup"]) for run in synthetic.values() if str(run["setup"]) not in usual)
    words = [f"set-up {setup}" + (f" ({strokes})" if (strokes := strokes_of(setup)) else "") for setup in others]
    return " and ".join(words)
