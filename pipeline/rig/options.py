"""A set-up's string and rig as a command line of `pipeline.new_run`, for a person who records it as an own run."""

import os
import re
import shlex
import zlib
from itertools import count
from pathlib import Path
from typing import Any

from ..ground import command as called
from ..ground.errors import BadInput
from ..run.folder import has_recording, read_run, unfinished
from .setup import SetUp

MATERIAL = "example"  # its own, `synthetic`, is kept for the runs that the pipeline records itself
USUAL = "paper"  # the set-up whose string has that name alone
APART, MANY = 1000, 1000  # between the seeds of two ports, for each recording takes the next one; such seeds
STRING = ("radius_mm", "length_mm", "stiffness_n_per_mm")
RIG = ("torsion_zone_mm", "separator_mm", "load_n")


def base_of(link: Path) -> str:
    """The base name of a rig's runs, before their number: from its port's name, if that is more than rig.

    So two rigs that serve at once, at /tmp/rig and /tmp/rig2, name runs of their own.
    """
    own = re.sub(r"[^a-z0-9]+", "-", link.name.lower()).strip("-")
    return own if own.startswith("rig") and own != "rig" else MATERIAL


def seed_of(link: Path) -> int:
    """The seed of a rig without a given one: 0, or another one for each port whose name names runs.

    Two rigs at once have two strings, and a rig that is started again has those that it had.
    """
    base = base_of(link)
    return 0 if base == MATERIAL else APART * (1 + zlib.crc32(base.encode()) % MANY)


def free_name(raw: Path, base: str = MATERIAL, number: int = 1) -> str:
    """The first free name from `base`-`number` on in the folder `raw`, which need not exist."""
    names = (f"{base}-{at}" for at in count(number))
    return next(name for name in names if not os.path.lexists(raw / name))


def waiting(raw: Path, base: str, number: int, material: str, string_id: str = "") -> str:
    """The first run from `base`-`number` on in the folder `raw` that is described and has no recording; empty for none.

    It is of a string of the `material`, and where `string_id` is given, of that string.
    """
    names = (path.name for path in raw.glob(f"{base}-*") if path.name.removeprefix(f"{base}-").isdecimal())
    for name in sorted((name for name in names if number_of(name) >= number), key=number_of):
        try:
            run = read_run(raw / name)
        except (BadInput, OSError):
            continue  # it waits for a person
        is_meant = run.string and run.string.material == material and string_id in ("", run.string_id)
        if is_meant and not has_recording(raw / name) and not unfinished(raw / name):
            return name
    return ""


def record_into(raw: Path, name: str, link: Path) -> str:
    """What to do with a run that waits, in words with the command."""
    port, folder = (shlex.quote(str(path)) for path in (link, raw / name))
    return f"goes into {folder}, which is described and waits: {called.command('capture')} {port} {folder}"


def string_of(raw: Path, name: str) -> str:
    """The string of a run; empty where its run.yaml does not tell it."""
    try:
        return read_run(raw / name).string_id
    except (BadInput, OSError):
        return ""


def number_of(name: str) -> int:
    """The number of such a name."""
    return int(name.rpartition("-")[2])


def option(name: str) -> str:
    """The option of a key of run.yaml."""
    return "--" + name.replace("_", "-")


def material_of(which: str) -> str:
    """A material for the string of a set-up's name or file, since effects differ from set-up to set-up."""
    own = re.sub(r"[^A-Za-z0-9_-]+", "-", Path(which).stem).strip("-")
    return MATERIAL if own in ("", USUAL) else f"{MATERIAL}-{own}"


def command(setup: SetUp, run: str, which: str = USUAL) -> str:
    """The command that makes a run folder of that name, with a new string; dimensions without a value are left out.

    `which` is the set-up's name or file.
    """
    string: Any = setup.run.get("string", {})
    rig: Any = setup.run.get("rig", {})
    content = {**string, **rig}
    sizes = [f"{option(name)} {content[name]:g}" for name in (*STRING, *RIG) if content.get(name) is not None]
    words = [called.command("new_run"), run, option("material"), material_of(which), *sizes, option("string_id"), run]
    return " ".join(words)


def again(raw: Path, first: str, zeroed: bool) -> str:
    """The command that makes a run folder for a further recording of the string of run `first`.

    A displacement sensor that is `zeroed` at each start has another zero in each recording.
    """
    first_yaml = raw / first / "run.yaml"
    like = raw / first if first_yaml.is_file() else raw / "RUN_OF_RECORDING_1"
    name = free_name(raw, first.rpartition("-")[0])
    return f"{called.command('new_run')} {name} --like {like}{' --tare run' if zeroed else ''}"
