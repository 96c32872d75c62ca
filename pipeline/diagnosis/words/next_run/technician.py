"""The next run → a protocol for the person at the rig: numbered steps with places, times, speeds and loads."""

from dataclasses import dataclass, replace

from ...document.expected import LegSaid, NextRun
from ..language.quantity import at, duration, listing, number, quantity
from ..language.vocabulary import Vocabulary

LEAST_TOLD_S = 1.0  # shorter pauses go without words
SAME_LOAD, SAME_SPEED = 0.08, 0.05  # shares: smaller changes are none
ROW = 4  # moves at one speed without pause, from which they are one step
A_STROKE = "Then make one stroke as before: a recording without any is refused."
LONGEST_BLOCK = 6  # steps of what is repeated


@dataclass(frozen=True)
class Step:
    """One thing to do: `move` to a place, `hold` there, or change the `load` to a value; places as they are said."""

    kind: str
    to: str = ""
    seconds: float = 0.0
    speed: float = 0.0
    up: bool = True


@dataclass(frozen=True)
class Part:
    """The recording of one run: the load at its beginning, and the steps in words."""

    load: str
    steps: list[str]

    @property
    def value(self) -> float:
        """The load as a number, in its unit as it is said."""
        return float(self.load.split()[0].replace(",", ""))


def parts(run: NextRun, words: Vocabulary, whole: float) -> list[Part]:
    """The runs that a proposal asks for: one, or one for each load where the load stands still in a recording.

    `whole` is the range of the motion: a place is said to a two-hundredth of it.
    """
    cut = [(load, place, steps) for load, place, steps in by_load(run, words, whole) if steps]
    runs = [Part(load, repeated(begun(in_rows(steps, words), place, load))) for load, place, steps in cut]
    moved = [any(step.kind == "move" for step in steps) for _, _, steps in cut]
    return [
        part if moves else replace(part, steps=[*part.steps, A_STROKE]) for part, moves in zip(runs, moved, strict=True)
    ]


def begun(lines: list[str], place: str, load: str) -> list[str]:
    """Steps of which the first says place and load."""
    under = f" under {load}" if load else ""
    first, *rest = lines
    if first.startswith("Hold"):
        return [f"{first[:-1]}{under}.", *rest]
    return [f"Begin at rest, at {place}{under}.", *lines]


def legs_of(run: NextRun) -> list[LegSaid]:
    """The legs without the first, which leads from where the recording ended to where the new one begins."""
    return run["legs"][1:] or run["legs"]


def by_load(run: NextRun, words: Vocabulary, whole: float) -> list[tuple[str, str, list[Step]]]:
    """Load and place at the beginning of each run, and its steps; a change of a constant load begins a new run."""
    legs = legs_of(run)
    place = run["legs"][0][words.driver]
    force = legs[0].get(words.load) if words.load else None
    cut: list[tuple[str, str, list[Step]]] = [(_load(force, words), at(place, words.motion_unit, whole), [])]
    for leg in legs:
        to, seconds, now = leg[words.driver], float(leg["seconds"]), leg.get(words.load) if words.load else None
        if now is not None and force is not None and abs(now - force) > SAME_LOAD * max(abs(now), abs(force)):
            if run.get("fixed_load"):
                cut.append((_load(now, words), at(place, words.motion_unit, whole), []))
            else:
                cut[-1][2].append(Step("load", _load(now, words)))
        force = now
        spot, steps = at(to, words.motion_unit, whole), cut[-1][2]
        if abs(to - place) > 0.005 * whole:
            speed = abs(to - place) / max(seconds, 1e-9)
            steps.append(Step("move", spot, seconds, speed, to > place))
        elif steps and steps[-1].kind == "hold":
            steps[-1] = replace(steps[-1], seconds=steps[-1].seconds + seconds)
        elif seconds >= LEAST_TOLD_S:
            steps.append(Step("hold", spot, seconds))
        place = to
    return cut


def every_load(run: NextRun, words: Vocabulary) -> list[str]:
    """Each load that a run asks for, as it is said, in the order in which they come."""
    forces = [leg.get(words.load) for leg in run["legs"]] if words.load else []
    return list(dict.fromkeys(_load(force, words) for force in forces if force is not None))


def _load(force: float | None, words: Vocabulary) -> str:
    return "" if force is None else quantity(force, words.load_unit)


def in_rows(steps: list[Step], words: Vocabulary) -> list[str]:
    """Steps in words; many moves at one speed without a pause are one step."""
    lines, row = [], []
    for step, after in zip(steps, [*steps[1:], None], strict=True):
        if step.kind != "move":
            lines.append(_still(step))
            continue
        row.append(step)
        if after is None or after.kind != "move" or abs(after.speed - step.speed) > SAME_SPEED * step.speed:
            lines += [_row(row, words)] if len(row) >= ROW and not _alike(row) else [_move(move, words) for move in row]
            row = []
    return lines


def _alike(row: list[Step]) -> bool:
    """Whether a row is the same up and down again: such strokes are counted."""
    return all(step.to == other.to for step, other in zip(row, row[2:], strict=False))


def _still(step: Step) -> str:
    if step.kind == "load":
        return f"Change the load to {step.to}."
    return f"Hold {duration(step.seconds)} at {step.to}."


def _move(step: Step, words: Vocabulary) -> str:
    verb = words.verbs[0 if step.up else 1].capitalize()
    return f"{verb} to {step.to} in {duration(step.seconds)} ({number(step.speed, whole=True)} {words.motion_unit}/s)."


def _row(row: list[Step], words: Vocabulary) -> str:
    unit = words.motion_unit
    places = listing([step.to.removesuffix(f" {unit}") for step in row], "and")
    seconds = duration(sum(step.seconds for step in row))
    return f"Go to {places} {unit} without a pause, at {number(row[0].speed, whole=True)} {unit}/s ({seconds} in all)."


def repeated(lines: list[str]) -> list[str]:
    """Lines with repetitions written once and counted; a repetition refers to its steps by number."""
    counted: list[str] = []
    start = 0
    while start < len(lines):
        size, again = _again(lines, start)
        block = lines[start : start + size]
        first = len(counted) + 1
        counted += block
        if again:
            steps = f"step {first}" if size == 1 else f"steps {first} to {first + size - 1}"
            counted.append(f"Repeat {steps} {'once more' if again == 1 else f'another {again} times'}.")
        start += size * (again + 1)
    return counted


def _again(lines: list[str], start: int) -> tuple[int, int]:
    """The repeated block that begins here, and its count: the one that saves most lines, else one line and no count."""
    best = (1, 0)
    for size in range(1, LONGEST_BLOCK + 1):
        block, again = lines[start : start + size], 0
        while lines[start + size * (again + 1) : start + size * (again + 2)] == block:
            again += 1
        if size * again > max(best[0] * best[1], 1):
            best = (size, again)
    return best


def lasting(run: NextRun) -> str:
    """How long it takes in all."""
    seconds = sum(float(leg["seconds"]) for leg in legs_of(run))
    return duration(seconds) if seconds < 90.0 else f"{number(max(round(seconds / 30.0) / 2.0, 1.0))} min"
