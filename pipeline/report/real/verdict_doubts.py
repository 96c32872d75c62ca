"""Verdicts on real recordings that are not firm or not expected: the kind of doubt, and its cause."""

from collections.abc import Mapping
from typing import Any

from ...ground.units import unit_of
from ...real.rigs import Answer, Expected
from ..layout.verdict_content import Content

SHOWN = 4  # of the explanations that tie


def doubt(
    content: Content | None, words: str, expected: Expected | None, answers: list[Answer]
) -> tuple[str, str] | None:
    """The kind of doubt and why, or None for a firm verdict that agrees with the literature."""
    if content is None:
        return "not decided", words.partition("not decided: ")[2] or words.partition("not imported: ")[2] or words
    verdict = content["verdict"]
    named = {entry["id"] for entry in content["mechanisms"]}
    against = contradictions(verdict, named, content, expected) + wrong_answers(content, answers)
    if verdict == "unknown":
        return verdict, " ".join([_unknown(content), *against])
    if verdict == "ambiguous":
        return verdict, " ".join([_ambiguous(content, named, expected), *against])
    return ("disagrees", " ".join(against)) if against else None


def _sets(content: Content) -> list[set[str]]:
    return [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]


def satisfies(ids: set[str], expected: Expected) -> bool:
    """Whether ids are an answer that the literature would give."""
    return all(ids & set(either) for either in expected.names or []) and not ids & set(expected.never)


def contradictions(verdict: str, named: set[str], content: Content, expected: Expected | None) -> list[str]:
    """The contradictions between a verdict and the literature, a sentence each."""
    if expected is None:
        return []
    sentences = []
    extra = sorted(named & set(expected.never))
    if extra:
        sentences.append(f"It names {', '.join(extra)}, against the literature: {expected.said}.")
    if expected.names is None:
        if verdict == "explained":
            sentences.append(f"It names {' + '.join(sorted(named))} firmly, although {expected.said}.")
        return sentences
    missing = [either for either in expected.names if not named & set(either)]
    if missing and verdict != "unknown":
        lacking = " and ".join(" or ".join(either) for either in missing)
        sentences.append(
            f"It does not name {lacking}, which the literature expects: {expected.said}.{_seen(content, missing)}"
        )
    further = sorted(named - {id_ for either in expected.names for id_ in either} - set(expected.never))
    if further and verdict == "explained":
        sizes = ", ".join(f"{id_} ({_size(content, id_)})" for id_ in further)
        sentences.append(f"Beside what the literature expects it names {sizes}.")
    return sentences


def _seen(content: Content, missing: list[list[str]]) -> str:
    """From which size on an effect would have been seen."""
    fit: Mapping[str, Any] = content["fit"]
    key = next((key for key in fit if key.startswith("detectable_")), "")
    size_by_id = fit.get(key) or {}
    unit = unit_of(key)
    sizes = [
        f"{id_} from {size_by_id[id_]:.2g} {unit} on" for either in missing for id_ in either if size_by_id.get(id_)
    ]
    return f" This recording would have shown {', '.join(sizes)}." if sizes else ""


def _size(content: Content, id_: str) -> str:
    entry: Mapping[str, Any] = next(entry for entry in content["mechanisms"] if entry["id"] == id_)
    key = next((key for key in entry if key.startswith("rms_")), "")
    return f"{entry[key]['value']:.2g} {unit_of(key)} rms" if key else "size not said"


def _ambiguous(content: Content, named: set[str], expected: Expected | None) -> str:
    sets = _sets(content)
    others = [" + ".join(sorted(ids)) for ids in sets[1:]]
    more = f" and {len(others) - SHOWN} more" if len(others) > SHOWN else ""
    text = f"Beside {' + '.join(sorted(named))}, {'; '.join(others[:SHOWN])}{more} fit as well."
    common = sorted(set.intersection(*sets))
    if common:
        text += f" All of them hold {' and '.join(common)}."
    if expected is not None and expected.names is not None:
        among = any(satisfies(ids, expected) for ids in sets)
        text += f" The literature's answer is {'' if among else 'not '}held by one of them."
    if next_run := content.get("next_experiment"):
        text += f" What would tell: {next_run.partition(':')[0]}."
    return text


def _unknown(content: Content) -> str:
    mismatch: Mapping[str, Any] = content["mismatch"] or {}
    key = next((key for key in mismatch if key.startswith("rms_")), "")
    size = f"{mismatch[key]:.2g} {unit_of(key)} rms" if key else "Mismatches"
    follow = mismatch.get("driver") or "nothing named"
    text = f"{size} remain that nothing in the library explains; they follow {follow}."
    if next_run := content.get("next_experiment"):
        text += f" What would tell more: {next_run.partition(':')[0]}."
    return text


def found_answer(content: Content, answer: Answer) -> tuple[float, float, float] | None:
    """Value, low and high of a parameter known from the literature, in its unit; None if it is missing."""
    parameters = content["parameters"]
    if answer.mechanism is not None:
        entries = [entry for entry in content["mechanisms"] if entry["id"] == answer.mechanism]
        parameters = entries[0]["parameters"] if entries else {}
    entry: Mapping[str, Any] | None = parameters.get(answer.parameter)
    if not entry or any(entry.get(key) is None for key in ("value", "low", "high")):
        return None
    low, high = sorted(answer.scale * entry[key] for key in ("low", "high"))
    return answer.scale * entry["value"], low, high


def wrong_answers(content: Content, answers: list[Answer]) -> list[str]:
    """Parameters whose interval misses the literature's value, a sentence each."""
    sentences = []
    for answer in answers:
        interval = found_answer(content, answer)
        if interval and not interval[1] <= answer.value <= interval[2]:
            value, low, high = interval
            sentences.append(
                f"Its {answer.what} is {value:.4g} ({low:.4g} to {high:.4g}) {answer.unit}, the literature's"
                f" {answer.value:g} {answer.unit}."
            )
    return sentences
