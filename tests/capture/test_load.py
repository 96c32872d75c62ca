"""5 kHz of 6 channels are recorded without a loss, in memory that does not grow; benchmarks/load.py takes longer."""

from benchmarks.load import RATE_HZ, measure

SECONDS = 8
DIFFERENCE_MB = 3.0  # the frames of these seconds are 1 MB on the line, and 20 MB and more as objects


def test_a_fast_rig_is_recorded_without_a_loss_and_in_flat_memory(tmp_path):
    load = measure(SECONDS, tmp_path / "load-1")
    assert (load.lost, load.bad, load.samples) == (0, 0, SECONDS * RATE_HZ), load
    assert load.sent == load.received == load.samples + 2
    assert load.late_mb - load.early_mb < DIFFERENCE_MB, load
