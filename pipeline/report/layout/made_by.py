"""Which configuration made a page, and whether that page is a result or only a small fit."""

import hashlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import PurePath
from typing import Any

from ...ground.configuration import ModelPlan
from ...ground.names import SYNTHETIC

AMOUNTS = ("within", "later", "seeds", "epochs", "strings", "count", "each")  # less of these than usual: a small fit
NOT_HASHED = ("recordings",)  # where files of others lie on this machine
Leaf = int | float | str | bool | None
OF_RIG = "synthetic."  # begins the settings of the synthetic rig
SHOWN = 3  # of the differences from the default configuration, in a sentence


@dataclass(frozen=True)
class MadeBy:
    """A configuration: its name, a hash of its content, its fits, and its differences from the default.

    `kind` is "default", "small" (fewer seeds, epochs, strings or cases than the default), "own" (differs otherwise) or
    "unknown" (a program was started by hand and was not told). `rig` says which synthetic rig it records, where that is
    not the default configuration's.
    """

    name: str = ""
    digest: str = ""
    kind: str = "unknown"
    fits: str = ""
    changed: tuple[str, ...] = ()
    rig: str = ""

    @property
    def version(self) -> str:
        """The hash in words: two configurations of one name are equal if it is equal."""
        return f"checksum of its settings {self.digest}"

    def packed(self) -> str:
        """All of it as one line of JSON, for a command line."""
        return json.dumps(asdict(self), sort_keys=True, ensure_ascii=False)


def unpacked(text: str) -> MadeBy:
    """The content that `packed` wrote; raises ValueError for any other text."""
    try:
        content = json.loads(text)
        made_by = MadeBy(**{**content, "changed": tuple(content["changed"])})
    except (TypeError, KeyError) as error:
        raise ValueError(f"is no mark of a configuration ({error})") from None
    return made_by


def _leaves(value: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Leaf]]:
    """Every number and text of a configuration with the keys that lead to it; places in a list are no keys."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from _leaves(inner, (*path, str(key)))
    elif isinstance(value, list) and any(isinstance(inner, dict) for inner in value):
        for inner in value:
            yield from _leaves(inner, path)
    else:
        yield path, value if isinstance(value, int | float | str) or value is None else json.dumps(value)


def _amounts(config: Mapping[str, object]) -> dict[tuple[str, ...], float]:
    """The entries of a configuration that are amounts; entries of a list add up."""
    amounts: dict[tuple[str, ...], float] = {}
    for path, value in _leaves(config):
        if path[-1:] and path[-1] in AMOUNTS and isinstance(value, int | float):
            amounts[path] = amounts.get(path, 0) + value
    return amounts


def _differences(config: Mapping[str, object], default: Mapping[str, object]) -> list[str]:
    """Where two configurations differ, in words, amounts first."""
    mine, usual = _amounts(config), _amounts(default)
    differences = [f"{'.'.join(path)} ({mine[path]:g} instead of {usual[path]:g})"
            for path in usual if path in mine and mine[path] != usual[path]]  # fmt: skip
    configured, by_default = (
        {path: value for path, value in _leaves(part) if path[-1] not in AMOUNTS} for part in (config, default)
    )
    differences += [
        ".".join(path) for path in {**by_default, **configured} if configured.get(path) != by_default.get(path)
    ]
    differences += [".".join(path) for path in mine if path not in usual]
    return list(dict.fromkeys(differences))


def _plural(count: int, word: str) -> str:
    return f"{count} {word}{'s' * (count != 1)}"


def _fits(models: Mapping[str, ModelPlan]) -> str:
    """How many seeds and epochs each model has; models of one fit without epochs are not listed."""
    fits = []
    for model in models.values():
        seeds, epochs = model["seeds"], model["settings"].get("epochs")
        later = f" ({seeds['later']} for later strokes)" if seeds["later"] != seeds["within"] else ""
        count = _plural(seeds["within"], "seed") + later
        if epochs is not None or seeds["within"] > 1:
            of_epochs = f" of {_plural(epochs, 'epoch')}" if isinstance(epochs, int) else ""
            fits.append(f"{model['title']} {count}{of_epochs}")
    return ", ".join(fits) + ("; the others one fit" if len(fits) < len(models) else "")


def made_by(
    config: Mapping[str, object], default: Mapping[str, object], name: str, parts: list[str], rig: str = ""
) -> MadeBy:
    """The mark of results of some parts (top-level keys) of a configuration; `rig` counts with `synthetic`."""
    hashed = {key: value for key, value in config.items() if key not in NOT_HASHED}
    digest = hashlib.sha256(json.dumps(hashed, sort_keys=True).encode()).hexdigest()[:7]
    mine, usual = ({part: whole.get(part) for part in parts} for whole in (config, default))
    changed = _differences(mine, usual)
    fewer = any(_amounts(mine).get(path, 0) < value for path, value in _amounts(usual).items())
    kind = "default" if not changed else "small" if fewer else "own"
    models: Any = config["models"] if "models" in parts else None
    fits = "" if models is None else _fits(models)
    return MadeBy(name, digest, kind, fits, tuple(changed), rig if "synthetic" in parts else "")


def sentence(mark: MadeBy, versioned: bool = True) -> str:
    """The remark on the configuration for a reader, in one or two plain sentences; `versioned` with its hash."""
    if mark.kind == "unknown":
        return "Made by hand: which configuration made its numbers is not known."
    rig = f" Only material {SYNTHETIC} is of another synthetic rig than by default: {mark.rig}." if mark.rig else ""
    fits = rig + (f" Fits: {mark.fits}." if mark.fits else "")
    name = f"{mark.name} ({mark.version})" if versioned else mark.name
    if mark.kind == "default":
        return f"Made by the default configuration, {name}.{fits}"
    if mark.kind == "small" and mark.fits:
        return f"Small fit, not a result: made by {name}, which asks for less than the default configuration.{fits}"
    keys = [key for key in mark.changed if not (mark.rig and key.startswith(OF_RIG))]  # the rig is said in words
    more = f" and {len(keys) - SHOWN} more" if len(keys) > SHOWN else ""
    differs = f"; it differs from the default in {', '.join(keys[:SHOWN])}{more}" if keys else ""
    head = "Small fit, not a result" if mark.kind == "small" else "Not the default configuration"
    return f"{head}: made by {name}{differs}.{fits}"


def warning(mark: MadeBy) -> str:
    """The few words that stand on a figure or in a caption; empty for the default configuration."""
    heads = {"small": "small fit: not a result", "own": "not the default configuration"}
    return f"{heads[mark.kind]}, made by {mark.name}" if mark.kind in heads else ""


def called(files: list[str], options: bool) -> str:
    """The name of a configuration: the files on top of the default one, and whether options were added."""
    names = " + ".join(PurePath(file).name for file in files) or "default.yaml"
    return f"{names} with --config" if options else names
