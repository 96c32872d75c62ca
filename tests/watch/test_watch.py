"""The page against the capture program and the synthetic rig, over HTTP and in a real browser."""

import contextlib
import fcntl
import http.client
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import time
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
import ready
import yaml
from browser import CHROMIUM, browser
from made_recording import content
from scripted_rig import synthetic_rig

from pipeline.capture.uncommitted_note import note
from pipeline.watch.appended import Printed
from pipeline.watch.left_of_string import strokes_left
from pipeline.wire import Channel, Event, Hello, Kind, encode, read_recording
from pipeline.wire.frames import EVENT

ROOT = Path(__file__).resolve().parents[2]
HOSTILE = '<img src=x onerror="document.title=1">'
HELLO = Hello(
    HOSTILE, "1", "1", 1000.0, 0,
    (Channel("motor_turns", "turns", "i32", 0.001), Channel("displacement_mm", "mm", "i32", 0.001)),
)  # fmt: skip
SAMPLE = np.dtype(HELLO.sample_type)

# as a real verdict.txt begins: its first words go up to an empty line
WORSE = """run-1: explained: physics is missing, and named; the explanation has a probability of 89 %. But
  on the unseen strokes the simulator as diagnosed is worse than the nominal one (2.3 mm against 0.57 mm).

What to know first
  On the unseen strokes creep makes the calibrated simulator worse: adopt nothing.
"""
SAID = " ".join(WORSE.partition("\n\n")[0].split())


def samples(first: int, count: int) -> bytes:
    """So many frames from number `first`, one a ms, the twist a slow sine."""
    rows = np.zeros(count, SAMPLE)
    at = np.arange(first, first + count)
    rows["t_us"] = (at * 1000) % 2**32
    rows["motor_turns"] = np.rint(10_000 * (1 - np.cos(at / 3000)))
    rows["displacement_mm"] = rows["motor_turns"] // 2
    return b"".join(encode(Kind.SAMPLE, int(n), row.tobytes()) for n, row in zip(at, rows, strict=True))


def folder(place: Path, name: str = "run-1", **changes: object) -> Path:
    """A run folder without a recording."""
    run_folder = place / "raw" / name
    run_folder.mkdir(parents=True)
    (run_folder / "run.yaml").write_text(yaml.safe_dump(content(name, **changes)))
    return run_folder


def ready_made(*words: object) -> ready.Program:
    """The program, its imports made."""
    return ready.start("pipeline.watch", *words)


def bare(*words: object) -> subprocess.Popen:
    """The program as a person starts it."""
    command = [sys.executable, "-m", "pipeline.watch", *map(str, words)]
    return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)


@contextlib.contextmanager
def watched(run: Path, *options: object, start=ready_made):
    """The program on a free port; its port, and the address that it printed."""
    process = start(run, "--port", 0, "--reports", run.parents[1] / "reports", *options)
    try:
        printed = process.stdout.readline().strip()
        yield int(re.search(r":(\d+)/", printed)[1]), printed
        assert process.poll() is None, "the program ended by itself"
    finally:
        process.terminate()
        process.communicate()


def get(port: int, path: str, **headers: str) -> tuple[int, bytes, http.client.HTTPMessage]:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=10)
    try:
        connection.putrequest("GET", path, skip_host="Host" in headers)
        for name, value in headers.items():
            connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        return answer.status, answer.read(), answer.headers
    finally:
        connection.close()


def told(port: int, until=lambda snapshot: True, seconds: float = 20.0) -> dict:
    """What the page is told, as soon as that holds."""
    end_s = time.monotonic() + seconds
    while True:
        snapshot = json.loads(get(port, "/data.json")[1])
        if "run" in snapshot and until(snapshot):
            return snapshot
        assert time.monotonic() < end_s, snapshot
        time.sleep(0.1)


def test_what_the_page_is_told_is_what_the_capture_program_recorded(tmp_path: Path):
    run = folder(tmp_path)
    with synthetic_rig(tmp_path / "port", ROOT / "pipeline/rig/setups/small.yaml", "--pace", 20), watched(run) as at:
        process = ready.start("pipeline.capture", tmp_path / "port", run)
        live = told(at[0], lambda snapshot: snapshot["samples"] > 0)
        assert process.poll() is None and not live["ended"], "it is shown while it is recorded"
        process.communicate()
        snapshot = told(at[0], lambda snapshot: snapshot["ended"])
    recorded = read_recording((run / "recording.frames").read_bytes())
    info = json.loads((run / "capture.json").read_text())
    assert snapshot["state"] == "complete" and snapshot["samples"] == info["samples"]["received"]
    assert (snapshot["lost"], snapshot["bad"]) == (info["frames"]["lost"], info["frames"]["bad"])
    assert snapshot["strokes"] == snapshot["planned"] == 5
    channels = {channel["name"]: channel for channel in snapshot["channels"]}
    for name, values in recorded.channels.items():
        assert min(channels[name]["low"]) == pytest.approx(values.min(), rel=1e-5, abs=1e-9)
        assert max(channels[name]["high"]) == pytest.approx(values.max(), rel=1e-5)
    assert snapshot["time_s"][-1] <= recorded.time_s[-1] < snapshot["time_s"][-1] + 2.0
    loop = snapshot["loops"][-1]
    assert len(snapshot["loops"]) == 3 and max(loop["motor_turns"]) == pytest.approx(16, abs=0.1)
    wound = slice(0, int(np.argmax(loop["motor_turns"])))
    simulated_wound = slice(0, int(np.argmax(loop["simulated_turns"])))
    measured = np.interp(
        loop["simulated_turns"][simulated_wound], loop["motor_turns"][wound], loop["displacement_mm"][wound]
    )
    off = np.array(loop["simulated_mm"][simulated_wound]) - measured
    assert 0.0 < np.abs(off).max() < 10.0, "the simulator is near, and not the recording itself"


def test_losses_are_counted_and_a_clock_that_jumps_moves_nothing(tmp_path: Path):
    run = folder(tmp_path)
    jumped = np.zeros(1, SAMPLE)
    jumped["t_us"] = 2_000_000_000
    frames = encode(Kind.HELLO, 0, HELLO.pack()) + samples(1, 500) + samples(511, 500) + b"\x05\x05\0"
    (run / "recording.frames").write_bytes(frames + encode(Kind.SAMPLE, 1011, jumped.tobytes()) + samples(1012, 9))
    with watched(run) as (port, _):
        snapshot = told(port, lambda snapshot: snapshot["samples"] == 1010)
    assert (snapshot["lost"], snapshot["bad"], snapshot["jumps"]) == (10, 1, 2)
    assert max(snapshot["time_s"]) == snapshot["time_s"][-1] == pytest.approx(1.02, abs=0.01)


def test_a_recording_that_grows_is_replaced_and_is_recovered(tmp_path: Path):
    run, place = folder(tmp_path), tmp_path / "raw" / "run-1" / "recording.frames"
    with watched(run) as (port, _):
        assert told(port)["state"] == "no recording yet"
        place.write_bytes(encode(Kind.HELLO, 0, HELLO.pack()) + samples(1, 300)[:-5])
        assert told(port, lambda snapshot: snapshot["samples"] == 299)
        with open(place, "ab") as file:
            file.write(samples(1, 300)[-5:] + encode(Kind.EVENT, 301, EVENT.pack(0, Event.STROKE_END, 1)))
        snapshot = told(port, lambda snapshot: snapshot["samples"] == 300)
        assert snapshot["lost"] == 0
        other = tmp_path / "other"
        other.write_bytes(encode(Kind.HELLO, 0, HELLO.pack()) + samples(1, 40))
        other.replace(place)
        snapshot = told(port, lambda snapshot: snapshot["samples"] == 40)
        assert snapshot["replaced"] == 1
        assert ready.run("pipeline.capture", "--recover", run).returncode == 0
        assert told(port, lambda snapshot: snapshot["ended"])["state"] == "recovered"


def test_printed_lines_are_shown_too(tmp_path: Path):
    run = folder(tmp_path)
    lines = "".join(f"{at * 10},{at / 100},{at / 200}\n" for at in range(1, 900))
    (run / "recording.lines").write_text("time_ms,motor_turns,displacement_mm\n" + lines)
    with watched(run, start=bare) as (port, _):
        snapshot = told(port, lambda snapshot: snapshot["samples"] == 899)
    assert snapshot["lost"] is None and snapshot["columns"] == ["motor_turns", "displacement_mm"]
    assert snapshot["time_s"][-1] == pytest.approx(8.98, abs=0.02)


def test_nothing_outside_reports_is_served_and_nothing_is_taken(tmp_path: Path):
    run, reports = folder(tmp_path), tmp_path / "reports"
    (reports / "diagnosis" / "run-1").mkdir(parents=True)
    (reports / "diagnosis" / "run-1" / "verdict.txt").write_text(WORSE)
    (tmp_path / "secret.txt").write_text("secret")
    (reports / ".hidden").write_text("secret")
    (reports / "link.txt").symlink_to(tmp_path / "secret.txt")
    with watched(run) as (port, _):
        status, body, headers = get(port, "/reports/diagnosis/run-1/verdict.txt")
        assert status == 200 and body == WORSE.encode()
        assert "script-src" not in headers["Content-Security-Policy"] and "default-src 'none'" in str(headers)
        absolute = f"/reports/{tmp_path}/secret.txt"
        for path in ("../secret.txt", "%2e%2e/secret.txt", "..%2fsecret.txt", "link.txt", ".hidden", "a%00b", ""):
            status, body, _ = get(port, f"/reports/{path}")
            assert status == 404 and b"secret" not in body, path
        assert get(port, absolute)[0] == get(port, "/reports//etc/passwd")[0] == get(port, "/nothing")[0] == 404
        assert get(port, "/data.json", Host="elsewhere.example")[0] == 403
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=10)
        connection.request("POST", "/", body="x")
        assert connection.getresponse().status == 405
        connection.close()
        snapshot = told(port)
    assert snapshot["verdict"] == SAID and snapshot["verdicts"][0]["verdict"] == SAID, (
        "its warning stands on the second line"
    )
    assert snapshot["verdicts"][0]["page"].endswith("verdict.txt")


def test_another_host_needs_the_token(tmp_path: Path):
    with watched(folder(tmp_path), "--host", "0.0.0.0") as (port, printed):
        token = printed.partition("?token=")[2]
        assert len(token) >= 32
        for path in ("/", "/data.json", "/watch.js", "/reports/x", "/data.json?token=", "/data.json?token=%C3%A9"):
            assert get(port, path)[0] == 403, path
        status, _, headers = get(port, f"/?token={token}")
        assert status == 200 and {"HttpOnly", "SameSite=strict"} <= {*headers["Set-Cookie"].split("; ")}
        assert get(port, "/data.json", Cookie=headers["Set-Cookie"].partition(";")[0])[0] == 200


def test_a_second_client_and_one_that_goes_away_change_nothing(tmp_path: Path):
    run = folder(tmp_path)
    (run / "recording.frames").write_bytes(encode(Kind.HELLO, 0, HELLO.pack()) + samples(1, 3000))
    with watched(run) as (port, _):
        for request in (b"", b"GET /da", b"\xff\0\r\n\r\n", b"GET /data.json HTTP/1.1\r\nHost: localhost\r\n\r\n"):
            with socket.create_connection(("127.0.0.1", port)) as client:
                client.sendall(request)
        told(port, lambda snapshot: snapshot["samples"] == 3000)
        assert [get(port, "/data.json")[0] for _ in range(40)] == [200] * 40
        with contextlib.ExitStack() as idle:  # more than there is room for
            for _ in range(30):
                idle.enter_context(socket.create_connection(("127.0.0.1", port)))
        assert told(port)["samples"] == 3000


@pytest.mark.skipif(not shutil.which("chromium"), reason="there is no chromium here")
def test_a_browser_shows_the_recording_and_no_hostile_text_acts(tmp_path: Path):
    string = content("run-1")["string"] | {"id": HOSTILE}
    run, reports = folder(tmp_path, string=string), tmp_path / "reports" / "diagnosis" / "run-1"
    reports.mkdir(parents=True)
    (reports / "verdict.txt").write_text(f"explained: {HOSTILE}\n")
    (run / "recording.frames").write_bytes(encode(Kind.HELLO, 0, HELLO.pack()) + samples(1, 3000) + samples(3011, 9))
    with watched(run) as (port, _):
        told(port, lambda snapshot: snapshot["samples"] == 3009)
        browser = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'home'}"]
        page = [*browser, "--virtual-time-budget=4000", "--dump-dom", f"http://127.0.0.1:{port}/"]
        home = {**os.environ, "HOME": str(tmp_path)}
        shown = subprocess.run(page, capture_output=True, text=True, timeout=120, env=home).stdout
    values = dict(re.findall(r'<b id="([a-z]+)"[^>]*>([^<]*)<', shown))
    assert (values["samples"], values["lost"]) == ("3,009", "10, 0"), values
    assert "<title>run-1</title>" in shown and "<img" not in shown and shown.count("&lt;img src=x") >= 2
    assert shown.count("<canvas") == 5 and re.search(r'id="link"[^>]*>connected<', shown)


@CHROMIUM
def test_a_browser_shows_words_where_nothing_is_recorded_and_when_a_run_ended(tmp_path: Path):
    """Axes from 0 to 1 without a curve looked broken; a run that had ended said `last sample 4.6 s ago`."""
    run = folder(tmp_path)
    with watched(run) as (port, _), browser(tmp_path / "home") as page:
        page.open(f"http://127.0.0.1:{port}/")
        page.until("document.getElementById('empty')?.textContent === 'Nothing is recorded yet.'")
        seen = "[...document.querySelectorAll('canvas')].filter((each) => each.offsetParent).length"
        assert page.run(seen) == 0
        (run / "recording.lines").write_text("time_ms,motor_turns,displacement_mm\n" + NAMELESS)
        assert ready.run("pipeline.capture", "--recover", run).returncode == 0
        page.until("document.getElementById('state')?.textContent === 'recovered'")
        page.until(f"{seen} === 3")
        assert page.text("empty") == "" and page.run("document.getElementById('age').previousSibling.textContent") == (
            "ended at"
        )
        mine = tmp_path / "reports" / "mine" / "run-1"
        mine.mkdir(parents=True)
        (mine / "verdict.txt").write_text("explained: friction\n")
        (mine / "diagnosis.json").write_text("{}")
        page.until("document.getElementById('verdict').textContent === 'explained: friction'")
        assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d \S+", page.text("age")), "with its time zone"
        assert page.text("link") == "connected"
        assert page.text("verdict-page") == "It stands in reports/mine/run-1/verdict.txt"


@pytest.mark.parametrize(("name", "stamps"), [("time_s", "0 2"), ("t_ms", "0 2000"), ("micros", "0 2000000")])
def test_printed_time_is_read_in_the_unit_of_its_name(name, stamps):
    lines = "".join(f"{stamp},0.5,1.5\n" for stamp in stamps.split())
    source = Printed()
    piece = source.feed(f"{name},motor_turns,displacement_mm\n{lines}".encode())
    assert piece is not None and source.columns == ("motor_turns", "displacement_mm")
    assert piece.rows[:, 0].tolist() == pytest.approx([0.0, 2.0])


NAMELESS = "".join(f"{at * 10},{at / 100},{at / 200}\n" for at in range(1, 900))


@contextlib.contextmanager
def written_to(path: Path):
    """A recording that a capture program writes to now."""
    with open(path, "ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def test_names_that_a_person_gave_are_known_while_it_is_recorded_and_afterwards(tmp_path: Path):
    """`--columns` alone named them: the page showed `samples 0`, axes from 0 to 1 and `no end was written`."""
    run = folder(tmp_path)
    (run / "recording.lines").write_text(NAMELESS)
    columns = ("time_ms", "motor_turns", "displacement_mm")
    with watched(run) as (port, _):
        with written_to(run / "recording.lines"):
            snapshot = told(
                port, lambda snapshot: snapshot["state"] == "recording" and snapshot["empty"] != "No sample came yet."
            )
            assert snapshot["samples"] == 0 and snapshot["empty"].startswith("No line is read yet, but all are kept")
            assert (
                "name them in the order in which the rig prints them, with a name for each ... (" in snapshot["empty"]
            )
            assert snapshot["empty"].endswith(f": python -m pipeline.capture --recover {run} --columns ...,...,...")
            note(run, datetime.now(UTC), columns)
            snapshot = told(port, lambda snapshot: snapshot["samples"])
            assert snapshot["columns"] == [*columns[1:]] and snapshot["state"] in ("recording", "silent")
            assert snapshot["empty"] == ""
        assert ready.run("pipeline.capture", "--recover", run).returncode == 0, "the note names them here too"
        snapshot = told(port, lambda snapshot: snapshot["ended"])
    assert snapshot["samples"] == 898 and snapshot["columns"] == [*columns[1:]] and snapshot["replaced"] == 0


def test_a_run_whose_columns_nobody_named_says_so_everywhere_with_the_command_that_works(tmp_path: Path):
    """`diagnose` advised `--recover` without names, which ends in a refusal; the page said `no end was written`."""
    run = folder(tmp_path)
    (run / "recording.lines").write_text(NAMELESS)
    assert ready.run("pipeline.capture", "--recover", run).returncode == 2
    os.utime(run / "recording.lines", (time.time() - 500, time.time() - 500))
    refused = ready.run("pipeline.diagnose", run, "--out", tmp_path / "mine")
    assert refused.returncode == 2 and "its columns have no names yet" in refused.stderr, refused.stderr
    mend = re.search(rf"pipeline\.capture (--recover {run} --columns (\.\.\.|time_ms),\.\.\.,\.\.\.)", refused.stderr)
    assert mend and "wait for the capture" not in refused.stderr
    with watched(run) as (port, _):
        snapshot = told(port, lambda snapshot: snapshot["unnamed"])
        assert (snapshot["samples"], snapshot["unnamed"], snapshot["state"]) == (
            0,
            898,
            "kept; its columns have no names",
        )
        filled = [*mend[1].split()[:-1], "time_ms,motor_turns,displacement_mm"]
        assert ready.run("pipeline.capture", *filled).returncode == 0
        assert told(port, lambda snapshot: snapshot["ended"])["unnamed"] == 0
    assert not (run / "capture-pending.json").exists()


def test_a_column_is_shown_as_the_channel_that_run_yaml_reads_it_as(tmp_path: Path):
    channels = {"motor_turns": {"column": "theta", "unit": "rad"}, "displacement_mm": {"column": 2, "scale": 2.0}}
    run = folder(tmp_path, channels=channels)
    (run / "recording.lines").write_text("time_ms,theta,x\n" + NAMELESS)
    with watched(run) as (port, _):
        snapshot = told(port, lambda snapshot: snapshot["samples"] == 899)
    assert snapshot["columns"] == ["motor_turns", "displacement_mm"] and snapshot["loops"] and snapshot["empty"] == ""
    assert snapshot["last"] == pytest.approx([8.98, 8.99 / (2 * np.pi), 8.99], rel=1e-4)


def test_a_silent_recording_is_told_from_one_that_was_cut_off_and_one_that_ended_says_when(tmp_path: Path):
    run = folder(tmp_path)
    lines = run / "recording.lines"
    with watched(run) as (port, _):
        assert told(port)["empty"] == "Nothing is recorded yet."
        lines.write_text("time_ms,motor_turns,displacement_mm\n" + NAMELESS)
        os.utime(lines, (time.time() - 500, time.time() - 500))
        snapshot = told(port, lambda snapshot: snapshot["samples"])
        assert snapshot["state"] == "no end was written" and 490 < snapshot["age_s"] < 600, "by the file, not the start"
        with written_to(lines):
            assert told(port, lambda snapshot: snapshot["state"] == "silent")
        assert ready.run("pipeline.capture", "--recover", run).returncode == 0
        snapshot = told(port, lambda snapshot: snapshot["ended"])
    assert snapshot["ended_utc"] == json.loads((run / "capture.json").read_text())["ended_utc"]


def test_a_diagnosis_and_a_forecast_are_shown_wherever_they_lie_in_reports_the_newest_one(tmp_path: Path):
    """After `diagnose … --out reports/mine` the page said: This run has no diagnosis yet."""
    string = content("run-1")["string"] | {"id": "spool-1"}
    run, reports = folder(tmp_path, string=string), tmp_path / "reports"

    def diagnosed(place: str, verdict: str, median_left: float, seconds: float) -> None:
        for name in ("run-1", "spool-1"):
            (reports / place / name).mkdir(parents=True)
        (reports / place / "run-1" / "verdict.txt").write_text(f"{verdict},\n  surely.\n\nmore\n")
        strokes = {"low": median_left - 1, "median": median_left, "high": median_left + 1}
        forecast = {"first": "a", "questions": {"a": {"strokes_left": strokes}}}
        for path, report in (("run-1/diagnosis.json", {}), ("spool-1/lifespan.json", forecast)):
            (reports / place / path).write_text(json.dumps(report))
            os.utime(reports / place / path, (seconds, seconds))

    diagnosed("diagnosis", "explained: creep", 9.0, 1e9)
    diagnosed("mine", "explained: friction", 5.0, 2e9)
    with watched(run) as (port, _):
        snapshot = told(port)
        assert (snapshot["verdict"], snapshot["verdict_page"]) == (
            "explained: friction, surely.",
            "mine/run-1/verdict.txt",
        )
        assert (snapshot["left"]["median"], snapshot["left"]["file"]) == (5.0, "mine/spool-1/lifespan.json")
        assert get(port, f"/reports/{snapshot['verdict_page']}")[0] == 200
        (reports / "mine" / "run-1" / "diagnosis.json").unlink()
        assert told(port, lambda snapshot: snapshot["verdict"] == "explained: creep, surely.")
    diagnosed("mine/deep", "explained: wear", 3.0, 2e9)
    with watched(run, "--reports", reports / "mine" / "deep") as (port, _):
        assert told(port)["verdict_page"] == "run-1/verdict.txt"


def test_a_verdict_of_settle_or_of_several_runs_is_shown_as_theirs(tmp_path: Path):
    """`This run has no diagnosis yet.`, while a step of settle or a joint diagnosis had one."""
    run, reports = folder(tmp_path), tmp_path / "reports"

    def diagnosed(place: str, runs: list[str] | str, verdict: str, seconds: float) -> None:
        (reports / place).mkdir(parents=True)
        (reports / place / "verdict.txt").write_text(f"{verdict}\n")
        (reports / place / "diagnosis.json").write_text(json.dumps({"run": runs, "verdict": verdict}, indent=1))
        os.utime(reports / place / "diagnosis.json", (seconds, seconds))

    diagnosed("mine/run-9", ["run-8", "run-9"], "consistent", 3e9)
    with watched(run) as (port, _):
        assert told(port)["verdict"] is None
        for place, runs, verdict, seconds, words in (
            ("settle/run-1/step-0", "run-1", "ambiguous", 1e9, "run-1 in step 0 of settle"),
            ("settle/run-1/step-1", ["run-1", "run-1-s1"], "explained", 1.1e9, "run-1 in step 1 of settle, together"),
            ("mine/run-2", ["run-1", "run-2"], "unknown", 2e9, "together with run-2"),
            ("both", ["run-2", "run-1", "run-3"], "open", 2.5e9, "together with run-2 and run-3"),
        ):
            diagnosed(place, runs, verdict, seconds)
            snapshot = told(port, lambda snapshot, verdict=verdict: snapshot["verdict"] == verdict)
            assert snapshot["verdict_page"] == f"{place}/verdict.txt" and snapshot["verdict_of"].startswith(words)


def test_the_strokes_left_say_of_which_limit_by_which_strokes_and_promise_no_more_than_the_terminal(tmp_path: Path):
    """`16.9 (9.93 to –)`: of what, by what, and the terminal said 9 and 16."""
    lifespan_folder = tmp_path / "spool-1"
    lifespan_folder.mkdir()
    strokes = {"low": 9.93, "median": 16.927, "high": None}
    questions = {"model_error": {"limit": 1.0, "unit": "mm", "strokes_left": strokes}}
    questions["stroke_loss"] = {"limit": 0.1, "unit": "1", "strokes_left": {"low": 62.2, "median": None, "high": None}}
    for first, words, until in (
        ("model_error", "16 (median), at least 9 in 90 % of the futures", "is off by 1 mm"),
        ("stroke_loss", "at least 62 in 90 % of the futures", "10 % of the stroke is lost"),
    ):
        forecast = {"first": first, "questions": questions, "level": 0.9, "strokes_seen": 18, "runs": ["a-1", "a-2"]}
        (lifespan_folder / "lifespan.json").write_text(json.dumps(forecast))
        tile = strokes_left(tmp_path, "spool-1")
        assert tile and (tile["words"], tile["rests"]) == (words, "18 strokes of a-1 and a-2")
        assert tile["until"].endswith(until)
