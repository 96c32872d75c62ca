"""Spikes of a channel are found as they are in a channel that is held whole, and change no cut into strokes."""

import numpy as np
import pandas as pd
import pytest
from made_recording import recording
from whole_strokes import despiked_whole

from pipeline.ground.numbers import quantiles
from pipeline.ground.stored import schemas
from pipeline.ground.stored.rows import Held
from pipeline.run import clean_motion, spikes
from pipeline.run.spikes import despiked, lonely
from pipeline.run.strokes import label, of_samples, segment


def noisy(seed):
    """A signal with spikes at its ends too, some of them small, on noise or on steps."""
    rng = np.random.default_rng(seed)
    signal = np.cumsum(rng.normal(0.0, 1.0, 400)) * rng.choice([0.0, 1.0])
    signal += rng.choice([0.0, 0.01]) * rng.normal(size=400)
    signal = np.round(signal * 2.0) / 2.0 if rng.random() < 0.3 else signal
    places = np.unique(np.append(rng.integers(0, 400, 9), rng.choice([0, 1, 2, 397, 398, 399], 2)))
    places = places[:0] if seed % 4 == 3 else places
    signal[places] += rng.choice([-50.0, 3.0, 0.3, 50.0], len(places))
    return signal


@pytest.mark.parametrize("seed", range(40))
def test_a_channel_in_pieces_loses_the_spikes_that_it_loses_whole(seed, monkeypatch):
    signal = noisy(seed)
    whole = despiked_whole(signal)
    np.testing.assert_array_equal(despiked(signal), whole)
    monkeypatch.setattr(schemas, "ROW_GROUP", 37)
    monkeypatch.setattr(quantiles, "HELD", 64)
    monkeypatch.setattr(quantiles, "DIGITS", (8,) * 8)
    np.testing.assert_array_equal(despiked(signal), whole)
    rows = Held(pd.DataFrame({"signal": signal}))
    places = spikes.spikes(rows, "signal")
    parts = [spikes.without_spikes(rows, "signal", places, first, first + 10) for first in range(0, 400, 10)]
    np.testing.assert_array_equal(np.concatenate(parts), whole)


def test_the_made_channels_have_spikes_and_some_none():
    changed = [int((despiked_whole(noisy(seed)) != noisy(seed)).sum()) for seed in range(40)]
    assert sum(map(bool, changed)) > 15 and not all(changed)


def test_spikes_are_the_same_whether_looked_at_in_one_block_or_in_many(monkeypatch):
    signal = np.random.default_rng(3).normal(0.0, 1.0, 1_000)
    signal[[0, 99, 200, 350, 500, 699, 998]] += 50.0
    whole = lonely(signal, 10.0)
    assert whole.sum() >= 3
    monkeypatch.setattr(spikes, "BLOCK", 100)
    np.testing.assert_array_equal(lonely(signal, 10.0), whole)


@pytest.mark.parametrize("step", [0.0, 0.3, 1.0, 1.2, 1.5, 2.0, 3.0, 6.0])
def test_noise_alone_has_no_spikes_however_coarse_the_sensor_is(step):
    noise = np.random.default_rng(7).normal(20.0, 1.0, 200_000)
    signal = np.round(noise / step) * step if step else noise
    assert len(spikes.spikes(Held(pd.DataFrame({"signal": signal})), "signal")) == 0
    signal[1_000:100_000:9_000] += 30.0
    assert len(spikes.spikes(Held(pd.DataFrame({"signal": signal})), "signal")) == 11, "spikes are found all the same"


@pytest.mark.parametrize("reads", [0.0, 40.0])
def test_a_lonely_sample_of_a_channel_without_noise_is_a_spike_and_no_step(reads):
    signal = np.full(5_000, 20.0)
    signal[[300, 900, 4_000]] = reads
    assert spikes.spikes(Held(pd.DataFrame({"signal": signal})), "signal").tolist() == [300, 900, 4_000]


def test_a_recording_with_spikes_is_cut_as_without_them():
    """A median alone reads one sample late beside a spike: the border of a stand would move."""
    plain, moved = recording(3), 0
    borders = segment(plain, "motor_turns", "plain")["first_sample"][1:]
    for step in range(-4, 5):
        spiked = plain.copy()
        spiked.loc[borders + step, "motor_turns"] += 40.0
        without = spiked.assign(motor_turns=despiked(spiked["motor_turns"].to_numpy()))
        columns = ["stroke", "phase", "first_sample", "last_sample"]
        cuts = [segment(table, "motor_turns", "made")[columns] for table in (spiked, without)]
        assert cuts[0].equals(cuts[1])
        moved += (
            len(borders_with_spikes(spiked)) != len(cuts[0])
            or (borders_with_spikes(spiked) != cuts[0]["first_sample"]).any()
        )
    assert moved  # where spikes stay in


def borders_with_spikes(table):
    """First samples of the stretches of a motion whose spikes are left in."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(clean_motion, "spikes", lambda rows, driver: np.zeros(0, np.intp))
        return segment(table, "motor_turns", "made")["first_sample"]


def test_the_table_of_strokes_says_what_the_label_of_each_sample_says():
    table = recording(4)
    marks = label(table["time_s"].to_numpy(), table["motor_turns"].to_numpy())
    for sample_labels, kept in zip(marks, of_samples(segment(table, "motor_turns", "made")), strict=True):
        np.testing.assert_array_equal(sample_labels, kept)
