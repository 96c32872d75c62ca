"""The cases of the concealed proof: every mix of the configuration, spread over a block of seeds."""

import itertools
import json
import random
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import NotRequired, TypedDict

from ..ground.errors import BadInput
from ..ground.outside_library import is_outside

RIG = Path(__file__).parent.parent / "rig"  # effects and authors by their files' names: the DAG's plan imports no rig
EFFECTS, AUTHORS = RIG / "effects", RIG / "authors"
BY_AUTHORS = ("none", "single", "pair", "open")  # strata that an author can make


class Mix(TypedDict):
    """Cases of one kind, as the configuration asks for them: `count` drawn cases, or `each` of every effect."""

    stratum: str
    protocol: str
    count: NotRequired[int]
    each: NotRequired[int]
    effects: NotRequired[list[str]]
    kappas: NotRequired[list[float | None]]  # noise floors
    without: NotRequired[bool]
    baselines: NotRequired[bool]
    authors: NotRequired[list[str]]


class ProofSettings(TypedDict):
    """The configuration of the proof: the first seed, the number of cases in a batch, and the mixes."""

    seed: int
    batch: int
    mixes: list[Mix]


@dataclass(frozen=True)
class Planned:
    """The choices for a case; the seed draws the rest. The name of its run tells nothing of it."""

    run: str
    seed: int
    stratum: str
    protocol: str
    effects: tuple[str, ...] = ()
    kappas: tuple[float, ...] = ()
    without: str = ""  # the mechanism that the diagnosis must do without
    baselines: bool = False  # whether they are asked as well
    author: str = ""  # who makes the recording, of `pipeline.rig.authors`; the project's own rig where none is named


def effect_names(open_set: bool) -> list[str]:
    """Effects that the rig has: with `open_set` those whose names begin with `x_`, else those of docs/physics.md."""
    names = sorted(path.stem for path in EFFECTS.glob("[!_]*.py"))
    return [name for name in names if is_outside(name) == open_set]


def _check_hand(mix: Mix) -> None:
    """Raise BadInput for an unknown author, and for a case that its maker, author or rig, cannot make."""
    author_names = sorted(path.parent.name for path in AUTHORS.glob("*/__init__.py"))
    for author in mix.get("authors", []):
        if author not in author_names:
            problem = f"{author!r} is no author"
            raise BadInput("configuration", "proof.mixes.authors", problem, f"use some of {', '.join(author_names)}")
    if "authors" not in mix and mix["protocol"] == "usual":
        problem = "the project's own rig has no protocol 'usual'"
        raise BadInput("configuration", "proof.mixes.protocol", problem, "use rich or poor, or name authors")
    if "authors" in mix and mix["stratum"] not in BY_AUTHORS:
        problem = f"no author makes the stratum {mix['stratum']!r}"
        raise BadInput("configuration", "proof.mixes.stratum", problem, f"use one of {', '.join(BY_AUTHORS)}")


def _of_mix(mix: Mix) -> Iterator[Planned]:
    """Cases of one mix without names and seeds: `count` drawn ones, or `each` of every effect at every kappa."""
    _check_hand(mix)
    bare = Planned("", 0, mix["stratum"], mix["protocol"], baselines=mix.get("baselines", False))
    sizes = [() if kappa is None else (float(kappa),) for kappa in mix.get("kappas", [None])]
    for author, kappas in itertools.product(mix.get("authors", [""]), sizes):
        sized = replace(bare, kappas=kappas, author=author)
        yield from [sized] * mix.get("count", 0)
        if "each" in mix:
            rig_effects = effect_names(mix["stratum"] == "open")
            for name in mix.get("effects") or rig_effects:
                if name not in rig_effects:
                    mend = f"use some of {', '.join(rig_effects)}"
                    raise BadInput("configuration", "proof.mixes.effects", f"{name!r} is no effect of the rig", mend)
                without = name if mix.get("without") else ""
                yield from [replace(sized, effects=(name,), without=without)] * mix["each"]


def plan(settings: ProofSettings) -> list[Planned]:
    """All cases: seeds are one block from `seed` on, and the order is drawn, so that no number tells a stratum."""
    wanted = [case for mix in settings["mixes"] for case in _of_mix(mix)]
    random.Random(settings["seed"]).shuffle(wanted)
    first = settings["seed"]
    return [replace(case, run=f"case-{first + at}", seed=first + at) for at, case in enumerate(wanted)]


def batches(settings: ProofSettings) -> dict[str, list[Planned]]:
    """Cases by batch: what one process makes or diagnoses.

    Those of one author, and those with the same mechanism missing, go together.
    """
    planned_by_batch: dict[str, list[Planned]] = {}
    cases, size = plan(settings), settings["batch"]
    for author in sorted({case.author for case in cases}):
        usual = [case for case in cases if case.author == author and not case.without]
        name = f"by_{author}" if author else "batch"
        for first in range(0, len(usual), size):
            planned_by_batch[f"{name}-{first // size:03d}"] = usual[first : first + size]
    for case in cases:
        if case.without:
            planned_by_batch.setdefault(f"without-{case.without}", []).append(case)
    return planned_by_batch


def written(cases: list[Planned]) -> str:
    """Cases as JSON, for a command line."""
    return json.dumps([asdict(case) for case in cases], separators=(",", ":"))


def read(text: str) -> list[Planned]:
    """Cases from such JSON."""
    entries = json.loads(text)
    return [
        Planned(**{**entry, "effects": tuple(entry["effects"]), "kappas": tuple(entry["kappas"])}) for entry in entries
    ]
