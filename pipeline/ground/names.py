"""The one check of names from `run.yaml` or a command line that become part of a path, a rule or a page.

Each check returns the name, or raises ValueError with `problem; mend`.
"""

import hashlib
import re
import unicodedata
from collections.abc import Callable
from pathlib import Path

from .errors import BadInput

LONGEST = 100  # characters: files are named after them, and a file's name has 255 bytes
LONGEST_BYTES = 200
LONGEST_SLUG = 60
RUN_NAME = re.compile(r"[a-z0-9][a-z0-9-]*")
MATERIAL_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")
SYNTHETIC = "synthetic"  # the material of the runs that the synthetic rig makes itself
SYNTHETIC_DEVICE = "twistbench synthetic rig"  # what its hello calls itself
# Folders and files under reports/ and processed/ that are made for something else than a material or a run.
TAKEN = {"blind", "campaign", "diagnosis", "docs", "index", "leak", "lifespan", "logs", "metrics", "processed", "proof"}
TAKEN |= {"pages", "raw", "readme", "real", "recordings", "reports", "settle", "site", "together"}
DEVICES = frozenset(["con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in range(1, 10))])
PERIODIC = re.compile(r"(.+?)\1{19,}\Z")  # an end that Snakemake takes for that of a rule which feeds itself
NOT_IN_TEXT = frozenset('/\\:*?"<>|$`{}')  # no file name on some system, or something to a shell or a rule


def _short(name: str) -> None:
    if len(name) > LONGEST:
        raise ValueError(f"has {len(name)} characters; give a name of at most {LONGEST}")


def _folder_name(name: str, form: re.Pattern[str], mend: str) -> str:
    """A name that folders carry; raises ValueError for one too long, of another form, or taken."""
    _short(name)
    if not form.fullmatch(name):
        raise ValueError(f"is {name!r}; {mend}")
    if repeated := PERIODIC.search(name):
        raise ValueError(
            f"ends with {repeated[1]!r} 20 times or more, which Snakemake plans no job for; use a shorter end"
        )
    _free(name)
    return name


def _free(name: str) -> None:
    if name.lower() in TAKEN:
        raise ValueError(f"is {name!r}, which reports/ and processed/ use for something else; give another name")
    if name.lower() in DEVICES:
        raise ValueError(f"is {name!r}, which is a device on Windows; give another name")


def run_name(name: str) -> str:
    """A run's name, which is its folder's."""
    mend = "use lower-case letters, digits and -, as in uhmwpe-20261121-01, and begin with a letter or a digit"
    return _folder_name(name, RUN_NAME, mend)


def slug(text: str) -> str:
    """A text in the letters that a run's name may have, never empty; too long, or too often the same, it is cut."""
    plain = re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")
    if plain and len(plain) <= LONGEST_SLUG and not PERIODIC.search(f"-{plain}"):
        return plain
    told_apart = hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()[:8]
    return f"{plain[: LONGEST_SLUG - 9].strip('-') or 'unnamed'}-{told_apart}"


def material(name: str) -> str:
    """A material's name, which folders under reports/ and processed/ carry."""
    return _folder_name(name, MATERIAL_NAME, "use letters, digits, _ and -, and begin with a letter or a digit")


def own_material(name: str) -> str:
    """A material's name for a run that is not the synthetic rig's own."""
    if material(name).lower() == SYNTHETIC:
        raise ValueError(
            f"is {name!r}, which is kept for the synthetic rig's own runs; give another, such as my-string"
        )
    return name


def _text(name: str) -> str:
    """A name of any letters, with spaces, of one line."""
    name = unicodedata.normalize("NFC", name)
    _short(name)
    if not name or name != name.strip():
        raise ValueError(f"is {name!r}; give a name that neither begins nor ends with a space")
    if len(name.encode("utf-8", "replace")) > LONGEST_BYTES:
        raise ValueError(f"has more than {LONGEST_BYTES} bytes; give a shorter name")
    for sign in name:
        if unicodedata.category(sign)[0] == "C" or (unicodedata.category(sign)[0] == "Z" and sign != " "):
            raise ValueError(f"holds {sign!r}, which cannot be seen; write the name with letters, digits and spaces")
    return name


def string_id(name: str) -> str:
    """The name of one individual string, such as `spool 3, end A`: any letters, except those of paths and shells."""
    name = _text(name)
    for sign in sorted(NOT_IN_TEXT.intersection(name)):
        raise ValueError(f"holds {sign!r}; write it with letters, digits, spaces and signs such as - _ . , # ( )")
    if name[0] in ".-~":
        raise ValueError(f"begins with {name[0]!r}; begin with a letter or a digit")
    if name[-1] == "." or name.split(".")[0].strip().lower() in DEVICES:
        raise ValueError(f"is {name!r}, which is no name of a file on Windows; give another name")
    return name


def column(name: str) -> str:
    """The name of a recording's column or channel: one line of visible text."""
    return _text(name)


def checked(check: Callable[[str], str], name: str, file: Path | str, field: str) -> str:
    """The name, if one of the checks above accepts it; else raises BadInput for file and field."""
    try:
        return check(name)
    except ValueError as error:
        problem, _, mend = str(error).rpartition("; ")
        raise BadInput(file, field, problem, mend) from None
