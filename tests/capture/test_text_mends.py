"""The mends that the end of a text recording prints: each is one that works, and none is a guess told as a fact."""

import re
import shlex

import pytest
import ready
import yaml
from capture.test_recover_text import folder, recover, wound
from made_recording import content

from pipeline.capture.printed.likely_order import KEPT, Kept, likely_order
from pipeline.run.samples import read_strokes

__all__ = ["folder"]
NAMED = {"time_s": {"column": "t_ms", "unit": "ms"}, "motor_turns": "turns", "displacement_mm": "disp"}
EXCHANGED = {**NAMED, "motor_turns": "disp", "displacement_mm": "turns"}


def described(folder, channels, printed: str, header: str = "") -> None:
    """Put a run.yaml and printed lines there; the header comes first, or none does."""
    (folder / "run.yaml").write_text(yaml.safe_dump(content("run-1", channels=channels), sort_keys=False))
    (folder / "recording.lines").write_text(f"{header}\n" * bool(header) + printed)


def other_way(printed: str) -> str:
    """The second and the third of three columns exchanged."""
    return "".join(f"{t},{c},{b}\n" for t, b, c in (line.split(",") for line in printed.splitlines()))


ROWS = wound().partition("\n")[2]


def commands(text: str) -> list[str]:
    """The commands in it that name columns anew."""
    return re.findall(r"pipeline\.capture (--recover \S+ --columns [\w,]+)", text)


def mend_words(text: str) -> list[str]:
    """The words of the command in it that changes run.yaml."""
    return shlex.split(re.search(r"Next: mend it, .*pipeline\.mend (.*)", text)[1])


@pytest.mark.parametrize("order", ["t_ms,turns,disp", "t_ms,disp,turns"])
def test_the_order_of_unnamed_columns_goes_by_their_numbers_where_these_tell_it(folder, order):
    """The order of run.yaml was told, which exchanged the columns of a rig that prints another one."""
    described(folder, NAMED, ROWS if order == "t_ms,turns,disp" else other_way(ROWS))
    done = recover(folder)
    (command,) = commands(done.stderr)
    assert done.returncode == 2 and command == f"--recover {folder} --columns {order}"
    last = dict(zip(order.split(","), (folder / "recording.lines").read_text().split("\n")[-2].split(","), strict=True))
    values = ", ".join(f"{name} = {value}" for name, value in last.items())
    advice = "in this order alone the numbers move as this string does; check it by the last line"
    assert f", by the command below; {advice}: {values}\n  python -m pipeline.capture {command}\n" in done.stderr
    right = ready.run("pipeline.capture", *shlex.split(command))
    assert right.returncode == 0 and "warning" not in right.stdout and "Next:" in right.stdout, right.stdout


def test_an_order_that_the_numbers_do_not_tell_is_asked_about_with_a_value_beside_each_name(folder):
    described(folder, NAMED, "".join(ROWS.splitlines(keepends=True)[:40]))  # it has hardly begun to wind
    done = recover(folder)
    last = ROWS.splitlines()[39].split(",")
    values = f"t_ms = {last[0]}, turns = {last[1]}, disp = {last[2]}"
    unsure = "the order is that of run.yaml, and the rig's may be another; check each name by the last line"
    assert f"by the command below; {unsure}: {values}; where a value is another column's" in done.stderr
    assert done.stderr.endswith(f"exchange the names\n  python -m pipeline.capture {commands(done.stderr)[0]}\n")


def test_of_orders_that_are_alike_none_is_told(folder):
    """A temperature and a load of about the same numbers: no motion tells which is which."""
    described(folder, {**NAMED, "load_n": "load", "temperature_c": "temp"}, "")
    kept, alike = Kept(), Kept()
    for row in ROWS.splitlines():
        kept.take([*row.split(","), "20.1", "-20.3"])
        alike.take([*row.split(","), "20.1", "20.3"])
    assert likely_order(folder, ("temp", "load", "disp", "turns", "t_ms"), alike) == ()
    assert len(kept.rows) <= KEPT and likely_order(folder, ("t_ms", "turns", "disp"), Kept()) == ()


def test_exchanged_columns_and_lines_before_the_header_are_mended_by_one_command(folder):
    """Two commands stood at the end: one named the columns rightly, and the other wrongly again."""
    rows = ROWS.splitlines(keepends=True)
    described(folder, NAMED, "".join([*rows[:100], "t_ms,disp,turns\n", *rows[100:]]))
    done = recover(folder)
    assert commands(done.stdout) == [f"--recover {folder} --columns t_ms,turns,disp"], done.stdout
    assert "99 lines of numbers came before anything named their columns; the command above reads them too" in (
        done.stdout
    )
    right = ready.run("pipeline.capture", *commands(done.stdout)[0].split())
    assert right.returncode == 0 and "799 samples" in right.stdout and "Next:" in right.stdout, right.stdout
    words = f"{folder}: it can be used: run.yaml reads it by these columns\nNext:"
    assert words in right.stdout and "can be used: run.yaml" not in done.stdout, right.stdout


@pytest.mark.parametrize(
    ("header", "channels"),
    [
        ("t_ms,turns,disp", EXCHANGED),  # the words in the names say it
        ("t_ms,a,b", {**NAMED, "motor_turns": "b", "displacement_mm": "a"}),  # the rig named them, and nobody else
        ("t_ms,turns,disp", {**NAMED, "motor_turns": 2, "displacement_mm": 1}),
    ],
)
def test_an_exchange_in_run_yaml_is_mended_there(folder, header, channels):
    """The mend called the columns of the rig's own header by each other's names."""
    described(folder, channels, ROWS, header)
    done = recover(folder)
    assert "exchange the columns of motor_turns and displacement_mm" in done.stdout and not commands(done.stdout)
    mended = ready.run("pipeline.mend", *mend_words(done.stdout))
    assert mended.returncode == 0 and "It can be used: 800 samples" in mended.stdout, mended
    right = {"motor_turns": channels["displacement_mm"], "displacement_mm": channels["motor_turns"]}
    assert yaml.safe_load((folder / "run.yaml").read_text())["channels"] == {**channels, **right}
    assert len(read_strokes(folder)[1]) == 800
    again = recover(folder)
    assert again.returncode == 0 and "there is nothing to recover" in again.stdout and "Next:" in again.stdout


def test_an_exchange_in_the_names_that_a_person_gave_is_mended_by_their_names(folder):
    described(folder, {**NAMED, "motor_turns": "a", "displacement_mm": "b"}, ROWS)
    done = recover(folder, "--columns", "t_ms,b,a")
    assert commands(done.stdout)[:1] == [f"--recover {folder} --columns t_ms,a,b"], done.stdout


def test_a_run_whose_sign_was_mended_is_said_to_be_usable_and_what_comes_next(folder):
    """The person had mended it, and `--recover` ended with "nothing to recover" and exit status 2."""
    turned = "".join(f"{t},{b},-{c}\n" for t, b, c in (line.split(",") for line in ROWS.splitlines()))
    described(folder, NAMED, turned, "t_ms,turns,disp")
    words = mend_words(recover(folder).stdout)
    assert recover(folder).returncode == 2, "nobody has mended it yet"
    assert ready.run("pipeline.mend", *words).returncode == 0
    done = recover(folder)
    words = f"{folder}: there is nothing to recover: the recording is finished, and run.yaml as it is now reads it"
    assert done.returncode == 0 and words in done.stdout and "Next:" in done.stdout and not done.stderr, done.stdout


@pytest.mark.parametrize("step_ms", [20, 50, 100, 200])
def test_a_clock_in_ms_that_is_read_in_s_is_mended_whatever_its_step(folder, step_ms):
    """Of 50 ms and more, which could be µs as well for a faster rig, no line of run.yaml was given."""
    printed = "".join(f"{step_ms * at},{row.partition(',')[2]}\n" for at, row in enumerate(ROWS.splitlines()))
    described(folder, {**NAMED, "time_s": "t"}, printed, "t,turns,disp")
    done = recover(folder)
    assert ready.run("pipeline.mend", *mend_words(done.stdout)).returncode == 0
    mended = yaml.safe_load((folder / "run.yaml").read_text())["channels"]["time_s"]
    assert mended == {"column": "t", "unit": "ms"}, done.stdout
    assert recover(folder).returncode == 0
