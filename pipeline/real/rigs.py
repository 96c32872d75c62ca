"""The known facts on each public rig: the names of its files, its literature, and where to get it."""

import re
from pathlib import Path
from typing import Annotated

import yaml
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from ..ground.errors import BadInput

RIGS = Path(__file__).parent.parent / "config" / "real.yaml"
MAPPINGS = Path(__file__).parent.parent / "mappings"


def _regular(text: str) -> str:
    try:
        re.compile(text)
    except re.error as error:
        raise ValueError(f"is no regular expression ({error})") from None
    return text


Pattern = Annotated[str, AfterValidator(_regular)]


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Files(_Section):
    """A kind of file: a pattern for its name without .gz, the mapping that reads it, and what belongs together."""

    pattern: Pattern
    mapping: str
    name: str = Field(pattern=r"^[a-z0-9][a-z0-9-]*$", description="what the names of its runs begin with")
    group: str = Field(description="runs of one group are one physical thing; \\1 is the pattern's first bracket")


class Expected(_Section):
    """The literature's statement on recordings whose run has a matching name; nothing where it has none."""

    runs: Pattern = ".*"
    names: list[list[str]] | None = Field(None, description="one id of each list must be named")
    never: list[str] = []
    said: str


class Published(_Section):
    """A figure that somebody else reports for this rig."""

    what: str
    value: str
    source: str


class Answer(_Section):
    """A parameter known from the literature, and its place in a diagnosis."""

    what: str
    value: float
    unit: str
    mechanism: str | None = Field(None, description="id of the mechanism that holds it; none: the base parameters")
    parameter: str
    scale: float = Field(1.0, description="from the diagnosis' unit to this one")


class Rig(_Section):
    """A public rig."""

    title: str
    repository: str
    where: str = Field(description="files in that repository")
    licence: str
    base: str = Field(description="the base model in a few words")
    files: list[Files]
    expected: list[Expected]
    published: list[Published] = []
    answers: list[Answer] = []
    note: str = Field("", description="what a reader must know to judge the figures")


def read_rigs(path: Path = RIGS) -> dict[str, Rig]:
    """The public rigs by name; raises BadInput for a file without rigs, or one that names a missing mapping."""
    try:
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise BadInput(path, "file", f"cannot be read ({type(error).__name__})", "restore it") from None
    if not isinstance(content, dict):
        raise BadInput(path, "file", "is not a list of rigs", "write a rig as those of pipeline/config/real.yaml")
    rigs = {}
    for name, described in content.items():
        try:
            rigs[str(name)] = Rig.model_validate(described)
        except ValidationError as error:
            first = error.errors(include_url=False)[0]
            field = ".".join(str(part) for part in (name, *first["loc"]))
            raise BadInput(path, field, first["msg"], "write a rig as those of pipeline/config/real.yaml") from None
        for kind in rigs[str(name)].files:
            if not (MAPPINGS / f"{kind.mapping}.yaml").is_file():
                raise BadInput(path, f"{name}.files", f"there is no mapping {kind.mapping!r}", f"add it to {MAPPINGS}")
    return rigs


def expected_of(rig: Rig, run: str) -> Expected | None:
    """The first expectation whose pattern matches a run's name, or None."""
    return next((expectation for expectation in rig.expected if re.search(expectation.runs, run)), None)
