"""What a simulator has beside what is named, in words."""

from ...document.content import Verdict

BESIDE = "Also in the simulator, as a stand-in and no name, is {}. {}"


def lines(content: Verdict) -> list[str]:
    """A line of each stand-in; nothing where there is none."""
    return [BESIDE.format(entry["id"], entry["sentence"]) for entry in content.get("beside", [])]
