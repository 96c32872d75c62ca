"""Where the zero of a planned motion is, and what state the string is assumed to begin in, in words."""

from ....ground.input.complaint import key_name
from ...prediction.planned_motion import Plan
from ..language.vocabulary import Vocabulary


def of_zero(plan: Plan, words: Vocabulary) -> str:
    """Where the zero of a plan's reading is from, and what the string has lived through before it."""
    run, channel = plan.run.run, plan.run.system.channel
    if plan.after or plan.zero:
        zero = f"that of the recording of {run}"
    elif plan.begun:
        zero = f"that of the recording of {run}, as its first second gives it"
    else:
        zero = f"where the plan begins: {channel} is 0 in its first row, for nothing tells what the sensor reads there"
    state = "as the recording left it" if plan.after else "as it was before its first stroke"
    if plan.before and not plan.after:
        earlier = " and ".join(key_name(each.run.run) for each in plan.before)
        state = f"as {earlier} left it, before its first stroke of {run}"
    return f"its zero is {zero}; the {words.string} is taken to be {state}"
