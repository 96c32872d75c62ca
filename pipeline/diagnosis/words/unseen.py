"""The error on strokes that no fit has seen, in words, and what must be said of it first."""

from typing import Any

from pipeline.diagnosis.words.quantity import size, times
from pipeline.diagnosis.words.vocabulary import Vocabulary

STILL_MISSING = 1.3  # noise floors on unseen strokes, from which something systematic is still missing
AVERAGED = 0.05  # of the noise: what averaging must take off it to be worth a word
WORSE, NO_BETTER = 1.02, 0.95  # times the other error


def errors(content: dict[str, Any], words: Vocabulary) -> tuple[float, float, float] | None:
    """Nominal, calibrated and explained error, or None where no stroke could be held out."""
    held = content["fit"]["heldout"]
    if not held:
        return None
    nominal, calibrated, explained = (held[f"{name}_{words.ending}"] for name in ("nominal", "calibrated", "explained"))
    return nominal, calibrated, explained


def cautions(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What a reader must know before anything else; nothing where the simulator foretells strokes to the noise."""
    found = errors(content, words)
    if found is None:
        return []
    nominal, calibrated, explained = found
    noise, said = content["fit"][f"noise_floor_{words.ending}"], []
    named = content["verdict"] in ("explained", "ambiguous")
    if calibrated > WORSE * nominal:
        sizes = f"{size(calibrated, words.unit)} against {size(nominal, words.unit)} as measured"
        without = " without what is named" if named and explained < nominal else ""
        said.append(
            f"On unseen strokes the calibrated simulator is worse than the nominal one: {sizes}."
            f" What calibration alone learnt does not hold later: do not adopt its dimensions{without}."
        )
    if named and explained > max(WORSE * calibrated, calibrated + 0.1 * noise):
        said.append("On unseen strokes the explanation makes the calibrated simulator worse: do not adopt it.")
    elif named and explained > NO_BETTER * calibrated:
        said.append("On unseen strokes the explanation improves nothing: it may be no more than a good fit.")
    if explained > STILL_MISSING * noise:
        missed = f"the unseen strokes are missed by {times(explained / noise)} times the noise"
        if named:
            said.append(f"Something systematic is still missing: {missed}.")
        elif content["verdict"] != "unknown":
            said.append(f"Something changes from stroke to stroke that the fit does not foresee: {missed}.")
    return said


def lines(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The three errors beside the noise floor."""
    found = errors(content, words)
    if found is None:
        return ["Too few strokes to hold any out: nothing says how well the simulator foretells."]
    noise = content["fit"][f"noise_floor_{words.ending}"]
    names = ("nominal", "calibrated", "as diagnosed")
    said = [
        f"{name} {size(error, words.unit)} ({times(error / noise)} times the noise)"
        for name, error in zip(names, found, strict=True)
    ]
    split = content["fit"]["heldout"]["split"]
    floor = content["evidence"][f"floor_{words.ending}"]
    other = f" (in averages, which the rest is compared in, {size(floor, words.unit)})"
    averaged = abs(floor - noise) > AVERAGED * noise
    known = f"The noise is {size(noise, words.unit)} rms{other if averaged else ''}."
    return [f"{'; '.join(said)}.", f"{known} Held out: the {split}."]
