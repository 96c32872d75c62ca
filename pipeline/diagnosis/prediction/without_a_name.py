"""Simulators that no verdict names, or that a verdict advised against; and the remark that says so."""

from typing import cast

from ..document.content import Simulated, Verdict
from .errors_to_compare import ToCompare

AT_NOISE = 1.3  # times the noise on strokes that no fit had seen: no more is told to be missing
AGAINST = "beware: run.yaml adopted this against the advice of its verdict, which says"


def to_simulate(content: Simulated, run: str) -> Simulated:
    """A diagnosis whose `simulation` and `parameters` predict one of its runs; for `unknown`, those of its `closest`.

    Another run keeps the dimensions alone: what no verdict names was seen to go wrong elsewhere.
    """
    closest, own_runs = cast(Verdict, content).get("closest"), content.get("run", "")
    if not closest or run not in ([own_runs] if isinstance(own_runs, str) else own_runs):
        return content
    parameters = {**content["parameters"], **closest["parameters"]}
    return {**content, "parameters": parameters, "simulation": closest["simulation"]}


def said_of_no_name(content: Simulated, ending: str) -> list[str]:
    """The remark that the simulator `content` is no name, or was adopted against advice; else nothing.

    `ending` is that of the keys of errors in `content`, as `mm`.
    """
    closest = cast(Verdict, content).get("closest")
    if not closest or list(content["simulation"]) != list(closest["simulation"]):
        return [f"{AGAINST}: {advised.rstrip('.')}" for advised in content.get("against_advice", [])]
    ids = " + ".join(closest["ids"])
    comes = "come closest and are no names" if len(closest["ids"]) > 1 else "comes closest and is no name"
    errors = ToCompare.of(cast(Verdict, content), ending)
    if errors.noise and errors.unseen and errors.unseen <= AT_NOISE * errors.noise:
        return [
            f"{ids} {comes}: the verdict is unknown, and its page says why. Of strokes that no fit had seen hardly "
            "more than the noise is left; of other motions nothing says how well it does"
        ]
    return [f"{ids} {comes}: the verdict is unknown, and more is missing"]
