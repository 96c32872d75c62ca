"""A material's page: its warning, the model to take, which strokes are of which run, and what to ask next."""

import pandas as pd
import programs
import pytest
from stages.nine_strokes import NINE
from test_models_page import TITLES, made_metrics

from pipeline.ground.stored import schemas
from pipeline.ground.words.jump_notes import write_jumps
from pipeline.report.parts.material_head import left_out_of

JUMP = "The zero jumps between two runs: write `tare: run` in run.yaml of a-02 <b>."
UNTIL = "Until then every model of that string learns the jump as if it were the string's own"


def run(program, *words):
    done = programs.run(f"pipeline.report.{program}", *map(str, words))
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """The three pages of a string of two runs, by the real programs, with a jump of the zero and without."""
    root, text = tmp_path_factory.mktemp("project"), {}
    schemas.write(made_metrics(), schemas.METRICS, root / "metrics.parquet")
    second = NINE.assign(run="a-02", stroke=NINE["stroke"] + 9)
    schemas.write(pd.concat([NINE.assign(run="a-01"), second]), schemas.DATASET, root / "dataset.parquet")
    for name, tare in (("a-01", ""), ("a-02", "tare: run\n")):
        (root / "raw" / name).mkdir(parents=True)
        (root / "raw" / name / "run.yaml").write_text(f"run: {name}\n{tare}")
    titles = ["--titles", *(f"{model}={title}" for model, title in TITLES.items())]
    for kind, notes in (("jumps", [JUMP]), ("calm", [])):
        note, out = root / kind / "zero_jumps.json", root / kind / "nylon"
        out.mkdir(parents=True)
        write_jumps(note, {"a": notes})
        of_jumps, metrics = ["--jumps", note], root / "metrics.parquet"
        run("comparison", metrics, *titles, *of_jumps, "--out", out / "comparison.md")
        run("models", metrics, *titles, *of_jumps, "--out", out / "models.md", "--table", out / "models.csv")
        raw = [root / "raw" / name for name in ("a-01", "a-02")]
        run("material_page", out, "--dataset", root / "dataset.parquet", *of_jumps, "--runs", *raw)
        text[kind] = {path.name: path.read_text(encoding="utf-8") for path in out.iterdir()}
    return text


@pytest.mark.parametrize("name", ["index.html", "models.html", "comparison.html"])
def test_a_jump_of_the_zero_stands_in_a_box_at_the_top_of_all_three_pages(pages, name):
    """The log and a table's note said it, and the pages whose model to take it had changed were silent."""
    text = pages["jumps"][name]
    box = text.partition("<blockquote>")[2].partition("</blockquote>")[0]
    assert "Beware: The zero jumps between two runs: write `tare: run` in run.yaml of a-02 &lt;b&gt;." in box
    assert UNTIL in box.replace("&#39;", "'") and "<h2" not in text[text.index("<h1>") : text.index("<blockquote>")]
    assert "blockquote {" in text, "a box is seen"
    assert "<blockquote>" not in pages["calm"][name] and UNTIL not in pages["calm"][name]


def test_the_markdown_of_a_page_says_it_too(pages):
    for name in ("models.md", "comparison.md"):
        assert pages["jumps"][name].split("\n\n")[1].startswith("> Beware: The zero jumps"), name
        assert "Beware" not in pages["calm"][name]


def test_a_page_says_which_model_to_take_as_the_terminal_does(pages):
    """The terminal said it, and the page only led to another one."""
    top = pages["calm"]["index.html"].partition("<h1>")[2].partition("Every model")[0]
    least = "Its forward error on later strokes is the least of those that can be exported: 0.061 mm."
    assert f"<b>Model to take: mlp.</b> {least} Its inverse error on later strokes is 0.305 turns." in top
    assert "<code>python -m pipeline.export processed/nylon/mlp/within-0.model --format c</code>" in top


def test_a_page_says_which_strokes_are_of_which_run_and_which_was_tared_anew(pages):
    text = pages["calm"]["index.html"]
    assert "Strokes 1 to 9 of a-01, 10 to 18 of a-02; the zero was set anew at a-02 (`tare: run`)." in text


def test_a_page_has_the_command_that_says_what_the_simulator_leaves_out(pages):
    command = "<code>python -m pipeline.diagnose raw/a-01 raw/a-02 --out reports/mine</code>"
    text = pages["calm"]["index.html"]
    assert f"What the simulator leaves out of these runs: {command}" in text
    both = f"{command.removesuffix('</code>')}".replace(" --out reports/mine", " --together --out reports/mine/")
    assert both in text and "tell more than each alone" in text, "two runs of one string"
    odd = left_out_of({"spool 3": ["a-01", "a-02"]})
    assert "--out &#39;reports/mine/spool 3&#39;</code>" in odd, "a shell reads it as one word"
    assert "--together" not in left_out_of({"a": ["a-01"], "b": ["b-01"]}), "two strings"
