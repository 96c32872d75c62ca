"""The spikes of a recording are counted by channel, and a recording without any has none."""

from pathlib import Path

from made_recording import content, recording

from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.recording.spikes_found import spikes_found
from pipeline.run.description import parse_run


def test_spikes_are_counted_by_channel_with_the_time_stamp_of_the_first():
    run, samples = parse_run(content("a-1"), Path("a-1/run.yaml")), recording()
    assert spikes_found([RecordedRun.cut(run, samples)]) == []
    spiky = samples.copy()
    spiky.loc[[300, 500, 700], "displacement_mm"] += [4.0, -3.0, 5.0]
    spiky.loc[400, "motor_turns"] += 9.0
    other = RecordedRun.cut(run.model_copy(update={"run": "a-2"}), samples)
    by_column = {entry["column"]: entry for entry in spikes_found([other, RecordedRun.cut(run, spiky)])}
    assert {column: entry["count"] for column, entry in by_column.items()} == {"motor_turns": 1, "displacement_mm": 3}
    assert by_column["displacement_mm"]["first_s"] == samples["time_s"][300]
    assert {entry["run"] for entry in by_column.values()} == {"a-1"}
