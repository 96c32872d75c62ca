"""The run that decides a tie, as run.yaml holds it: a short list, one line for each thing to do."""

import re

STEP = re.compile(r" (?=\d+\. [A-Z])")  # where a step begins
END = re.compile(r"(?<=[.:]) (?=[A-Z])")  # where a sentence ends
AFTER = re.compile(
    r" (?=(?:Only if|If your|Worth making|Worth a try|Hardly worth|This run is|It shows|It is to tell|Record it"
    r"|Record each) )"
)
DROPPED = "Record "  # how the sentence begins that the commands replace


def as_list(experiment: str) -> list[str]:
    """A run in the form of `next_experiment` in diagnosis.json: its title, its steps, and what it is good for.

    What the predictions differ by, and how the recording is diagnosed, stay in the adopted diagnosis.
    """
    protocol, *after = AFTER.split(experiment)
    head, *steps = STEP.split(protocol)
    lines = END.split(head)
    for step in steps:
        number, _, sentences = step.partition(" ")
        first, *changed = END.split(sentences)  # before the next run
        lines += [f"{number} {first}", *changed]
    return lines + [END.split(sentence)[0] for sentence in after if not sentence.startswith(DROPPED)]


def in_one_line(protocol: str | list[str] | None) -> str | None:
    """A run from a run.yaml in one line, whether it is a list or a paragraph, as in earlier versions."""
    return " ".join(protocol) if isinstance(protocol, list) else protocol
