"""Questions are answered with intervals, flagged beyond the recorded range, and refused where they lack something."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from models.made_dataset import made_dataset

from pipeline.export.source import Beside, opened
from pipeline.ground.errors import BadInput
from pipeline.ground.kinematics import usual_stiffness
from pipeline.ground.stored import schemas
from pipeline.ground.words.jump_notes import NOT_COMPARED, write_jumps
from pipeline.models.interface import make_model
from pipeline.models.parts.questions.question_points import read_questions

ROOT = Path(__file__).parent.parent


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("predict") / "dataset.parquet"
    schemas.write(made_dataset(60, 6), schemas.DATASET, path)
    return path


def ask(dataset: Path, text: str, *words: str) -> programs.Done:
    questions = dataset.with_name("questions.csv")
    questions.write_text(text)
    return programs.run("pipeline.predict", dataset, questions, "--out", dataset.with_name("answers.csv"), *words)


def test_answers_come_with_intervals_and_what_lies_outside_is_flagged(dataset: Path) -> None:
    recorded_points = pd.read_parquet(dataset).iloc[[40, 200, 300]]
    lines = [f"{row.stroke},{row.direction},{row.motor_turns}" for row in recorded_points.itertuples()]
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns", *lines, "3,1,90\n"]), "--model", "polynomial")
    assert done.returncode == 0, done.stderr
    assert "1 of them without an interval" in done.stdout
    reason = r"twist 90 turns is above [\d.]+, the most that was recorded, with 1% to spare"
    assert re.search(rf"^  row 4: {reason}$", done.stdout, re.MULTILINE) and done.stdout.count("  row ") == 1
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["inside"].tolist() == [True, True, True, False]
    assert table.columns[-2:].tolist() == ["inside", "why"] and table["why"].isna().tolist() == [True] * 3 + [False]
    assert re.fullmatch(reason, table["why"][3])
    np.testing.assert_allclose(table["displacement_mm"][:3], recorded_points["displacement_mm"], atol=0.2)
    width = table["displacement_mm_high"] - table["displacement_mm_low"]
    assert (width[:3] > 0.03).all() and (width[:3] < 1.0).all()
    assert table[["displacement_mm_low", "displacement_mm_high"]].isna().all(axis=1).tolist() == [False] * 3 + [True]
    assert "inf" not in dataset.with_name("answers.csv").read_text(), "no interval is two empty cells"


def test_a_stroke_too_far_ahead_has_no_interval_and_a_higher_level_a_wider_one(dataset: Path) -> None:
    text = "stroke,direction,displacement_mm\n6,1,5\n7,1,5\n12,1,5\n"
    widths = {}
    for level in ("0.8", "0.95"):
        done = ask(dataset, text, "--model", "polynomial", "--level", level)
        assert done.returncode == 0 and "1 of them without an interval" in done.stdout
        assert "  row 3: stroke 12 is 6 after 6, the last recorded; errors were measured up to 2 strokes ahead (" in (
            done.stdout
        )
        table = pd.read_csv(dataset.with_name("answers.csv"))
        widths[level] = table["motor_turns_high"] - table["motor_turns_low"]
        assert widths[level][1] >= widths[level][0] and np.isnan(widths[level][2])
        assert table["inside"].tolist() == [True, True, False] and np.isfinite(table["motor_turns"]).all()
    assert (widths["0.95"] > widths["0.8"])[:2].all()


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("stroke,direction\n1,1\n", "columns"),
        ("stroke,direction,motor_turns,displacement_mm\n1,1,3,4\n", "row 1"),
        ("stroke,direction,motor_turns,displacement_mm\n1,1,,\n", "row 1"),
        ("stroke,direction,motor_turns,phase\n1,1,3,hold\n", "phase"),
        ("stroke,direction,motor_turns,phase\n1,-1,3,winding\n", "phase"),
        ("stroke,direction,motor_turns,time_s\n1,1,3,600\n", "time_s"),
        ('stroke,direction,motor_turns\n1,1,"3,5"\n', "motor_turns"),
        ("stroke,direction,motor_turns\n1,winding,3\n", "direction"),
        ("stroke,direction,motor_turns\n", "rows"),
        ("stroke,motor_turns\n1,3\n", "direction"),
        ("direction,motor_turns\n1,3\n", "stroke"),
        ("stroke,direction,motor_turns\n1,0,3\n", "direction"),
        ("stroke,direction,motor_turns\n1,1,many\n", "motor_turns"),
        ("stroke,direction,motor_turns\n1,1,\n", "motor_turns"),
        ("stroke,direction,motor_turns\n2.5,1,3\n", "stroke"),
        ("stroke,direction,motor_turns\n,1,3\n", "stroke"),
        ("stroke,direction,motor_turns\n0,1,3\n", "stroke"),
        ("stroke,direction,motor_turns\n9,1,1,3\n9,1,1,4\n", "rows"),  # pandas takes the first for an index
        ("stroke,direction,motor_turns,motor_turns\n1,1,3,4\n", "motor_turns"),
        ("stroke,direction,motor_turns\nTrue,1,3\n", "stroke"),
        ("stroke,direction,motor_turns\n1,1,1e999\n", "motor_turns"),
        ("stroke,direction,motor_turns,load_N\n1,1,3,20\n", "load_N"),
        ("stroke,direction,motor_turns,actuator\n1,1,3,\n", "actuator"),
        (",".join(f"a{number}" for number in range(100_000)) + "\n1\n", "file"),
    ],
)
def test_a_question_that_lacks_something_is_refused_by_name(dataset: Path, text: str, field: str) -> None:
    questions = dataset.with_name("wrong.csv")
    questions.write_text(text)
    with pytest.raises(BadInput) as refused:
        read_questions(questions, pd.read_parquet(dataset))
    assert refused.value.field == field and refused.value.file == str(questions)


@pytest.mark.parametrize("name", ["q.csv.gz", "q.csv.xz", "q.csv.zst", "q.tar", "q.csv", "pipe"])
def test_questions_that_are_no_text_are_refused_in_words(dataset: Path, tmp_path: Path, name: str) -> None:
    questions = tmp_path / name
    if name == "pipe":
        os.mkfifo(questions)
    else:
        questions.write_bytes(b"\x1f\x8b" + bytes(range(256)) if name.endswith("gz") else bytes(range(128, 256)))
    done = programs.run("pipeline.predict", dataset, questions, "--out", tmp_path / "out.csv")
    assert done.returncode == 2 and done.stderr.startswith(f"error: {questions}: file: "), done.stderr
    assert done.stderr.count("\n") == 1 and not (tmp_path / "out.csv").exists()


def test_a_misspelt_column_is_told_the_near_name(dataset: Path) -> None:
    done = ask(dataset, "stroke,direction,motor_turns,load_N\n1,1,3,20\n")
    assert done.returncode == 2 and "load_N: is not a column that is read. Mend: did you mean 'load_n'?" in done.stderr


@pytest.mark.parametrize(
    ("name", "mend"),
    [
        ("contraction_mm", "rename it: displacement_mm? That is in mm"),
        ("x", "rename it: displacement_mm? That is in mm"),
        ("turns", "rename it: motor_turns? That is in turns"),
        ("twist_turns", "rename it: motor_turns? That is in turns"),
    ],
)
def test_another_word_for_a_column_is_told_its_name(dataset: Path, name: str, mend: str) -> None:
    """Told to remove it, a person asked without what the question was about."""
    done = ask(dataset, f"stroke,direction,{name}\n1,1,3\n")
    assert done.returncode == 2 and f"{name}: is not a column that is read. Mend: {mend}" in done.stderr, done.stderr
    both = ask(dataset, f"strok,direction,{name}\n1,1,3\n")
    assert f"for strok, {mend.split(': ')[1].split('?')[0]} for {name}" in both.stderr, both.stderr


def test_all_wrong_columns_are_named_at_once(dataset: Path) -> None:
    done = ask(dataset, "strokes,dir,motor_turn,weather\n1,1,3,20\n")
    assert (
        done.returncode == 2
        and "strokes, dir, motor_turn, weather: are not columns that are read. Mend: " in done.stderr
    )
    assert "write stroke for strokes, direction for dir, motor_turns for motor_turn; known are" in done.stderr
    assert done.stderr.endswith(": take weather out, or write one of them.\n"), done.stderr


def test_what_varies_must_be_told(dataset: Path) -> None:
    questions = dataset.with_name("loads.csv")
    questions.write_text("stroke,direction,motor_turns\n1,1,3\n")
    varied = pd.read_parquet(dataset)
    varied.loc[varied["stroke"] > 3, "load_n"] = 30.0
    with pytest.raises(BadInput, match="load_n"):
        read_questions(questions, varied)


def test_answers_say_of_which_load_they_are(dataset: Path) -> None:
    varied = pd.read_parquet(dataset)
    varied.loc[varied["stroke"] % 2 == 0, "load_n"] = 30.0
    path = dataset.with_name("varied.parquet")
    schemas.write(varied, schemas.DATASET, path)
    text = "stroke,direction,motor_turns,load_n\n1,1,9,20\n1,1,9,30\n"
    done = ask(path, text, "--model", "polynomial")
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table.columns[:4].tolist() == ["motor_turns", "stroke", "direction", "load_n"]
    assert table["load_n"].tolist() == [20, 30]
    done = ask(path, "stroke,direction,motor_turns,load_n\n1,1,9,30\n", "--model", "polynomial")
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["load_n"].tolist() == [30] and "string" not in table, "one question differs from no other"


def test_help_says_what_directions_are_and_that_the_model_is_fitted_anew(dataset: Path) -> None:
    printed = " ".join(ask(dataset, "", "--help").stdout.split())
    assert "direction, 1 winding or -1 unwinding" in printed and "fitted anew, no saved file is read" in printed


def test_a_bad_level_and_a_missing_file_end_with_2(dataset: Path) -> None:
    assert ask(dataset, "stroke,direction,motor_turns\n1,1,3\n", "--level", "1.5").returncode == 2
    command = [sys.executable, "-m", "pipeline.predict", dataset, "nowhere.csv", "--out", dataset.with_name("x.csv")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 2 and "nowhere.csv" in done.stderr and not dataset.with_name("x.csv").exists()


def test_a_load_that_varies_as_a_load_cell_is_noisy_need_not_be_told(dataset: Path) -> None:
    questions = dataset.with_name("noisy.csv")
    questions.write_text("stroke,direction,motor_turns\n2.0,1,3\n")
    noisy = pd.read_parquet(dataset)
    noisy["load_n"] += np.random.default_rng(0).normal(0.0, 0.1, len(noisy))
    points = read_questions(questions, noisy).points
    assert points["load_n"].item() == pytest.approx(20.0, abs=0.02) and points["stroke"].item() == 2


def test_of_several_strings_the_one_asked_about_must_be_told(dataset: Path) -> None:
    questions = dataset.with_name("which.csv")
    questions.write_text("stroke,direction,motor_turns\n1,1,3\n")
    points = pd.read_parquet(dataset)
    with pytest.raises(BadInput, match="string"):
        read_questions(questions, pd.concat([points, points.assign(string="made-02")], ignore_index=True))


def test_a_model_with_a_memory_a_table_that_is_none_and_one_block_end_with_2(dataset: Path) -> None:
    text = "stroke,direction,motor_turns\n1,1,3\n"
    done = ask(dataset, text, "--model", "diagnosed")
    assert done.returncode == 2 and "whole motion" in done.stderr
    points = pd.read_parquet(dataset)
    wrong = {
        "none.parquet": None,
        "empty.parquet": points[:0],
        "block.parquet": points[points["stroke"] == 1].assign(block=3),
    }
    for name, rows in wrong.items():
        path = dataset.parent / name / "dataset.parquet"
        path.parent.mkdir()
        if rows is None:
            path.write_text("no table")
        else:
            schemas.write(rows.astype({"block": "int32"}), schemas.DATASET, path)
        done = ask(path, text, "--model", "polynomial")
        assert done.returncode == 2 and str(path) in done.stderr and "Mend" in done.stderr, done.stderr


def test_the_help_says_which_model_answers_where_none_is_named(dataset: Path) -> None:
    done = ask(dataset, "", "--help")
    assert done.returncode == 0 and "default: spline" in " ".join(done.stdout.split())
    assert "default: 0.9" in done.stdout


def test_of_many_questions_outside_the_first_have_their_reason(dataset: Path) -> None:
    lines = [f"40,1,{turns}\n" for turns in (90, 91, 90, 92, 93, 94, 95, 96)]
    done = ask(dataset, "stroke,direction,motor_turns\n" + "".join(lines), "--model", "polynomial")
    assert "8 of them without an interval" in done.stdout and done.stdout.count("  row") == 5
    assert "  and 2 more, each with its reason in the column `why`\n" in done.stdout
    both = r"twist {} turns is above [\d.]+, the most that was recorded, with 1% to spare; "
    both += "stroke 40 is 34 after 6, the last recorded; "
    assert re.search(rf"rows 1, 3: {both.format(90)}", done.stdout), "a reason of several rows is said once"
    assert re.search(rf"row 5: {both.format(93)}", done.stdout)
    assert pd.read_csv(dataset.with_name("answers.csv"))["why"].str.match(both.format(r"\d+")).all()


def saved_model(dataset: Path, points: pd.DataFrame, name: str, stem: str) -> Path:
    """The file of a model of a name, fitted to points, where the pipeline would put it."""
    file = dataset.parent / name / f"{stem}.model"
    file.parent.mkdir(exist_ok=True)
    model = make_model(name)
    model.fit(points, 0)
    model.save(file)
    return file


@pytest.mark.parametrize("name", ["spline", "polynomial"])
def test_a_saved_model_answers_as_itself_within_the_ranges_of_its_export(dataset: Path, name: str) -> None:
    """Header and `predict` side by side gave slightly other numbers: one was fitted to fewer points."""
    points = pd.read_parquet(dataset)
    file = saved_model(dataset, points[points["block"] % 4 != 0], name, "within-0")
    text = "stroke,direction,motor_turns\n2,1,9\n5,-1,14\n8,1,9\n13,1,9\n2,1,90\n"
    done = ask(dataset, text, "--saved", str(file))
    assert done.returncode == 0, done.stderr
    assert "without intervals; 2 of them outside of its export or of what was recorded." in done.stdout
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table.columns.tolist() == ["motor_turns", "stroke", "direction", "displacement_mm", "inside", "why"]
    source = opened(file, None, Beside(dataset=dataset))
    queries = np.array([[9, 2, 1], [14, 5, -1], [9, 8, 1]], float)
    meant = source.model.forward(source.inputs.points("motor_turns", queries))
    np.testing.assert_allclose(table["displacement_mm"][:3], meant, rtol=1e-5)
    assert table["inside"].tolist() == [True, True, True, False, False]
    limit = "(twice the last stroke that it was fitted to; TSA_BAD_STROKE)"
    assert f"  row 4: stroke 13 is above 12, the most that the export takes {limit}\n" in done.stdout
    assert table["why"][3] == f"stroke 13 is above 12, the most that the export takes {limit}"
    limit = r"\(of the points that it was fitted to, with 1% to spare; TSA_BAD_MOTOR_TURNS\)"
    words = rf"twist 90 turns is above [\d.]+, the most that the export takes {limit}"
    assert re.fullmatch(words, table["why"][4]) and table["why"][:3].isna().all()


def test_a_stroke_too_far_ahead_of_a_saved_model_is_flagged_as_it_is_of_one_that_is_fitted_anew(dataset: Path) -> None:
    """Stroke 12 of a string of 6 was answered as inside, and nothing said that no error was ever measured there."""
    points = pd.read_parquet(dataset)
    text = "stroke,direction,motor_turns\n6,1,9\n8,1,9\n9,1,9\n12,-1,9\n13,1,9\n"
    flagged = {}
    for stem, fitted_points in (("far-0", points), ("later-0", points[points["stroke"] <= 5])):
        file = saved_model(dataset, fitted_points, "spline", stem)
        done = ask(dataset, text, "--saved", str(file))
        assert done.returncode == 0, done.stderr
        table = pd.read_csv(dataset.with_name("answers.csv"))
        flagged[stem] = table["inside"].tolist()
        assert np.isfinite(table["displacement_mm"]).all()
        last = fitted_points["stroke"].max()
        reason = (
            f"stroke 9 is {9 - last} after {last}, the last that the model was fitted to; errors were measured up to 2 "
            "strokes ahead (strokes recorded - 4, at most 3); the export answers, by the model's law of n (in C "
            "tsa_recorded says so)"
        )
        assert table["why"][2] == reason and f"  row 3: {reason}\n" in done.stdout
        assert "TSA_BAD_STROKE" in table["why"][4] and "law of n" not in table["why"][4]
    assert flagged == {"far-0": [True, True, False, False, False], "later-0": [True, False, False, False, False]}


def test_a_file_of_questions_that_is_not_there_is_said_to_be_missing(dataset: Path) -> None:
    words = (dataset, dataset.with_name("nothere.csv"), "--out", dataset.with_name("answers.csv"))
    done = programs.run("pipeline.predict", *words)
    assert done.returncode == 2 and "nothere.csv" in done.stderr and "is not there" in done.stderr
    assert "part columns by commas" not in done.stderr


def test_a_saved_model_of_another_material_is_refused(dataset: Path, tmp_path: Path) -> None:
    file = saved_model(dataset, pd.read_parquet(dataset), "polynomial", "other-0")
    beside = tmp_path / "twine" / "dataset.parquet"
    beside.parent.mkdir()
    beside.write_bytes(dataset.read_bytes())
    done = ask(beside, "stroke,direction,motor_turns\n2,1,9\n", "--saved", str(file))
    assert done.returncode == 2 and f"was fitted to {dataset}, and {beside} is another" in done.stderr, done.stderr
    assert f"Mend: ask with {dataset}" in done.stderr and not (beside.parent / "answers.csv").exists()


def test_a_saved_model_takes_no_settings_and_a_file_of_none_is_refused(dataset: Path) -> None:
    text = "stroke,direction,motor_turns\n1,1,3\n"
    done = ask(dataset, text, "--saved", "spline/within-0.model", "--model", "spline")
    assert done.returncode == 2 and "leave out --model, --settings, --each-string and --level" in done.stderr
    done = ask(dataset, text, "--saved", str(dataset.parent / "spline" / "no.model"))
    assert done.returncode == 2 and f"is not there. Mend: name one of {dataset.parent}/spline/" in done.stderr


@pytest.mark.parametrize("saved", [False, True], ids=["anew", "saved"])
def test_a_contraction_that_no_twist_gives_is_outside_and_said(dataset: Path, saved: bool) -> None:
    """The largest recorded twist was answered, as inside and with an interval."""
    points = pd.read_parquet(dataset)
    file = saved_model(dataset, points, "spline", "reach-0")
    ends = points[points["stroke"] == 6].groupby("direction")["displacement_mm"].agg(["min", "max"]).loc[1]
    first = points[points["stroke"] == 1]["displacement_mm"]
    contractions_mm = [0.5 * (ends["min"] + ends["max"]), first.max() - 0.01, ends["min"] - 0.01]
    strokes = [6, 6, 1]
    lines = [f"{stroke},1,{value}" for stroke, value in zip(strokes, contractions_mm, strict=True)]
    words = ("--saved", str(file)) if saved else ("--model", "spline")
    done = ask(dataset, "\n".join(["stroke,direction,displacement_mm", *lines]) + "\n", *words)
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert first.max() - ends["max"] > 0.3 and first.min() - ends["min"] > 0.3, "strokes differ by what they reach"
    assert table["inside"].tolist() == [True, False, False]
    assert table["why"].str.startswith("HELD at ").tolist()[1:] == [True, True] and table["why"].isna()[0]
    assert table["why"].str.endswith(" (TSA_HELD)").tolist()[1:] == [saved, saved]
    assert "at this stroke and direction" in table["why"][1], "no load was asked: it was the same all the time"
    least_mm, most_mm = (float(number) for number in re.findall(r"give (-?[\d.]+) to ([\d.]+) mm", table["why"][1])[0])
    assert contractions_mm[1] > most_mm > ends["max"] - 0.1 and least_mm == pytest.approx(ends["min"], abs=0.1)
    held_turns = [float(re.findall(r"HELD at ([-\d.]+) turns", words)[0]) for words in table["why"][1:]]
    np.testing.assert_allclose(table["motor_turns"][1:], held_turns, rtol=1e-3)


def test_of_a_contraction_beyond_all_that_was_recorded_it_is_said_where_its_twist_is_held(dataset: Path) -> None:
    """The end of the range stood in the cell as an answer, and `why` told of the contraction alone."""
    done = ask(dataset, "stroke,direction,displacement_mm\n3,1,5\n3,1,90\n", "--model", "polynomial")
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["inside"].tolist() == [True, False] and table["why"].isna()[0]
    end = pd.read_parquet(dataset)["motor_turns"].max()
    assert table["motor_turns"][1] == pytest.approx(end, rel=0.02)
    assert "contraction 90 mm is above" in table["why"][1]
    assert table["why"][1].endswith(f"; HELD at {table['motor_turns'][1]:.4g} turns, the end of the range")


@pytest.mark.parametrize("is_saved", [False, True], ids=["anew", "saved"])
def test_rows_that_ask_for_twist_and_rows_that_ask_for_contraction_may_stand_in_one_file(
    dataset: Path, is_saved: bool
) -> None:
    """Such a file was refused as telling both, though each of its rows told one."""
    points = pd.read_parquet(dataset)
    file = saved_model(dataset, points, "polynomial", "mixed-0")
    words = ("--saved", str(file)) if is_saved else ("--model", "polynomial")
    rows = ["3,1,9,", "3,-1,,5", "3,1,90,", "3,1,14,"]
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns,displacement_mm", *rows]) + "\n", *words)
    assert done.returncode == 0, done.stderr
    mixed = pd.read_csv(dataset.with_name("answers.csv"))
    assert mixed["asked_for"].tolist() == ["displacement_mm", "motor_turns", "displacement_mm", "displacement_mm"]
    assert mixed["direction"].tolist() == [1, -1, 1, 1] and mixed["inside"].tolist() == [True, True, False, True]
    assert mixed["why"].notna().tolist() == [False, False, True, False] and mixed.columns[-1] == "why"
    for name, places in (("motor_turns", [0, 2, 3]), ("displacement_mm", [1])):
        alone = [",".join(filter(None, rows[place].split(","))) for place in places]
        assert ask(dataset, "\n".join([f"stroke,direction,{name}", *alone]) + "\n", *words).returncode == 0
        single = pd.read_csv(dataset.with_name("answers.csv"))
        for column in single:
            pairs = zip(single[column], mixed[column][places], strict=True)
            assert all(alone == beside or (alone != alone and beside != beside) for alone, beside in pairs), column


def test_a_question_of_another_load_than_the_one_that_is_baked_in_is_no_answer_of_the_export(dataset: Path) -> None:
    """It was answered by what the model makes of that load, as inside, where the header has no field for a load."""
    points = pd.read_parquet(dataset)
    file = saved_model(dataset, points, "spline", "load-0")
    done = ask(dataset, "stroke,direction,motor_turns,load_n\n3,1,9,20\n3,1,9,45\n", "--saved", str(file))
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["inside"].tolist() == [True, False] and table["why"][1] == "load 45 N: the export has 20 baked in"


@pytest.mark.long
def test_a_limit_that_is_named_is_itself_inside(dataset: Path) -> None:
    done = ask(dataset, "stroke,direction,motor_turns\n3,1,90\n3,1,-90\n", "--model", "polynomial")
    limits = re.findall(r"is (?:above|below) (-?[\d.]+),", done.stdout)
    done = ask(dataset, "stroke,direction,motor_turns\n" + "".join(f"3,1,{end}\n" for end in limits))
    assert len(limits) == 2 and "without an interval" not in done.stdout, done.stdout


def test_all_rows_that_cannot_be_answered_are_named_at_once_and_the_others_answered(dataset):
    """One bad row refused the whole file."""
    rows = ["1,1,3", "1.5,1,3", "1,2,3", "1,1,x", "1,1,", "1,1,inf", "1,-1,4"]
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns", *rows]) + "\n", "--model", "polynomial")
    first = "rows: 5 cannot be answered (row 1 is the first question). Mend: each as its line says."
    assert done.returncode == 2 and done.stderr.splitlines() == [
        f"error: {dataset.with_name('questions.csv')}: {first} The other 2 rows are answered.",
        "  row 2: stroke is 1.5, no whole number from 1; the first stroke of a new string is 1",
        "  row 3: direction is 2, neither 1 nor -1; 1 is winding, -1 unwinding",
        "  row 4: motor_turns is 'x', no number; write a number alone",
        "  row 5: motor_turns is empty or nan; fill it in, or take the row out",
        "  row 6: motor_turns is without end; write a number",
    ], "a line a row: all were one paragraph"
    assert "2 answers in " in done.stdout and "; 5 rows without an answer. The column `why` says why" in done.stdout
    assert "row 4" not in done.stdout, "what is wrong is said once, in the error"
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["inside"].tolist() == [True, *[False] * 5, True] and table["stroke"][[0, 1, 6]].tolist() == [1, 1.5, 1]
    assert table["displacement_mm"].notna().tolist() == table["inside"].tolist() == table["why"].isna().tolist()
    assert table["displacement_mm_low"].notna().tolist() == table["inside"].tolist()
    good = ask(dataset, "\n".join(["stroke,direction,motor_turns", rows[0], rows[-1]]) + "\n", "--model", "polynomial")
    alone = pd.read_csv(dataset.with_name("answers.csv"))
    assert good.returncode == 0 and alone["displacement_mm"].tolist() == table["displacement_mm"][[0, 6]].tolist()


def test_where_no_row_can_be_answered_nothing_is_written(dataset):
    answers = dataset.with_name("answers.csv")
    answers.unlink(missing_ok=True)
    rows = [*["1,3,3"] * 40, *(f"1,1,x{number}" for number in range(9))]
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns", *rows]) + "\n")
    assert done.returncode == 2 and not answers.exists()
    first, alike, *others = done.stderr.splitlines()
    assert "49 cannot be answered (row 1 is the first question)" in first
    assert first.endswith("Until then no row is answered.")
    assert alike == "  rows 1 to 40: direction is 3, neither 1 nor -1; 1 is winding, -1 unwinding"
    assert [line.split(":")[0] for line in others[:-1]] == ["  row 41", "  row 42", "  row 43", "  row 44"]
    assert others[-1] == "  and 5 more", "no file has them"


def test_of_many_bad_rows_the_first_are_said_and_where_the_others_are(dataset):
    """Twelve bad rows were one paragraph, with their mends behind all of them."""
    rows = ["1,1,3", *(f"1,1,x{number}" for number in range(12))]
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns", *rows]) + "\n", "--model", "polynomial")
    lines, answers = done.stderr.splitlines(), dataset.with_name("answers.csv")
    assert done.returncode == 2 and len(lines) == 7 and lines[1].startswith("  row 2: motor_turns is 'x0', no number; ")
    assert lines[6] == f"  and 7 more, each with its reason in the column `why` of {answers}"
    assert pd.read_csv(answers)["why"].notna().sum() == 12


@pytest.mark.parametrize(("row", "has"), [("1,1,3,5", 4), ("1,1,3,5,,7", 6), ("1", 1), ("1,1", 2)])
@pytest.mark.parametrize("place", [0, 1, 2], ids=["first", "middle", "last"])
def test_a_row_with_another_number_of_fields_is_refused_alone(dataset, row, has, place):
    """One with too many fields refused the whole file; a last one with too few was left out with status 0."""
    rows = ["1,1,3", "1,-1,4"]
    rows.insert(place, row)
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns", *rows]) + "\n", "--model", "polynomial")
    fields = f"{has} field{'s' * (has > 1)}, and the header has 3"
    assert done.returncode == 2 and f"row {place + 1}: has {fields}. Mend: " in done.stderr, done.stderr
    assert done.stderr.endswith("The other 2 rows are answered.\n") and "1 row without an answer" in done.stdout
    assert ("what is missing: " in done.stderr) == (has < 3) and "cut off" not in done.stderr
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["inside"].tolist() == [at != place for at in range(3)] and table["displacement_mm"].notna().sum() == 2
    assert table["why"][place].startswith(f"no question: has {fields}; ")


def test_fields_that_may_be_empty_may_be_left_out(dataset):
    text = "stroke,direction,motor_turns,displacement_mm\n1,1,3\n1,1,,5,,\n1,1,4,\n"
    done = ask(dataset, text, "--model", "polynomial")
    assert done.returncode == 0 and pd.read_csv(dataset.with_name("answers.csv"))["inside"].all(), done.stderr


def test_a_string_that_is_called_by_a_number_is_found(dataset):
    """`07` was read as 7, which no recording has; beside an empty cell 12 was read as 12.0."""
    first = pd.read_parquet(dataset)
    path = dataset.with_name("numbered.parquet")
    strings = [first.assign(string=name, radius_mm=radius) for name, radius in (("07", 0.4), ("12", 0.5))]
    schemas.write(pd.concat(strings, ignore_index=True), schemas.DATASET, path)
    done = ask(path, "stroke,direction,motor_turns,string\n1,1,3,07\n1,1,3, 12 \n1,1,3,\n", "--model", "polynomial")
    table = pd.read_csv(dataset.with_name("answers.csv"), dtype=str)
    assert done.returncode == 2 and table["inside"].tolist() == ["True", "True", "False"], done.stdout
    assert table["string"].tolist()[:2] == ["07", "12"]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("My questions\nstroke,direction,motor_turns\n1,1,3\n1,1,4\n", "Mend: begin with the header."),
    ],
)
def test_another_layout_is_said_to_be_that(dataset, text, says):
    done = ask(dataset, text)
    assert done.returncode == 2 and says in done.stderr, done.stderr


ASKED = [{"stroke": 3, "direction": 1, "motor_turns": 9.5}, {"stroke": 3, "direction": -1, "motor_turns": 4.25}]


def answered_as(dataset, name, write):
    """The answers to a file of the same questions, and what is said."""
    questions, out = dataset.with_name(name), dataset.with_name("other_answers.csv")
    write(questions)
    done = programs.run("pipeline.predict", dataset, questions, "--model", "polynomial", "--out", out)
    return done, (out.read_text() if done.returncode == 0 else "")


@pytest.mark.parametrize(
    ("name", "write"),
    [
        ("german.csv", lambda path: pd.DataFrame(ASKED).to_csv(path, index=False, sep=";", decimal=",")),
        ("points.csv", lambda path: pd.DataFrame(ASKED).to_csv(path, index=False, sep=";")),
        ("tabs.txt", lambda path: pd.DataFrame(ASKED).to_csv(path, index=False, sep="\t", decimal=",")),
        ("sheet.xlsx", lambda path: pd.DataFrame(ASKED).to_excel(path, index=False)),
    ],
)
def test_the_same_questions_in_another_layout_have_the_same_answers(dataset, name, write):
    """Semicolons and workbooks were refused, though an import reads them."""
    done, answers = answered_as(dataset, name, write)
    assert done.returncode == 0, done.stderr
    plain, expected = answered_as(dataset, "plain.csv", lambda path: pd.DataFrame(ASKED).to_csv(path, index=False))
    assert plain.returncode == 0 and answers == expected


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        (["3;1;9,5", "3;-1;4.25"], "hold 9,5 and 4.25: the comma may"),
        (["3\t1\t9,500", "3\t-1\t4,250"], "hold 9,500: the comma may"),
    ],
)
def test_a_comma_that_may_part_thousands_is_refused_with_the_command_that_mends_it(dataset, rows, says):
    mark = ";" if ";" in rows[0] else "\t"
    text = "\n".join([mark.join(ASKED[0]), *rows]) + "\n"
    done, _ = answered_as(dataset, "it's.csv", lambda path: path.write_text(text))
    assert done.returncode == 2 and says in done.stderr, done.stderr
    subprocess.run(["bash", "-ec", done.stderr.splitlines()[-1]], check=True)
    mended = dataset.with_name("it's-points.csv")
    assert pd.read_csv(mended)["motor_turns"].tolist() == [9.5, 4.25]
    done, _ = answered_as(dataset, mended.name, lambda path: None)
    assert done.returncode == 0, done.stderr


def test_a_cell_of_a_workbook_that_is_no_number_keeps_its_row_alone(dataset):
    rows = [*ASKED, {"stroke": 3, "direction": "up", "motor_turns": 4.0}, {"stroke": 3, "direction": 1}]
    done, _ = answered_as(dataset, "words.xlsx", lambda path: pd.DataFrame(rows).to_excel(path, index=False))
    assert done.returncode == 2 and "row 3: direction is 'up', no number" in done.stderr, done.stderr
    assert "row 4: motor_turns is empty" in done.stderr


def test_a_string_that_a_workbook_calls_by_a_number_is_found(dataset):
    first = pd.read_parquet(dataset)
    path = dataset.with_name("numbered_too.parquet")
    strings = [first.assign(string=name, radius_mm=radius) for name, radius in (("7", 0.4), ("12", 0.5))]
    schemas.write(pd.concat(strings, ignore_index=True), schemas.DATASET, path)
    table = pd.DataFrame([{**row, "string": 12} for row in ASKED])
    done, answers = answered_as(path, "numbered.xlsx", lambda file: table.to_excel(file, index=False))
    assert done.returncode == 0 and answers.count(",12,") == 2, done.stderr + answers


def test_a_damaged_workbook_is_to_be_saved_as_csv(dataset):
    questions = dataset.with_name("questions.xlsx")
    questions.write_bytes(b"PK\x03\x04" + bytes(100))
    done = programs.run("pipeline.predict", dataset, questions, "--out", dataset.with_name("answers.csv"))
    assert done.returncode == 2 and "Mend: save its sheet of questions as CSV" in done.stderr, done.stderr


@pytest.mark.parametrize("is_saved", [False, True], ids=["anew", "saved"])
def test_a_bad_row_among_questions_of_both_ways_keeps_its_place(dataset, is_saved):
    file = saved_model(dataset, pd.read_parquet(dataset), "polynomial", "bad-0")
    words = ("--saved", str(file)) if is_saved else ("--model", "polynomial")
    rows = ["3,1,9,", "3,1,9,5", "3,-1,,5"]
    done = ask(dataset, "\n".join(["stroke,direction,motor_turns,displacement_mm", *rows]) + "\n", *words)
    assert done.returncode == 2 and "row 2: tells both motor_turns and displacement_mm" in done.stderr
    table = pd.read_csv(dataset.with_name("answers.csv"))
    assert table["asked_for"].fillna("").tolist() == ["displacement_mm", "", "motor_turns"]
    assert table["inside"].tolist() == [True, False, True] and table["why"].notna().tolist() == [False, True, False]
    assert table["why"][1].startswith("no question: tells both motor_turns and displacement_mm; leave the cell empty")


@pytest.mark.parametrize("phase", ["hold", "rest", "dwell", "Hold"])
def test_no_row_of_a_motor_that_stands_is_answered(dataset, phase):
    text = f"stroke,direction,motor_turns,phase\n1,1,3,winding\n1,1,4,{phase}\n"
    done = ask(dataset, text, "--model", "polynomial")
    assert done.returncode == 2 and f"phase: is {phase} in row 2" in done.stderr and "--motion" in done.stderr
    assert pd.read_csv(dataset.with_name("answers.csv"))["displacement_mm"].notna().tolist() == [True, False]
    done = ask(dataset, "stroke,direction,motor_turns\n1,1,3\n1,0,4\n", "--model", "polynomial")
    assert done.returncode == 2 and "direction: is 0 in row 2, neither 1 nor -1" in done.stderr
    assert "The other 1 row is answered." in done.stderr


def test_all_columns_and_all_strings_that_are_missing_are_named_at_once(dataset):
    """`string` was named, then `load_n`, and of the strings the first five."""
    first = pd.read_parquet(dataset)
    strings = [first.assign(string=f"made-{number:02d}", load_n=10.0 + number) for number in range(8)]
    path = dataset.with_name("strings.parquet")
    schemas.write(pd.concat(strings, ignore_index=True), schemas.DATASET, path)
    done = ask(path, "stroke,direction,motor_turns\n1,1,3\n")
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    page = (ROOT / "docs" / "use_a_model.md").read_text()
    assert "\n| `string` | " in page and "\n| `load_n` and the like | " in page, "it tells which columns are asked for"
    assert "load_n, string: are missing, and vary in the recordings" in done.stderr.replace(
        "string, load_n", "load_n, string"
    )
    assert "load_n, recorded are 10 to 17 N" in done.stderr
    assert f"recorded are {', '.join(f'made-{number:02d}' for number in range(8))}" in done.stderr


JUMP = "The zero jumps by 3 mm."
TWO = "stroke,direction,motor_turns,string\n2,1,9,made-01\n2,1,9,made-02\n"


@pytest.fixture(scope="module")
def of_two(dataset: Path) -> Path:
    """A dataset of two strings of the same sizes, of which the second contracts a tenth less."""
    first = pd.read_parquet(dataset)
    second = first.assign(string="made-02", run="made-02", displacement_mm=first["displacement_mm"] * 0.9)
    path = dataset.parent / "processed" / "two" / "dataset.parquet"
    path.parent.mkdir(parents=True)
    schemas.write(pd.concat([first.assign(string="made-01"), second], ignore_index=True), schemas.DATASET, path)
    return path


def answered(of_two: Path) -> pd.DataFrame:
    return pd.read_csv(of_two.with_name("answers.csv"), keep_default_na=False)


def test_strings_of_the_same_sizes_have_one_answer_and_that_is_said(of_two: Path) -> None:
    """`string` was asked for, both strings had the same number, and nothing said that it is their mean."""
    done = ask(of_two, TWO, "--model", "polynomial")
    beware = "beware: polynomial does not tell strings of the same sizes apart: made-01, made-02 have one answer, "
    assert answered(of_two)["displacement_mm"].nunique() == 1 and beware in done.stderr, done.stderr
    assert "For answers of one string alone: --each-string, or --model calibrated." in done.stderr
    assert answered(of_two)["answer_of"].tolist() == ["made-01, made-02"] * 2, "the file says it where nobody reads"
    pooled_width = answered(of_two).eval("displacement_mm_high - displacement_mm_low")
    for options in (["--model", "polynomial", "--each-string"], ["--model", "calibrated"]):
        done = ask(of_two, TWO, *options)
        assert done.returncode == 0 and "beware" not in done.stderr, done.stderr
        table = answered(of_two)
        assert table["displacement_mm"].nunique() == 2 and "answer_of" not in table
        if "--each-string" in options:
            assert table["displacement_mm"][1] == pytest.approx(0.9 * table["displacement_mm"][0], rel=0.01)
            width = table.eval("displacement_mm_high - displacement_mm_low")
            assert (width < 0.5 * pooled_width).all(), "the interval is of one string"
            assert f"by the polynomial model, fitted anew to each string of {of_two} alone" in done.stdout


def test_each_string_alone_is_answered_as_if_no_other_were_there(dataset: Path, of_two: Path) -> None:
    ask(of_two, TWO, "--model", "polynomial", "--each-string")
    ask(dataset, TWO.splitlines()[0].removesuffix(",string") + "\n2,1,9\n", "--model", "polynomial")
    alone = pd.read_csv(dataset.with_name("answers.csv"))
    both = answered(of_two)
    for name in ("displacement_mm", "displacement_mm_low", "displacement_mm_high"):
        assert both[name][0] == alone[name][0]
    mixed = f"{TWO.splitlines()[0]},displacement_mm\n2,1,9,made-02,\n2,-1,,made-01,3\n2,5,9,made-01,\n2,1,9,made-01,\n"
    done = ask(of_two, mixed, "--model", "polynomial", "--each-string")
    table = answered(of_two)
    assert done.returncode == 2 and "in row 3, neither 1 nor -1" in done.stderr, done.stderr
    assert table["string"].tolist()[:2] == ["made-02", "made-01"] and table["asked_for"][1] == "motor_turns"
    assert [float(table["displacement_mm"][row]) for row in (0, 3)] == both["displacement_mm"].tolist()[::-1]
    pooled = ask(of_two, mixed, "--model", "polynomial")
    assert pooled.returncode == 2 and answered(of_two)["answer_of"].tolist() == ["made-01, made-02"] * 2 + [
        "",
        *["made-01, made-02"],
    ]


def test_each_string_of_a_dataset_of_one_string_is_said_to_change_nothing(dataset: Path, of_two: Path) -> None:
    """The option was taken without a word, and the numbers were those without it."""
    text, words = "stroke,direction,motor_turns\n2,1,9\n", ("--model", "polynomial")
    note = f"note: --each-string changes nothing: {dataset} is of one string.\n"
    assert note not in ask(dataset, text, *words).stderr
    without = dataset.with_name("answers.csv").read_text()
    done = ask(dataset, text, *words, "--each-string")
    assert done.returncode == 0 and done.stderr.count(note) == 1, done.stderr
    assert dataset.with_name("answers.csv").read_text() == without
    assert "changes nothing" not in ask(of_two, TWO, *words, "--each-string").stderr


def test_a_load_beyond_all_recorded_ones_is_said_to_be_far_off_of_a_new_string_too(of_two_sizes: Path) -> None:
    """60 N of a new string stood among the answers as any number; of a recorded one a line said what to do."""
    points = pd.read_parquet(of_two_sizes)
    points["load_n"] = np.where(points["stroke"] <= 3, 20.0, 40.0)
    loads = of_two_sizes.with_name("loads.parquet")
    schemas.write(points, schemas.DATASET, loads)
    rows = "2,1,9,new,0.5,20\n2,1,9,new,0.5,30\n2,1,9,new,0.5,60\n2,1,9,new,0.5,5\n2,1,9,made-01,0.4,60\n"
    done = ask(loads, f"stroke,direction,motor_turns,string,radius_mm,load_n\n{rows}", "--model", "polynomial")
    assert done.returncode == 0, done.stderr
    far_off = "no string was recorded under such a load, and the numbers of polynomial may be far off."
    thinner = "The equations know of a load that it makes the string thinner, and they know no stretch."
    compare = f"Record one under it. {thinner} To compare, what the equations answer:\n  "
    assert f"\nRows 3, 4: {far_off} {compare}" in done.stdout and "--model traditional" in done.stdout
    assert "\nRow 5: the string was not recorded under this load" in done.stdout
    first, answers = loads.with_name("answers.csv"), loads.with_name("answers-traditional.csv")
    by_polynomial = first.read_bytes()
    line = next(line for line in done.stdout.splitlines() if "--model traditional" in line)
    compared = programs.run("pipeline.predict", *shlex.split(line)[3:])
    assert f"answers in {answers}, by the traditional model" in compared.stdout, compared.stderr
    assert answers.exists() and first.read_bytes() == by_polynomial, "the command wrote over the answers to compare"


def test_a_saved_model_of_each_string_answers_about_all_of_them(of_two: Path) -> None:
    """The command that the material's page prints was refused where a file asked about two strings."""
    file = saved_model(of_two, pd.read_parquet(of_two), "calibrated", "within-0")
    done = ask(of_two, TWO, "--saved", str(file))
    assert done.returncode == 0 and not done.stderr, done.stderr
    assert answered(of_two)["displacement_mm"].nunique() == 2 and answered(of_two)["inside"].all()
    for options in (["--saved", str(file)], ["--model", "calibrated"], ["--model", "polynomial", "--each-string"]):
        done = ask(of_two, TWO.replace("made-02", "made-03"), *options)
        table = answered(of_two)
        assert done.returncode == 2 and not table["inside"][1] and table["displacement_mm"][0] and len(table) == 2
        reason = "string is made-03, which has no recording; recorded are made-01, made-02"
        takers = "a new string is answered by the models cinn, inn, mlp, polynomial, spline, traditional"
        assert table["why"][1] == f"no question: {reason}; {takers}" and "string: is made-03 in row 2" in done.stderr
        assert "--string" not in done.stderr, "predict has no such option"
    file = saved_model(of_two, pd.read_parquet(of_two), "spline", "within-0")
    done = ask(of_two, TWO.replace("made-02", "made-03"), "--saved", str(file))
    table = answered(of_two)
    assert done.returncode == 0 and table["inside"].tolist() == [True, False]
    assert table["why"][1].startswith("string made-03 is none that it was fitted to"), "it was answered as inside"


def test_a_string_of_several_has_the_range_of_its_own_recording(of_two: Path) -> None:
    """Asked for a contraction that the other string reached, calibrated gave the end of its range as an answer."""
    points = pd.read_parquet(of_two)
    most_mm = points.groupby("string")["displacement_mm"].max()
    assert most_mm["made-01"] > 1.05 * most_mm["made-02"]
    text = f"stroke,direction,displacement_mm,string\n2,1,{most_mm['made-01'] - 0.01},made-02\n"
    for options in (["--model", "calibrated"], ["--model", "polynomial", "--each-string"]):
        assert ask(of_two, text, *options).returncode == 0
        assert not answered(of_two)["inside"][0] and answered(of_two)["motor_turns_low"][0] == ""


@pytest.mark.long
def test_the_model_that_the_page_takes_is_named_where_another_answers(of_two: Path) -> None:
    models_csv = of_two.parents[2] / "reports" / "two" / "models.csv"
    models_csv.parent.mkdir(parents=True)
    rows = [("spline", 0.5), ("polynomial", 0.1), ("floor", 0.01), ("diagnosed", 0.02)]
    lines = [f"{name},later,forward,all,{error}" for name, error in rows]
    models_csv.write_text("\n".join(["model,split,map,column,median", *lines, ""]))
    named = "The page of two takes polynomial: --model polynomial asks that one.\n"
    assert named in ask(of_two, TWO).stdout
    assert named not in ask(of_two, TWO, "--model", "mlp", "--settings", '{"epochs": 1}').stdout, "who names one knows"
    models_csv.unlink()
    assert "The page of" not in ask(of_two, TWO).stdout


def test_what_is_said_of_the_zero_is_one_line_a_call(dataset: Path) -> None:
    """Each pair of runs had a line of its own above the answers, at every call."""
    notes, text = dataset.with_name("zero_jumps.json"), "stroke,direction,motor_turns\n1,1,3\n1,1,4\n"
    uncompared = [f"{NOT_COMPARED} a and {run}: why." for run in "bcd"]
    try:
        for sentences, beware in (
            (uncompared[:1], f"{NOT_COMPARED} a and b: why."),
            ([*uncompared, JUMP], f"{JUMP} 3 more notes on the zero of these runs: {notes}"),
        ):
            write_jumps(notes, {str(pd.read_parquet(dataset)["string"].iloc[0]): sentences})
            done = ask(dataset, text, "--model", "polynomial")
            assert done.returncode == 0 and done.stderr == f"beware: {beware}\n" and done.stdout.count("zero") == 1
    finally:
        for path in notes.parent.glob(f"{notes.name}*"):
            path.unlink()


@pytest.mark.parametrize(
    "options",
    [["--model", "polynomial"], ["--model", "polynomial", "--each-string"], ["--model", "traditional"]],
    ids=lambda options: options[-1],
)
def test_the_zero_of_another_string_is_no_beware_of_the_questions(of_two: Path, options: list[str]) -> None:
    """It stood above answers about a string whose zero was never moved."""
    notes = of_two.with_name("zero_jumps.json")
    write_jumps(notes, {"made-01": [JUMP]})
    learnt = "note: the model that answers has learnt string made-01 too, whose zero jumps between runs"
    try:
        for string in ("made-01", "made-02"):
            done = ask(of_two, f"stroke,direction,motor_turns,string\n2,1,9,{string}\n", *options)
            assert done.returncode == 0 and (f"beware: {JUMP}" in done.stderr) == (string == "made-01"), done.stderr
            is_learnt = string == "made-02" and options == ["--model", "polynomial"]
            assert ("by the traditional model, which learns nothing" in done.stdout) == ("traditional" in options)
            assert (f"{learnt}: {notes}\n" in done.stderr) == is_learnt, done.stderr
    finally:
        for path in notes.parent.glob(f"{notes.name}*"):
            path.unlink()


def test_a_dataset_that_is_not_there_can_be_made_alone_if_its_material_was_recorded(tmp_path: Path) -> None:
    (tmp_path / "raw" / "nylon-1").mkdir(parents=True)
    (tmp_path / "raw" / "nylon-1" / "run.yaml").write_text("string:\n  material: nylon  # of spool 3\n")
    (tmp_path / "questions.csv").write_text(TWO)
    for material in ("nylon", "nylom"):
        missing = f"processed/{material}/dataset.parquet"
        done = programs.run("pipeline.predict", missing, "questions.csv", "--out", "answers.csv", cwd=tmp_path)
        make = f"or make it alone, in seconds: snakemake --cores 2 -- {missing}."
        assert done.returncode == 2 and (make in done.stderr) == (material == "nylon"), done.stderr


def test_a_column_that_is_near_none_is_to_be_taken_out(dataset: Path) -> None:
    done = ask(dataset, "stroke,direction,motor_turns,note\n1,1,3,first\n")
    assert "note: is not a column that is read. Mend: take it out; known are motor_turns, " in done.stderr, done.stderr


@pytest.fixture(scope="module")
def of_two_sizes(dataset: Path) -> Path:
    """A dataset of two strings of other radii, made-01 and made-02."""
    first, path = pd.read_parquet(dataset), dataset.with_name("two_sizes.parquet")
    second = first.assign(string="made-02", run="made-02", displacement_mm=first["displacement_mm"] * 0.9)
    schemas.write(
        pd.concat([first.assign(string="made-01"), second.assign(radius_mm=0.6)], ignore_index=True),
        schemas.DATASET,
        path,
    )
    return path


@pytest.mark.long
def test_strings_that_sizes_set_apart_are_not_answered_together(of_two_sizes: Path) -> None:
    text = TWO.replace("string\n", "string,radius_mm\n").replace("-01\n", "-01,0.4\n").replace("-02\n", "-02,0.6\n")
    done = ask(of_two_sizes, text)
    assert done.returncode == 0 and "beware" not in done.stderr, "their sizes set them apart"


def test_a_recorded_string_brings_its_own_sizes_and_sizes_their_string(of_two_sizes: Path) -> None:
    answers = []
    for columns, cells in (("string,radius_mm", "made-02,0.6"), ("string", "made-02"), ("radius_mm", "0.6003")):
        done = ask(of_two_sizes, f"stroke,direction,motor_turns,{columns}\n2,1,9,{cells}\n", "--model", "polynomial")
        assert done.returncode == 0, done.stderr
        answers.append(pd.read_csv(of_two_sizes.with_name("answers.csv")))
    assert "radius_mm" not in answers[1], "the columns are those of the questions"
    assert len({tuple(table[["displacement_mm", "displacement_mm_low"]].iloc[0]) for table in answers[:2]}) == 1
    assert answers[2]["displacement_mm"][0] == pytest.approx(answers[0]["displacement_mm"][0], abs=0.01)


def test_a_size_that_is_not_the_named_strings_is_no_question(of_two_sizes: Path) -> None:
    """The answer was another string's, with its narrow interval and no word."""
    text = "stroke,direction,motor_turns,string,radius_mm\n2,1,9,made-02,0.4\n2,1,9,made-01,\n"
    done = ask(of_two_sizes, text, "--model", "polynomial")
    assert done.returncode == 2 and "is 0.4 in row 1, and string made-02 has 0.6. Mend: leave radius_mm" in done.stderr
    table = pd.read_csv(of_two_sizes.with_name("answers.csv"))
    assert np.isnan(table["displacement_mm"][0]) and np.isfinite(table["displacement_mm"][1])
    assert table["why"][0].startswith("no question: radius_mm is 0.4, and string made-02 has 0.6;")
    done = ask(of_two_sizes, "stroke,direction,motor_turns,string\n2,1,9,new\n2,1,9,made-01\n", "--model", "polynomial")
    assert "string: is new in row 1, which has no recording, and its radius_mm is not told" in done.stderr
    assert "recorded are made-01, made-02; of a new string add the column radius_mm" in done.stderr


@pytest.mark.parametrize(
    ("column", "cell", "says"), [("", "", "radius_mm: is without end"), ("string,", "made-02,", "has 0.6")]
)
def test_a_size_of_400_digits_is_refused_in_words(of_two_sizes: Path, column: str, cell: str, says: str) -> None:
    text = f"stroke,direction,motor_turns,{column}radius_mm\n2,1,9,{cell}{'9' * 400}\n"
    with pytest.raises(BadInput, match=says):
        read_questions(_written(of_two_sizes, text), pd.read_parquet(of_two_sizes))


def test_a_new_string_has_the_usual_stiffness_where_none_was_measured(of_two_sizes: Path) -> None:
    """It was asked for, though nobody had measured that of any string."""
    points = pd.read_parquet(of_two_sizes)
    usual = usual_stiffness(points["radius_mm"], points["length_mm"])
    table = read_questions(
        _written(of_two_sizes, "stroke,direction,motor_turns,string,radius_mm\n2,1,9,new,0.5\n2,1,9,made-01,\n"),
        points.assign(stiffness_n_per_mm=usual),
    ).points
    assert table["stiffness_n_per_mm"].tolist() == pytest.approx([usual_stiffness(0.5, 400.0), usual.min()])


def _written(beside: Path, text: str) -> Path:
    path = beside.with_name("of_new.csv")
    path.write_text(text)
    return path
