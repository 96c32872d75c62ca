"""A damaged file of a step, on the real program: a sentence with file, field and mend; nothing is lost or moved."""

import json
import shutil
from pathlib import Path

import pytest
from settle_bench import begun_once, copied, ended, rig, state

STATE, VERDICT, RUNS, PROPOSED = "step-1/state.json", "step-0/diagnosis.json", "step-0/next_runs.json", "proposed.json"
DEEP = "[" * 100_000
WORDS = ("settle", "raw/poor-1", "--port", "port", "--out", "out")


@pytest.fixture(scope="module")
def waiting(tmp_path_factory) -> Path:
    """A loop whose first step is proposed."""
    return begun_once(tmp_path_factory)[0]


@pytest.fixture
def place(waiting, tmp_path) -> Path:
    return copied(waiting, tmp_path / "lab")


def changed(path: Path, **entries: object) -> str:
    return json.dumps(json.loads(path.read_text()) | entries)


def files(place: Path) -> dict[str, bytes]:
    """What the loop and its runs hold, but for its lock."""
    paths = (path for name in ("out", "raw") for path in (place / name).rglob("*") if path.is_file())
    return {str(path): path.read_bytes() for path in paths if "lock" not in path.name}


PROPOSAL = {"title": "one", "runs": []}
LEG = {"seconds": 1.0, "motor_turns": 2.0}
BROKEN = {
    "a state that is cut": (STATE, "{", "content"),
    "a deep state": (STATE, DEEP, "content"),
    "a state that is a list": (STATE, "[]", "content"),
    "a proposal that is a list": (STATE, {"proposal": []}, "proposal"),
    "a leg that is a number": (STATE, {"proposal": PROPOSAL | {"legs": [3]}}, "proposal.legs.0"),
    "a leg of text": (STATE, {"proposal": PROPOSAL | {"legs": [LEG | {"seconds": "1"}]}}, "proposal.legs.0.seconds"),
    "an endless leg": (STATE, {"proposal": PROPOSAL | {"legs": [LEG | {"seconds": 1e999}]}}, "proposal.legs.0.seconds"),
    "no title": (STATE, {"proposal": {"legs": [LEG]}}, "proposal.title"),
    "a title of numbers": (STATE, {"proposal": {"title": 3, "legs": [LEG]}}, "proposal.title"),
    "no proposal": (STATE, {"proposal": None}, "proposal"),
    "another state": (STATE, {"state": "aproved"}, "state"),
    "another step": (STATE, {"number": 7}, "number"),
    "an unknown key": (STATE, {"numbes": 1}, "numbes"),
    "a verdict that is cut": (VERDICT, "{", "content"),
    "a proposed run that is cut": (f"step-1/{PROPOSED}", "{", "content"),
    "a proposed run without curves": (f"step-1/{PROPOSED}", {"curves": None}, "content"),
    "a proposed run that is a list": (f"step-1/{PROPOSED}", "[]", "content"),
}


def refused(place: Path, path: Path, field: str) -> str:
    """What the program says of a damaged file; it moves and writes nothing."""
    before = files(place)
    done = ended(place, *WORDS[:2], "--out", "out")
    assert done.returncode == 2 and "Traceback" not in done.stdout, done.stdout
    assert f"error: {path.relative_to(place)}: {field}: " in done.stdout and " Mend: " in done.stdout
    assert len(done.stdout.splitlines()) == 1 and len(done.stdout) < 500, "one short line"
    assert files(place) == before
    return done.stdout


@pytest.mark.parametrize("kind", BROKEN)
def test_before_a_run_is_made_it_is_refused(place, kind):
    name, content, field = BROKEN[kind]
    path = place / "out" / name
    path.write_text(content if isinstance(content, str) else changed(path, **content))
    message = refused(place, path, field)
    assert "restore it, or begin anew: name another --out, and every run that is recorded so far" in message


@pytest.mark.parametrize(
    ("name", "content", "field"),
    [
        (VERDICT, "{", "content"),
        (VERDICT, DEEP, "content"),
        (VERDICT, "[]", "content"),
        (VERDICT, {"verdict": "explained"}, "content"),  # its check sum is another
        (RUNS, "{", "content"),
        (RUNS, "[3]", "0"),
        (RUNS, "{}", "content"),
    ],
    ids=["cut", "deep", "a list", "edited", "runs cut", "runs of numbers", "no list of runs"],
)
def test_before_a_run_is_proposed_it_is_refused_and_its_mend_mends_it(place, name, content, field):
    shutil.rmtree(place / "out" / "step-1")
    path, whole = place / "out" / name, (place / "out" / name).read_bytes()
    path.write_text(content if isinstance(content, str) else changed(path, **content))
    message = refused(place, path, field)
    assert 'set "state" in out/step-0/state.json to "recorded", and start again' in message
    if content != "{":
        return
    stands = place / "out" / "step-0" / "state.json"
    stands.write_text(changed(stands, state="recorded"))
    with rig(place, "--pace", "inf"):
        done = ended(place, *WORDS)
    assert "no terminal in which to ask; nothing was moved" in done.stdout and path.read_bytes() == whole
    assert state(place)["state"] == "proposed"


def test_a_verdict_without_its_check_sum_is_looked_at_for_its_form_alone(place):
    shutil.rmtree(place / "out" / "step-1")
    path = place / "out" / VERDICT
    path.with_name("diagnosis.json.sha256").unlink()
    path.write_text(changed(path, mechanisms=[{"name": "creep"}]))
    assert "Field required" in refused(place, path, "mechanisms.0.id")
