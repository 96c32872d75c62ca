"""The runs of one string: which belong together, what they say of their zero, and what comes next."""

import json
import shlex
from pathlib import Path

import programs
import pytest
from made_recording import content
from stages.nine_strokes import string

from pipeline.lifespan.forecast.strokes_left import LEAST_STROKES
from pipeline.run.folder import read_run
from pipeline.string.jumps_beside import Beside
from pipeline.string.next_steps import DIAGNOSIS, LIFE, next_steps
from pipeline.string.rests import Rests
from pipeline.string.same_string import next_name, others_recorded, tares


def made(place: Path, name: str, tare: str | None = None, id_: str = "a", recording: str = "recording.csv") -> Path:
    folder = place / name
    folder.mkdir(parents=True)
    (folder / "run.yaml").write_text(json.dumps(content(name, string=string(id=id_), tare=tare)))
    if recording:
        (folder / recording).touch()
    return folder


@pytest.fixture
def runs(tmp_path: Path) -> list[Path]:
    """Three recorded runs of one string, and beside them three that are not to be named."""
    made(tmp_path, "b-1", id_="b")
    made(tmp_path, "a-4", recording="")
    made(tmp_path, "a-5", recording="recording.frames")  # unfinished
    return [made(tmp_path, "a-2"), made(tmp_path, "a-10", "run"), made(tmp_path, "a-1")]


def test_all_recorded_runs_of_a_string_are_named_and_no_other(runs: list[Path]) -> None:
    two, ten, first_run = runs
    assert others_recorded(two, read_run(two)) == [first_run, ten]
    elsewhere = made(two.parent / "there", "a-9")
    assert others_recorded(two, read_run(two), like=elsewhere) == [first_run, elsewhere, ten]
    assert others_recorded(two, read_run(two), like=first_run) == [first_run, ten]


def test_what_comes_next_names_all_runs_of_the_string(runs: list[Path]) -> None:
    two, ten, first_run = runs
    diagnose, dataset, lifespan = next_steps(ten, 9)
    assert diagnose.endswith(f"pipeline.diagnose {first_run} {two} {ten} --together --out reports/mine/a-10")
    assert dataset.endswith(f": python -m pipeline.dataset {first_run} {two} {ten}")
    command = f"python -m pipeline.lifespan {first_run} {two} {ten} --out reports/mine"
    assert lifespan == f"Next: ask how long the string lasts by: {command}"


def test_after_the_first_run_the_second_is_described_or_the_life_asked(runs: list[Path]) -> None:
    alone = runs[0].parent / "b-1"
    diagnose, _, again = next_steps(alone, 9)
    assert diagnose.endswith(f"python -m pipeline.diagnose {alone} --out reports/mine")
    described = f"python -m pipeline.new_run b-2 --like {alone}"
    assert again == f"Next: for another recording of this string: {described}, then record into it"
    another = next_steps(alone, 9, anew=True)[-1]
    beginning = "Next: this rig's next recording is of another string (rig --standing keeps one string): "
    words = "b-2 --material"
    words = another.removeprefix(f"{beginning}python -m ").removesuffix(", then record into it")
    done = programs.run(*shlex.split(words), cwd=alone.parent)
    assert done.returncode == 0, done.stderr
    other = read_run(alone.parent / "raw" / "b-2")
    assert other.string_id == "b-2" and other.rig == read_run(alone).rig
    assert "pipeline.lifespan" in next_steps(alone, LIFE)[-1] and LIFE == LEAST_STROKES


def test_strokes_of_all_runs_of_the_string_are_counted_for_what_comes_next(runs: list[Path]) -> None:
    """Of a second run the end said `diagnose` and `lifespan`, though both runs had three strokes in all."""

    class OfEach(Beside):
        def __init__(self, strokes: int) -> None:
            super().__init__()
            self.rests = Rests(read_run(runs[0]), runs[0], "", (0.0, 1.0), strokes, (), (), (), (), 20.0, 0.01)

        def at(self, folder: Path) -> Rests:
            return self.rests

    more, again = next_steps(runs[0], 1, beside=OfEach(2))
    assert more.startswith("Next: record more of this rig: 5 strokes so far, and a diagnosis needs at least 6 to 8")
    assert again.startswith("Next: for another recording of this string: ")
    diagnose, *_, again = next_steps(runs[0], 2, beside=OfEach(2))
    assert "--together" in diagnose and "new_run" in again and "lifespan" not in again
    assert "pipeline.lifespan" in next_steps(runs[0], 4, beside=OfEach(4))[-1]


def test_fewer_strokes_than_a_diagnosis_needs_are_said_and_not_diagnosed(runs: list[Path]) -> None:
    alone = runs[0].parent / "b-1"
    more, again = next_steps(alone, DIAGNOSIS - 1)
    longer = next_steps(alone, DIAGNOSIS - 1, anew=True)[0]
    assert longer == more.replace("record more of this rig", "let a recording go on for longer"), (
        "not of another string"
    )
    needs = "a diagnosis needs at least 6 to 8, with holds"
    assert more == f"Next: record more of this rig: 5 strokes so far, and {needs} (docs/record.md)"
    assert "pipeline.new_run b-2" in again
    assert "pipeline.diagnose" in next_steps(alone, DIAGNOSIS)[0]
    assert "--together" in next_steps(runs[0], 1)[0], "with the others of its string it has more"
    assert needs[0].upper() + needs[1:] in (Path(__file__).parents[2] / "docs/record.md").read_text()


def test_a_rig_without_a_string_has_no_life(tmp_path: Path) -> None:
    folder = tmp_path / "c-1"
    folder.mkdir()
    (folder / "run.yaml").write_text(json.dumps({"run": "c-1", "actuator": "moving_mass", "rig": {"mass_kg": 1.0}}))
    (line,) = next_steps(folder, 99)
    assert line.endswith(f"pipeline.diagnose {folder} --out reports/mine")


@pytest.mark.parametrize(
    ("name", "following"), [("a-1", "a-3"), ("lot-07", "lot-08"), ("lot", "lot-2"), ("9", "10"), ("a-99", "a-100")]
)
def test_the_next_run_has_the_next_free_number(tmp_path: Path, name: str, following: str) -> None:
    (tmp_path / "a-2").mkdir()
    assert next_name(tmp_path / name) == following


def test_what_the_runs_say_of_their_zero_is_told(runs: list[Path]) -> None:
    two, ten, first_run = runs
    text = tares(two, read_run(two), [first_run, ten])
    assert "`tare: string` (the default) in a-1; `tare: run` in a-10; a-2 has `tare: string` (the default): its" in text
    assert "If it was set to zero since, as that of a-10 was, add `tare: run` to its run.yaml: python -m" in text
    alone = tares(two, read_run(two), [first_run])
    mend = f"add `tare: run` to its run.yaml: python -m pipeline.mend {two} tare=run"
    assert alone.endswith(f"If it was set to zero since, {mend}")
    checked = made(two.parent / "there", "a-3", "checked")
    text = tares(checked, read_run(checked), [first_run])
    assert text.endswith("a-3 has `tare: checked`: its sensor was checked and has the zero of the run before.")
    assert "a-10 has `tare: run`: its sensor was set to zero since the run before." in tares(
        ten, read_run(ten), [first_run, two]
    )
    many = [made(two.parent / "more", f"m-{number}") for number in range(1, 8)]
    assert "`tare: string` (the default) in m-4, m-5, m-6, m-7 and 3 more;" in tares(two, read_run(two), many)
