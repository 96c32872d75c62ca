"""What the main job says last: what comes next, and no more than that; what was left out only of what was asked for."""

import os
import re

import pandas as pd
import pytest

from pipeline.ground.stored import schemas
from pipeline.ground.words.left_out import LeftOut
from pipeline.report.end_of_job.failures import ALL_ELSE, concerned, told_at_start, without
from pipeline.report.end_of_job.summary import RUNS, summary

TITLE = "TABLE I: FORWARD ERRORS (small fit: not a result, made by ci.yaml)"
ROWS = "\n".join(f"| model {place} | n=1 | 0.1 |" for place in range(24))
CAPTION = "Material x: forward errors on held-out points of the split within."


def made(tmp_path, materials, page=True):
    """The paths of a main job of some materials, each with tables, a page, a fitted model and a run."""
    reports, paths = tmp_path / "reports", []
    for material in materials:
        folder, model = reports / material, tmp_path / "processed" / material / "spline" / "within-0.model"
        for path in (*(folder / f"table_{number}.md" for number in (1, 2)), folder / "models.html", model):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"{TITLE}\n\n{ROWS}\n\n{CAPTION}\n")
            paths.append(path)
        (folder / "models.csv").write_text("model,split,map,column,median\nspline,later,forward,all,0.1\n")
        if page:
            (folder / "index.html").touch()
            paths.append(folder / "index.html")
        verdict = reports / "diagnosis" / f"{material}-1" / "verdict.txt"
        verdict.parent.mkdir(parents=True)
        verdict.write_text(f"{material}-1: explained by creep.\n\nMore\n")
        paths.append(verdict.parent)
    (reports / "index.html").touch()
    paths.append(reports / "index.html")
    return [str(path) for path in paths], reports, list(materials), [f"{material}-1" for material in materials]


def test_two_materials_end_with_at_most_twenty_lines_that_say_what_comes_next(tmp_path):
    """It printed 120: four tables with their captions, then the files of each."""
    end_text = summary(*made(tmp_path, ("nylon", "silk")))
    assert len(end_text.splitlines()) <= 20 and "| model" not in end_text and CAPTION not in end_text
    for material in ("nylon", "silk"):
        assert f"== {material} (small fit: not a result, made by ci.yaml) ===" in end_text, (
            "no title of a table says it"
        )
        assert f"every model and how to ask it: {tmp_path / 'reports' / material / 'index.html'}\n" in end_text
        assert "model to take: spline. Its forward error on later strokes is the least" in end_text
        assert f"to a controller: python -m pipeline.export processed/{material}/spline/within-0.model" in end_text
        assert f"\n{material}-1: explained by creep.\n" in end_text
    assert end_text.endswith(f"\nthe way to all of it: {tmp_path / 'reports' / 'index.html'}\n")
    assert "\nto ask it: " not in end_text and "models.html" not in end_text, "the page has them"


def test_one_material_ends_with_its_tables_without_what_stands_beneath_them_in_their_files(tmp_path):
    end_text = summary(*made(tmp_path, ("nylon",)))
    assert end_text.count(TITLE) == 2 and end_text.count("| model 23 |") == 2 and CAPTION not in end_text


def test_where_no_page_of_a_material_was_asked_for_each_file_and_command_is_named(tmp_path):
    end_text = summary(*made(tmp_path, ("nylon", "silk"), page=False))
    assert f"Table I: {tmp_path / 'reports' / 'silk' / 'table_1.md'}\n" in end_text and "to ask it: " in end_text
    assert f"beside the floor: {tmp_path / 'reports' / 'silk' / 'models.html'}\n" in end_text
    assert end_text.count("| model 23 |") == 4, "who asks for the tables reads them"


def test_a_job_that_made_the_tables_alone_says_why_its_model_is_the_one_to_take(tmp_path):
    """It named the spline without a word, whatever the errors were: only the page of models had them."""
    paths, *rest = made(tmp_path, ("nylon",), page=False)
    page, processed = tmp_path / "reports" / "nylon" / "models.csv", tmp_path / "processed" / "nylon"
    (processed / "mlp").mkdir()
    for name in ("mlp/within-0.model", "diagnosed/within-0.model"):
        (processed / name).parent.mkdir(exist_ok=True)
        (processed / name).touch()
        paths.append(str(processed / name))
    errors_mm = {"spline": (0.05, 0.4), "mlp": (0.07, 0.2), "diagnosed": (0.01, 0.1), "floor": (0.04, 0.04)}
    rows = [
        ["nylon", model, split, "forward", "all", "all", "all", 0, "rmse", "mm", error_mm]
        for model, both in errors_mm.items()
        for split, error_mm in zip(("within", "later"), both, strict=True)
    ]
    heads = ["material", "model", "split", "map", "stroke", "phase", "angle_band", "seed", "metric", "unit", "value"]
    schemas.write(pd.DataFrame(rows, columns=heads), schemas.METRICS, processed / "metrics.parquet")
    paths.append(str(processed / "metrics.parquet"))
    end_text = summary(paths, *rest, ["diagnosed"])
    why = "Its forward error on later strokes is the least of those that can be exported: 0.200 mm."
    assert f"model to take: mlp. {why}" in end_text and "nylon/mlp/within-0.model --format c" in end_text
    assert "Inside strokes, which the tables show, spline errs less: 0.050 mm against 0.070 mm." in end_text
    end_text = summary([*paths, str(page)], *rest)
    assert "model to take: spline. " in end_text, "a page that the job made wins"


def test_of_many_runs_the_newest_verdicts_are_said_and_the_older_ones_counted(tmp_path):
    """The first ones by name were said, and the run that had just been made was among "2 more runs"."""
    names = [f"m{place}" for place in range(RUNS + 2)]
    asked_for = made(tmp_path, names)
    *_, runs = asked_for
    for place, run in enumerate(runs):
        os.utime(tmp_path / "reports" / "diagnosis" / run / "verdict.txt", (1e9 + place, 1e9 + place))
    end_text = summary(*asked_for)
    shown = re.findall(r"^([\w-]+): .*explained by creep", end_text, re.M)
    assert shown == runs[:1:-1] and "\n2 more runs, made earlier, and of each what to do: " in end_text


@pytest.mark.parametrize(
    ("targets", "runs"),
    [
        (["reports/nylon/index.html", "processed/nylon/dataset.parquet"], ["nylon-2", "nameless"]),
        (["processed/silk-1/samples.parquet"], ["silk-1", "nameless"]),
        (["reports/nylon/index.html", "reports/index.html"], ["nylon-2", "silk-1", "nameless"]),
    ],
)
def test_what_was_left_out_of_another_material_is_not_said(targets, runs):
    """Who had made the reports of nylon read last that a run of silk is to be mended."""
    of = {"nylon-2": "nylon", "silk-1": "silk", "nameless": ""}
    left_out = [
        LeftOut(run, material, f"raw/{run}", "recording", "is missing", "put it there") for run, material in of.items()
    ]
    assert [entry.run for entry in concerned(left_out, targets)] == runs


SILK = LeftOut("silk-1", "silk", "raw/silk-1", "recording", "is unfinished", "wait")
NYLON = LeftOut("nylon-2", "nylon", "raw/nylon-2", "recording", "is missing", "put it there")


@pytest.mark.parametrize(
    ("words", "named", "others"),
    [
        (["--cores", "2", "--", "reports/nylon/index.html"], [NYLON], 1),
        (["--", "reports/diagnosis/silk-1"], [SILK], 1),
        (["--", "reports/vectran/table_1.md"], [], 2),
        (["--", "reports/index.html"], [NYLON, SILK], 0),
        (["--", "reports/vectran/table_1.md", "tables"], [NYLON, SILK], 0),
        (["--cores", "2"], [NYLON, SILK], 0),
    ],
)
def test_a_start_names_what_was_left_out_of_what_it_is_asked_for_and_counts_the_rest(words, named, others):
    """Each start listed every run that cannot be used, whatever was asked for."""
    lines = told_at_start([NYLON, SILK], ["snakemake", *words])
    assert lines[: len(named)] == [f"left out: {entry.why}" for entry in named]
    counted = [
        f"left out beside what is asked for: {others} run{'s' * (others > 1)}; a start without targets names each"
    ]
    assert lines[len(named) :] == (counted if others else [])


def test_the_last_lines_say_once_that_a_run_was_left_out():
    """It read "Left out until mended: left out: raw/…"."""
    assert " ".join([*without([NYLON.why]).splitlines()]).casefold().count("left out") == 1
    assert "left out" not in ALL_ELSE.casefold()
