import pandas as pd

from pipeline.report.shown.run_strokes import strokes_of_runs, tared_runs


def made(**strokes):
    pairs = [(run, stroke) for run, numbers in strokes.items() for stroke in numbers]
    return pd.DataFrame(index=pd.MultiIndex.from_tuples(pairs, names=["run", "stroke"]))


def test_the_strokes_of_each_run_are_said_with_the_runs_that_were_tared_anew():
    two = made(a=range(1, 6), b=range(6, 11))
    assert (
        strokes_of_runs(two, [])
        == "Strokes 1 to 5 of a, 6 to 10 of b; no later run says `tare: run`, so all are tared as a is."
    )
    assert strokes_of_runs(two, None) == "Strokes 1 to 5 of a, 6 to 10 of b.", "nobody knows"
    assert strokes_of_runs(two, ["b"]).endswith("; the zero was set anew at b (`tare: run`).")
    assert strokes_of_runs(two, ["a"]).endswith(" all are tared as a is."), "nothing was before the first"
    assert strokes_of_runs(made(a=[1, 2]), ["a"]) == ""


def test_many_runs_are_not_named_one_by_one():
    many = made(**{f"r{number:02d}": [number] for number in range(1, 21)})
    words = strokes_of_runs(many, [f"r{number:02d}" for number in range(1, 21)])
    assert "8 of r08 and 12 more runs; " in words and "r09 (`tare: run`) and 11 more." in words and "r15" not in words


def test_which_runs_are_tared_anew_stands_in_their_run_yaml(tmp_path):
    for run, text in (("a", "run: a\n"), ("b", "run: b\ntare: run\n"), ("c", "tare: string\n")):
        (tmp_path / run).mkdir()
        (tmp_path / run / "run.yaml").write_text(text)
    assert tared_runs([tmp_path / run for run in "abcd"]) == {"b"}
