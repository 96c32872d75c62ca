"""The words of pages and verdicts, each explained in a sentence; a mechanism's tells what a person would see."""

import ast
from pathlib import Path

from ..outside_library import is_outside

MECHANISMS = Path(__file__).resolve().parents[2] / "diagnosis" / "mechanisms"  # read, not imported: it takes seconds
FOUND_BY_NAME = ("pipeline.diagnosis.mechanisms.*",)  # for fingerprints

TERMS: dict[str, dict[str, str]] = {
    "The rig and its string": {
        "twist": "turns of the motor since the string was untwisted, θ/2π.",
        "displacement": "how much shorter the twisted string is, x; also called contraction.",
        "winding, unwinding": "the motor twists the string further, or lets it untwist.",
        "stroke": "a winding and the unwinding after it; n counts the strokes since the string was new.",
        "hold, rest": "the motor stands; at rest the string is untwisted or nearly so.",
        "tare": "the zero of the displacement, set once a string on the rest before its first stroke.",
    },
    "Models and their errors": {
        "forward": "from twist to displacement.",
        "inverse": "from displacement to twist.",
        "INN": "the invertible neural network of the paper; one network gives both ways.",
        "traditional model": "the paper's equations with the dimensions as they were measured.",
        "calibrated model": "the same equations with the dimensions moved, within tolerance, to fit the recording.",
        "diagnosed simulator": "the equations with the physics that the diagnosis found missing.",
        "RMSE": "root of the mean square error.",
        "held out": "kept away from the model while it learns; all errors here are on such points.",
        "within strokes": "each stroke is cut into short blocks, at most 80 a winding; one block in four is held out.",
        "later strokes": "the last quarter of the strokes is held out, whole.",
        "floor": "what the best smooth curve through the held-out answers themselves still misses; noise, mostly.",
        "× floor": "a model's error divided by the floor for what it knows; knowing no more, none gets far below 1.",
        "knows the direction": "the model is told whether the string is being wound or unwound.",
        "seed": "one training; several show how much of an error is chance.",
    },
    "The diagnosis": {
        "nominal": "the simulator with the dimensions as they were measured.",
        "calibrated": "the simulator after its dimensions moved, each by at most three times its tolerance.",
        "as diagnosed": "the calibrated simulator with the physics that the verdict names, if any.",
        "noise floor": "what no systematic cause explains: sensors' noise; averages have less than single samples.",
        "mismatch": "what is left after calibration, with the noise taken off.",
        "rms": "root of the mean square: the usual size of something that varies.",
        "consistent": "no (further) missing physics can be named, and moving the dimensions helps nothing either.",
        "parameters": "no (further) missing physics can be named; the simulation fits only once its dimensions move.",
        "explained": "physics is missing and named.",
        "ambiguous": "physics is missing, and several explanations are likely.",
        "unknown": "the mismatch is real, and no explanation of the library is good enough.",
        "not decided": "the recording is too short or too poor; the page says what to record.",
        "named": "the effect is in the one explanation that is kept; no percentage is known on rigs without string.",
        "next run": "the run that would tell the likely explanations apart.",
    },
}


def _mechanisms() -> dict[str, str]:
    """The visible sign of each mechanism, from its file, by id, read as text; the library's first."""
    meanings: dict[str, str] = {}
    for path in sorted(MECHANISMS.glob("[!_]*.py"), key=lambda path: (is_outside(path.stem), path.stem)):
        tree = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        for value in (node.value for node in tree if isinstance(node, ast.keyword) and node.arg == "meaning"):
            meanings[path.stem] = str(ast.literal_eval(value))
    return meanings


TERMS["What a simulator can leave out"] = _mechanisms()
MEANING = {word: words for terms in TERMS.values() for word, words in terms.items()}
