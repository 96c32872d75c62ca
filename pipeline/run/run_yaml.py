"""The keys that a person may write into `run.yaml`; `description` checks them."""

from typing import Literal, TypedDict

from .description import Adopted, Included, Tare


class StringYaml(TypedDict, total=False):
    """The string: what it is made of and what was measured on it, in mm and N/mm."""

    material: str
    radius_mm: float
    length_mm: float
    stiffness_n_per_mm: float | None
    id: str | None
    strokes_before: int


class ChannelYaml(TypedDict, total=False):
    """Where a channel stands in the recording: value = scale · raw + offset, in `unit`."""

    column: str | int | None
    unit: str | None
    scale: float
    offset: float
    counts_per_turn: float | None
    step_s: float | None


class FileYaml(TypedDict, total=False):
    """How a text recording, or a workbook, is written."""

    delimiter: str
    skip: int
    skip_below: int
    sheet: int | str | None
    rows: tuple[int, int] | list[int] | None
    decimal: Literal[".", ","]
    header: bool
    comment: str | None
    encoding: str


class RunYaml(TypedDict, total=False):
    """All of it; `rig` and `tolerance` have the keys of the actuator, with their units in their names."""

    run: str
    actuator: str
    string: StringYaml | None
    rig: dict[str, float]
    tolerance: dict[str, float]
    simulation: list[Included]
    adopted: list[Adopted]
    file: FileYaml
    channels: dict[str, ChannelYaml | str | int]  # a name or an index alone is its column
    tare: Tare
    mended: dict[str, int]
