"""Why an explanation is less likely than the best one: what counts most against it, in words."""

from ...document.explanations import Cause, ExplanationEntry
from ..language.quantity import number, times

# of each aspect: what is said where its sign is smaller than that of the best explanation, and where it is larger
SAID = {
    "fit": ("it fits the recording worse", "it fits the recording better"),
    "numbers": ("it has fewer free numbers", "it has more free numbers"),
    "weakest": ("its weakest effect adds less", "its weakest effect adds more"),
    "instead": (
        "another effect in place of its weakest one does less well",
        "another effect in place of its weakest one does better",
    ),
    "more": ("a further effect would add less to it", "a further effect would add more to it"),
    "cancels": ("its effects work against each other less", "its effects work against each other more"),
    "signature": (
        "what is left without effects looks less like what its effects leave",
        "what is left without effects looks more like what its effects leave",
    ),
    "size": ("it has fewer effects", "it has more effects"),
}
MARK = ("it leaves out {}", "it has {}")
NAMES = "explanations with these effects were right less often in the simulated recordings that taught the judge"
OF_ITS_SIZE = (
    "explanations with so many effects were right less often in the simulated recordings that taught the judge"
)
SPEAKS_FOR = {  # whether an aspect's sign is larger, where a reader would take it for a merit
    "fit": True, "numbers": False, "weakest": True, "instead": False, "more": False, "cancels": False,
    "signature": True,
}  # fmt: skip
TAUGHT = "though {}: such explanations were right less often in the simulated recordings that taught the judge"
NOT_OF_THIS = ("names",)  # aspects that say nothing of this recording: told where nothing else is
NEARLY_0 = 0.01  # log odds: an aspect that counts less is no reason
LEAST = 1.05  # times less likely: less is alike


def less_often(explanation: ExplanationEntry, best: ExplanationEntry | None) -> str:
    """How many times less likely than the best one an explanation is: 37; empty where unknown or hardly less."""
    mine, first = explanation.get("probability"), best.get("probability") if best else None
    if not mine or not first or first < LEAST * mine:
        return ""
    less = first / mine
    return times(less) if less < 1000.0 else number(less, 1)


def chiefly(explanation: ExplanationEntry) -> str:
    """The strongest point against an explanation, as part of a sentence; empty where no reason is known."""
    causes = explanation.get("because") or []
    because = [cause for cause in causes if abs(cause.get("log_odds", 1.0)) >= NEARLY_0] or causes
    seen = [cause for cause in because if cause["aspect"] not in NOT_OF_THIS and not speaks_for(cause)]
    if because and not seen and speaks_for(because[0]):
        return TAUGHT.format(" and ".join(reason(cause) for cause in because if speaks_for(cause)))
    reasons = [f"since {reason(cause)}" for cause in seen or because]
    how = "partly" if seen and because[0] not in seen else "chiefly"
    return f"{how} {' and '.join(reasons)}" if reasons else ""


def speaks_for(cause: Cause) -> bool:
    """Whether the point against an explanation would read like a merit of it."""
    return SPEAKS_FOR.get(cause["aspect"]) == (cause["more"] > 0.0)


def reason(cause: Cause) -> str:
    """One aspect in words."""
    aspect, larger = cause["aspect"], cause["more"] > 0.0
    if aspect.startswith("mark_"):
        id_ = aspect.removeprefix("mark_")
        shown = "hardly shows" if larger else "shows"
        return f"{MARK[larger].format(id_)}, whose mark this recording {shown}"
    if aspect == "names":
        return NAMES
    if aspect == "size" and not cause["more"]:
        return OF_ITS_SIZE
    return SAID[aspect][larger]
