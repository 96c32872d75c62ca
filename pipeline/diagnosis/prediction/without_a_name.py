"""What is simulated though no verdict names it, or though its verdict advised against it, and that it is so."""

from typing import cast

from ..document.content import Simulated, Verdict

AGAINST = "beware: run.yaml adopted this against the advice of its verdict, which says"


def to_simulate(content: Simulated, run: str) -> Simulated:
    """A diagnosis whose `simulation` and `parameters` are what predicts one of its runs: of `unknown` its `closest`.

    Another run keeps the dimensions alone: what no verdict names was seen to go wrong elsewhere.
    """
    closest, known = cast(Verdict, content).get("closest"), content.get("run", "")
    if not closest or run not in ([known] if isinstance(known, str) else known):
        return content
    parameters = {**content["parameters"], **closest["parameters"]}
    return {**content, "parameters": parameters, "simulation": closest["simulation"]}


def said_of_no_name(content: Simulated) -> list[str]:
    """That what is simulated, `content`, is no name, or was adopted against advice; else nothing."""
    closest = cast(Verdict, content).get("closest")
    if not closest or list(content["simulation"]) != list(closest["simulation"]):
        return [f"{AGAINST}: {advised.rstrip('.')}" for advised in content.get("against_advice", [])]
    ids = " + ".join(closest["ids"])
    comes = "come closest and are no names" if len(closest["ids"]) > 1 else "comes closest and is no name"
    return [f"{ids} {comes}: the verdict is unknown, and more is missing"]
