"""The page's content of each half second: state, curves that fit a screen, and news from reports/, as JSON."""

import json
import math
import os
from pathlib import Path, PurePosixPath

from ..ground.kinematics import Array
from .came_of_run import beyond
from .envelope import Envelope
from .followed_recording import Followed
from .left_of_string import strokes_left
from .page_content import Beside, Content, StrokeCurve
from .reports_of_run import verdicts
from .verdict_of_run import newest_verdict


def numbers(values: Array) -> list[float | None]:
    """Values with six digits, None where a value is no number. Shape (values,), in any unit."""
    return [float(f"{value:.6g}") if math.isfinite(value) else None for value in values.tolist()]


def _loop(followed: Followed, part: Envelope, turns: int, mm: int) -> StrokeCurve:
    """One stroke: displacement over twist, and the simulator at the same twist."""
    simulated = followed.simulated(part.first)
    twist, measured_mm = part.line(mm)
    return {
        "motor_turns": numbers(twist),
        "displacement_mm": numbers(measured_mm),
        "simulated_turns": [] if simulated is None else numbers(part.first[:, turns]),
        "simulated_mm": [] if simulated is None else numbers(simulated),
    }


def snapshot(followed: Followed, reports: Path, beside: Beside | None = None) -> bytes:
    """The whole content of the page, as JSON; at most a few hundred kB, however long the recording is.

    `beside`: what is shown of other things than the recording.
    """
    columns, whole = followed.source.columns, followed.whole
    run = followed.run()
    content: Content = {
        **(beside or {}),
        **followed.state(),
        "run": followed.folder.name,
        "columns": list(columns),
    }
    content["string"] = run.string_id if run else None
    content["material"] = run.string.material if run and run.string else None
    content["last"] = numbers(followed.last)
    content["channels"] = []
    if whole is not None and len(whole.first):
        content["time_s"] = numbers(whole.first[:, 0])
        for at, name in enumerate(columns, 1):
            parts = {"low": whole.low, "high": whole.high, "low_s": whole.low_s, "high_s": whole.high_s}
            content["channels"].append({"name": name, **{key: numbers(part[:, at]) for key, part in parts.items()}})
    content["loops"] = []
    content["noise_mm"] = followed.noise.sigma
    if {"motor_turns", "displacement_mm"} <= {*columns}:
        turns, mm = 1 + columns.index("motor_turns"), 1 + columns.index("displacement_mm")
        content["loops"] = [_loop(followed, part, turns, mm) for part in followed.strokes if len(part.first)]
        loop = content.get("loop")
        if loop and loop["foretold"] and loop["state"] != "proposed" and len(rows := followed.means.rows):
            came = beyond(rows[:, 0], rows[:, turns], rows[:, mm], loop["foretold"])
            loop["foretold"]["came"] = {key: numbers(values) for key, values in came.items()}
    if (loop := content.get("loop")) and (drawing := loop.get("came")):
        place, root = (Path(os.path.realpath(path)) for path in (drawing["file"], reports))
        below = place.relative_to(root).as_posix() if place.is_relative_to(root) else None  # else nothing serves it
        loop["came"] = {**drawing, "page": below}
    content["verdicts"] = verdicts(reports)
    listed = next((verdict for verdict in content["verdicts"] if verdict["run"] == content["run"]), None)
    newest = newest_verdict(reports, content["run"]) or listed
    if newest is None and (loop := content.get("loop")):  # the run that is made now has none; the loop's first run has
        newest = newest_verdict(reports, loop["first"])
    content["verdict"], content["verdict_page"] = (newest["verdict"], newest["page"]) if newest else (None, None)
    content["verdict_text"] = str(PurePosixPath(newest["page"]).parent / "verdict.txt") if newest else None
    content["verdict_of"] = newest.get("of", "") if newest else ""
    content["index"] = (reports / "index.html").is_file()
    content["left"] = strokes_left(reports, run.string_id) if run else None
    return json.dumps(content, separators=(",", ":")).encode()
