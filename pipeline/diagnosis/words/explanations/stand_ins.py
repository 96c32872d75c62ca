"""The stand-ins that a simulator has beside the named effects, in words."""

from ...document.content import Verdict

BESIDE = "Also in the simulator, as a stand-in and no name, is {}. {}"


def lines(content: Verdict) -> list[str]:
    """A line for each stand-in; nothing where there is none."""
    return [BESIDE.format(entry["id"], entry["sentence"]) for entry in content.get("beside", [])]
