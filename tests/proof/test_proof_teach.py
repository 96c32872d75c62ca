"""The judge is taught by lessons, and scored on authors whom it was not taught by."""

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pandas.testing import assert_frame_equal

from pipeline.diagnosis.choice.judged import held
from pipeline.diagnosis.numerics.judge import Judge, Weighed, judge
from pipeline.diagnosis.numerics.recogniser import OF_EXPLANATION
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.ground.errors import BadInput
from pipeline.proof import verdicts
from pipeline.proof.teach import across, fitted_judge
from pipeline.proof.teach.lesson import Lesson, curriculum, learnt, read, recorded, written
from pipeline.rig.authors import authors, names
from pipeline.rig.authors.__main__ import write
from pipeline.rig.authors.interface import Asked
from pipeline.run.samples import read_strokes

ROOT = Path(__file__).parents[2]
JUDGES = ROOT / "pipeline" / "proof" / "teach" / "judges"


def made_lessons(count: int, seed: int = 0) -> list[Lesson]:
    """Lessons of which the right explanation leaves less than the wrong one; where all leave much, none is right."""
    rng, lessons = np.random.default_rng(seed), []
    for number in range(count):
        good = number % 4 != 0
        leftover = {
            "creep": rng.uniform(-5.0, -4.0) if good else rng.uniform(-0.5, 0.0),
            "jam": rng.uniform(-2.0, -0.5),
        }
        leftover["creep jam"] = leftover["creep"] - 0.05
        ids = tuple(tuple(name.split()) for name in leftover)
        signs = tuple(
            {"left_share": value, "more_gain": float(rng.normal()), "mismatch_floors": 1.0}
            for value in leftover.values()
        )
        right = tuple(good and names == ("creep",) for names in ids)
        effects = ("creep",) if good else ("x_odd",)
        author = ("one", "two")[(number // 4) % 2]
        lessons.append(Lesson(author, number, effects, (1.0,), "rich", ids, signs, right))
    return lessons


def test_a_judge_learns_which_explanation_is_right_and_when_none_is() -> None:
    taught = fitted_judge.fitted(made_lessons(200))
    for lesson in made_lessons(40, seed=1):
        *named, none = taught.probabilities(fitted_judge.explanations(lesson)).tolist()
        assert sum(named) + none == pytest.approx(1.0)
        best = int(np.argmax(named))
        assert lesson.right[best] and none < 0.5 if any(lesson.right) else none > 0.5


def test_a_judge_that_goes_on_knows_what_the_earlier_one_knew_and_learns_a_sign_that_was_not_there() -> None:
    before = fitted_judge.fitted(made_lessons(200))
    assert np.array_equal(fitted_judge.blank(made_lessons(8), before).weights, before.weights)
    fresh = [
        replace(lesson, signs=tuple(signs | {"left_of_own": 5.0 * number} for number, signs in enumerate(lesson.signs)))
        for lesson in made_lessons(4, seed=2)
    ]
    onwards = fitted_judge.fitted(fresh, before)
    assert set(onwards.knots) == {*before.knots, "left_of_own"} and onwards.names == before.names
    earlier_weights = dict(zip(before.columns, before.weights, strict=True))
    moved = dict(zip(onwards.columns, onwards.weights, strict=True))
    assert (
        max(abs(moved[column] - weight) for column, weight in earlier_weights.items())
        < 0.5 * np.abs(before.weights).max()
    )
    assert any(moved[column] != 0.0 for column in set(moved) - set(earlier_weights))
    for lesson in made_lessons(40, seed=1):
        more_signs = [signs | {"left_of_own": 5.0 * number} for number, signs in enumerate(lesson.signs)]
        *named, none = onwards.probabilities(
            fitted_judge.explanations(replace(lesson, signs=tuple(more_signs)))
        ).tolist()
        assert lesson.right[int(np.argmax(named))] and none < 0.5 if any(lesson.right) else none > 0.5


def test_a_judge_says_what_each_column_of_its_basis_is_of() -> None:
    taught = fitted_judge.fitted(made_lessons(40))
    (row,) = taught.basis([Weighed(("creep",), {name: knots[0] for name, knots in taught.knots.items()})])
    named = {column for column, value in zip(taught.columns, row, strict=True) if value}
    assert named == {"size", "name creep", "size, of 1", "name creep, of 1"}


def test_where_nothing_of_the_library_is_right_a_set_without_its_physics_is() -> None:
    ids = (("creep",), ("x_clock",), ("creep", "x_clock"))
    lesson = Lesson("one", 1, ("x_odd",), (1.0,), "rich", ids, ({}, {}, {}), (False, False, False))
    assert lesson.answers == (False, True, False)
    assert replace(lesson, right=(True, False, False)).answers == (True, False, False)


def signed(count: int, seed: int = 0) -> list[Lesson]:
    """Lessons whose explanations all leave as much: only the signature says which effect was hidden."""
    rng, lessons = np.random.default_rng(seed), []
    for number in range(count):
        name = ("creep", "jam", "x_odd")[number % 3]
        ids, alike = (("creep",), ("jam",)), {"left_share": -3.0, "mismatch_floors": 1.0}
        signature = {effect: float(rng.normal(3.0 * (effect == name), 1.0)) for effect in ("creep", "jam", "x_odd")}
        right = tuple(only == name for (only,) in ids)
        author = ("one", "two")[(number // 3) % 2]
        lessons.append(Lesson(author, number, (name,), (1.0,), "rich", ids, (alike, alike), right, signature))
    return lessons


def test_where_all_explanations_leave_as_much_the_signature_tells_which_is_right() -> None:
    deaf = fitted_judge.fitted(signed(240))
    listening = fitted_judge.listening(deaf, signed(240))
    assert deaf.recogniser is None and np.array_equal(listening.weights, deaf.weights)
    for judge_of, least, most in ((deaf, 0.0, 0.6), (listening, 0.85, 1.0)):
        likeliest = []
        for lesson in signed(60, seed=1):
            best = int(np.argmax(judge_of.probabilities(fitted_judge.explanations(lesson, judge_of.recogniser))))
            likeliest.append([*lesson.right, not any(lesson.right)][best])
        assert least <= np.mean(likeliest) <= most


def test_the_judge_meets_each_signature_by_a_recogniser_whom_its_author_did_not_teach(monkeypatch) -> None:
    author_sets: list[set[str]] = []
    whole = fitted_judge.taught
    monkeypatch.setattr(
        fitted_judge, "taught", lambda lessons: author_sets.append({each.author for each in lessons}) or whole(lessons)
    )
    fitted_judge.listening(fitted_judge.fitted(signed(60)), signed(60))
    assert author_sets == [{"two"}, {"one"}, {"one", "two"}]


def test_it_is_scored_on_authors_whom_it_does_not_know(monkeypatch) -> None:
    lessons = made_lessons(120)
    taught = {name: fitted_judge.fitted([each for each in lessons if each.author != name]) for name in ("one", "two")}
    judges: list[Judge] = []
    whole = across.judged
    monkeypatch.setattr(across, "judged", lambda judge, lesson: judges.append(judge) or whole(judge, lesson))
    judgements = across.left_out([*lessons, replace(lessons[0], ids=())], taught)
    assert [taught[each.lesson.author] for each in judgements] == judges and len(judgements) == 120
    singles = [judgement for judgement in judgements if judgement.stratum == "single"]
    assert sum(judgement.outcome == "exact" for judgement in singles) > 0.8 * len(singles)
    assert sum(judgement.outcome == "unknown" for judgement in judgements if judgement.stratum == "open") == 30


def test_sets_are_held_until_they_have_most_of_the_probability() -> None:
    assert held(np.array([0.05, 0.6, 0.3])) == [1, 2]
    assert held(np.array([0.02, 0.9, 0.03])) == [1]
    assert held(np.array([0.01, 0.09, 0.005])) == [1]  # whatever "none" has


def test_the_curriculum_has_every_effect_of_every_author_and_repeats() -> None:
    first, again = (curriculum(list(names()), 1, 7) for _ in range(2))
    assert first == again and first != curriculum(list(names()), 1, 8)
    for name, author in authors().items():
        alone = {lesson.effects[0] for lesson in first if lesson.author == name and len(lesson.effects) == 1}
        assert {law for law in author.laws if not law.startswith("x_")} <= alone


@pytest.mark.long
def test_a_lesson_has_the_signs_that_the_judge_weighs_and_comes_back_from_its_line() -> None:
    lesson = learnt(Lesson("lattice", 4, ("axial_elasticity",), (6.0,), "rich"))
    assert any(lesson.right) and lesson.ids[lesson.right.index(True)] == ("axial_elasticity",)
    assert {*judge().knots, *OF_EXPLANATION} <= set(lesson.signs[0])
    assert judge().recogniser and set(judge().recogniser.numbers) == set(lesson.signature)
    assert all(np.isfinite(value) for signs in lesson.signs for value in signs.values())
    assert read(written(lesson)) == lesson
    assert not learnt(replace(lesson, seed=5, effects=(), kappas=(), ids=(), signs=(), right=())).ids


def test_every_author_has_a_judge_who_was_taught_without_it() -> None:
    assert sorted(path.stem for path in JUDGES.glob("*.json")) == [f"without_{name}" for name in sorted(names())]
    weights = {path.read_text() for path in JUDGES.glob("*.json")} | {
        (ROOT / "pipeline" / "diagnosis" / "numerics" / "judge.json").read_text()
    }
    assert len(weights) == len(names()) + 1
    for path in JUDGES.glob("*.json"):
        missing = set(judge().knots) - set(judge(path).knots)
        assert set(judge(path).knots) <= set(judge().knots)
        assert all(name.startswith(("with_", "without_")) for name in missing)  # a mark that hardly ever shows


def test_a_file_that_is_no_judge_is_refused(tmp_path) -> None:
    (tmp_path / "judge.json").write_text('{"knots": {}}')
    with pytest.raises(BadInput, match="is no judge"):
        judge(tmp_path / "judge.json")


@pytest.mark.long
def test_the_program_keeps_its_lessons_and_writes_judges(tmp_path) -> None:
    wanted = curriculum(list(names()), 1, 50_000)
    lessons = made_lessons(len(wanted))
    kept = [
        replace(lesson, ids=other.ids, signs=other.signs, right=other.right)
        for lesson, other in zip(wanted, lessons, strict=True)
    ]
    (tmp_path / "lessons.jsonl").write_text("".join(f"{written(lesson)}\n" for lesson in kept))
    command = [
        sys.executable,
        "-m",
        "pipeline.proof.teach",
        "--rounds",
        "1",
        "--lessons",
        str(tmp_path / "lessons.jsonl"),
    ]
    command += ["--out", str(tmp_path / "judge.json"), "--apart", str(tmp_path / "apart")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in (tmp_path / "apart").iterdir()) == [
        f"without_{author}.json" for author in sorted(names())
    ]
    assert json.loads((tmp_path / "judge.json").read_text())["names"] == ["creep", "jam"]
    assert "single" in done.stdout and "mean set" in done.stdout


def test_an_authors_cases_are_asked_of_the_judge_who_does_not_know_the_author(tmp_path, monkeypatch) -> None:
    judges = []
    monkeypatch.setattr(verdicts, "find_runs", lambda folder: [folder / "case-1"])
    monkeypatch.setattr(verdicts, "ask", lambda runs, out, without, judge: judges.append(judge) or {"status": 0})
    for author in ("lattice", ""):
        monkeypatch.setattr(sys, "argv", ["verdicts", str(tmp_path), "--out", str(tmp_path), f"--untaught-by={author}"])
        with pytest.raises(SystemExit) as exit_info:
            verdicts.main()
        assert not exit_info.value.code
    assert judges == [JUDGES / "without_lattice.json", None] and judges[0].is_file()


def test_a_lesson_is_taught_on_what_a_diagnosis_of_the_run_folder_reads(tmp_path) -> None:
    recording = authors()["mechanics"].make(Asked(4, ("creep",), (3.0,), "usual"))
    assert "load_n" not in recording.table and recording.content["rig"]["load_n"] > 0
    write(recording, "lesson", tmp_path, tmp_path / "answer.json", "{}")
    _, samples, strokes = read_strokes(tmp_path / "lesson")
    taught = recorded({"run": "lesson", **recording.content}, recording.table)
    assert set(taught.samples["load_n"]) == {recording.content["rig"]["load_n"]}
    assert_frame_equal(taught.samples, samples)
    assert_frame_equal(taught.strokes, strokes)


def test_a_lesson_studies_it(monkeypatch) -> None:
    studied: list[RecordedRun] = []

    def seen(runs: list[RecordedRun]) -> None:
        studied.extend(runs)
        raise InterruptedError

    monkeypatch.setattr("pipeline.proof.teach.lesson.make_problem", seen)
    with pytest.raises(InterruptedError):
        learnt(Lesson("mechanics", 4, ("creep",), (3.0,), "usual"))
    assert float(studied[0].samples["load_n"].min()) > 0.0
