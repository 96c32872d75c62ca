"""A recording whose verdict says to adopt nothing is adopted all the same: whoever comes later is told of it."""

import json
import re
from pathlib import Path
from types import SimpleNamespace

import once
import programs
import pytest
import yaml

from pipeline.diagnosis.drawing import figures
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.pages.headline import still_holds
from pipeline.systems import systems

ADVICE = "Adopt nothing: the names change when the last 30 % of strokes are left out, so none is proved"
ASKS = "Record the rig once more, with at least 8 strokes (30 N among the first), and diagnose all runs together."


def flat(text: str) -> str:
    """A text without the breaks of its lines."""
    return " ".join(text.split())


@pytest.fixture(scope="module")
def visit(tmp_path_factory):
    """The quick job's recording, diagnosed, adopted with --sure, and diagnosed again: what stands in its files."""
    shared = once.place(tmp_path_factory)

    def make():
        raw, first, again = (shared / "advised" / name for name in ("raw", "first", "again"))
        folder = raw / "synthetic-01"
        assert programs.run("pipeline.rig.record", "small", folder, "--seed", 1).returncode == 0
        assert programs.run("pipeline.diagnose", folder, "--out", first).returncode == 0
        source = first / folder.name / "diagnosis.json"
        refused = programs.run("pipeline.adopt", source, folder)
        adopted = programs.run("pipeline.adopt", source, folder, "--sure")
        assert (refused.returncode, adopted.returncode) == (2, 0), adopted.stderr
        explained = programs.run("pipeline.adopt", "--explain", folder)
        assert programs.run("pipeline.diagnose", folder, "--out", again).returncode == 0
        texts = {
            name: (again / folder.name / name).read_text() for name in ("verdict.txt", "details.txt", "diagnosis.json")
        }
        return SimpleNamespace(folder=folder, source=source, adopted=adopted, explained=explained, texts=texts)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(figures, "page", lambda study, content, path, mark="": None)
        return once.made_once(shared, "adopted against advice", make)


@pytest.mark.long
def test_a_run_keeps_what_the_verdict_advised_that_it_adopted_against_its_advice(visit) -> None:
    (adoption,) = yaml.safe_load((visit.folder / "run.yaml").read_text())["adopted"]
    assert adoption["verdict"] == "ambiguous" and len(adoption["tied"]) == 2
    assert adoption["against_advice"] == [f"{ADVICE}.", ASKS]
    pasted = yaml.safe_load((visit.source.parent / "simulation.yaml").read_text())["adopted"]
    assert pasted[0]["against_advice"] == adoption["against_advice"], "who pastes it by hand keeps it too"
    assert json.loads(visit.texts["diagnosis.json"])["adopted"] == [adoption]


@pytest.mark.long
def test_the_next_verdict_says_so_and_claims_no_more(visit) -> None:
    page, details = visit.texts["verdict.txt"], visit.texts["details.txt"]
    for text in map(flat, (page, details)):
        assert text.startswith(
            "synthetic-01: creep and friction_hysteresis, adopted against their verdict's advice, were fitted to this "
            "recording, which is no test of them; nothing further can be named; "
        )
        assert f"adopted against the advice of their verdict. It says: {ADVICE}." in text
        assert "still hold" not in text and "No other explanation was as likely" not in text
        assert "Nothing needs to be done" not in text and ASKS in text
        assert "creep in 1 of 3 likely explanations, against its advice 0.66 mm" in text
    commands = [line.split()[2] for line in details.splitlines() if line.startswith("    ") and "python -m" in line]
    once_more = ["pipeline.new_run", "pipeline.capture", *["pipeline.adopt"] * 2, "pipeline.diagnose"]
    between_likely = ["pipeline.adopt", "pipeline.new_run", "pipeline.capture", "pipeline.diagnose"]
    assert commands == [*once_more, *between_likely]
    assert len(page.splitlines()) <= 66


@pytest.mark.long
def test_its_figure_says_so_in_title_and_mark(visit) -> None:
    content, words = json.loads(visit.texts["diagnosis.json"]), Vocabulary.of(systems()["separator"])
    title = figures.title(content, still_holds(content, words)).replace("\N{NO-BREAK SPACE}", " ")
    assert title == "synthetic-01: adopted creep + friction_hysteresis, against the advice of their verdict"
    assert flat(figures.warning(content, words)).endswith(f"against the advice of their verdict. It says: {ADVICE}")


@pytest.mark.long
def test_simulating_says_so(visit, tmp_path: Path) -> None:
    plan = tmp_path / "plan.csv"
    plan.write_text("time_s,motor_turns,load_n\n0,0,20\n5,20,20\n5.3,20,20\n10.3,0,20\n")
    for words in ([], ["--motion", plan]):
        done = programs.run("pipeline.simulate", visit.folder, *words, "--out", tmp_path / "out.csv")
        assert done.returncode == 0, done.stderr
        assert f"adopted this against the advice of its verdict, which says: {ADVICE}" in flat(done.stdout)


@pytest.mark.long
def test_a_plan_s_error_says_whose_it_is_and_the_loop_has_the_sign_that_lifespan_has(visit, tmp_path: Path) -> None:
    """The error of what is named without the last strokes stood there as that of what is simulated."""
    plan = tmp_path / "plan.csv"
    plan.write_text("time_s,motor_turns,load_n\n0,0,20\n5,20,20\n5.3,20,20\n10.3,0,20\n")
    whose = "(of plastic_elongation + shaft_windup, which the procedure names without these strokes)"
    for words in ([], ["--simulation", visit.source]):
        done = programs.run("pipeline.simulate", visit.folder, *words, "--motion", plan, "--out", tmp_path / "out.csv")
        assert f"Of it 1.9 mm is what strokes that no fit had seen were missed by {whose}, " in flat(done.stdout)
        assert "difference: winding less unwinding)" in done.stdout
        assert "+0.2 mm" in done.stdout and " 0.0 mm" in done.stdout and "-0.0" not in done.stdout


@pytest.mark.long
def test_rows_add_up_but_for_what_hardly_differs_and_a_formula_has_the_symbols_of_its_elements(visit) -> None:
    """The rows of creep added up to -0.670 mm under a head of -0.677 mm; F stood beside the root of the load."""
    creep, friction = flat(visit.explained.stdout).split(" Its formula: ")[:2]
    assert "where – stands, both ends hardly differ" in creep
    head = float(re.search(r"rms, and by (-[0-9.]+) mm from 0 to 20 turns", creep)[1])
    rows = [float(way) for way in re.findall(r" (-[0-9.]+) mm (?:lengthens)", creep)]
    assert rows and sum(rows) == pytest.approx(head, abs=0.02 * abs(head))
    assert "dx = -sum k_i f_i g_i s_i" in flat(visit.explained.stdout) and "F/K" not in friction


@pytest.mark.long
def test_what_adopting_prints_stands_in_groups(visit) -> None:
    heads = [line for line in visit.adopted.stdout.splitlines() if line[:1].strip()]
    assert heads[-3:] == ["What changed", "What it means", "What comes next"]
    assert "run.yaml keeps that advice" in visit.adopted.stdout


@pytest.mark.long
def test_a_run_yaml_of_an_earlier_program_is_read_and_says_nothing_of_advice(visit, tmp_path: Path) -> None:
    content = yaml.safe_load((visit.folder / "run.yaml").read_text())
    del content["adopted"][0]["against_advice"]
    folder = tmp_path / visit.folder.name
    folder.mkdir()
    for path in visit.folder.iterdir():
        (folder / path.name).write_bytes(path.read_bytes())
    (folder / "run.yaml").write_text(yaml.safe_dump(content))
    done = programs.run("pipeline.simulate", folder, "--out", tmp_path / "out.csv")
    assert done.returncode == 0 and "advice" not in done.stdout
    assert programs.run("pipeline.diagnose", folder, "--out", tmp_path / "later").returncode == 0
    page = flat((tmp_path / "later" / folder.name / "verdict.txt").read_text())
    assert "which is no test of them; nothing further can be named; what was adopted is one of 3 likely" in page
    assert "advice" not in page
    assert "Decide between what was adopted and what was likely as well, if you need to know" in page


@pytest.mark.long
def test_simulating_with_a_verdict_that_advises_against_it_says_so(visit, tmp_path) -> None:
    words = ("--simulation", visit.source, "--out", tmp_path / "out.csv")
    printed = flat(programs.run("pipeline.simulate", visit.folder, *words).stdout)
    assert f"beware: the verdict advises against what is simulated: {ADVICE}" in printed
