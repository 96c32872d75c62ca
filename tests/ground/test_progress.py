"""Long work shows where it is: one line that renews itself on a terminal, a line a minute in a log."""

import io
import os
import pty
import re
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from first_few import first_few
from made_recording import recording
from models.made_dataset import made_dataset

from pipeline.ground.stored import schemas
from pipeline.ground.words import progress
from pipeline.ground.words.progress import steps

ROOT = Path(__file__).parents[2]


class Clock:
    """A clock that a test sets forward."""

    now_s = 1000.0

    def __call__(self) -> float:
        return self.now_s


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    fake_clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", fake_clock)
    return fake_clock


def work(clock: Clock, step_s: float) -> None:
    for _ in steps(range(3), "fit"):
        for _ in steps(range(4), "epoch"):
            clock.now_s += step_s


def test_a_log_gets_a_line_a_minute(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    log = io.StringIO()
    monkeypatch.setattr(sys, "stderr", log)
    work(clock, 20.0)
    assert log.getvalue().splitlines() == [
        "fit 1 of 3, epoch 4 of 4, 60 s so far",
        "fit 2 of 3, epoch 3 of 4, 2 min 0 s so far",
        "fit 3 of 3, epoch 2 of 4, 3 min 0 s so far",
    ]


def test_what_is_soon_done_says_nothing_in_a_log_and_little_on_a_terminal(
    clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    for stream, shown in ((io.StringIO(), ""), (Terminal(), "\rfit 1 of 3, 0 s so far\x1b[K\r\r\x1b[K")):
        monkeypatch.setattr(sys, "stderr", stream)
        work(clock, 0.001)
        assert stream.getvalue() == shown


def test_a_terminal_has_one_line_that_is_gone_at_the_end(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Terminal()
    monkeypatch.setattr(sys, "stderr", screen)
    work(clock, 1.0)
    terminal_text = screen.getvalue()
    assert "\n" not in terminal_text and terminal_text.startswith(
        "\rfit 1 of 3, 0 s so far\x1b[K\r\rfit 1 of 3, epoch 2 of 4, 1 s so far"
    )
    assert "fit 3 of 3, epoch 4 of 4, 11 s so far" in terminal_text and terminal_text.endswith("\r\x1b[K")


def test_work_that_fails_leaves_no_line_behind(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Terminal()
    monkeypatch.setattr(sys, "stderr", screen)
    with pytest.raises(ValueError):
        for _ in steps([1, 2], "fit"):
            clock.now_s += 1.0
            for _ in steps(range(2), "epoch"):
                raise ValueError
    assert screen.getvalue().endswith("\r\x1b[K")
    work(clock, 1.0)
    assert "\rfit 1 of 3, epoch 2 of 4, 1 s so far" in screen.getvalue()


def on_a_terminal(command: list[str]) -> str:
    """What a command writes to a terminal as its stderr."""
    ours, theirs = pty.openpty()
    pieces: list[bytes] = []

    def listen() -> None:
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:
                return
            if not piece:
                return
            pieces.append(piece)

    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=theirs)
    os.close(theirs)
    listener = threading.Thread(target=listen)
    listener.start()
    assert process.wait() == 0
    listener.join()
    os.close(ours)
    return b"".join(pieces).decode()


@pytest.mark.long
def test_lifespan_and_a_campaign_show_theirs(make_run, tmp_path: Path) -> None:
    folder = make_run("a-1", recording(13, rate_hz=10.0))
    words = {"lifespan": [str(folder), "--out", f"{tmp_path}/life"]}
    words["stages.campaign.points"] = [str(folder.parent), "--out", f"{tmp_path}/points.parquet"]
    for program in words:
        terminal_text = on_a_terminal([sys.executable, "-m", f"pipeline.{program}", *words[program]])
        assert (
            re.search(r"\rstring 1 of 1", terminal_text)
            and "\n" not in terminal_text
            and terminal_text.endswith("\r\x1b[K")
        )


@pytest.mark.parametrize("program", first_few(["predict", "stages.train"]))
def test_a_program_shows_its_progress_on_a_terminal_and_nothing_in_a_log(program: str, tmp_path: Path) -> None:
    schemas.write(made_dataset(60, 4), schemas.DATASET, tmp_path / "dataset.parquet")
    (tmp_path / "questions.csv").write_text("stroke,direction,motor_turns\n1,1,3\n")
    model = ("polynomial", "{}") if program == "predict" else ("spline", '{"bins": 6, "steps": 4}')
    words = ["--model", model[0], "--settings", model[1]]
    if program == "predict":
        words += [f"{tmp_path}/questions.csv", "--out", f"{tmp_path}/answers.csv"]
    else:
        words += ["--split", "within", "--out-model", f"{tmp_path}/m", "--out-predictions", f"{tmp_path}/p.parquet"]
    command = [sys.executable, "-m", f"pipeline.{program}", f"{tmp_path}/dataset.parquet", *words]
    terminal_text = on_a_terminal(command)
    shown = r"\rfit 1 of 5, 0 s" if program == "predict" else r"\rlaw of growth \d+ of 18"
    assert re.search(shown, terminal_text) and "\n" not in terminal_text and terminal_text.endswith("\r\x1b[K")
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
