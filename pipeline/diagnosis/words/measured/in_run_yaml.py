"""The lines for run.yaml that say how well a dimension was measured, and which gain the displacement sensor has."""

from collections.abc import Iterable, Sequence

from ...document.content import Verdict
from ..language.quantity import number
from . import tolerances

FURTHER_GAIN = (
    "run.yaml says scale: {there}, and a gain of {gain} is left beside it. If you measure that, write scale: {scale}, "
    "which is {there} divided by {gain}, and say how well you measured it: `tolerance: {{scale: …}}`"
)
GAIN = (
    "If you measured the sensor's gain, give its inverse as the scale. Say it is the {gain} that fits best: then write "
    "`channels: {{displacement_mm: {{scale: {scale}}}}}` where run.yaml has no `channels`, and `scale: {scale}` under "
    "its displacement_mm where it has. Beside it say how well you measured it: `tolerance: {{scale: …}}`"
)


def lines(content: Verdict, again: Sequence[str]) -> list[str]:
    """The lines for run.yaml: the accuracy of the dimensions measured `again`, and the sensor's gain."""
    keys = ", ".join(f"{key}: …" for key in tolerance_keys(again))
    gain = ""
    if "scale" in again:
        value, scale_given = content["parameters"]["scale"]["value"], content["evidence"].get("scale_given")
        template = GAIN if scale_given is None else FURTHER_GAIN
        scales = {"scale": number((scale_given or 1.0) / value, 4), "there": number(scale_given or 1.0, 4)}
        gain = f" {template.format(gain=number(value, 4), **scales)}."
    return [f"In run.yaml a tolerance is written as `tolerance: {{{keys}}}` (docs/import.md).{gain}"] if keys else []


def tolerance_keys(moved: Iterable[str]) -> list[str]:
    """The keys of `tolerance:` in `run.yaml` of dimensions; a stiffness has none."""
    return list(dict.fromkeys(tolerances.key_of(name) for name in moved if not name.startswith("stiffness")))
