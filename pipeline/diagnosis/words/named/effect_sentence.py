"""A named mechanism → its sentence: the library's words with the size, the range and the fitted parameters."""

import re
from string import Formatter

from ...document.content import Verdict
from ...document.effects_named import Loop, MechanismEntry, Quantity, WithParameters
from ...document.made_keys import amount, extent, interval
from ...document.time_constants import BRANCH_S, half_done_s, time_constants_s
from ...mechanisms.interface import Mechanism
from ...recording.system_units import Units
from ..language.quantity import at, duration, listing, place_near, quantity, size
from ..language.vocabulary import Vocabulary
from ..measured.other_load import only_in

CALCULATED = (
    "a temperature that is calculated from how fast and under what load the motor moves (it is not a measured one)"
)
NOTHING = (
    "The search's first fit, which is an approximation, gave it a part, but the exact fit of everything together gives "
    "it a strength of 0."
)
BETWEEN_RUNS = {
    0.0: "Its memory fits best as going on from run to run, a minute apart.",
    1.0: "It fits best with each run begun as the first one was: what it had done was gone between the runs.",
    2.0: "It fits best with the {string} loaded for long before each later run.",
}  # by the way in which a later run begins
EVERY = "once in every "  # such a length: it is said in place of the turn, which nobody sees on such a rig
NO_CONSTANT = "Of {} there is no constant to report: {}."
LONGER = " or longer (the longest that was tried: a recording of this length does not tell longer ones apart)"
OF_PARTS = "the fit knows what {} parts do together, not each part"
AT = "at_s"  # of a sudden event: when it happens
BARE = re.compile(r": [0-9.,]+ ")  # a constant without an interval
CONSTANT = re.compile(r"\d [^()]*\(-?[0-9.,]+ to -?[0-9.,]+\)")  # its unit may have spaces: 114 N s/m


def sentence(
    mechanism: Mechanism, entry: WithParameters, span: float | None, words: Vocabulary, units: Units,
    opened: Loop | None = None, trend: float | None = None, whole: float = 0.0, mass_kg: float | None = None,
) -> str:  # fmt: skip
    """What a mechanism does on this rig, in a sentence; `entry` is its entry of `mechanisms`, `span` its range.

    `opened` is its loop: the width, and the motion where it is so wide; None where no whole strokes show one. `trend`:
    by how much it moves the reading in the course of the recording; None in an older file. `whole`: the motion's range.
    `mass_kg`: what moves, if the rig knows it.
    """
    worth = interval(entry, f"rms_{words.ending}")["value"]
    if not worth:
        return f"{NOTHING} So nothing shows that it is at work."
    fields = {**words.fields, "size": f"{size(worth, words.unit)} rms"}
    fields["span"] = size(span, words.unit) if span is not None else ""
    fields["lowers"] = "moves" if not trend else "raises" if trend > 0.0 else "lowers"
    fields["grows"] = "changes" if not trend else "grows" if trend > 0.0 else "falls"
    fields["loop"] = loop(fields["span"], words, opened, whole)
    fields["times"] = time_constants(entry["parameters"])
    fields["half"] = half_done(entry)
    fields["temperature"] = CALCULATED if calculated(mechanism, entry) else "the measured temperature"
    phrase = filled(mechanism.sentence, fields).rstrip(".")
    detail = details(mechanism, entry["parameters"] | _late(entry["parameters"], units, mass_kg), words, units)
    if "loop" in detail and opened and opened.get("by_load"):  # the loads of the loops above are others
        detail += ", on average over all loads"
    phrase = phrase.replace(" once per turn", "") if detail.startswith(EVERY) else phrase
    return f"{phrase}{': ' if detail else ''}{detail}."


def loop(span: str, words: Vocabulary, opened: Loop | None, whole: float = 0.0) -> str:
    """The difference of both ways at one place, and the place; where that is unknown, the whole range, named so."""
    if opened:
        near = place_near(amount(opened, words.driver), words.motion_unit, whole)
        widths = [
            f"{size(width, words.unit)} under {quantity(load, words.load_unit)}"
            for load, width in opened.get("by_load", [])
        ]
        return f"up to {listing(widths) or size(amount(opened, f'width_{words.ending}'), words.unit)}, most near {near}"
    return f"{span} from the lowest to the highest value" if span else ""


def between_runs(entry: MechanismEntry, words: Vocabulary) -> str:
    """The state in which later runs begin, for an effect with a memory; else nothing."""
    way = entry["parameters"].get("later_runs")
    return f" {BETWEEN_RUNS[way['value']].format(**words.fields)}" if way else ""


def calculated(mechanism: Mechanism, entry: WithParameters) -> bool:
    """Whether a mechanism follows a temperature that is calculated from self-heating, not measured."""
    return "{temperature}" in mechanism.sentence and not entry["parameters"].get("measured", {"value": 0.0})["value"]


def filled(template: str, fields: dict[str, str]) -> str:
    """A template with its fields filled in; the words around an empty field are left out."""
    parts = re.split(r"(?<=,) ", template)
    kept = [part for part in parts if all(fields.get(name, "") for name in names_in(part))]
    if len(kept) == len(parts):
        return template.format(**fields)
    return f"{' '.join(part.format(**fields) for part in kept).rstrip(',.')}."


def names_in(template: str) -> list[str]:
    """The fields of a template."""
    return [name for _, name, _, _ in Formatter().parse(template) if name]


def details(mechanism: Mechanism, parameters: dict[str, Quantity], words: Vocabulary, units: Units) -> str:
    """The first detail whose parameters were all found, once for every event, in the order of time."""
    parameters = parameters | _usual_load(parameters, units)
    for template in mechanism.details:
        wanted = {name: units.name(name) for name in names_in(template) if name not in words.fields}
        phrases = list[tuple[float, str]]()
        for number in range(1, mechanism.steps + 1):
            ending = "" if number == 1 else f"_{number}"
            values = {name: parameters.get(f"{key}{ending}") for name, key in wanted.items()}
            if any(value is None or not value["value"] for value in values.values()):
                continue
            spelled = {name: with_interval(value) for name, value in values.items() if value}
            at_s = values.get(AT)
            phrases.append((at_s["value"] if at_s else 0.0, template.format(**words.fields, **spelled)))
        if phrases:
            return listing([phrase for _, phrase in sorted(phrases, key=lambda pair: pair[0])])
    return ""


def _usual_load(parameters: dict[str, Quantity], units: Units) -> dict[str, Quantity]:
    """The load for which a law's numbers hold, in its unit: the usual one; nothing where a law has none."""
    usual_load = parameters.get("usual_load")
    if usual_load is None:
        return {}
    value, low, high = (units.load_size * end for end in (usual_load["value"], usual_load["low"], usual_load["high"]))
    return {units.name("usual_load_n"): {"value": value, "low": low, "high": high, "unit": units.load}}


def _late(parameters: dict[str, Quantity], units: Units, mass_kg: float | None) -> dict[str, Quantity]:
    """The delay of a moving mass, from its product with the mass; nothing where one of them is unknown."""
    lateness = parameters.get(units.name("late_mm_s3_per_turn"))
    if lateness is None or not mass_kg or (units.reading, units.motion) != ("N", "m"):
        return {}
    value, low, high = (1e3 * end / mass_kg for end in (lateness["value"], lateness["low"], lateness["high"]))
    return {"late_ms": {"value": value, "low": low, "high": high, "unit": "ms"}}


def with_interval(constant: Quantity) -> str:
    """A constant of an effect with its 90 % interval, if it has one: `0.141 turns (0.137 to 0.144)`."""
    value, low, high = (quantity(constant[key], constant["unit"], digits=3) for key in ("value", "low", "high"))
    unit = value.partition(" ")[2]
    return value if low == high else f"{value} ({low.removesuffix(unit).strip()} to {high.removesuffix(unit).strip()})"


def has_constants(entry: MechanismEntry) -> bool:
    """Whether an effect's sentence gives a constant with its interval."""
    return bool(CONSTANT.search(entry["sentence"]))


def no_constants(entries: list[MechanismEntry]) -> list[str]:
    """Why effects have no constant to report, one sentence for each reason; nothing where all have one."""
    without = [entry for entry in entries if not has_constants(entry)]
    single = [entry["id"] for entry in without if BARE.search(entry["sentence"])]
    parts = [entry["id"] for entry in without if entry["id"] not in single]
    return [
        NO_CONSTANT.format(listing(ids), reason.format("their" if len(ids) > 1 else "its"))
        for ids, reason in ((single, "the fit gives {} constant no interval"), (parts, OF_PARTS))
        if ids
    ]


def time_constants(parameters: dict[str, Quantity]) -> str:
    """The time constants that carry most of an effect, from the names of its strengths."""
    kept = time_constants_s(
        {"parameters": {name: value for name, value in parameters.items() if BRANCH_S.search(name)}}
    )
    if not kept:
        return ""
    longest = parameters.get("slowest_s", {"value": None})["value"]
    ends = " to ".join(duration(seconds) for seconds in dict.fromkeys((kept[0], kept[-1])))
    best = f"best with {'a time constant' if len(kept) == 1 else 'time constants'} of {ends}"
    return f"{best}{LONGER}" if kept[-1] == longest else f"{best} of those that were tried"


def half_done(entry: WithParameters) -> str:
    """The time after which half of an effect is done, by its fitted strengths; empty where they tell none."""
    halves = half_done_s(entry)
    if halves is None:
        return ""
    return f"half of it done after {' to '.join(dict.fromkeys(duration(seconds) for seconds in halves))}"


def at_the_top(content: Verdict, change: float | None, words: Vocabulary) -> str:
    """By how much a slow effect moves the reading at the highest motion, as a person sees it from stroke to stroke.

    `change` is from the first stroke to the last.
    """
    if not change or abs(change) < amount(content["evidence"], f"floor_{words.ending}"):
        return ""
    low, high = extent(content["evidence"], words.driver)
    top, way = at(high, words.motion_unit, high - low), "more" if change > 0.0 else "less"
    several = content["evidence"]["loaded"] or only_in(content)
    load = " under the same load" if several else ""
    return (
        f" At {top} that is {size(abs(change), words.unit)} {way} in the last stroke that goes there{load} than in the "
        "first; no dimension makes strokes differ."
    )
