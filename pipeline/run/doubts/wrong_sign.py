"""A displacement that falls while the string is wound: the message and the mend, for every program that finds it."""

from ..description import Channel, Run

FALLS = "falls while the motor winds"
POSITIVE = "contraction is positive"


def turned_sign(run: Run) -> str:
    """The mend in run.yaml."""
    scale = run.channels.get("displacement_mm", Channel.model_validate({})).scale
    return f"{POSITIVE}: set channels.displacement_mm.scale to {-scale:g}" + f", not {scale:g}" * (scale < 0)
