"""A run is cut into strokes once: of its samples, thinned or begun alone, each stays in the stroke that it was in."""

from pathlib import Path

import numpy as np
import pytest
from made_recording import content, recording

from pipeline.diagnosis.recording.made_of import recordings_of
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.recording.working_samples import PHASES, joined
from pipeline.run import strokes
from pipeline.run.description import parse_run
from pipeline.run.strokes import label, of_samples, segment, stretches

RUN = parse_run(content("a-1"), Path("a-1/run.yaml"))


@pytest.fixture
def cut_once(monkeypatch: pytest.MonkeyPatch) -> RecordedRun:
    """A recording of three strokes, after which nothing may be cut."""
    samples = recording()
    recorded = RecordedRun(RUN, samples, segment(samples, "motor_turns", "a-1"), Path("a-1"))

    def never(motion: object) -> None:
        raise AssertionError("it was cut before")

    monkeypatch.setattr(strokes, "_stretches", never)
    return recorded


def test_the_strokes_of_samples_are_those_that_of_samples_gives_back():
    samples = recording()
    table = segment(samples, "motor_turns", "a-1")
    rebuilt = stretches(*of_samples(table))
    for name in rebuilt:
        assert rebuilt[name].tolist() == table[name].tolist(), name
    motion = (samples["time_s"].to_numpy(), samples["motor_turns"].to_numpy())
    assert stretches(*label(*motion)).to_numpy().tolist() == rebuilt.to_numpy().tolist()
    assert stretches(np.zeros(0, int), np.zeros(0, object)).empty


@pytest.mark.parametrize("step", [1, 3, 400])
def test_each_third_sample_stays_in_its_stroke(cut_once, step):
    stroke, phase = of_samples(cut_once.strokes)
    thinned = cut_once.each(step)
    assert len(thinned.samples) == -(-len(cut_once.samples) // step) and thinned.folder == Path("a-1")
    record = joined([thinned], len(thinned.samples))
    np.testing.assert_array_equal(record.stroke, stroke[::step])
    assert [PHASES[place] for place in record.phase] == phase[::step].tolist()


def test_the_beginning_of_a_run_is_in_its_strokes(cut_once):
    stroke, phase = of_samples(cut_once.strokes)
    begun = cut_once.begun(500)
    assert len(begun.samples) == 500 and begun.samples["time_s"].equals(cut_once.samples["time_s"][:500])
    assert [column.tolist() for column in of_samples(begun.strokes)] == [stroke[:500].tolist(), phase[:500].tolist()]


def test_a_run_without_its_strokes_is_none():
    with pytest.raises(TypeError, match="strokes"):
        RecordedRun(RUN, recording())  # type: ignore[call-arg]


def test_a_motion_without_a_stroke_can_be_planned():
    still = recording().assign(motor_turns=3.0)
    assert len(of_samples(RecordedRun.cut(RUN, still).strokes)[0]) == len(still)


def test_a_recording_that_is_held_is_not_read_again(tmp_path, cut_once):
    folder = tmp_path / "a-1"
    folder.mkdir()
    (folder / "recording.csv").write_text("nobody reads this")
    held_run = RecordedRun(cut_once.run, cut_once.samples, cut_once.strokes, folder)
    (taken,) = recordings_of({"run": "a-1"}, tmp_path / "diagnosis.json", folder, [held_run])  # type: ignore[typeddict-item]
    assert taken.samples is held_run.samples and taken.strokes is held_run.strokes
