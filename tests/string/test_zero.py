"""A zero that jumps between runs of one string is seen, said, and by `tare: run` taken off; wear is left in."""

import json
import re
from dataclasses import replace
from itertools import pairwise, takewhile
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
import ready
from made_recording import content, recording
from stages.nine_strokes import recorded, string

from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas
from pipeline.ground.words.jump_notes import KNOWN_IN_PART, MODEL_VALUE, NOT_COMPARED, read_jumps
from pipeline.lifespan.from_folders import strings
from pipeline.run.strokes import segment
from pipeline.stages.dataset import make_dataset
from pipeline.string.history import Recorded
from pipeline.string.jump import Jump
from pipeline.string.jumps_beside import Beside, _last, advice_on, jumps_into
from pipeline.string.not_compared import not_compared, to_confirm
from pipeline.string.rests import Rests
from pipeline.string.tare_notes import set_anew, tare_notes
from pipeline.string.zero import jumps_among, offsets_mm

ROOT = Path(__file__).parents[2]
CUT_S, JUMP_MM = 121.0, 0.58  # amid the rest after the fourth of eight strokes; 29 times the noise
NAMES = ("a-1", "a-2")


def halves(jump_mm: float, **how: float) -> list[pd.DataFrame]:
    """Two recordings of one string, one after the other, between which the zero jumps."""
    whole = recording(8, rate_hz=20.0, **how)
    first_half, two = (
        whole[part].reset_index(drop=True) for part in (whole["time_s"] < CUT_S, whole["time_s"] >= CUT_S)
    )
    return [first_half, two.assign(displacement_mm=two["displacement_mm"] + jump_mm)]


def runs(jump_mm: float, tare: str | None = None, **second: object) -> list[Recorded]:
    first_half, two = halves(jump_mm)
    return [
        recorded(NAMES[0], samples=first_half, string=string(id="a")),
        recorded(NAMES[1], samples=two, string=string(id="a", **second), tare=tare),
    ]


def jumps(of_string: list[Recorded]) -> list[Jump]:
    """The jumps of the zero among runs of one string."""
    return jumps_among([Rests.of(run) for run in of_string])


@pytest.fixture(scope="module")
def whole() -> pd.DataFrame:
    """The dataset of the two runs as one, which no zero can part."""
    return make_dataset([recorded("a-1", samples=recording(8, rate_hz=20.0), string=string(id="a"))])


def test_the_cut_lies_in_a_rest() -> None:
    assert [int(recorded_run.strokes["stroke"].max()) for recorded_run in runs(0.0)] == [4, 4]


@pytest.mark.parametrize("jump_mm", [JUMP_MM, -JUMP_MM])
def test_a_jump_is_seen_with_its_size_in_noise_floors(jump_mm: float) -> None:
    (seen,) = jumps(runs(jump_mm))
    assert (seen.before, seen.run, seen.unrecorded) == (*NAMES, 0)
    assert seen.jump_mm == pytest.approx(jump_mm, abs=0.02) and seen.floor_mm == pytest.approx(0.02, rel=0.3)
    assert re.search(rf"reads 0\.5[6-9] mm {'more' if jump_mm > 0 else 'less'} than a-1 at its end", seen.sentence)
    assert "`tare: run`" in seen.advice and "no stroke in between" in seen.sentence


def test_wear_and_noise_are_no_jump() -> None:
    assert jumps(runs(0.0)) == []
    noisy = [
        recorded(name, samples=part, string=string(id="a"))
        for name, part in zip(NAMES, halves(0.1, noise_mm=0.1), strict=True)
    ]
    assert jumps(noisy) == []  # one floor
    assert jumps(runs(0.08)) == []  # four floors, and less than a stroke changes


def test_rests_that_do_not_compare_say_nothing() -> None:
    first_run, two = runs(JUMP_MM)
    loaded = two.samples.assign(load_n=30.0)
    assert jumps([first_run, Recorded(two.run, "", loaded, two.strokes)]) == []
    late = two.samples[two.samples["time_s"] > CUT_S + 10.0].reset_index(drop=True)  # begins high up
    assert jumps([first_run, Recorded(two.run, "", late, segment(late, "motor_turns", "a-2"))]) == []


def test_strokes_in_between_are_said() -> None:
    (seen,) = jumps(runs(JUMP_MM, strokes_before=10))
    assert seen.unrecorded == 6 and "6 strokes that were not recorded" in seen.sentence


def test_by_default_the_tare_is_the_strings(whole: pd.DataFrame) -> None:
    first, second = offsets_mm(runs(JUMP_MM))
    assert first == second
    points = make_dataset(runs(JUMP_MM))
    off = points["displacement_mm"] - whole["displacement_mm"]
    assert off[points["run"] == "a-1"].abs().max() < 1e-9
    assert off[points["run"] == "a-2"].to_numpy() == pytest.approx(JUMP_MM)


def test_tare_run_takes_the_jump_off_and_leaves_the_wear_in(whole: pd.DataFrame) -> None:
    points = make_dataset(runs(JUMP_MM, tare="run"))
    assert points["stroke"].tolist() == whole["stroke"].tolist()
    assert (points["displacement_mm"] - whole["displacement_mm"]).abs().max() < 0.02  # what two rests can tell
    assert jumps(runs(JUMP_MM, tare="run"))  # it is still said


def test_a_run_after_the_one_that_was_moved_goes_with_it() -> None:
    first_run, two = runs(JUMP_MM, tare="run")
    later = two.samples.assign(time_s=two.samples["time_s"] + 500.0)
    three = recorded("a-3", samples=later, string=string(id="a"))
    first, second, third = offsets_mm([first_run, two, three])
    assert second == third == pytest.approx(first - JUMP_MM, abs=0.02)


def test_after_a_tare_it_is_said_which_zero_is_compared_and_that_the_old_one_is_a_jump() -> None:
    """A third run whose sensor was set back lay 1.1 mm off: its person took "the zero of the string" for the first."""
    first_run, two = runs(JUMP_MM, tare="run")
    later = two.samples.assign(
        time_s=two.samples["time_s"] + 500.0, displacement_mm=two.samples["displacement_mm"] - 1.0
    )
    three = recorded("a-3", samples=later, string=string(id="a"))
    four = recorded("a-4", samples=later.assign(time_s=later["time_s"] + 500.0), string=string(id="a"))
    words = "It is compared with the zero since a-2's own tare: one back where a-1 had it is a jump too. If the sensor"
    tared, back, *_ = jumps([first_run, two, three, four])
    assert words not in tared.advice and back.run == "a-3" and words in back.advice
    untared = Recorded(two.run.model_copy(update={"tare": "string"}), "", two.samples, two.strokes)
    assert not any("own tare" in jump.advice for jump in jumps([first_run, untared, three]))


def folders(place: Path, jump_mm: float, tare: str | None = None) -> list[Path]:
    run_folders = []
    for name, part in zip(NAMES, halves(jump_mm), strict=True):
        folder = place / name
        folder.mkdir(parents=True)
        run_yaml = content(name, string=string(id="a"), tare=tare if name == "a-2" else None)
        (folder / "run.yaml").write_text(json.dumps(run_yaml))
        part.to_parquet(folder / "recording.parquet", index=False)
        run_folders.append(folder)
    return run_folders


def program(module: str, *words: object) -> str:
    done = programs.run(f"pipeline.{module}", *words)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize(
    ("tare", "expected_words", "noted"),
    [
        (None, "write `tare: run` in run.yaml of a-2", ["The zero jumps between two runs of one string: at rest a-2"]),
        ("run", "is taken off the displacement before the tables", ["zero set anew at a-2 (+0.5"]),
        ("checked", "run.yaml of a-2 says `tare: checked`: so the change is the string's own.", []),
    ],
)
def test_the_dataset_program_says_it(tmp_path: Path, tare: str | None, expected_words: str, noted: list[str]) -> None:
    """A zero that was set anew stood on no page with its size, and `predict` answered without a word.

    Of one that was checked the jump came back on the pages and above the answers at every job.
    """
    run_folders, processed = folders(tmp_path / "raw", JUMP_MM, tare), tmp_path / "processed"
    for folder in run_folders:
        samples, strokes = (processed / folder.name / f"{table}.parquet" for table in ("samples", "strokes"))
        program("stages.ingest", folder, "--out", samples, "--out-strokes", strokes)
    notes = tmp_path / "zero_jumps.json"
    words = ("--processed", processed, "--out", tmp_path / "dataset.parquet", "--out-jumps", notes)
    text = program("stages.dataset", *run_folders, *words)
    for note, begins in zip(read_jumps([notes]), noted, strict=True):
        assert note.startswith(begins) and (KNOWN_IN_PART in note) == (tare == "run")
    jumps_said = text.count("The zero jumps between two runs of one string: at rest a-2 reads")
    assert jumps_said == (tare != "checked") and text.count(expected_words) == 1
    assert ("write `tare: checked`" in text) == (tare is None) and "Beware" not in text
    if tare == "checked":
        assert re.search(r"^At rest a-2 reads 0\.5[6-9] mm more than a-1 at its end, \d+ times the noise", text, re.M)
    assert len(schemas.read(tmp_path / "dataset.parquet", schemas.DATASET))


def test_a_note_of_jumps_that_is_none_is_refused(tmp_path: Path) -> None:
    for number, text in enumerate(("{", "[1]", '{"a": 1}', "[" * 100_000)):
        (tmp_path / f"{number}.json").write_text(text)
        with pytest.raises(BadInput, match=r"damaged.*run snakemake: it is made again"):
            read_jumps([tmp_path / f"{number}.json"])
    assert read_jumps([tmp_path / "none.json"]) == []


def test_another_tare_is_refused(make_run) -> None:
    from pipeline.run.folder import read_run

    with pytest.raises(BadInput, match="tare"):
        read_run(make_run("b-1", tare="always"))


def test_lifespan_takes_no_jump_for_wear(tmp_path: Path) -> None:
    calm, jumped = (strings(folders(tmp_path / str(jump_mm), jump_mm))[0] for jump_mm in (0.0, JUMP_MM))
    for name in ("rest_mm", "stroke_mm", "model_error_mm"):
        assert np.abs(calm.strokes[name] - jumped.strokes[name]).max() < 0.03, name
    assert not calm.jumps and [jump.run for jump in jumped.jumps] == ["a-2"]
    text = " ".join(program("lifespan", *folders(tmp_path / "said", JUMP_MM), "--out", tmp_path / "life").split())
    assert "write `tare: run` in run.yaml of a-2" in text and "Here the change is taken off: it is no wear." in text
    (zero_jump,) = json.loads((tmp_path / "life" / "a" / "lifespan.json").read_text())["zero_jumps"]
    assert (
        zero_jump["run"] == "a-2"
        and zero_jump["taken_off"]
        and zero_jump["jump_mm"] == pytest.approx(JUMP_MM, abs=0.02)
    )


def test_lifespan_asks_for_no_mend_that_was_made(tmp_path: Path) -> None:
    text = program("lifespan", *folders(tmp_path / "said", JUMP_MM, "run"), "--out", tmp_path / "life")
    assert re.search(r"a-2 has `tare: run`: the 0\.5[6-9] mm by which its zero was moved are taken off\.", text)
    assert "Such a zero is known in part" in text
    assert "The zero jumps" not in text and "write `tare: run`" not in text


def test_a_change_at_a_zero_that_was_checked_is_the_strings_own(whole: pd.DataFrame, tmp_path: Path) -> None:
    """Nobody could say that the sensor had been checked: its jump was asked about, and lifespan took it off."""
    first, second = offsets_mm(runs(JUMP_MM, tare="checked"))
    assert first == second
    (change,) = jumps(runs(JUMP_MM, tare="checked"))
    assert change.may_be_wear and not change.is_unconfirmed and "zero jumps" not in change.advice
    run_folders = folders(tmp_path / "raw", JUMP_MM, "checked")
    (health,) = strings(run_folders)
    rest_mm = health.strokes.groupby("run")["rest_mm"].mean()
    calm_mm = strings(folders(tmp_path / "calm", 0.0))[0].strokes.groupby("run")["rest_mm"].mean()
    assert rest_mm["a-2"] - calm_mm["a-2"] == pytest.approx(JUMP_MM, abs=0.01), "it is left in"
    text = " ".join(program("lifespan", *run_folders, "--out", tmp_path / "life").split())
    assert f"{change.advice} It is left in." in text and "known in part" not in text and "Beware" not in text
    content_said = json.loads((tmp_path / "life" / "a" / "lifespan.json").read_text())
    assert content_said["zero_jumps"] == [] and content_said["tares"] == [f"{change.advice} It is left in."]
    assert advice_on(run_folders[1]) == [change.advice], "capture and new_run say it too"


@pytest.mark.parametrize(
    ("tare", "begins"),
    [(None, "The zero jumps"), ("checked", "At rest a-2 reads"), ("run", "run.yaml of a-2 says")],
)
def test_a_verdict_says_in_short_what_run_yaml_tells_of_a_zero(
    tmp_path: Path, monkeypatch, tare: str | None, begins: str
) -> None:
    from pipeline.notebook import of_folders
    from pipeline.string.from_raw import read

    recorded_runs = [read(folder) for folder in folders(tmp_path, JUMP_MM, tare)]
    rests = [Rests.of(recorded_run) for recorded_run in recorded_runs]
    zero = {"value": 0.5, "from_first": {"value": 0.6, "low": 0.57, "high": 0.63}}
    written, doubts = {"run": ["a-1", "a-2"], "parameters": {"zero_2_mm": zero}}, []
    monkeypatch.setattr(of_folders, "write_words", lambda *arguments: doubts.extend(arguments[4]) or "")
    names = [recorded_run.folder for recorded_run in recorded_runs]
    of_folders.Decided(written, [recorded_run.run for recorded_run in recorded_runs], rests, names, tmp_path).write(
        Beside(rests)
    )
    (doubt,) = doubts
    assert doubt.endswith(of_folders.OWN_ZERO) and ("zero_jumps" in written) == (tare != "checked")
    assert doubt.startswith(begins) and f"`tare: {tare or 'checked'}`" in doubt
    assert "Fitted together with all effects it is +0.60 mm (+0.57 to +0.63)." in doubt
    assert (len(doubt) < 320) == (tare is not None), "what is settled, and what nothing depends on, is said in short"


def test_of_a_zero_that_was_checked_nothing_more_is_asked() -> None:
    two = runs(JUMP_MM, tare="checked")
    pair = [Rests.of(two[0]), other_load(Rests.of(two[1]))]
    assert not_compared(pair) == [] and to_confirm(pair) == []
    open_pair = [pair[0], replace(pair[1], run=two[1].run.model_copy(update={"tare": "string"}))]
    by = f"python -m pipeline.mend {two[1].folder} tare=checked"
    assert not_compared(open_pair)[0].endswith(f"If neither moved, write `tare: checked` ({by}).")


def test_a_zero_at_the_models_value_is_not_said_to_be_known_as_one_that_was_compared() -> None:
    """Its doubt was that of zeros that were compared, 0.02 to 0.05 mm; the wear before it is lost from it."""
    two = runs(JUMP_MM, tare="run")
    compared, apart = Rests.of(two[1]), other_load(Rests.of(two[1]))
    (note,) = set_anew([Rests.of(two[0]), apart])
    assert note.endswith(f"a-2 (set to the model's value), as run.yaml says by `tare: run`. {MODEL_VALUE}")
    assert tare_notes([Rests.of(two[0]), apart])[0][1].endswith(f"it is set to the model's value. {MODEL_VALUE}")
    later = replace(compared, run=two[1].run.model_copy(update={"run": "a-3"}))
    (note,) = set_anew([Rests.of(two[0]), compared, replace(later, load_n=apart.load_n)])
    assert KNOWN_IN_PART in note and MODEL_VALUE in note


def test_a_run_that_continues_another_beside_it_is_told_of_the_jump(tmp_path: Path) -> None:
    from pipeline.string.from_raw import read

    first_folder, two = folders(tmp_path, JUMP_MM)
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "run.yaml").write_text("a: [")
    for asked_folders, seen in (([two], ["a-2"]), ([first_folder, two], ["a-2"]), ([first_folder], [])):
        zero_jumps = jumps_into([Rests.of(read(folder)) for folder in asked_folders], Beside())
        assert [jump.run for jump in zero_jumps] == seen


@pytest.mark.long
def test_the_verdict_says_it(tmp_path: Path) -> None:
    run_folders = []
    for name, seed, jump_mm in (("a-1", 0, 0.0), ("a-2", 1, 1.0)):
        samples = recording(2, rate_hz=10.0, seed=seed, top=15.0)
        folder = tmp_path / name
        folder.mkdir()
        (folder / "run.yaml").write_text(json.dumps(content(name, string=string(id="a"))))
        samples.assign(displacement_mm=samples["displacement_mm"] + jump_mm).to_parquet(folder / "recording.parquet")
        run_folders.append(folder)
    text = program("diagnose", *run_folders, "--together", "--out", tmp_path / "out")
    lines = text.splitlines()
    start = lines.index("What to know first")
    rest = takewhile(lambda line: line.startswith(" "), lines[start + 1 :])  # to the next heading
    doubts = [lines[start], *rest]
    doubts_text = " ".join(" ".join(doubts).split())
    assert len(doubts) > 2 and max(map(len, doubts)) <= 120
    assert (
        "The zero jumps between two runs of one string: at rest a-2 reads" in doubts_text
        and "`tare: run`" in doubts_text
    )
    assert "This verdict does not depend on it" in doubts_text
    assert text.strip() == (tmp_path / "out" / "verdict.txt").read_text().strip()
    assert [
        zero_jump["run"] for zero_jump in json.loads((tmp_path / "out" / "diagnosis.json").read_text())["zero_jumps"]
    ] == ["a-2"]


@pytest.mark.parametrize(
    ("tares", "expected_notes"),
    [
        ((None, None, None), []),
        (("run", None, None), []),  # the first run of a string is its zero
        ((None, "run", "run"), ["b says `tare: run`: at rest it reads", "c says `tare: run`: at rest it reads"]),
        ((None, "run", "checked"), ["b says `tare: run`: at rest it reads"]),
        (
            (None, "run", None),
            ["b says `tare: run`: at rest", "b, of the same string, says `tare: run`, and c does not"],
        ),
    ],
)
def test_a_small_jump_is_asked_about_where_another_run_was_zeroed(whole: pd.DataFrame, tares, expected_notes) -> None:
    """A sensor that starts at 0 in each recording: a jump of less than six floors stayed in, and nobody said so."""
    parts = [whole[(whole["time_s"] >= a) & (whole["time_s"] < b)] for a, b in pairwise((0.0, 61.0, 121.0, 400.0))]
    rests = [
        Rests.of(recorded(name, samples=part.reset_index(drop=True), string=string(id="a"), tare=tare))
        for name, part, tare in zip("abc", parts, tares, strict=True)
    ]
    notes = tare_notes(rests)
    assert len(notes) == len(expected_notes) and all(
        words in note for words, (_, note) in zip(expected_notes, notes, strict=True)
    )
    if tares[2] is None and expected_notes:
        assert "mm" in notes[1][1] and notes[1][0] == "c" and "write `tare: run` in run.yaml of c too" in notes[1][1]
        by = f"python -m pipeline.mend {rests[2].folder} tare=checked"
        assert notes[1][1].endswith(f"; if it was checked and did not move, `tare: checked` ({by}).")


def test_where_a_jump_is_said_the_tare_is_not_said_again() -> None:
    rests = [Rests.of(run) for run in runs(JUMP_MM, tare="run")]
    assert jumps(runs(JUMP_MM, tare="run")) and not tare_notes(rests)


@pytest.mark.long
def test_lifespan_names_the_runs_of_the_string_that_were_not_given(tmp_path: Path) -> None:
    first_folder, two = folders(tmp_path / "raw", 0.0)
    text = program("lifespan", first_folder, "--out", tmp_path / "life")
    assert "1 more run of the string a beside, not given" in text
    needed = "4 strokes recorded (1 to 4), all compared; at least 12 are needed, 8 more than there are. Name the runs "
    assert f"{needed}beside as well. " in " ".join(text.split())
    assert "Record 8" not in text
    life = tmp_path / "life"
    again = f"python -m pipeline.lifespan {first_folder} {two} --out {life}"
    assert again in map(str.strip, text.splitlines()) and "replaces" not in text
    path = life / "a" / "lifespan.json"
    assert f"Written: {path} and {path.with_name('lifespan.png')}." in " ".join(text.split())
    text = program("lifespan", first_folder, two, "--out", life)
    assert "not given" not in text and "This replaces the answer that was there, from a-1.\n" in text
    assert "replaces" not in program("lifespan", first_folder, two, "--out", life), "an answer from the same runs"
    lacks = program("lifespan", two, "--out", life)
    assert "This replaces the answer that was there, from a-1, a-2, and lacks a-1." in lacks
    path.write_text("[1]")
    assert "replaces" not in program("lifespan", two, "--out", life)


def test_lifespan_says_a_tare_that_is_smaller_than_a_jump(tmp_path: Path) -> None:
    text = program("lifespan", *folders(tmp_path / "raw", 0.05, "run"), "--out", tmp_path / "life")
    assert "  run.yaml of a-2 says `tare: run`: at rest it reads 0.0" in text
    assert "So this change is taken off the displacement" in " ".join(text.split())
    (tare_note,) = json.loads((tmp_path / "life" / "a" / "lifespan.json").read_text())["tares"]
    assert tare_note in " ".join(text.split())
    assert "`tare" not in program("lifespan", *folders(tmp_path / "plain", 0.05), "--out", tmp_path / "life")


def test_of_many_runs_of_a_string_the_last_ones_before_the_new_one_are_read(tmp_path: Path) -> None:
    first_folder, two = folders(tmp_path / "raw", JUMP_MM)
    for number in range(6):
        folder = tmp_path / "raw" / f"old-{number}"
        folder.mkdir()
        (folder / "run.yaml").write_text(json.dumps(content(folder.name, string=string(id="a"))))
        (folder / "recording.parquet").write_bytes(b"never read")
        (folder / "capture.json").write_text(json.dumps({"started_utc": f"2026-01-0{number + 1}T00:00:00+00:00"}))
    for folder, day in ((first_folder, 8), (two, 9)):
        (folder / "capture.json").write_text(json.dumps({"started_utc": f"2026-01-0{day}T00:00:00+00:00"}))
    assert [last.name for last in _last([*sorted((tmp_path / "raw").glob("o*")), first_folder], "2026-01-09")] == [
        "old-3", "old-4", "old-5", "a-1",
    ]  # fmt: skip
    (sentence,) = advice_on(two)
    assert "write `tare: run` in run.yaml of a-2" in sentence and advice_on(first_folder) == []
    assert f"(python -m pipeline.mend {two} tare=run)" in sentence
    assert ready.run("pipeline.mend", two, "tare=run").returncode == 0
    (confirmed,) = advice_on(two)
    assert "run.yaml of a-2 says `tare: run`. " in confirmed and "pipeline.mend" not in confirmed


def of_other_loads(place: Path) -> list[Path]:
    """Two runs of one string, the second under 30 N in place of 20 N; its zero was moved as well."""
    run_folders = folders(place, JUMP_MM)
    table = pd.read_parquet(run_folders[1] / "recording.parquet")
    table.assign(load_n=30.0).to_parquet(run_folders[1] / "recording.parquet", index=False)
    return run_folders


def test_a_zero_that_is_not_compared_is_said_in_the_log_of_the_dataset(tmp_path: Path) -> None:
    """The list of jumps was empty, as if the zeros had been compared and were the same."""
    run_folders, processed = of_other_loads(tmp_path / "raw"), tmp_path / "processed"
    for folder in run_folders:
        samples, strokes = (processed / folder.name / f"{table}.parquet" for table in ("samples", "strokes"))
        program("stages.ingest", folder, "--out", samples, "--out-strokes", strokes)
    notes = tmp_path / "zero_jumps.json"
    words = ("--processed", processed, "--out", tmp_path / "dataset.parquet", "--out-jumps", notes)
    text = program("stages.dataset", *run_folders, *words)
    why = "a-1 rests last at 20 N, a-2 begins at 30 N, 0.59 mm more than simulated"
    (note,) = read_jumps([notes])
    assert note.startswith(f"{NOT_COMPARED} a-1 and a-2: {why}. If the sensor"), (
        "the pages and the job's end say it too"
    )
    assert text.count(f"Beware: zero not compared between a-1 and a-2: {why}. If the sensor or a clamp was moved") == 1


@pytest.mark.long
def test_a_zero_that_is_not_compared_is_said_of_runs_that_are_diagnosed_together(tmp_path: Path) -> None:
    run_folders = of_other_loads(tmp_path / "raw")
    done = programs.run("pipeline.diagnose", *run_folders, "--together", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    warning = "a-1+a-2: zero not compared between a-1 and a-2: a-1 rests last at 20 N, a-2 begins at 30 N, "
    assert warning in done.stderr and "This verdict does not depend on it" in done.stderr


def test_why_a_zero_is_not_compared_is_told_once() -> None:
    first_run, two = runs(JUMP_MM)
    late = two.samples[two.samples["time_s"] > CUT_S + 10.0].reset_index(drop=True)  # begins high up
    begun = Recorded(two.run, "", late, segment(late, "motor_turns", "a-2"))
    (note,) = not_compared([Rests.of(first_run), Rests.of(begun)])
    assert re.search(
        r"between a-1 and a-2: a-1 rests last at 0 turns, a-2 begins at 1\d.* turns, 0\.\d+ mm \w+ than simulated\.",
        note,
    )
    beginning = Rests.of(first_run)  # of a run that ends while it unwinds: its load changed since its only rest
    alone = replace(
        beginning, after=(0,), **{name: getattr(beginning, name)[:1] for name in ("turns", "load_n", "levels_mm")}
    )
    (note,) = not_compared([alone, Rests.of(begun)])
    assert "a-1 begins at 0 turns and rests no more, a-2 begins at" in note
    assert not_compared([Rests.of(run) for run in runs(JUMP_MM)]) == []
    tared = [Rests.of(first_run), replace(Rests.of(begun), run=runs(JUMP_MM, tare="run")[1].run)]
    assert not_compared(tared) == [] and len(tare_notes(tared)) == 1
    assert to_confirm(tared) == [], "its run.yaml confirms it"


def test_a_zero_that_is_not_compared_stands_on_the_pages_where_another_run_is_tared_anew() -> None:
    """There the log says it in other words, which are no sentence of `not_compared`."""
    first_run, two = runs(JUMP_MM)
    begun = other_load(Rests.of(two))
    tared = replace(Rests.of(two), run=first_run.run.model_copy(update={"run": "a-3", "tare": "run"}))
    every = [Rests.of(first_run), begun, tared]
    assert [note.split(":")[0] for note in to_confirm(every)] == [f"{NOT_COMPARED} a-1 and a-2"]
    assert not_compared(every) == []


def test_of_many_zeros_that_are_not_compared_the_pages_have_the_first() -> None:
    two = Rests.of(runs(JUMP_MM)[1])
    notes = to_confirm([other_load(two, 2.0**number) for number in range(6)])
    last = f"{NOT_COMPARED} 2 more pairs of runs of string a: the log of the dataset names them."
    assert len(notes) == 4 and notes[3] == last


def other_load(rests: Rests, times: float = 1.5) -> Rests:
    """The same under so many times the load."""
    return replace(rests, load_n=tuple(times * load_n for load_n in rests.load_n))
