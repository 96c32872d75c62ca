"""A string that nobody recorded is asked about by the sizes in which strings differ, and each that lacks is named."""

from pathlib import Path

import pandas as pd
import programs
import pytest
from made_dataset import made_dataset, words_that_ask

from pipeline.ground.kinematics import usual_stiffness
from pipeline.ground.stored import schemas
from pipeline.models.interface import about, names, names_for_new_strings

ASSUMED = "its stiffness is assumed, {:.4g} N/mm, the usual one of its radius and length"


def of_radii(folder: Path, measured: bool = False) -> Path:
    """A dataset of three strings, A and B of 0.4 and 0.6 mm and C as thick as B, of usual or of measured stiffness."""
    points = made_dataset(60, 6)
    strings = []
    for string, radius_mm, softness in (("A", 0.4, 1.0), ("B", 0.6, 0.9), ("C", 0.6, 0.9)):
        stiffness = usual_stiffness(radius_mm, 400.0) * (softness if measured else 1.0)
        shorter = points["displacement_mm"] * radius_mm / 0.4
        own = points.assign(string=string, run=string, radius_mm=radius_mm, stiffness_n_per_mm=stiffness)
        strings.append(own.assign(displacement_mm=shorter))
    path = folder / "dataset.parquet"
    schemas.write(pd.concat(strings, ignore_index=True), schemas.DATASET, path)
    return path


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return of_radii(tmp_path_factory.mktemp("usual"))


def ask(dataset: Path, columns: str, *rows: str, words: tuple[str, ...] = ("--model", "polynomial")) -> programs.Done:
    questions, header = dataset.with_name("questions.csv"), f"stroke,direction,motor_turns{columns and ','}{columns}"
    questions.write_text("\n".join([header, *(f"2,1,9{columns and ','}{row}" for row in rows)]) + "\n")
    return programs.run("pipeline.predict", dataset, questions, "--out", dataset.with_name("answers.csv"), *words)


def answered(dataset: Path) -> pd.DataFrame:
    return pd.read_csv(dataset.with_name("answers.csv"), keep_default_na=False)


def test_a_missing_string_is_asked_for_alone_with_what_tells_a_new_one(dataset: Path, tmp_path: Path) -> None:
    """String, radius and stiffness were asked for, where the name alone was enough."""
    done = ask(dataset, "", "")
    mend = "add the column: recorded are A, B, C, or of a new string radius_mm (recorded are 0.4 to 0.6 mm)."
    assert f"string: is missing, and varies in the recordings. Mend: {mend}" in done.stderr, done.stderr
    both = "radius_mm (recorded are 0.4 to 0.6 mm) and stiffness_n_per_mm (recorded are 8.796 to 17.81 N/mm)."
    assert f"or of a new string {both}" in ask(of_radii(tmp_path, measured=True), "", "").stderr
    done = ask(dataset, "radius_mm", "0.4", "0.45", "0.6", "")
    table = answered(dataset)
    assert table["inside"].tolist() == [True, False, False, False], done.stderr
    assert table["why"][1].startswith("string of these sizes has no recording here; "), "a radius tells a new string"
    several = "string is not told, and these are sizes of B and C; add the column string"
    assert f"row 3: {several}" in done.stderr and table["why"][2] == f"no question: {several}"
    assert table["why"][3] == "no question: radius_mm is empty; a new string needs radius_mm; recorded are A, B, C"


def test_where_strings_are_answered_alone_no_new_one_is(dataset: Path) -> None:
    ask(dataset, "radius_mm", "0.4", "0.45", words=("--model", "polynomial", "--each-string"))
    table = answered(dataset)
    reason = "no question: string is not told, and no recorded one has these sizes; recorded are A, B, C"
    takers = "cinn, inn, mlp, polynomial, spline, traditional"  # written out: the models declare it of themselves
    reason = f"{reason}; a new string is answered by the models {takers}"
    assert table["inside"].tolist() == [True, False] and table["why"][1] == reason


@pytest.mark.parametrize(
    ("columns", "row", "reason"),
    [
        ("string,radius_mm", "new,", "radius_mm is empty; a new string needs radius_mm; recorded are A, B, C"),
        (
            "string,radius_mm,stiffness_n_per_mm",
            "new,,",
            "radius_mm is empty; a new string needs radius_mm; recorded are A, B, C",
        ),
        (
            "string,radius_mm,stiffness_n_per_mm",
            "new,,12",
            "radius_mm is empty; a new string needs radius_mm; recorded are A, B, C",
        ),
        ("string,radius_mm", "new,0", "radius_mm is 0, no size of a string; write it in mm, above 0"),
        ("string,radius_mm", "new,-0.4", "radius_mm is -0.4, no size of a string; write it in mm, above 0"),
    ],
)
def test_a_size_that_is_none_is_blamed_and_no_other(dataset: Path, columns: str, row: str, reason: str) -> None:
    """An empty radius blamed the stiffness, and a radius of -0.4 mm was answered with 15 mm."""
    done = ask(dataset, columns, row, f"A{',' * columns.count(',')}")
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "stiffness" not in done.stderr
    assert answered(dataset)["why"].tolist() == [f"no question: {reason}", ""]


def test_all_sizes_that_a_new_string_lacks_are_named_at_once(tmp_path: Path) -> None:
    done = ask(of_radii(tmp_path, measured=True), "string", "new", "A")
    both = "radius_mm and stiffness_n_per_mm"
    assert f"has no recording, and its {both} are not told. Mend: " in done.stderr, done.stderr
    assert f"of a new string add the columns {both}." in done.stderr
    done = ask(tmp_path / "dataset.parquet", "string,radius_mm,stiffness_n_per_mm", "new,0.5,", "A,,")
    assert "stiffness_n_per_mm: is empty in row 1. Mend: a new string needs stiffness_n_per_mm; recorded" in done.stderr


@pytest.mark.parametrize("is_saved", [False, True], ids=["anew", "saved"])
def test_an_empty_stiffness_is_assumed_as_a_missing_column_is_and_said_once(dataset: Path, is_saved: bool) -> None:
    """It was refused, where a file without that column was answered; the stiffness had a remark beside the radius."""
    words = words_that_ask(dataset, is_saved=is_saved)
    tables = []
    for columns, end in (("string,radius_mm", ""), ("string,radius_mm,stiffness_n_per_mm", ",")):
        done = ask(dataset, columns, f"new,0.5{end}", f"new,4{end}", f"A,{end}", words=words)
        assert done.returncode == 0, done.stderr
        tables.append(answered(dataset))
        assert tables[-1]["why"][0].endswith(ASSUMED.format(usual_stiffness(0.5, 400.0)))
        assert tables[-1]["why"].str.count("stiffness").tolist() == [1, 1, 0], tables[-1]["why"].tolist()
        assert tables[-1]["why"].str.count("radius [0-9]|no radius").tolist() == [1, 1, 0]
    assert tables[0]["displacement_mm"].tolist() == tables[1]["displacement_mm"].tolist()
    done = ask(dataset, "string,radius_mm,stiffness_n_per_mm", "new,0.5,13", words=words)
    assert "assumed" not in answered(dataset)["why"][0] and "no stiffness" not in answered(dataset)["why"][0]


def test_a_misspelt_string_is_told_the_near_one(dataset: Path, tmp_path: Path) -> None:
    ask(dataset, "string,radius_mm", "a,0.45", "knotted,0.45")
    whys = answered(dataset)["why"]
    assert whys[0].startswith("string a has no recording here (did you mean A?)")
    assert whys[1].startswith("string knotted has no recording here;")
    numbered = of_radii(tmp_path)
    points = pd.read_parquet(numbered)
    points["string"] = points["string"].map({"A": "reel-1", "B": "reel-3", "C": "cord"})
    schemas.write(points, schemas.DATASET, numbered)
    ask(numbered, "string,radius_mm", "reel-9,0.45")
    assert answered(numbered)["why"][0].startswith("string reel-9 has no recording here, recorded are reel-1, reel-3;")
    done = ask(dataset, "string", "a", "knotted", "A")
    whys = answered(dataset)["why"]
    assert "string is a, which has no recording (did you mean A?), and its radius_mm is not told" in done.stderr
    assert whys[1].startswith("no question: string is knotted, which has no recording, and its radius_mm is not told")
    done = ask(dataset, "string,radius_mm", "a,0.4", "A,", words=("--model", "polynomial", "--each-string"))
    assert "string: is a in row 1, which has no recording (did you mean A?)." in done.stderr, done.stderr


def test_a_misspelt_string_is_told_the_near_one_by_a_saved_model_too(dataset: Path) -> None:
    """Its answer was that of a string that is none, and no near name stood beside it."""
    ask(dataset, "string,radius_mm", "a,0.45", "knotted,0.45", words=words_that_ask(dataset, is_saved=True))
    whys = answered(dataset)["why"]
    assert whys[0].startswith("string a is none that it was fitted to (did you mean A?); the export answers")
    assert whys[1].startswith("string knotted is none that it was fitted to; the export answers")


def test_the_models_that_take_a_new_string_are_those_that_say_so() -> None:
    """What is read without an import is what an import gives."""
    takers = {name for name in names() if not (about(name).each_string_apart or about(name).needs_motion)}
    assert set(names_for_new_strings()) == takers and takers < set(names())
